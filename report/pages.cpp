#include "report/pages.hpp"

#include "report/escape.hpp"
#include "report/numbers.hpp"
#include "report/summary.hpp"
#include "report/templates.hpp"

namespace stickslip::report {
namespace {

std::string short_ball(const Json& ball, int digits) {
  return readable({ball.at("mid").get<std::string>(), ball.at("rad").get<std::string>()}, digits);
}

// The value of the key without underscores: "as printed" for as_printed.
void add_words(Json& object, const std::string& key) {
  object[key + "_words"] = spaced(object.at(key));
}

void complete_outcome(Json& outcome) {
  add_words(outcome, "verdict");
  for (Json& comparison : outcome.at("comparisons")) {
    comparison["proved_short"] = short_ball(comparison.at("proved"), 12);
    comparison["units_off_short"] = short_ball(comparison.at("units_off"), 3);
  }
}

void complete_claim(Json& claim) {
  add_words(claim, "status");
  claim["examined"] = claim.at("status") != proofs::to_string(proofs::Status::model);
  complete_outcome(claim.at("outcome"));
  for (const char* further : {"corrected_outcome", "converse"}) {
    if (!claim.at(further).is_null()) {
      complete_outcome(claim.at(further));
    }
  }
  const Json& corrected = claim.at("corrected_outcome");
  claim["needs"] = (corrected.is_null() ? claim.at("outcome") : corrected).at("hypotheses");
}

}  // namespace

Json page_data(const Json& audit) {
  Json data = audit;
  Json findings = Json::array();
  Json numbers = Json::array();
  for (Json& status : data.at("summary").at("statuses")) {
    add_words(status, "status");
  }
  for (Json& place : data.at("places")) {
    for (Json& claim : place.at("claims")) {
      complete_claim(claim);
      if (claim.at("finding").get<bool>()) {
        findings.push_back(claim);
      }
      if (!claim.at("outcome").at("comparisons").empty()) {
        numbers.push_back(claim);
      }
    }
  }
  data["findings"] = std::move(findings);
  data["numbers"] = std::move(numbers);
  return data;
}

std::vector<File> pages(const proofs::Audit& audit) {
  const Json json = to_json(audit);
  const Json data = page_data(json);
  const std::filesystem::path directory = template_directory();
  const auto page = [&](const std::string& name, Escape escape) -> File {
    const std::string source = name + ".mustache";
    return {name, render(source, read_file(directory / source), data, escape)};
  };
  return {{"audit.json", to_text(json)}, page("index.html", escape_html), page("audit.tex", escape_tex)};
}

}  // namespace stickslip::report
