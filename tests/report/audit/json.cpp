#include "report/audit/json.hpp"

#include <doctest/doctest.h>

#include "tests/report/audit/sample.hpp"

using namespace stickslip;
using namespace stickslip::report::tools;
using namespace stickslip::report;
using namespace stickslip::report::audit;
using namespace stickslip::proofs::methods;

namespace {

// The claim of that id in the JSON of the sample.
Json claim(const Json& audit, const std::string& id) {
  for (const Json& place : audit.at("places")) {
    for (const Json& c : place.at("claims")) {
      if (c.at("id") == id) {
        return c;
      }
    }
  }
  return nullptr;
}

// Whether a number occurs that is neither a count nor a string.
bool has_floating_number(const Json& json) {
  if (json.is_structured()) {
    for (const Json& value : json) {
      if (has_floating_number(value)) {
        return true;
      }
    }
  }
  return json.is_number_float();
}

}  // namespace

TEST_CASE("an audit survives the way through its text") {
  const Json json = to_json({sample_paper(), sample_audit()});
  CHECK(Json::parse(to_text(json)) == json);
  CHECK(to_text(json) == to_text(to_json({sample_paper(), sample_audit()})));
  CHECK(to_text(json).ends_with("}\n"));
}

TEST_CASE("numbers are text, exact or balls") {
  const Json json = to_json({sample_paper(), sample_audit()});
  CHECK_FALSE(has_floating_number(json));
  const Json comparison = claim(json, "S.tau").at("outcome").at("comparisons").at(0);
  CHECK(comparison.at("printed") == "7.749");
  CHECK(comparison.at("proved").at("mid") == "7.7503000000000000000");
  CHECK(comparison.at("proved").at("rad").get<std::string>().starts_with("1.0"));
  CHECK(comparison.at("units_off").at("mid") == "-1.300");
  const Json witness = claim(json, "44").at("outcome").at("witness");
  CHECK(witness.at("point").at(1).at("value") == "1/3");
  CHECK(witness.at("left").at("mid") == "1");
}

TEST_CASE("a claim says what is known, each key always there") {
  const Json json = to_json({sample_paper(), sample_audit()});
  CHECK(json.at("schema_version") == schema_version);
  const Json misprint = claim(json, "44");
  CHECK(misprint.at("status") == "misprint_corrected");
  CHECK(misprint.at("finding") == true);
  CHECK(misprint.at("outcome").at("verdict") == "refuted");
  CHECK(misprint.at("corrected_outcome").at("verdict") == "proved");
  CHECK(misprint.at("corrected_outcome").at("uses") == Json::array({"5"}));
  CHECK(misprint.at("assumptions").at(0).at("needed") == true);
  CHECK(misprint.at("assumptions").at(1).at("needed") == false);
  const Json proved = claim(json, "5");
  CHECK(proved.at("finding") == false);
  CHECK(proved.at("corrected_outcome").is_null());
  CHECK(proved.at("outcome").at("witness").is_null());
  CHECK(proved.at("outcome").at("free").at(0).at("latex") == "\\omega_1");
  CHECK(claim(json, "5.where").at("outcome").at("hypotheses").at(0).at("text") == "omega - omega1 != 0");
  for (const Json& place : json.at("places")) {
    for (const Json& c : place.at("claims")) {
      CHECK(c.size() == proved.size());
    }
  }
}

TEST_CASE("the paper is the one that is handed over, sentences are without marks") {
  const Json json = to_json({sample_paper(), sample_audit()});
  CHECK(json.at("paper").at("doi") == "10.1000/1");
  CHECK(json.at("places").at(1).at("title") == "Section 3: phases");
  CHECK(json.at("places").back().at("title") == "A2");  // of no section
  CHECK(claim(json, "44").at("words") == "Time reversal, for x < y & y > \"0\".");
}

TEST_CASE("the summary counts the paper's statements once, and the claims by their origin") {
  const Json json = to_json({sample_paper(), sample_audit()});
  const Json summary = json.at("summary");
  const auto total = [](const Json& counts) {
    std::size_t sum = 0;
    for (const Json& one : counts) {
      sum += one.at("count").get<std::size_t>();
    }
    return sum;
  };
  CHECK(summary.at("statements") == 5);
  CHECK(total(summary.at("statuses")) == 5);
  CHECK(summary.at("claims") == 6);
  CHECK(total(summary.at("origins")) == 6);
  CHECK(summary.at("origins").at(0).at("origin") == "paper");
  CHECK(summary.at("origins").at(0).at("count") == 5);
  CHECK(summary.at("origins").at(1).at("origin") == "new");
  CHECK(total(summary.at("origins").at(0).at("statuses")) == 5);
  CHECK(summary.at("decided") == false);
}

TEST_CASE("a remark goes with a finding, a result with claims that are decided") {
  const Json json = to_json({sample_paper(), sample_audit()});
  CHECK(claim(json, "44").at("remark").at("fact") == "it runs to -t");
  CHECK(claim(json, "5").at("remark").is_null());
  REQUIRE(json.at("results").size() == 1);
  CHECK(json.at("results").at(0).at("theorem") == "for all t & x");
  Paper open = sample_paper();
  open.results.front().claims = {"5", "17"};
  CHECK(to_json({open, sample_audit()}).at("results").empty());
  open.results.front().claims = {"not there"};
  CHECK(to_json({open, sample_audit()}).at("results").empty());
}

TEST_CASE("a statement of the paper says which claims state it, and its status is the worst of theirs") {
  const Json json = to_json({sample_paper(), sample_audit()});
  const Json two = json.at("statements").at(1);
  CHECK(two.at("claims") == Json::array({"5", "5.where"}));
  CHECK(two.at("status") == "needs_hypotheses");
  CHECK(json.at("statements").at(4).at("status") == "not_stated");
  CHECK(json.at("statements").at(4).at("missing") == "a drawing");
  CHECK(claim(json, "17").at("origin") == "new");
  CHECK(claim(json, "5").at("origin") == "paper");
}
