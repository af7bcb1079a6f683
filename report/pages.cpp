#include "report/pages.hpp"

#include <algorithm>

#include "report/escape.hpp"
#include "report/numbers.hpp"
#include "report/summary.hpp"
#include "report/templates.hpp"

namespace stickslip::report {
namespace {

std::string short_ball(const Json& ball, int digits) {
  return readable({ball.at("mid").get<std::string>(), ball.at("rad").get<std::string>()}, digits);
}

// "as printed" for as_printed.
void add_words(Json& object) {
  object["status_words"] = spaced(object.at("status"));
}

void add_short_numbers(Json& outcome) {
  for (Json& comparison : outcome.at("comparisons")) {
    comparison["proved_short"] = short_ball(comparison.at("proved"), 12);
    comparison["units_off_short"] = short_ball(comparison.at("units_off"), 3);
  }
}

}  // namespace

Json page_data(const Json& audit) {
  Json data = audit;
  Json findings = Json::array();
  Json numbers = Json::array();
  std::ranges::for_each(data.at("summary").at("statuses"), add_words);
  for (Json& place : data.at("places")) {
    for (Json& claim : place.at("claims")) {
      add_words(claim);
      add_short_numbers(claim.at("outcome"));
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
