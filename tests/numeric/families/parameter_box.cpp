// Whole boxes of parameters at once.
#include "numeric/families/parameter_box.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <random>
#include <tuple>

#include "core/error.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/symmetric.hpp"
#include "tests/numeric/families/composed.hpp"

using namespace stickslip;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::examples;

namespace {

Ball around(const Ball& middle, const char * radius) {
  const Ball r(parse_rational(radius));
  return middle + Ball::hull(-r, r);
}

SymmetricState<Ball> state_S(const ExactParameters& a) {
  for (const SymmetricProof& proof : solve_symmetric(a, 30)) {
    if (proof.existence.truth == Truth::proved && proof.orbit.phase == LoadPhase::first &&
        near(proof.orbit.state.tau, "7.749", "0.1")) {
      return proof.orbit.state;
    }
  }
  FAIL("no orbit S");
  return {};
}

std::vector<double> guess_S() {
  const SymmetricState<Ball> s = state_S(S());
  return {s.tau.approximate(), s.C.approximate()};
}

std::vector<double> guess_O() {
  const ComposedOrbit orbit = orbit_O();
  std::vector<double> guess;
  for (int i = 0; i < 5; ++i) {
    guess.push_back(orbit.proof.box(i).approximate());
  }
  return guess;
}

std::vector<double> guess_P() {
  const NonstickingOrbit orbit = list_nonsticking(P(), 20).orbits.at(0);
  return {orbit.box(0).approximate(), orbit.box(1).approximate()};
}

}  // namespace

TEST_CASE("a box of no width gives the orbit itself") {
  const BoxOrbit S_box = prove_symmetric_over(parameters_as<Ball>(S()), 1, guess_S());
  REQUIRE(S_box.existence.truth == Truth::proved);
  CHECK(S_box.zero[0].overlaps(state_S(S()).tau));
  CHECK(S_box.ur.overlaps(state_S(S()).ur));
  CHECK((S_box.ur.radius() - Ball(1e-20)).is_negative());
  CHECK(admissible(S_box.conditions).truth == Truth::proved);
  const BoxOrbit O_box = prove_overshooting_over(parameters_as<Ball>(O()), Ball(0), guess_O());
  REQUIRE(O_box.existence.truth == Truth::proved);
  CHECK(O_box.ur.overlaps(orbit_O().ur));
  CHECK(admissible(O_box.conditions).truth == Truth::proved);
  const BoxOrbit P_box =
      prove_nonsticking_over(parameters_as<Ball>(P()), Ball(parse_rational("0.2996")), guess_P());
  REQUIRE(P_box.existence.truth == Truth::proved);
  CHECK(P_box.ur.overlaps(list_nonsticking(P(), 20).orbits[0].ur_max));
  CHECK(admissible(P_box.conditions).truth == Truth::proved);
}

TEST_CASE("chi = 0.5 ± 1e-4: example S exists and is admissible for every member") {
  model::Parameters<Ball> a = parameters_as<Ball>(S());
  a.chi = around(a.chi, "1e-4");
  const BoxOrbit orbit = prove_symmetric_over(a, 1, guess_S());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(orbit.split == "chi");
  for (const Condition& condition : orbit.conditions) {
    CAPTURE(condition.id);
    CAPTURE(condition.verdict.reason);
    CHECK(condition.verdict.truth == Truth::proved);
  }
  // The enclosures hold the orbits of members, ends of the box included, and are not wildly larger.
  Ball hull = orbit.ur.midpoint();
  for (const char * chi : {"0.4999", "0.49993", "0.5", "0.50004", "0.5001"}) {
    CAPTURE(chi);
    const SymmetricState<Ball> member = state_S(parse_parameters(chi, "3.8", "0.02", "1", "0.6", "0.05"));
    CHECK(orbit.zero[0].contains(member.tau));
    CHECK(orbit.ur.contains(member.ur));
    CHECK(orbit.motion.phases[0].Z(0).contains(member.z10));
    CHECK(orbit.motion.phases[0].load.contains(member.phi));
    hull = Ball::hull(hull, member.ur);
  }
  CHECK((orbit.ur.radius() - Ball(3) * hull.radius()).is_negative());
}

TEST_CASE("the margins over a box contain those of its members") {
  model::Parameters<Ball> a = parameters_as<Ball>(O());
  a.V = around(a.V, "2e-5");
  a.p = around(a.p, "2e-6");
  const BoxOrbit orbit = prove_overshooting_over(a, around(Ball(0), "1e-5"), guess_O());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(admissible(orbit.conditions).truth == Truth::proved);
  for (const char * V : {"0.99998", "1.00001", "1.00002"}) {
    const ExactParameters member = parse_parameters("0.2", "4", "0.05", V, "0.6289", "0.050001");
    const BoxOrbit narrow =
        prove_overshooting_over(parameters_as<Ball>(member), Ball(parse_rational("-0.000007")), guess_O());
    REQUIRE(narrow.existence.truth == Truth::proved);
    for (std::size_t i = 0; i < narrow.conditions.size(); ++i) {
      CAPTURE(narrow.conditions[i].id);
      CHECK(orbit.conditions[i].margin->contains(*narrow.conditions[i].margin));
    }
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(orbit.zero[i].contains(narrow.zero[i]));
    }
  }
}

TEST_CASE("an engineer knows the friction, not the phase: example O over a box of u_r") {
  std::vector<double> guess = guess_O();
  guess.push_back(0);
  const Ball ur = orbit_O().ur.midpoint();
  const BoxOrbit point = prove_overshooting_at_friction_over(parameters_as<Ball>(O()), ur, guess);
  REQUIRE(point.existence.truth == Truth::proved);
  CHECK(near(point.zero[5], "0", "1e-20"));
  const BoxOrbit box =
      prove_overshooting_at_friction_over(parameters_as<Ball>(O()), around(ur, "1e-6"), guess);
  REQUIRE(box.existence.truth == Truth::proved);
  CHECK(box.split == "ur");
  CHECK(admissible(box.conditions).truth == Truth::proved);
  CHECK(box.zero[0].contains(point.zero[0]));
  const BoxOrbit member =
      prove_overshooting_at_friction_over(parameters_as<Ball>(O()), ur + Ball(9e-7), guess);
  REQUIRE(member.existence.truth == Truth::proved);
  CHECK(box.zero[5].contains(member.zero[5]));
  CHECK_FALSE(point.zero[5].overlaps(member.zero[5]));
}

TEST_CASE("example P is one of a family through V = 0") {
  model::Parameters<Ball> a = parameters_as<Ball>(P());
  a.V = around(Ball(0), "0.01");
  a.chi = around(a.chi, "1e-4");
  const BoxOrbit orbit = prove_nonsticking_over(a, around(Ball(parse_rational("0.2")), "0.01"), guess_P());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(admissible(orbit.conditions).truth == Truth::proved);
  const BoxOrbit without = prove_nonsticking_over(a, std::nullopt, guess_P());
  CHECK(admissible(without.conditions).truth == Truth::proved);
  const BoxOrbit grazing = prove_nonsticking_over(a, Ball(parse_rational("0.2996")), guess_P());
  CHECK(admissible(grazing.conditions).truth == Truth::undecided);
}

TEST_CASE("(36) is decided over boxes with V = 0, as (25) is") {
  model::Parameters<Ball> a = parameters_as<Ball>(P());
  a.p = around(a.p, "1e-4");
  const auto condition = [&](const char * ur, const char * id) {
    for (const Condition& c : prove_nonsticking_over(a, Ball(parse_rational(ur)), guess_P()).conditions) {
      if (c.id == id) {
        return c.verdict.truth;
      }
    }
    return Truth::out_of_domain;
  };
  for (const char * ur : {"0.29", "0.2996", "0.31"}) {
    CAPTURE(ur);
    CHECK(condition(ur, "36") == condition(ur, "25"));
  }
  CHECK(condition("0.29", "36") == Truth::proved);
  CHECK(condition("0.31", "36") == Truth::refuted);
  a.V = around(a.V, "1e-5");
  CHECK(condition("0.29", "36") == Truth::out_of_domain);  // not a condition of these orbits
}

TEST_CASE("boxes that are too wide are undecided and name the parameter to split") {
  model::Parameters<Ball> a = parameters_as<Ball>(S());
  a.chi = around(a.chi, "0.05");
  a.p = around(a.p, "1e-6");
  const BoxOrbit orbit = prove_symmetric_over(a, 1, guess_S());
  CHECK(orbit.existence.truth == Truth::undecided);
  CHECK(orbit.split == "chi");
  CHECK(orbit.conditions.empty());
  a = parameters_as<Ball>(S());
  a.omega = around(a.omega, "0.5");  // holds a natural frequency
  CHECK(prove_symmetric_over(a, 1, guess_S()).existence.truth == Truth::undecided);
}

namespace {

using Data = model::Parameters<Ball>;

struct Subject {
  const char * name;
  Data data;
  std::vector<double> guess;
  std::function<BoxOrbit(const Data&, const std::vector<double>&)> prove;
};

std::vector<Subject> examples_over_boxes() {
  return {
      {"S", parameters_as<Ball>(S()), guess_S(),
       [](const Data& a, const std::vector<double>& guess) { return prove_symmetric_over(a, 1, guess); }},
      {"O", parameters_as<Ball>(O()), guess_O(),
       [](const Data& a, const std::vector<double>& guess) {
         return prove_overshooting_over(a, Ball(0), guess);
       }},
      {"P", parameters_as<Ball>(P("0.1")), guess_P(), [](const Data& a, const std::vector<double>& guess) {
         return prove_nonsticking_over(a, Ball(parse_rational("0.2")), guess);
       }}};
}

const std::vector<std::pair<const char *, Ball Data::*>>& parameters() {
  static const std::vector<std::pair<const char *, Ball Data::*>> all{
      {"chi", &Data::chi}, {"eta", &Data::eta},     {"us", &Data::us},
      {"V", &Data::V},     {"omega", &Data::omega}, {"p", &Data::p}};
  return all;
}

bool is_proved(const Verdict& verdict) {
  return verdict.truth == Truth::proved;
}

// That the orbit of the member is the one that the wide proof speaks of, and that all holds there that was
// proved over the whole box.
void check_member(const Subject& example, const BoxOrbit& wide, const Data& member) {
  std::vector<double> guess;
  for (const Ball& unknown : wide.zero) {
    guess.push_back(unknown.approximate());
  }
  const BoxOrbit narrow = example.prove(member, guess);
  REQUIRE(is_proved(narrow.existence));
  for (std::size_t i = 0; i < wide.zero.size(); ++i) {
    CHECK(wide.zero[i].contains(narrow.zero[i]));
  }
  CHECK(wide.ur.contains(narrow.ur));
  REQUIRE(narrow.conditions.size() == wide.conditions.size());
  for (std::size_t i = 0; i < wide.conditions.size(); ++i) {
    CAPTURE(wide.conditions[i].id);
    const Truth over_all = wide.conditions[i].verdict.truth;
    const bool decided = over_all == Truth::proved || over_all == Truth::refuted;
    CHECK((!decided || narrow.conditions[i].verdict.truth == over_all));
  }
}

}  // namespace

TEST_CASE("parameters widened until the proof gives up: what is proved holds at both ends") {
  for (const Subject& example : examples_over_boxes()) {
    CAPTURE(std::string(example.name));
    for (const auto& [name, parameter] : parameters()) {
      CAPTURE(std::string(name));
      int proved = 0;
      for (const char * width : {"1e-8", "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "0.1"}) {
        CAPTURE(std::string(width));
        Data wide = example.data;
        wide.*parameter = around(example.data.*parameter, width);
        const BoxOrbit orbit = example.prove(wide, example.guess);
        if (!is_proved(orbit.existence)) {
          break;
        }
        ++proved;
        for (const Ball& end : {(wide.*parameter).lower(), (wide.*parameter).upper()}) {
          Data member = example.data;
          member.*parameter = end;
          check_member(example, orbit, member);
        }
      }
      CHECK(proved >= 2);
    }
  }
}

TEST_CASE("parameters widened over a resonance or beyond the domain: nothing is proved") {
  for (const Subject& example : examples_over_boxes()) {
    CAPTURE(std::string(example.name));
    const model::Modes<Ball> modes = model::modes<Ball>(example.data.chi, example.data.eta);
    const std::vector<std::tuple<const char *, Ball Data::*, Ball>> beyond{
        {"omega1", &Data::omega, modes.omega1}, {"omega2", &Data::omega, modes.omega2},
        {"chi = 0", &Data::chi, Ball(0)},       {"chi = 1", &Data::chi, Ball(1)},
        {"eta = 0", &Data::eta, Ball(0)},       {"omega = 0", &Data::omega, Ball(0)}};
    for (const auto& [name, parameter, end] : beyond) {
      CAPTURE(std::string(name));
      Data wide = example.data;
      wide.*parameter = Ball::hull(example.data.*parameter, end);
      CHECK_FALSE(is_proved(example.prove(wide, example.guess).existence));
    }
  }
}

TEST_CASE("a wrong number of unknowns is the caller's error") {
  CHECK_THROWS_AS((void)prove_symmetric_over(parameters_as<Ball>(S()), 1, {1, 2, 3}), InternalError);
}
