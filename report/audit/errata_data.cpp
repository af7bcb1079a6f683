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

// Of the paper's claims those that need a correction, and of what it takes for granted that on which there is
// a remark.
bool has_erratum(const Json& claim) {
  const std::string status = claim.at("status");
  const bool remarked = !claim.at("letter").is_null();
  return claim.at("origin") == "reading"
             ? remarked
             : claim.at("origin") == "paper" && (remarked || status == "misprint_corrected" ||
                                                 (status == "digits_off" && compares(claim)));
}

// Whether the letter tells the claim with the statement: one that states it, or a reading that it leads to.
bool is_told_with(const PrintedStatement& statement, const Json& claim) {
  std::vector<std::string> ids = stating(statement);
  if (claim.at("origin") == "reading") {
    ids.insert(ids.end(), statement.see.begin(), statement.see.end());
  }
  return std::ranges::find(ids, claim.at("id").get<std::string>()) != ids.end();
}

// "16" of "16.back".
std::string equation_of(const std::string& id) {
  return id.substr(0, id.find('.'));
}

// A claim of the paper that has something to correct, as a letter to the journal says it.
Json erratum(const Json& claim, const std::string& place) {
  Json one = {{"misprint", claim.at("status") == "misprint_corrected"},
              {"printed", claim.at("printed")},
              {"corrected", claim.at("corrected")},
              {"illegible", claim.at("illegible")},
              {"numbers", claim.at("outcome").at("comparisons")}};
  if (claim.at("letter").is_null()) {
    one["place"] = place_in_full(place);
    one["remark"] = nullptr;
    return one;
  }
  one["place"] = place_in_full(claim.at("letter").at("place"));
  one["remark"] = claim.at("letter");
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
      if (has_erratum(claim) && is_told_with(statement, claim) && told.insert(claim.at("id")).second) {
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

Json hypotheses_to_add(const std::vector<Json>& claims, const Json& findings) {
  Json result = Json::array();
  // "7.only" is of Section 7, and "7" of Section 3.
  const auto is_told = [&](const Json& origin) {
    const auto its_claim =
        std::ranges::find_if(claims, [&](const Json& claim) { return claim.at("id") == origin.at("id"); });
    return std::ranges::any_of(claims, [&](const Json& claim) {
      return has_erratum(claim) && claim.at("place") == its_claim->at("place") &&
             equation_of(claim.at("id")) == equation_of(origin.at("id"));
    });
  };
  for (const Json& group : findings) {
    for (const Json& one : group.at("hypotheses_groups")) {
      if (one.at("matters") == true && std::ranges::none_of(one.at("origins"), is_told)) {
        result.push_back(one);
      }
    }
  }
  return result;
}

}  // namespace stickslip::report::audit
