// One orbit over a whole box of parameters, in parts: what is said of the box is so for members of it, and
// two orbits are not taken for one.
#include "numeric/orbit_over_box.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "numeric/families/symmetric.hpp"
#include "numeric/orbits.hpp"
#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches::examples;

namespace {

// One orbit of an example: the one whose first phase lasts nearly so long.
struct Example {
  OrbitQuestion question;
  double duration;
};
Example example_S() {
  return {S(), 7.749};
}
Example example_O() {
  return {O(), 4.909};
}
Example example_P() {
  OrbitQuestion q = P();
  q.parameters.V = Range{0};
  q.ur = Range{parse_rational("0.2")};
  return {q, 5.236};
}

motion::Given<Rational> exact(const OrbitQuestion& q) {
  return motion::mapped<Rational>(motion::Given<Range>{q.parameters, q.phi, q.ur},
                                  [](const Range& range) { return range.middle; });
}

// Of several with that duration, an admissible one.
families::Candidate candidate(const Example& example) {
  const OrbitQuestion& q = example.question;
  const motion::Given<Rational> given = exact(q);
  for (const families::Candidate& one : q.family->search(given).candidates) {
    const std::optional<Ball> ur = given.ur ? std::optional(Ball(*given.ur)) : std::nullopt;
    const auto closed = motion::prove_closed(one.equations, given, one.guess, 20);
    if (std::abs(closed.motion.phases[0].duration.approximate() - example.duration) < 1e-2 &&
        decided_orbit(*q.family, closed, ur).admissible.truth == Truth::proved) {
      return one;
    }
  }
  FAIL("no such orbit");
  return {{}, families::SymmetricClosing{families::LoadPhase::first}};
}

constexpr std::array names{"chi", "eta", "us", "V", "omega", "p"};

std::array<Rational *, 6> members(model::Parameters<Rational>& a) {
  return {&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p};
}

// Each parameter of that name, or each, with the relative radius.
motion::Given<Ball> box(const OrbitQuestion& q, const std::string& name, const Rational& radius) {
  motion::Given<Rational> given = exact(q);
  const auto around = [&](const std::string& parameter, const Rational& x) {
    const bool varies = name == parameter || name == "all";
    return varies ? Ball::from_interval(x - abs(x) * radius, x + abs(x) * radius) : Ball(x);
  };
  const model::Parameters<Rational>& a = given.data;
  motion::Given<Ball> result{{around("chi", a.chi), around("eta", a.eta), around("us", a.us),
                              around("V", a.V), around("omega", a.omega), around("p", a.p)},
                             {},
                             {}};
  result.phi = given.phi ? std::optional(Ball(*given.phi)) : std::nullopt;
  result.ur = given.ur ? std::optional(Ball(*given.ur)) : std::nullopt;
  return result;
}

// What the box says of its orbit holds for that member.
void check_member(const Example& example, const OrbitOverBox& over, const motion::Given<Rational>& given,
                  const families::Candidate& candidate) {
  const auto closed = motion::prove_closed(candidate.equations, given, over.orbit.motion, 20);
  REQUIRE(closed.existence.truth == Truth::proved);
  const std::optional<Ball> ur = given.ur ? std::optional(Ball(*given.ur)) : std::nullopt;
  const Orbit orbit = decided_orbit(*example.question.family, closed, ur);
  for (std::size_t k = 0; k < orbit.values.size(); ++k) {
    CAPTURE(orbit.values[k].name);
    CHECK(over.orbit.values[k].value.contains(orbit.values[k].value));
  }
  for (std::size_t k = 0; k < orbit.conditions.size(); ++k) {
    CAPTURE(orbit.conditions[k].id);
    CHECK(orbit.conditions[k].verdict.truth == over.orbit.conditions[k].verdict.truth);
    if (orbit.conditions[k].margin && over.orbit.conditions[k].margin) {
      CHECK(over.orbit.conditions[k].margin->overlaps(*orbit.conditions[k].margin));
    }
  }
  REQUIRE(orbit.stability);
  REQUIRE(over.orbit.stability);
  CHECK(orbit.stability->kind == over.orbit.stability->kind);
  for (const motion::ComplexBall& mu : orbit.stability->multipliers) {
    const auto& all = over.orbit.stability->multipliers;
    CHECK((all.empty() || std::any_of(all.begin(), all.end(), [&](const motion::ComplexBall& wide) {
             return wide.re.overlaps(mu.re) && wide.im.overlaps(mu.im);
           })));
  }
}

}  // namespace

TEST_CASE("boxes as large as the orbits allow, and members at their corners") {
  struct Box {
    Example example;
    const char *name, *radius;
  };
  for (const Box& one :
       {Box{example_O(), "chi", "1e-3"}, Box{example_O(), "eta", "1e-3"}, Box{example_O(), "omega", "1e-3"},
        Box{example_O(), "p", "1e-2"}, Box{example_O(), "all", "1e-4"}, Box{example_S(), "omega", "3e-3"},
        Box{example_S(), "p", "1e-1"}, Box{example_S(), "all", "3e-4"}, Box{example_P(), "chi", "1e-2"},
        Box{example_P(), "p", "1e-1"}}) {
    CAPTURE(one.example.question.family->name);
    CAPTURE(std::string(one.name));
    const families::Candidate found = candidate(one.example);
    const Rational radius = parse_rational(one.radius);
    const OrbitOverBox over =
        prove_over_box(*one.example.question.family, found, box(one.example.question, one.name, radius));
    REQUIRE(over.existence.truth == Truth::proved);
    CHECK(over.orbit.admissible.truth == Truth::proved);
    REQUIRE(over.orbit.stability);
    CHECK(over.orbit.stability->kind != motion::StabilityKind::undecided);
    for (const int corner : {0, 21, 42, 63}) {
      motion::Given<Rational> given = exact(one.example.question);
      const auto all = members(given.data);
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (one.name == std::string("all") || one.name == std::string(names[k])) {
          *all[k] *= 1 + ((corner >> k) % 2 == 1 ? radius : Rational(-radius));
        }
      }
      check_member(one.example, over, given, found);
    }
  }
}

TEST_CASE("a condition that some members obey and others do not is neither proved nor refuted") {
  // Condition 18 of O is lost at omega = 0.6312.
  const Example example = example_O();
  const OrbitOverBox over = prove_over_box(*example.question.family, candidate(example),
                                           box(example.question, "omega", parse_rational("5e-3")));
  REQUIRE(over.existence.truth == Truth::proved);
  CHECK(over.parts > 1);
  CHECK(over.orbit.admissible.truth == Truth::undecided);
  for (const motion::Condition& condition : over.orbit.conditions) {
    CAPTURE(condition.id);
    CHECK(condition.verdict.truth == (condition.id == "18" ? Truth::undecided : Truth::proved));
  }
}

TEST_CASE("where a phase lasts less than no time for some members no orbit of all is said to exist") {
  // The closing conditions go on; what violates another condition was called an orbit that is not admissible.
  OrbitQuestion q = data("overshooting", {"0.579", "5.31", "0.418", "1", "1.68", "1.97"});
  for (const char * radius : {"0.01", "0.03"}) {
    q.phi = Range{parse_rational("2.9"), parse_rational(radius)};
    const OrbitList list = list_orbits(q);
    for (const Orbit& orbit : list.orbits) {
      for (const motion::Phase& phase : orbit.motion.phases) {
        CHECK(phase.duration.is_positive());
      }
    }
    const bool open = std::ranges::any_of(list.unresolved, [](const Unresolved& one) {
      return one.reason.find("one of its phases may last no time") != std::string::npos;
    });
    CHECK(open == (std::string(radius) == "0.03"));
    CHECK(!list.orbits.empty());
  }
}

TEST_CASE("over a fold no orbit is said to exist") {
  // Two orbits meet at omega = 0.618247; the box is around each of them and reaches beyond.
  Example example = example_O();
  example.question.parameters.omega = Range{parse_rational("0.6183")};
  const motion::Given<Rational> given = exact(example.question);
  const auto candidates = example.question.family->search(given).candidates;
  REQUIRE(!candidates.empty());
  for (const families::Candidate& one : candidates) {
    const OrbitOverBox over = prove_over_box(*example.question.family, one,
                                             box(example.question, "omega", parse_rational("2e-4")), 256);
    CHECK(over.existence.truth == Truth::undecided);
  }
}

namespace {

// y³ - y = 16 (chi - 1/2), y = 4 (x - 7): three zeros next to chi = 1/2, one further away.
struct Cubic {
  static constexpr bool takes_phi = false, takes_ur = false;

  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    const T y = T(4) * (x(0) - T(7));
    return zeros::VectorOf<T>::Constant(1, y * y * y - y - T(16) * (p(0) - T(1) / T(2)));
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return families::SymmetricClosing{families::LoadPhase::first}.motion<T>(
        (zeros::VectorOf<T>(2) << x(0), T(1)).finished(), p);
  }
  [[nodiscard]] zeros::Vector unknowns(const motion::Motion& motion) const {
    return zeros::Vector::Constant(1, motion.phases[0].duration);
  }
};

}  // namespace

TEST_CASE("parts over which different motions exist do not fit together") {
  // The zero y = 0 ends at a fold, but over each half of the box there is an outer one, which Newton's method
  // finds.
  const Example example = example_S();
  const motion::Closing equations = Cubic{};
  const motion::Motion middle = equations.motion<Ball>(
      zeros::Vector::Constant(1, Ball(7)), equations.parameters({box(example.question, "", 0).data}));
  const families::Candidate cubic{{middle, {}, {}}, equations};
  const auto over = [&](const char * radius) {
    return prove_over_box(*example.question.family, cubic,
                          box(example.question, "chi", parse_rational(radius)));
  };
  CHECK(over("0.04").existence.truth == Truth::proved);  // the folds are at chi = 0.5 (1 ± 0.048)
  const OrbitOverBox beyond = over("0.3");
  CHECK(beyond.parts > 1);
  CHECK(beyond.existence.truth == Truth::undecided);
  CHECK(beyond.existence.reason == "the motions over two parts of the box may be different ones");
}
