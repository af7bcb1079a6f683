// Pictures of orbits.
#include "report/orbits/orbits.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <regex>
#include <string>

#include "core/error.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "report/orbits/orbit_words.hpp"
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

TEST_CASE("a portrait has an arrow in each phase, which points the way of the motion") {
  const std::string script = report::orbits::plot_script(example_list(), PlotFormat::svg);
  const std::regex arrow("set arrow from first (\\S+),(\\S+) to first (\\S+),(\\S+) head");
  int count = 0;
  for (std::sregex_iterator found(script.begin(), script.end(), arrow), end; found != end; ++found, ++count) {
    const double velocity = std::stod((*found)[2]) + std::stod((*found)[4]);
    CHECK((std::stod((*found)[3]) - std::stod((*found)[1])) * velocity > 0);
  }
  CHECK(count == 2 * 3);
}

TEST_CASE("a picture is told in words, of the orbits that are drawn") {
  const std::string words = report::orbits::picture_in_words(example_list());
  CHECK(words.find("orbit 1 of 2") == std::string::npos);
  for (const char * part : {"Overshooting orbit 2 of 2, admissible, ur = 0.4590", "slip from t = 0 to 4.909,",
                            "the belt's is 1."}) {
    CHECK_MESSAGE(words.find(part) != std::string::npos, words);
  }
}

TEST_CASE("another u_r for each orbit is said only where it is proved") {
  OrbitList list = list_orbits(question_of(example_named("S")));
  CHECK(report::orbits::remark_on_ur(list).starts_with("Each of these orbits belongs to another $u_r$"));
  list.orbits.push_back(list.orbits.front());
  CHECK(report::orbits::remark_on_ur(list).find("may be another") != std::string::npos);
  list.orbits.resize(1, list.orbits.front());
  CHECK(report::orbits::remark_on_ur(list).empty());
  CHECK(report::orbits::remark_on_ur(list_orbits(question_of(example_named("P")))).empty());
}

TEST_CASE("gnuplot draws all formats") {
  const TemporaryDirectory temporary;
  const OrbitList list = example_list();
  report::tools::write_plot(temporary.path() / "a.svg", report::orbits::plot_script(list, PlotFormat::svg));
  report::tools::write_plot(temporary.path() / "a.pdf", report::orbits::plot_script(list, PlotFormat::pdf));
  CHECK(report::tools::read_file(temporary.path() / "a.svg").find("</svg>") != std::string::npos);
  report::tools::write_plot(temporary.path() / "a.png", report::orbits::plot_script(list, PlotFormat::png));
  CHECK(report::tools::read_file(temporary.path() / "a.pdf").starts_with("%PDF"));
  CHECK(report::tools::read_file(temporary.path() / "a.png").starts_with("\x89PNG"));
  CHECK(temporary.count() == 3);
}

TEST_CASE("what cannot be drawn is an error, and leaves no file") {
  const TemporaryDirectory temporary;
  CHECK_THROWS_AS((void)report::tools::gnuplot("nonsense"), InputOutputError);
  CHECK_THROWS_AS(report::tools::write_plot(temporary.path() / "a.svg", "nonsense"), InputOutputError);
  CHECK_THROWS_AS(report::tools::require_plot(temporary.path() / "missing" / "a.svg"), InputOutputError);
  std::filesystem::create_directory(temporary.path() / "directory.svg");
  CHECK_THROWS_AS(report::tools::require_plot(temporary.path() / "directory.svg"), InputOutputError);
  CHECK_THROWS_AS(report::tools::require_plot(temporary.path()), UsageError);
  CHECK_THROWS_AS((void)report::tools::plot_format("a.jpg"), UsageError);
  CHECK(temporary.count() == 1);
}
