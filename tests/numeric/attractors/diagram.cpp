// Diagrams along a parameter and basins say what is found at each value and from each start alone.
#include "numeric/attractors/diagram.hpp"

#include <doctest/doctest.h>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/attractors/settle.hpp"
#include "tests/numeric/examples.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::attractors;

TEST_CASE("along a parameter each value has what is found there alone, and what lies outside says so") {
  const AttractorQuestion at_P{{P(), Rational(1, 4), 20}, 8, 3, 3000};
  const Diagram d = diagram_of({at_P, "ur", Rational(1, 20), Rational(3, 10), 3});
  REQUIRE(d.points.size() == 3);
  CHECK(d.points[0].value == Rational(1, 20));
  CHECK(d.points[2].value == Rational(3, 10));
  CHECK(d.points[0].outside.find("ur > us") != std::string::npos);
  CHECK(d.points[0].attractors.empty());
  for (const std::size_t k : {1, 2}) {
    const DiagramPoint& point = d.points[k];
    AttractorQuestion here = at_P;
    here.machine.ur = point.value;
    const AttractorList alone = find_attractors(here);
    REQUIRE(point.attractors.size() == alone.attractors.size());
    REQUIRE(point.once.size() == alone.attractors.size());
    for (std::size_t i = 0; i < alone.attractors.size(); ++i) {
      const Attractor& a = point.attractors[i];
      CHECK(a.word == alone.attractors[i].word);
      CHECK(a.count == alone.attractors[i].count);
      REQUIRE(a.kind == Kind::periodic);
      CHECK(static_cast<long>(point.once[i].size()) == std::min(a.periods, most_once));
      // One period of the load after the last state the first one comes again.
      simulation::Simulation next(parameters_as<double>(P()), scalars::scalar<double>(point.value), 0,
                                  point.once[i].back());
      next.advance(next.period());
      CHECK((a.periods > most_once || distance(next.state(), point.once[i].front()) < 1e-5));
    }
  }
  CHECK(d.points[1].attractors[0].word == "OS");
  CHECK(d.points[2].attractors[0].word != "OS");
}

TEST_CASE("a diagram along what is no parameter, or outside the domain, is refused") {
  const AttractorQuestion at_P{{P(), Rational(1, 4), 20}, 4, 3, 1000};
  CHECK_THROWS_AS((void)diagram_of({at_P, "tau", Rational(0), Rational(1), 3}), UsageError);
  CHECK_THROWS_AS((void)diagram_of({at_P, "chi", Rational(1), Rational(2), 3}), DomainError);
}

TEST_CASE("each start of a plane is placed on what the motion from it settles on") {
  BasinsQuestion q{{{P(), parse_rational("0.2996"), 20}, 1, 1, 20000}, {1, 3}, {}, {5, 4}};
  q.through = model::Vector4<double>(0.5, 1, 0, -0.5);
  const Basins b = basins_of(q);
  REQUIRE(b.starts.size() == 20);
  REQUIRE(b.at.size() == 20);
  const StartBox box = start_box(parameters_as<double>(P()));
  CHECK(b.starts[0](0) == 0.5);
  CHECK(b.starts[0](1) == doctest::Approx(1 - 0.8 * box.half(1)));
  CHECK(b.starts[1](1) == doctest::Approx(1 - 0.4 * box.half(1)));
  CHECK(b.starts[19](3) == doctest::Approx(-0.5 + 0.75 * box.half(3)));
  long placed = 0;
  for (const Attractor& a : b.attractors) {
    placed += a.count;
  }
  CHECK(placed == 20);
  for (std::size_t k = 0; k < b.starts.size(); k += 3) {
    const Attractor alone = find_attractor(q.machine.machine, b.starts[k]);
    CHECK(alone.kind == b.attractors[b.at[k]].kind);
    CHECK(alone.word == b.attractors[b.at[k]].word);
  }
}
