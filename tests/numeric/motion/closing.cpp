// Closed motions over whole boxes of parameters at once.
#include "numeric/motion/closing.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <random>
#include <tuple>

#include "core/error.hpp"
#include "numeric/orbit_over_box.hpp"
#include "tests/numeric/families/composed.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::examples;

namespace {

Ball around(const Ball& middle, const char * radius) {
  const Ball r(parse_rational(radius));
  return middle + Ball::hull(-r, r);
}

// What the examples' systems are.
const Closing system_S = SymmetricClosing{LoadPhase::first};
const Closing system_O = OvershootingClosing{true, false};
const Closing system_O_at_ur = OvershootingClosing{false, true};
const Closing system_P = NonstickingClosing{};

using Data = model::Parameters<Ball>;

using BoxOrbit = OrbitOverBox;

// The whole box at once.
BoxOrbit prove_over(const Family& family, const Closing& f, const Given<Ball>& given, const Motion& guess) {
  return prove_over_box(family, {{guess, {}, {}}, f}, given, 1);
}
BoxOrbit prove_symmetric_over(const Data& a, const Motion& guess) {
  return prove_over(symmetric(), system_S, {a}, guess);
}
BoxOrbit prove_overshooting_over(const Data& a, const Ball& phi, const Motion& guess) {
  return prove_over(overshooting(), system_O, {a, phi}, guess);
}
BoxOrbit prove_overshooting_at_friction_over(const Data& a, const Ball& ur, const Motion& guess) {
  return prove_over(overshooting(), system_O_at_ur, {a, {}, ur}, guess);
}
BoxOrbit prove_nonsticking_over(const Data& a, const std::optional<Ball>& ur, const Motion& guess) {
  return prove_over(nonsticking(), system_P, {a, {}, ur}, guess);
}

Orbit state_S(const ExactParameters& a) {
  for (const Orbit& orbit : listed(symmetric(), a, 30).orbits) {
    if (near(orbit.value("tau"), "7.749", "0.1")) {
      return orbit;
    }
  }
  FAIL("no orbit S");
  return {};
}

Motion guess_S() {
  return state_S(S()).motion;
}

Motion guess_O() {
  return orbit_O().motion;
}

Motion guess_P() {
  return listed(nonsticking(), P(), 20).orbits.at(0).motion;
}

bool contains(const BoxOrbit& wide, const BoxOrbit& narrow, const char * name) {
  return wide.orbit.value(name).contains(narrow.orbit.value(name));
}

}  // namespace

TEST_CASE("a box of no width gives the orbit itself") {
  const BoxOrbit S_box = prove_symmetric_over(parameters_as<Ball>(S()), guess_S());
  REQUIRE(S_box.existence.truth == Truth::proved);
  CHECK(S_box.orbit.value("tau").overlaps(state_S(S()).value("tau")));
  CHECK(S_box.orbit.value("ur").overlaps(state_S(S()).value("ur")));
  CHECK((S_box.orbit.value("ur").radius() - Ball(1e-20)).is_negative());
  CHECK(admissible(S_box.orbit.conditions).truth == Truth::proved);
  const BoxOrbit O_box = prove_overshooting_over(parameters_as<Ball>(O()), Ball(0), guess_O());
  REQUIRE(O_box.existence.truth == Truth::proved);
  CHECK(O_box.orbit.value("ur").overlaps(orbit_O().ur));
  CHECK(admissible(O_box.orbit.conditions).truth == Truth::proved);
  const BoxOrbit P_box =
      prove_nonsticking_over(parameters_as<Ball>(P()), Ball(parse_rational("0.2996")), guess_P());
  REQUIRE(P_box.existence.truth == Truth::proved);
  CHECK(prove_nonsticking_over(parameters_as<Ball>(P()), {}, guess_P())
            .orbit.value("ur_max")
            .overlaps(listed(nonsticking(), P(), 20).orbits[0].value("ur_max")));
  CHECK(admissible(P_box.orbit.conditions).truth == Truth::proved);
}

TEST_CASE("chi = 0.5 ± 1e-4: example S exists and is admissible for every member") {
  model::Parameters<Ball> a = parameters_as<Ball>(S());
  a.chi = around(a.chi, "1e-4");
  const BoxOrbit orbit = prove_symmetric_over(a, guess_S());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(orbit.split == "chi");
  for (const Condition& condition : orbit.orbit.conditions) {
    CAPTURE(condition.id);
    CAPTURE(condition.verdict.reason);
    CHECK(condition.verdict.truth == Truth::proved);
  }
  // The enclosures hold the orbits of members, ends of the box included, and are not wildly larger.
  const Ball& ur = orbit.orbit.value("ur");
  Ball hull = ur.midpoint();
  for (const char * chi : {"0.4999", "0.49993", "0.5", "0.50004", "0.5001"}) {
    CAPTURE(chi);
    const Orbit member = state_S(parse_parameters(chi, "3.8", "0.02", "1", "0.6", "0.05"));
    CHECK(orbit.orbit.value("tau").contains(member.value("tau")));
    CHECK(orbit.orbit.value("ur").contains(member.value("ur")));
    CHECK(orbit.orbit.value("z10").contains(member.value("z10")));
    CHECK(orbit.orbit.value("phi").contains(member.value("phi")));
    hull = Ball::hull(hull, member.value("ur"));
  }
  CHECK((ur.radius() - Ball(3) * hull.radius()).is_negative());
}

TEST_CASE("the margins over a box contain those of its members") {
  model::Parameters<Ball> a = parameters_as<Ball>(O());
  a.V = around(a.V, "2e-5");
  a.p = around(a.p, "2e-6");
  const BoxOrbit orbit = prove_overshooting_over(a, around(Ball(0), "1e-5"), guess_O());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(admissible(orbit.orbit.conditions).truth == Truth::proved);
  for (const char * V : {"0.99998", "1.00001", "1.00002"}) {
    const ExactParameters member = parse_parameters("0.2", "4", "0.05", V, "0.6289", "0.050001");
    const BoxOrbit narrow =
        prove_overshooting_over(parameters_as<Ball>(member), Ball(parse_rational("-0.000007")), guess_O());
    REQUIRE(narrow.existence.truth == Truth::proved);
    for (std::size_t i = 0; i < narrow.orbit.conditions.size(); ++i) {
      CAPTURE(narrow.orbit.conditions[i].id);
      CHECK(orbit.orbit.conditions[i].margin->contains(*narrow.orbit.conditions[i].margin));
    }
    for (const char * name : {"tau", "tau1", "z10", "z20", "zdot10"}) {
      CHECK(contains(orbit, narrow, name));
    }
  }
}

TEST_CASE("an engineer knows the friction, not the phase: example O over a box of u_r") {
  const Motion guess = guess_O();
  const Ball ur = orbit_O().ur.midpoint();
  const BoxOrbit point = prove_overshooting_at_friction_over(parameters_as<Ball>(O()), ur, guess);
  REQUIRE(point.existence.truth == Truth::proved);
  CHECK(near(point.orbit.value("phi"), "0", "1e-20"));
  const BoxOrbit box =
      prove_overshooting_at_friction_over(parameters_as<Ball>(O()), around(ur, "1e-6"), guess);
  REQUIRE(box.existence.truth == Truth::proved);
  CHECK(box.split == "ur");
  CHECK(admissible(box.orbit.conditions).truth == Truth::proved);
  CHECK(contains(box, point, "tau"));
  const BoxOrbit member =
      prove_overshooting_at_friction_over(parameters_as<Ball>(O()), ur + Ball(9e-7), guess);
  REQUIRE(member.existence.truth == Truth::proved);
  CHECK(contains(box, member, "phi"));
  CHECK_FALSE(point.orbit.value("phi").overlaps(member.orbit.value("phi")));
}

TEST_CASE("example P is one of a family through V = 0") {
  model::Parameters<Ball> a = parameters_as<Ball>(P());
  a.V = around(Ball(0), "0.01");
  a.chi = around(a.chi, "1e-4");
  const BoxOrbit orbit = prove_nonsticking_over(a, around(Ball(parse_rational("0.2")), "0.01"), guess_P());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(admissible(orbit.orbit.conditions).truth == Truth::proved);
  const BoxOrbit without = prove_nonsticking_over(a, std::nullopt, guess_P());
  CHECK(admissible(without.orbit.conditions).truth == Truth::proved);
  const BoxOrbit grazing = prove_nonsticking_over(a, Ball(parse_rational("0.2996")), guess_P());
  CHECK(admissible(grazing.orbit.conditions).truth == Truth::undecided);
}

TEST_CASE("(36) is decided over boxes with V = 0, as (25) is") {
  model::Parameters<Ball> a = parameters_as<Ball>(P());
  a.p = around(a.p, "1e-4");
  const auto condition = [&](const char * ur, const char * id) -> std::optional<Truth> {
    for (const Condition& c :
         prove_nonsticking_over(a, Ball(parse_rational(ur)), guess_P()).orbit.conditions) {
      if (c.id == id) {
        return c.verdict.truth;
      }
    }
    return std::nullopt;
  };
  for (const char * ur : {"0.29", "0.2996", "0.31"}) {
    CAPTURE(ur);
    CHECK(condition(ur, "36") == condition(ur, "25"));
  }
  CHECK(condition("0.29", "36") == Truth::proved);
  CHECK(condition("0.31", "36") == Truth::refuted);
  a.V = around(a.V, "1e-5");
  CHECK_FALSE(condition("0.29", "36").has_value());  // not a condition of these orbits
}

TEST_CASE("boxes that are too wide are undecided and name the parameter to split") {
  model::Parameters<Ball> a = parameters_as<Ball>(S());
  a.chi = around(a.chi, "0.05");
  a.p = around(a.p, "1e-6");
  const BoxOrbit orbit = prove_symmetric_over(a, guess_S());
  CHECK(orbit.existence.truth == Truth::undecided);
  CHECK(orbit.split == "chi");
  CHECK(orbit.orbit.conditions.empty());
  a = parameters_as<Ball>(S());
  a.omega = around(a.omega, "0.5");  // holds a natural frequency
  CHECK(prove_symmetric_over(a, guess_S()).existence.truth == Truth::undecided);
}

namespace {

struct Subject {
  const char * name;
  Data data;
  Motion guess;
  std::function<BoxOrbit(const Data&, const Motion&)> prove;
};

std::vector<Subject> examples_over_boxes() {
  return {{"S", parameters_as<Ball>(S()), guess_S(),
           [](const Data& a, const Motion& guess) { return prove_symmetric_over(a, guess); }},
          {"O", parameters_as<Ball>(O()), guess_O(),
           [](const Data& a, const Motion& guess) { return prove_overshooting_over(a, Ball(0), guess); }},
          {"P", parameters_as<Ball>(P("0.1")), guess_P(), [](const Data& a, const Motion& guess) {
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
  const BoxOrbit narrow = example.prove(member, wide.orbit.motion);
  REQUIRE(is_proved(narrow.existence));
  for (const NamedBall& value : wide.orbit.values) {
    CAPTURE(value.name);
    // What does not depend on the wide parameter differs by rounding only.
    const Ball rounding = Ball::hull(Ball(-1e-30), Ball(1e-30));
    CHECK((value.value + rounding).contains(narrow.orbit.value(value.name)));
  }
  REQUIRE(narrow.orbit.conditions.size() == wide.orbit.conditions.size());
  for (std::size_t i = 0; i < wide.orbit.conditions.size(); ++i) {
    CAPTURE(wide.orbit.conditions[i].id);
    const Truth over_all = wide.orbit.conditions[i].verdict.truth;
    const bool decided = over_all == Truth::proved || over_all == Truth::refuted;
    CHECK((!decided || narrow.orbit.conditions[i].verdict.truth == over_all));
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

TEST_CASE("a guess with other phases and a datum that is not given are the caller's errors") {
  CHECK_THROWS_AS((void)prove_symmetric_over(parameters_as<Ball>(S()), guess_O()), InternalError);
  CHECK_THROWS_AS((void)prove_over(overshooting(), system_O, {parameters_as<Ball>(O())}, guess_O()),
                  InternalError);
}
