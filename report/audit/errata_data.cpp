#include "report/audit/errata_data.hpp"

#include <algorithm>
#include <regex>
#include <set>

#include "report/audit/finding_data.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::audit {

using namespace tools;
using namespace proofs::methods;

namespace {

// The sentence without the ids of claims, which a letter does not know: "so it is (16.back)".
std::string without_ids(const std::string& sentence) {
  static const std::regex ids(R"( \((?:[0-9A-Z]+\.[A-Za-z0-9.]+(?:, )?)+\))");
  return std::regex_replace(sentence, ids, "");
}

// The place as a sentence begins: "Section 4, example" for "sec. 4, example".
std::string place_in_full(const std::string& place) {
  return capitalised(place.starts_with("sec. ") ? "Section " + place.substr(5) : place);
}

bool has_erratum(const Json& claim) {
  const std::string status = claim.at("status");
  return claim.at("origin") == "paper" && (!claim.at("remark").is_null() || status == "misprint_corrected" ||
                                           (status == "digits_off" && compares(claim)));
}

// A claim of the paper that has something to correct, as a letter to the journal says it.
Json erratum(const Json& claim, const std::string& place) {
  Json one = {{"misprint", claim.at("status") == "misprint_corrected"},
              {"printed", claim.at("printed")},
              {"corrected", claim.at("corrected")},
              {"numbers", claim.at("outcome").at("comparisons")}};
  if (claim.at("remark").is_null()) {
    one["place"] = place_in_full(place);
    one["remark"] = nullptr;
    return one;
  }
  one["place"] = place_in_full(claim.at("remark").at("place"));
  one["remark"] = claim.at("remark");
  for (const char * part : {"says", "fact", "because"}) {
    one["remark"][part] = without_ids(one.at("remark").at(part));
  }
  return one;
}

// Numbers of one place make one entry.
void add_erratum(Json& errata, const Json& one) {
  const bool numbers = !one.at("misprint").get<bool>() && one.at("remark").is_null();
  if (numbers && !errata.empty() && errata.back().at("place") == one.at("place") &&
      errata.back().at("remark").is_null() && !errata.back().at("misprint").get<bool>()) {
    for (const Json& number : one.at("numbers")) {
      errata.back()["numbers"].push_back(number);
    }
  } else {
    errata.push_back(one);
  }
}

}  // namespace

Json errata_data(const Paper& paper, const std::vector<Json>& claims) {
  Json errata = Json::array();
  std::set<std::string> told;
  for (const PrintedStatement& statement : paper.statements) {
    for (const Json& claim : claims) {
      const std::string id = claim.at("id");
      if (has_erratum(claim) && std::ranges::find(statement.claims, id) != statement.claims.end() &&
          told.insert(id).second) {
        add_erratum(errata, erratum(claim, statement.place));
      }
    }
  }
  for (std::size_t i = errata.size(); i-- > 0;) {
    const Json& place = errata.at(i).at("place");
    errata[i]["heading"] = i > 0 && errata.at(i - 1).at("place") == place ? Json() : place;
  }
  return errata;
}

}  // namespace stickslip::report::audit
