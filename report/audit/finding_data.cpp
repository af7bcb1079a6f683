#include "report/audit/page_data.hpp"

#include <algorithm>
#include <regex>
#include <set>

#include "report/audit/summary.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace tools;

namespace {

const std::string not_so = "What does not hold as the paper has it",
                  taken_for_granted = "What the paper takes for granted, and is not so";

Json group(const std::string& title, const std::string& explanation) {
  return {{"title", title},          {"explanation", explanation}, {"count", 0},
          {"claims", Json::array()}, {"numbers", Json::array()},   {"hypotheses_groups", Json::array()}};
}

// What is known about the hypotheses that this claim brings in, as far as the claims that show it are proved.
Json judgements_of(const Audited& all, const std::string& origin) {
  const auto is_shown = [&](const Judgement& judgement) {
    return std::ranges::all_of(judgement.shown_by, [&](const std::string& id) {
      return std::ranges::any_of(all.audit.records, [&](const proofs::methods::Record& record) {
        return record.claim.id == id && record.outcome.verdict.truth == Truth::proved;
      });
    });
  };
  Json json = Json::array();
  for (const Judgement& judgement : all.paper.judgements) {
    if (judgement.origin == origin && is_shown(judgement)) {
      json.push_back({{"matters", judgement.matters ? "matters" : "does not matter"},
                      {"words", judgement.words},
                      {"shown_by", judgement.shown_by}});
    }
  }
  return json;
}

Json hypothesis_group(const Audited& all, const HypothesisGroup& g) {
  Json json = {{"hypotheses", Json::array()},     {"origins", Json::array()},
               {"inherited_by", g.inherited_by},  {"inherited_by_count", g.inherited_by.size()},
               {"status", to_string(g.status())}, {"matters", false}};
  for (const proofs::methods::Hypothesis& hypothesis : g.hypotheses) {
    json["hypotheses"].push_back({{"latex", hypothesis.latex}});
  }
  for (const proofs::methods::Record * origin : g.origins) {
    json["matters"] = json.at("matters").get<bool>() ||
                      std::ranges::any_of(all.paper.judgements, [&](const Judgement& judgement) {
                        return judgement.origin == origin->claim.id && judgement.matters;
                      });
    json["origins"].push_back({{"id", origin->claim.id},
                               {"words", origin->claim.words},
                               {"judgements", judgements_of(all, origin->claim.id)}});
  }
  return json;
}

constexpr const char * open_questions = "Not decided";

// The groups of findings in the order of their weight, without findings: what is open; what the paper says
// and is not so; then by status, from the worst; last what the paper takes for granted. Statuses with one
// heading make one group.
Json empty_groups() {
  Json groups = Json::array();
  Json by_status = Json::array();
  for (auto status = statuses().rbegin(); status != statuses().rend(); ++status) {
    Json& list = status->heading == std::string(open_questions) ? groups : by_status;
    if (status->finding && (list.empty() || list.back().at("title") != status->heading)) {
      list.push_back(group(status->heading, status->explanation));
    }
  }
  groups.push_back(group(not_so, "What the paper says, what is so, and why; the weightiest first."));
  groups.insert(groups.end(), by_status.begin(), by_status.end());
  groups.push_back(group(taken_for_granted, "Said nowhere in the paper, and needed by what it says."));
  return groups;
}

// Where a reader finds the claim among the findings.
std::string heading_of(const Record& record, const Remark * remark) {
  return !remark                             ? facts(record.status).heading
         : facts(record.claim.origin).source ? not_so
                                             : taken_for_granted;
}

Json& group_of(Json& groups, const std::string& heading) {
  return *std::ranges::find_if(groups, [&](const Json& one) { return one.at("title") == heading; });
}

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

Json finding_data(const Audited& all, const std::vector<Json>& claims) {
  Json groups = empty_groups();
  const auto add = [&](const std::string& heading, const char * list, Json one) {
    Json& found = group_of(groups, heading);
    found[list].push_back(std::move(one));
    found["count"] = found.at("count").get<int>() + 1;
  };
  for (const HypothesisGroup& g : hypothesis_groups(all.audit)) {
    add(facts(g.status()).heading, "hypotheses_groups", hypothesis_group(all, g));
  }
  for (const Record * record : findings_by_weight(all)) {
    if (needs_something(*record)) {
      continue;
    }
    const Json& claim =
        *std::ranges::find_if(claims, [&](const Json& one) { return one.at("id") == record->claim.id; });
    const Remark * remark = remark_on(all.paper, record->claim.id);
    const bool number = record->status == Status::digits_off && compares(claim);
    add(heading_of(*record, remark), number ? "numbers" : "claims", claim);
  }
  std::erase_if(groups.get_ref<Json::array_t&>(), [](const Json& one) { return one.at("count") == 0; });
  return groups;
}

bool compares(const Json& claim) {
  return !claim.at("outcome").at("comparisons").empty();
}

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
