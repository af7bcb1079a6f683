// Lists of orbits as JSON and on a terminal.
#include "report/orbits/orbits.hpp"
#include "numeric/families/family.hpp"

#include <doctest/doctest.h>

#include <set>
#include <sstream>

#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::motion;
using namespace stickslip::proofs::pascal2012;
using report::tools::Json;

namespace {

// No number anywhere: values are decimal strings.
void check_no_floats(const Json& json) {
  CHECK_FALSE(json.is_number());
  if (json.is_structured()) {
    for (const Json& member : json) {
      check_no_floats(member);
    }
  }
}

// {"mid", "rad"}: decimal strings, the radius not negative.
void check_ball(const Json& json) {
  CHECK(json.size() == 2);
  CHECK_NOTHROW((void)parse_decimal(json.at("mid").get<std::string>()));
  CHECK(parse_decimal(json.at("rad").get<std::string>()).value >= 0);
}

std::set<std::string> balls_of_family(const OrbitQuestion& q) {
  std::set<std::string> names{"tau", "Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10"};
  names.insert(!families::has_stick(*q.family) && !q.ur ? "ur_max" : "ur");
  names.insert(q.family->durations.begin(), q.family->durations.end());
  return names;
}

void check_orbit(const Json& orbit, const OrbitQuestion& q) {
  std::set<std::string> expected = balls_of_family(q);
  for (const std::string& name : expected) {
    check_ball(orbit.at(name));
  }
  expected.insert({"admissible", "conditions"});
  if (orbit.at("admissible") == true) {
    expected.insert({"multipliers", "stability"});
    CHECK(orbit.at("multipliers").size() == 4);
    for (const Json& mu : orbit.at("multipliers")) {
      check_ball(mu.at("re"));
      check_ball(mu.at("im"));
    }
    if (orbit.at("stability") == "stable") {
      expected.insert("contact");
      check_ball(orbit.at("contact").at("margin"));
      check_ball(orbit.at("contact").at("at"));
    }
  }
  std::set<std::string> found;
  for (const auto& [key, value] : orbit.items()) {
    found.insert(key);
  }
  CHECK(found == expected);
  CHECK(orbit.at("admissible").is_boolean());
  CHECK_FALSE(orbit.at("conditions").empty());
  for (const Json& condition : orbit.at("conditions")) {
    CHECK(condition.contains("id"));
    CHECK(condition.contains("statement"));
    check_ball(condition.at("margin"));
    const bool proved = condition.at("verdict") == "proved";
    CHECK(condition.contains("reason") != proved);
  }
}

std::size_t admissible_ones(const Json& list) {
  std::size_t count = 0;
  for (const Json& orbit : list.at("orbits")) {
    count += orbit.at("admissible") == true ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("the examples as JSON have the published keys, and no float anywhere") {
  for (const auto& example : printed_examples()) {
    CAPTURE(example.name);
    const OrbitQuestion q = question_of(example);
    const Json json = report::orbits::to_json(list_orbits(q));
    check_no_floats(json);
    CHECK(json.at("family") == example.family->name);
    CHECK(json.at("parameters").at("chi") == to_string(example.data.chi));
    CHECK(json.at("parameters").contains("phi") == example.phi.has_value());
    CHECK(json.at("complete") == true);
    CHECK(json.at("unresolved").empty());
    CHECK_FALSE(json.at("orbits").empty());
    CHECK(admissible_ones(json) >= 1);
    for (const Json& orbit : json.at("orbits")) {
      check_orbit(orbit, q);
    }
  }
}

TEST_CASE("without a friction at rest the largest admissible one is reported") {
  OrbitQuestion q = question_of(example_named("P"));
  q.ur.reset();
  const Json json = report::orbits::to_json(list_orbits(q));
  check_orbit(json.at("orbits").at(0), q);
  CHECK(json.at("orbits").at(0).at("admissible") == true);
}

TEST_CASE("as many digits as asked for") {
  const Json json = report::orbits::to_json(list_orbits(question_of(example_named("S"), 200)));
  for (const Json& orbit : json.at("orbits")) {
    const Json& tau = orbit.at("tau");
    CHECK(tau.at("mid").get<std::string>().size() == 201);
    const Rational rad = parse_decimal(tau.at("rad").get<std::string>()).value;
    CHECK(rad < parse_rational("1e-198"));
  }
}

TEST_CASE("two precisions overlap") {
  const Json rough = report::orbits::to_json(list_orbits(question_of(example_named("O"), 5)));
  const Json fine = report::orbits::to_json(list_orbits(question_of(example_named("O"), 50)));
  REQUIRE(rough.at("orbits").size() == fine.at("orbits").size());
  const auto ball = [](const Json& json) {
    const Rational mid = parse_decimal(json.at("mid").get<std::string>()).value;
    const Rational rad = parse_decimal(json.at("rad").get<std::string>()).value;
    return Ball::from_interval(mid - rad, mid + rad);
  };
  for (std::size_t i = 0; i < rough.at("orbits").size(); ++i) {
    for (const char * name : {"tau", "tau1", "z10", "ur"}) {
      CHECK(ball(rough.at("orbits").at(i).at(name)).overlaps(ball(fine.at("orbits").at(i).at(name))));
    }
  }
}

TEST_CASE("a box of parameters is never called complete, and a wide one says where to split") {
  OrbitQuestion q = question_of(example_named("P"));
  q.parameters.p.radius = parse_rational("1e-2");
  const OrbitList list = list_orbits(q);
  CHECK_FALSE(list.complete());
  CHECK_FALSE(all_decided(list));
  const Json json = report::orbits::to_json(list);
  CHECK(json.at("complete") == false);
  CHECK(json.at("parameters").at("p") == "1+-0.01");
  CHECK(json.at("orbits").at(0).at("admissible").is_null());
  CHECK(json.at("orbits").at(0).at("split") == "p");
  q.parameters.p.radius = parse_rational("1e-6");
  CHECK(all_decided(list_orbits(q)));
}

TEST_CASE("the terminal report keeps to its width and names every condition") {
  for (const auto& example : printed_examples()) {
    const OrbitList list = list_orbits(question_of(example));
    const std::string text = report::orbits::terminal_report(list, {});
    CHECK(text.find("complete: ") != std::string::npos);
    CHECK(text.find('\x1b') == std::string::npos);
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      CAPTURE(line);
      CHECK(report::tools::columns(line) <= 80);
    }
    for (const Condition& condition : list.orbits.front().conditions) {
      CHECK(text.find("  " + condition.id + " ") != std::string::npos);
    }
  }
}

TEST_CASE("a rounded ball shows no digit that it does not know") {
  CHECK(report::tools::rounded(Ball(parse_rational("1/3")), 5) == "0.33333");
  CHECK(report::tools::rounded(Ball(2), 5) == "2");
  const Ball wide = Ball::from_interval(parse_rational("1.2340"), parse_rational("1.2344"));
  CHECK(report::tools::rounded(wide, 9).size() <= 5);
  CHECK(report::tools::rounded(Ball::from_interval(-1, 1), 5).find("±") != std::string::npos);
  CHECK(report::tools::rounded(Ball(1) / Ball(0), 5) == "unbounded");
}

TEST_CASE("each value of an orbit is measured by its name: times, angles, lengths, velocities and forces") {
  const DataTaken taken = data_taken({2, 1, 8, 9, 1, 2, 1, 1, 1});
  const report::orbits::Units si(taken);
  const auto unit = [&](const std::string& name) {
    const std::string text = si.text({name, Ball(1)}, 5);
    return text.substr(text.rfind(' ') + 1);
  };
  for (const Family * family : all_families()) {
    OrbitQuestion q;
    q.family = family;
    for (const std::string& name : balls_of_family(q)) {
      CAPTURE(name);
      const std::string expected = name == "phi"                      ? "rad"
                                   : name.starts_with("ur")           ? "N"
                                   : name.find("dot") != name.npos    ? "m/s"
                                   : name[0] == 'x' || name[0] == 'z' ? "m"
                                                                      : "s";
      CHECK(unit(name) == expected);
      CHECK(report::orbits::is_time(name) == (expected == "s"));
    }
  }
  CHECK(unit("tau2") == "s");
  CHECK_THROWS_AS((void)unit("theta"), InternalError);
  CHECK_FALSE(report::orbits::is_time("theta"));
}
