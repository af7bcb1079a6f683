// Pictures of orbits.
#include "report/orbits/orbits_plot.hpp"

#include <doctest/doctest.h>

#include <fstream>

#include "core/error.hpp"
#include "proofs/methods/example_orbits.hpp"
#include "proofs/pascal2012/examples.hpp"
#include "report/tools/files.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::report::tools;
using report::tools::PlotFormat;

namespace {

OrbitList example_list() {
  return list_orbits(question_of(example_named("O")));
}

}  // namespace

TEST_CASE("the script draws the admissible orbits only, each phase with its own line") {
  const std::string script = report::orbits::plot_script(example_list(), PlotFormat::svg);
  CHECK(script.find("$orbit1phase0") == std::string::npos);
  for (const char * part : {"$orbit2phase0", "$orbit2phase1", "$orbit2phase2", "\"overshoot\"", "lw 5 "}) {
    CHECK(script.find(part) != std::string::npos);
  }
  OrbitList none = example_list();
  none.orbits.clear();
  CHECK(report::orbits::plot_script(none, PlotFormat::svg).empty());
}

TEST_CASE("gnuplot draws both formats") {
  const TemporaryDirectory temporary;
  const OrbitList list = example_list();
  report::tools::write_plot(temporary.path() / "a.svg", report::orbits::plot_script(list, PlotFormat::svg));
  report::tools::write_plot(temporary.path() / "a.pdf", report::orbits::plot_script(list, PlotFormat::pdf));
  CHECK(report::tools::read_file(temporary.path() / "a.svg").find("</svg>") != std::string::npos);
  CHECK(report::tools::read_file(temporary.path() / "a.pdf").starts_with("%PDF"));
  CHECK(temporary.count() == 2);
}

TEST_CASE("what cannot be drawn is an error, and leaves no file") {
  const TemporaryDirectory temporary;
  CHECK_THROWS_AS((void)report::tools::gnuplot("nonsense"), InputOutputError);
  CHECK_THROWS_AS(report::tools::write_plot(temporary.path() / "a.svg", "nonsense"), InputOutputError);
  CHECK_THROWS_AS(report::tools::require_plot(temporary.path() / "missing" / "a.svg"), InputOutputError);
  CHECK_THROWS_AS(report::tools::require_plot(temporary.path()), InputOutputError);
  CHECK_THROWS_AS((void)report::tools::plot_format("a.png"), UsageError);
  CHECK(temporary.count() == 0);
}
