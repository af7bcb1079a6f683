#include "report/audit/comparison.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "report/audit/json.hpp"
#include "report/tools/files.hpp"
#include "tests/report/audit/sample.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::report;
using namespace stickslip::report::audit;
using namespace stickslip::report::tools;

namespace {

Json sample() {
  Json audit = to_json({sample_paper(), sample_audit()});
  audit["examples"] =
      Json::parse(R"([{"name": "S", "orbits": {"parameters": {"chi": "0.5"}, "complete": true, "orbits": [
    {"tau": {"mid": "2.45", "rad": "1e-3"}, "admissible": true, "stability": "stable",
     "conditions": [{"id": "slip", "verdict": "proved", "margin": {"mid": "6.58", "rad": "0.01"}}]}]}}])");
  return audit;
}

Json& claim(Json& audit, const std::string& id) {
  for (Json& place : audit.at("places")) {
    for (Json& one : place.at("claims")) {
      if (one.at("id") == id) {
        return one;
      }
    }
  }
  throw InternalError("the sample has no claim " + id);
}

Json& orbit(Json& audit) {
  return audit.at("examples").at(0).at("orbits").at("orbits").at(0);
}

// The only difference, as "ID: WHAT".
std::string only_difference(const Json& older, const Json& newer) {
  const Comparison found = compare(older, newer);
  CHECK_FALSE(found.is_same());
  return found.differences.size() == 1 ? found.differences[0].id + ": " + found.differences[0].what
                                       : to_text(found);
}

}  // namespace

TEST_CASE("an audit is the same as itself, and its words may change") {
  Json other = sample();
  claim(other, "44").at("words") = "said otherwise";
  other.at("program").at("version") = "7.1";
  const Comparison same = compare(sample(), other);
  CHECK(same.is_same());
  CHECK(same.same > 10);
  CHECK(to_text(same) ==
        "Beside what stickslip " + sample().at("program").at("version").get<std::string>() +
            " found: " + std::to_string(same.same) +
            " statements, claims and orbits are the same, 0 differ, 0 are gone, 0 are new.\n");
}

TEST_CASE("whatever is decided otherwise differs") {
  Json other = sample();
  claim(other, "5").at("status") = "refuted";
  CHECK(only_difference(sample(), other) == "5: status");
  other = sample();
  claim(other, "5").at("outcome").at("theorems").push_back("|- (0 = 1)");
  CHECK(only_difference(sample(), other) == "5: theorems");
  other = sample();
  claim(other, "5.where").at("outcome").at("hypotheses") = Json::array();
  CHECK(only_difference(sample(), other) == "5.where: hypotheses");
  other = sample();
  claim(other, "44").at("printed").at(0).at("text") = "H = 0";
  CHECK(only_difference(sample(), other) == "44: what is printed");
  other = sample();
  other.at("statements").at(0).at("status") = "undecided";
  CHECK(only_difference(sample(), other) ==
        sample().at("statements").at(0).at("id").get<std::string>() + ": status");
  other = sample();
  orbit(other).at("conditions").at(0).at("verdict") = "refuted";
  CHECK(only_difference(sample(), other) == "example S, orbit 1: condition slip");
  other = sample();
  orbit(other).at("stability") = "unstable";
  CHECK(only_difference(other, sample()) == "example S, orbit 1: stability");
}

TEST_CASE("a number is the same where the balls meet") {
  Json other = sample();
  orbit(other).at("tau") = {{"mid", "2.4515"}, {"rad", "5e-4"}};
  CHECK(compare(sample(), other).is_same());
  orbit(other).at("tau").at("rad") = "4.9e-4";
  CHECK(only_difference(sample(), other) == "example S, orbit 1: tau");
  CHECK(to_text(compare(sample(), other))
            .starts_with("example S, orbit 1: tau\n  before  2.45 ± 1e-3\n  now     2.4515 ± 4.9e-4\n"));
  other = sample();
  orbit(other).at("conditions").at(0).at("margin").at("mid") = "7";
  CHECK(compare(sample(), other).is_same());
  other = sample();
  claim(other, "S.tau").at("outcome").at("comparisons").at(0).at("proved") = {{"mid", "1"}, {"rad", "0"}};
  CHECK(only_difference(sample(), other) == "S.tau: tau");
}

TEST_CASE("what is gone is a difference, and what is new is none") {
  Json other = sample();
  Json& orbits = other.at("examples").at(0).at("orbits").at("orbits");
  orbits.push_back(orbits.at(0));
  const Comparison more = compare(sample(), other);
  CHECK(more.is_same());
  CHECK(more.added == std::vector<std::string>{"example S, orbit 2"});
  const Comparison less = compare(other, sample());
  CHECK_FALSE(less.is_same());
  CHECK(less.gone == std::vector<std::string>{"example S, orbit 2"});
  CHECK(mentions(to_text(less), "example S, orbit 2 is gone\n"));
}

TEST_CASE("what is no audit, or of a layout with another first number, is refused") {
  const TemporaryDirectory temporary;
  const auto read = [&temporary](const std::string& text) {
    write_file(temporary.path() / "old.json", text);
    return read_audit(temporary.path() / "old.json");
  };
  CHECK(read(to_text(sample())) == sample());
  CHECK_THROWS_WITH_AS(static_cast<void>(read("no JSON")), doctest::Contains("is not the JSON of an audit"),
                       UsageError);
  CHECK_THROWS_WITH_AS(static_cast<void>(read("{\"schema_version\": \"2.0\"}")),
                       doctest::Contains("it has no program"), UsageError);
  Json other = sample();
  other.at("schema_version") = "1.9";
  CHECK_THROWS_WITH_AS(static_cast<void>(read(to_text(other))), doctest::Contains("schema_version 1.9"),
                       UsageError);
  other = sample();
  other.at("statements").at(0).erase("status");
  CHECK_THROWS_WITH_AS(static_cast<void>(read(to_text(other))), doctest::Contains("key 'status' not found"),
                       UsageError);
  CHECK_THROWS_AS(static_cast<void>(read_audit(temporary.path() / "none.json")), InputOutputError);
}
