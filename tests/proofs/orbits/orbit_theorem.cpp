#include "proofs/orbits/orbit_theorem.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "numeric/families/family.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using numeric::motion::Motion;
using pascal2012::example_named;

namespace {

const Motion& motion_of(const std::string& name) {
  return methods::printed_orbit(example_named(name)).motion;
}
orbits::Question question(const std::string& name) {
  return orbits::question_of(methods::question_of(example_named(name)), motion_of(name));
}
void refuses(const orbits::Question& question, const Motion& motion) {
  CHECK_THROWS_AS(static_cast<void>(orbits::orbit_theorem(question, motion)), KernelError);
}

// The names that an existence binds.
std::vector<std::string> bound(Formula formula) {
  std::vector<std::string> names;
  while (formula.kind() == Kind::exists) {
    names.push_back(formula.name());
    formula = opened(formula, Variable{formula.name(), formula.binds()});
  }
  return names;
}

}  // namespace

TEST_CASE("the orbits of the three figures exist: no hypotheses") {
  const Theorem S = orbits::orbit_theorem(question("S"), motion_of("S"));
  CHECK(S.hypotheses().empty());
  CHECK(bound(S.conclusion()) == std::vector<std::string>{"tau", "T", "phi", "ur", "X1", "X2"});
  const Theorem O = orbits::orbit_theorem(question("O"), motion_of("O"));
  CHECK(O.hypotheses().empty());
  CHECK(bound(O.conclusion()) == std::vector<std::string>{"tau", "tau1", "T", "ur", "X1", "X2", "X3"});
  const Theorem P = orbits::orbit_theorem(question("P"), motion_of("P"));
  CHECK(P.hypotheses().empty());
  CHECK(bound(P.conclusion()) == std::vector<std::string>{"tau", "tau1", "phi", "X1", "X2"});
}

TEST_CASE("an orbit as one motion: periodic, and each phase's definition holds of it") {
  for (const auto& [name, names] : {std::pair{"S", std::vector<std::string>{"tau", "T", "phi", "ur", "X"}},
                                    std::pair{"O", std::vector<std::string>{"tau", "tau1", "T", "ur", "X"}},
                                    std::pair{"P", std::vector<std::string>{"tau", "tau1", "phi", "X"}}}) {
    CAPTURE(name);
    const orbits::Question asked = question(name);
    const Theorem orbit = orbits::orbit_theorem(asked, motion_of(name)),
                  one = orbits::one_motion(orbit, asked);
    CHECK(one.hypotheses().empty());
    CHECK(bound(one.conclusion()) == names);
    Formula said = one.conclusion();
    while (said.kind() == Kind::exists) {
      said = opened(said, Variable{said.name(), said.binds()});
    }
    const Variable X{"X", function_of_time(4, 1)}, t{"t"};
    const Term Theta = Term(2) * pi() / Term(asked.data.omega);
    CHECK(said.parts().front() == for_all(t, equal(apply(X, Term(t) + Theta), apply(X, t))));
    CHECK(static_cast<std::size_t>(std::ranges::count(said.parts(), Kind::defined, &Term::kind)) ==
          asked.phases.size());
    CHECK(std::ranges::count(said.variables(), function_of_time(4, 1), &Variable::type) == 1);
    // Of a period that the phases do not have, nothing.
    orbits::Question wrong = asked;
    wrong.period = 2;
    CHECK_THROWS_AS(static_cast<void>(orbits::one_motion(orbit, wrong)), KernelError);
  }
}

TEST_CASE("each phase lasts") {
  Formula said = orbits::orbit_theorem(question("S"), motion_of("S")).conclusion();
  while (said.kind() == Kind::exists) {
    said = opened(said, Variable{said.name(), said.binds()});
  }
  for (const char * duration : {"tau", "T"}) {
    CHECK(std::ranges::count(said.parts(), less(0, Term(Variable{duration}))) == 1);
  }
}

TEST_CASE("an orbit at given ur, with its load phase as a result") {
  numeric::OrbitQuestion asked = methods::question_of(example_named("O"));
  asked.phi.reset();
  asked.ur = Range{parse_rational("0.46")};
  const numeric::OrbitList list = numeric::list_orbits(asked);
  const auto good = std::ranges::find_if(
      list.orbits, [](const numeric::Orbit& orbit) { return orbit.admissible.truth == Truth::proved; });
  REQUIRE(good != list.orbits.end());
  const Theorem theorem = orbits::orbit_theorem(orbits::question_of(asked, good->motion), good->motion);
  CHECK(theorem.hypotheses().empty());
  CHECK(bound(theorem.conclusion()) == std::vector<std::string>{"tau", "tau1", "T", "phi", "X1", "X2", "X3"});
  // And none of those that are not admissible.
  for (const numeric::Orbit& orbit : list.orbits) {
    if (orbit.admissible.truth == Truth::refuted) {
      refuses(orbits::question_of(asked, orbit.motion), orbit.motion);
    }
  }
}

TEST_CASE("what is no orbit is refused") {
  // Each datum, changed: the motion does not close.
  using P = model::Parameters<Rational>;
  for (Rational P::*datum : {&P::chi, &P::eta, &P::us, &P::V, &P::omega, &P::p}) {
    orbits::Question wrong = question("S");
    wrong.data.*datum *= Rational(10001, 10000);
    refuses(wrong, motion_of("S"));
  }
  // Its friction at rest is too small, or too large, for the phases.
  orbits::Question stuck = question("P");
  stuck.ur = parse_rational("0.3");
  refuses(stuck, motion_of("P"));
  stuck.ur.reset();
  refuses(stuck, motion_of("P"));
  // Another load phase, another order of the phases, another period.
  orbits::Question late = question("S");
  late.lag = 1;
  refuses(late, motion_of("S"));
  orbits::Question turned = question("P");
  std::swap(turned.phases[0], turned.phases[1]);
  refuses(turned, motion_of("P"));
  orbits::Question slow = question("P");
  slow.period = 2;
  refuses(slow, motion_of("P"));
  // Friction at rest below friction when sliding: no law of friction.
  orbits::Question slippery = question("P");
  slippery.ur = slippery.data.us / 2;
  refuses(slippery, motion_of("P"));
  // A phase that lasts less than no time.
  Motion backwards = motion_of("P");
  backwards.phases[0].duration = Ball(-1);
  refuses(question("P"), backwards);
  // Phi and ur together are more than an orbit can be asked for.
  orbits::Question both = question("O");
  both.ur = parse_rational("0.46");
  refuses(both, motion_of("O"));
}

TEST_CASE("a closed form has to solve the equations: numbers near the solution do not") {
  const orbits::Question asked = question("P");
  const orbits::Phases phases(asked);
  const std::vector<Rational> near = phases.near(motion_of("P"));
  const Variable epsilon{"epsilon"};
  orbits::ClosedForm known{{}, {{phases.omega(), asked.data.omega}}, {{epsilon, {0, 1}}}, equal(epsilon, 0)};
  for (std::size_t i = 0; i < near.size(); ++i) {
    known.values.emplace(phases.unknowns()[i], near[i]);
  }
  CHECK_THROWS_AS(static_cast<void>(orbits::orbit_theorem(asked, known, {})), KernelError);
}

TEST_CASE("a value lies where the orbit's theorem says, and nowhere else") {
  const orbits::Question q = question("S");
  const Theorem orbit = orbits::orbit_theorem(q, motion_of("S"));
  const auto about = [&](const std::string& name, const char * lower, const char * upper, bool outside) {
    return orbits::value_theorem(orbit, q, name, parse_rational(lower), parse_rational(upper), outside);
  };
  CHECK(about("tau", "7.7485", "7.7495", true).hypotheses().empty());
  CHECK(about("tau", "7.74669", "7.7467", false).hypotheses().empty());
  CHECK(about("Theta", "10.4715", "10.4725", false).hypotheses().empty());
  CHECK(about("z10", "1.061", "1.062", false).hypotheses().empty());
  CHECK_THROWS_AS(static_cast<void>(about("tau", "7.7485", "7.7495", false)), KernelError);
  CHECK_THROWS_AS(static_cast<void>(about("tau", "7.74669", "7.7467", true)), KernelError);
  CHECK_THROWS_AS(static_cast<void>(about("Theta", "10.4715", "10.4725", true)), KernelError);
  CHECK_THROWS_AS(static_cast<void>(about("z10", "1.1", "1.11", false)), KernelError);  // that is x10
  CHECK_THROWS_AS(static_cast<void>(about("tau1", "0", "10", false)), KernelError);     // S has none
}

TEST_CASE("each condition of the three figures holds of their orbits, others do not") {
  using numeric::motion::Quantity;
  using numeric::motion::Requirement;
  for (const std::string name : {"S", "O", "P"}) {
    CAPTURE(name);
    const orbits::Question q = question(name);
    const Theorem orbit = orbits::orbit_theorem(q, motion_of(name));
    for (const Requirement& requirement :
         numeric::families::requirements(*example_named(name).family, true)) {
      CAPTURE(requirement.id);
      const Theorem theorem = orbits::condition_theorem(orbit, q, requirement);
      CHECK(theorem.hypotheses().empty());
      CHECK(bound(theorem.conclusion()) == bound(orbit.conclusion()));
    }
    const auto refused = [&](Quantity quantity, std::size_t phase, bool along) {
      const Requirement wrong{"wrong", "wrong", quantity, phase, along};
      CHECK_THROWS_AS(static_cast<void>(orbits::condition_theorem(orbit, q, wrong)), KernelError);
    };
    refused(Quantity::above_belt, 0, true);  // phase 0 slips
    refused(Quantity::below_ur, 0, true);    // and r is beyond ur at its beginning, or just there
    refused(Quantity::beyond_minus_ur, 0, false);
    if (name == "S") {
      refused(Quantity::below_belt, 1, true);  // phase 1 sticks
      refused(Quantity::beyond_ur, 0, false);  // r = ur
    }
    if (name == "P") {
      refused(Quantity::falls_behind, 0, false);  // ur < r
    }
  }
}
