// The conditions of the paper along whole motions.
#include "numeric/motion/conditions.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "numeric/motion/stability.hpp"
#include "tests/numeric/families/composed.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::examples;

namespace {

const Condition& find(const std::vector<Condition>& conditions, const std::string& id) {
  const auto found = std::find_if(conditions.begin(), conditions.end(),
                                  [&](const Condition& condition) { return condition.id == id; });
  REQUIRE(found != conditions.end());
  return *found;
}

Orbit orbit_S() {
  return listed(symmetric(), S(), 30).orbits.at(1);
}

std::vector<Condition> decide_conditions(const Family& family, const Motion& motion, const Ball& ur) {
  return conditions(family, taken_as_closed(motion), ur);
}

// What a sample of the motion says about a requirement's distance divided by its weight.
double sampled(const Motion& motion, const Ball& ur, const Requirement& q) {
  const Phase& phase = motion.phases[q.phase];
  const model::Parameters<Ball>& a = motion.oscillator.data;
  double least = 1e9;
  for (int i = 1; i < 1000; ++i) {
    const Ball t = phase.duration * Ball(i) / Ball(1000);
    const Ball speed = state(motion, q.phase, t)(3);
    const Ball r = friction(motion, q.phase, t);
    Ball g;
    switch (q.quantity) {
      case Quantity::below_belt:
        g = a.V - speed;
        break;
      case Quantity::above_belt:
        g = speed - a.V;
        break;
      case Quantity::below_ur:
        g = a.eta * (ur - r);
        break;
      default:
        g = a.eta * (ur + r);
    }
    const double from_start = q.touches.start ? t.approximate() : 1;
    const double from_end = q.touches.end ? (phase.duration - t).approximate() : 1;
    least = std::min(least, g.approximate() / std::min({1.0, from_start, from_end}));
  }
  return least;
}

void check_margins_against_samples(const Family& family, const Motion& motion, const Ball& ur) {
  for (const Requirement& q : requirements(family)) {
    if (!q.along) {
      continue;
    }
    CAPTURE(q.id);
    const Condition condition = decide(motion, ur, q);
    REQUIRE(condition.margin.has_value());
    CHECK(condition.margin->approximate() == doctest::Approx(sampled(motion, ur, q)).epsilon(0.02));
    CHECK((condition.margin->radius() - Ball(1e-15)).is_negative());
  }
}

}  // namespace

TEST_CASE("example S obeys every condition, with the margins that (12), (13) give in closed form") {
  const Orbit orbit = orbit_S();
  const Motion& motion = orbit.motion;
  const Ball& ur = orbit.value("ur");
  const std::vector<Condition> conditions = decide_conditions(symmetric(), motion, ur);
  for (const Condition& condition : conditions) {
    CAPTURE(condition.id);
    CAPTURE(condition.verdict.reason);
    CHECK(condition.verdict.truth == Truth::proved);
    CHECK_FALSE(condition.violation.has_value());
  }
  CHECK(admissible(conditions).truth == Truth::proved);
  // The middle of (14) is -eta (ur - us).
  const Ball eta(S().eta);
  const Ball us(S().us);
  CHECK(find(conditions, "14.lower").margin->overlaps(Ball(2) * eta * us));
  CHECK(find(conditions, "14.upper").margin->overlaps(Ball(2) * eta * (ur - us)));
  CHECK(find(conditions, "12").margin->overlaps(eta * (ur - us)));
  CHECK(find(conditions, "f2").margin->is_positive());
  check_margins_against_samples(symmetric(), motion, ur);
}

TEST_CASE("example O obeys every condition") {
  const ComposedOrbit orbit = orbit_O();
  REQUIRE(orbit.proof.verdict.truth == Truth::proved);
  const std::vector<Condition> conditions = decide_conditions(overshooting(), orbit.motion, orbit.ur);
  for (const Condition& condition : conditions) {
    CAPTURE(condition.id);
    CAPTURE(condition.verdict.reason);
    CHECK(condition.verdict.truth == Truth::proved);
  }
  CHECK(conditions.size() == 13);
  check_margins_against_samples(overshooting(), orbit.motion, orbit.ur);
}

TEST_CASE("a friction at rest that does not hold the mass refutes the stick with a time and a ball") {
  const ComposedOrbit orbit = orbit_O();
  // (12) ties ur to the orbit: another ur breaks that premise.
  for (const char * other : {"0.3", "0.6"}) {
    const auto conditions = decide_conditions(overshooting(), orbit.motion, Ball(parse_rational(other)));
    CHECK(find(conditions, "12").verdict.truth == Truth::refuted);
    CHECK(find(conditions, "11.upper").verdict.truth == Truth::refuted);
    CHECK(admissible(conditions).truth == Truth::refuted);
  }
  // Without that premise the excess of r over a small ur is found along the stick.
  const Requirement upper{"11.upper", "", Quantity::below_ur, 2, true, {}, true};
  const Condition excess = decide(orbit.motion, Ball(parse_rational("0.3")), upper);
  CHECK(excess.verdict.truth == Truth::refuted);
  REQUIRE(excess.violation.has_value());
  CHECK(excess.violation->value.is_negative());
  const Ball local = excess.violation->time - orbit.motion.phases[2].start;
  CHECK((friction(orbit.motion, 2, local) - Ball(parse_rational("0.3"))).is_positive());
}

TEST_CASE("phases in another order, a shifted state or another phase of the load are never proved") {
  const ComposedOrbit orbit = orbit_O();
  const auto never_proved = [&](const Motion& motion) {
    for (const Condition& condition : decide_conditions(overshooting(), motion, orbit.ur)) {
      CAPTURE(condition.id);
      CHECK(condition.verdict.truth == Truth::refuted);
    }
  };
  Motion swapped = orbit.motion;
  std::swap(swapped.phases[1], swapped.phases[2]);
  never_proved(swapped);
  Motion relabelled = orbit.motion;
  relabelled.phases[0].kind = PhaseKind::overshoot;
  relabelled.phases[1].kind = PhaseKind::slip;
  never_proved(relabelled);
  Motion shifted = orbit.motion;
  shifted.phases[0].Z(0) += Ball(parse_rational("1e-20"));
  never_proved(shifted);
  Motion other_load = orbit.motion;
  other_load.phases[1].load += Ball(parse_rational("1e-20"));
  never_proved(other_load);
  Motion truncated = orbit.motion;
  truncated.phases.pop_back();
  never_proved(truncated);
}

TEST_CASE("slip and overshoot confused: the speed condition is refuted, with a violation") {
  const ComposedOrbit orbit = orbit_O();
  const Condition wrong =
      decide(orbit.motion, orbit.ur, {"", "", Quantity::above_belt, 0, true, {true, true}, true});
  CHECK(wrong.verdict.truth == Truth::refuted);
  REQUIRE(wrong.violation.has_value());
  CHECK((state(orbit.motion, 0, wrong.violation->time)(3) - orbit.motion.oscillator.data.V).is_negative());
}

TEST_CASE("a phase that does not begin at the belt's velocity is no slip") {
  const ComposedOrbit orbit = orbit_O();
  Motion begun = orbit.motion;  // the end of the slip is looked at, too: it is left out here
  begun.phases[0].duration = begun.phases[0].duration / Ball(2);
  const Requirement slip{"", "", Quantity::below_belt, 0, true, {true, false}, true};
  REQUIRE(decide(begun, orbit.ur, slip).verdict.truth == Truth::proved);
  for (const char * off : {"1e-20", "-1e-20"}) {
    Motion motion = begun;
    motion.phases[0].Z(3) += Ball(parse_rational(off));
    const Verdict verdict = decide(motion, orbit.ur, slip).verdict;
    CHECK(verdict.truth == Truth::refuted);
    CHECK(verdict.reason.find("is not met") != std::string::npos);
  }
}

TEST_CASE("grazing decides nothing: ur at the largest |r| of the stick") {
  const ComposedOrbit orbit = orbit_O();
  const Requirement lower{"", "", Quantity::above_minus_ur, 2, true, {}, true};
  const Condition at_orbit = decide(orbit.motion, orbit.ur, lower);
  const Ball eta = orbit.motion.oscillator.data.eta;
  const Ball grazing = orbit.ur - *at_orbit.margin / eta;  // min r = -grazing
  CHECK(decide(orbit.motion, grazing, lower).verdict.truth == Truth::undecided);
  CHECK(decide(orbit.motion, grazing + Ball(1e-12), lower).verdict.truth == Truth::proved);
  CHECK(decide(orbit.motion, grazing - Ball(1e-12), lower).verdict.truth == Truth::refuted);
}

TEST_CASE("degenerate numbers") {
  const ComposedOrbit orbit = orbit_O();
  Motion motion = orbit.motion;
  const Requirement duration{"", "", Quantity::duration, 1, false, {}, true};
  motion.phases[1].duration = Ball(0);
  CHECK(decide(motion, orbit.ur, duration).verdict.truth == Truth::refuted);
  motion.phases[1].duration = Ball(-1);
  CHECK(decide(motion, orbit.ur, duration).verdict.truth == Truth::refuted);
  motion.phases[1].duration = Ball::hull(Ball(0), Ball(1));
  CHECK(decide(motion, orbit.ur, duration).verdict.truth == Truth::undecided);
  const Requirement step{"", "", Quantity::friction_step, 0, false, {}, true};
  CHECK(decide(motion, motion.oscillator.data.us, step).verdict.truth != Truth::proved);
  CHECK_THROWS_AS((void)decide(motion, std::nullopt, step), InternalError);
  CHECK_THROWS_AS((void)decide(motion, orbit.ur, {"", "", Quantity::duration, 7, false, {}, true}),
                  InternalError);
  CHECK(admissible({}).truth == Truth::undecided);
}

TEST_CASE("precisions agree") {
  const std::vector<Condition> narrow = [] {
    const ComposedOrbit orbit = orbit_O();
    return decide_conditions(overshooting(), orbit.motion, orbit.ur);
  }();
  for (const long bits : {256L, 1024L}) {
    const WorkingPrecision precision(bits);
    const ComposedOrbit orbit = orbit_O();
    const auto conditions = decide_conditions(overshooting(), orbit.motion, orbit.ur);
    for (std::size_t i = 0; i < narrow.size(); ++i) {
      CAPTURE(conditions[i].id);
      CHECK(conditions[i].margin->overlaps(*narrow[i].margin));
      CHECK(conditions[i].verdict.truth == narrow[i].verdict.truth);
    }
  }
}

TEST_CASE(
    "how little it takes to leave a stable orbit is the least margin along it, never that of the data") {
  const auto proved = [](const char * id, double margin, std::optional<Ball> at) {
    return Condition{id, "", Verdict::proved(), Ball(margin), std::move(at), {}};
  };
  const std::vector<Condition> all{proved("us", 0.001, {}), proved("slip", 0.3, Ball(2)),
                                   proved("25", 0.25, Ball(0)), proved("26", 0.7, Ball(5))};
  const std::optional<Contact> contact = contact_of(all);
  REQUIRE(contact.has_value());
  CHECK(contact->condition == "25");
  CHECK(contact->margin.contains(Rational(1, 4)));
  CHECK(contact->at.contains(Rational(0)));
  CHECK_FALSE(contact_of({all[0]}).has_value());
  for (const Verdict& verdict : {Verdict::refuted("no"), Verdict::undecided("open")}) {
    std::vector<Condition> open = all;
    open[3].verdict = verdict;
    CHECK_FALSE(contact_of(open).has_value());
  }
}
