#include "report/audit/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/decimal.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace tools;

namespace {

constexpr int number_digits = 10;
constexpr int unit_digits = 3;

// The difference in units, or that it is next to nothing.
std::string units_off(const Ball& ball) {
  return (abs(ball) - Ball(Rational(1, 1000))).is_negative() ? "under 0.001" : readable(ball, unit_digits);
}

// The value of the key without underscores: "as printed" for as_printed.
void add_words(Json& object, const std::string& key) {
  object[key + "_words"] = spaced(object.at(key));
}

// With a capital and a full stop, unless it begins with a formula.
std::string sentence(const std::string& words) {
  return words.empty() || words.ends_with('.') ? capitalised(words) : capitalised(words) + ".";
}

void complete_comparison(Json& json, const proofs::methods::Comparison& comparison) {
  const std::string proved = readable(comparison.proved, number_digits);
  json["unit"] = orbits::unit_of(comparison.name);
  json["proved_short"] = proved;
  json["rounded"] = rounded_like(parse_decimal(comparison.printed), comparison.proved).value_or(proved);
  json["units_off_short"] = units_off(comparison.units_off);
}

void complete_outcome(Json& json, const proofs::methods::Outcome& outcome, const std::string& id) {
  add_words(json, "verdict");
  json["route"] = outcome.route;
  json["evaluated"] = outcome.cross_check.formulas > 0;
  json["reason"] = outcome.verdict.reason;
  // That a theorem says so is the rule, and not said.
  json["obeyed_words"] =
      outcome.obeyed == proofs::methods::Obeyed::theorem ? "" : proofs::methods::sentence(outcome.obeyed);
  json["may_be_vacuous"] = outcome.obeyed == proofs::methods::Obeyed::unknown;
  for (Json& coordinate : json.at("at")) {
    coordinate["value_latex"] = coordinate.at("value");
  }
  for (Json& hypothesis : json.at("hypotheses")) {
    hypothesis["foreign"] = hypothesis.at("origin") != id;
  }
  for (std::size_t i = 0; i < outcome.comparisons.size(); ++i) {
    complete_comparison(json.at("comparisons").at(i), outcome.comparisons[i]);
  }
}

void complete_claim(Json& claim, const Record& record, const std::string& place_title) {
  const std::string& id = record.claim.id;
  add_words(claim, "status");
  claim["origin_words"] = facts(record.claim.origin).one;
  claim["examined"] = record.status != Status::model;
  claim["place_title"] = place_title;
  claim["words_sentence"] = sentence(words_of(record));
  claim["answers"] = !record.outcome.found.empty();
  claim["illegible"] = record.claim.illegible;
  for (std::size_t i = 0; i < record.repairs.size(); ++i) {
    claim.at("repairs").at(i)["what"] = record.repairs[i].what;
  }
  complete_outcome(claim.at("outcome"), record.outcome, id);
  if (record.corrected) {
    complete_outcome(claim.at("corrected_outcome"), *record.corrected, id);
  }
  if (record.converse) {
    complete_outcome(claim.at("converse"), *record.converse, id);
  }
  claim["certified"] = claim.at("certificate").at("state") == "certified";
  claim["stale"] = claim.at("certificate").at("state") == "stale";
  claim["without_formula"] = record.claim.printed.empty() && record.status != Status::model;
  claim["proof_summary"] = claim.at("examined") ? "proof, and what it rests on" : "what it is used for";
  claim["needs"] = claim.at(record.corrected ? "corrected_outcome" : "outcome").at("hypotheses");
}

const OriginFacts& origin_named(const std::string& name) {
  return *std::ranges::find_if(origins(), [&](const OriginFacts& known) { return known.name == name; });
}

// A remark with its sentences.
Json remark_sentences(const Remark& remark, Origin origin, const proofs::methods::Audit& audit) {
  return {{"place", remark.place},
          {"who", facts(origin).says},
          {"says", sentence(remark.says)},
          {"quote", remark.quote},
          {"note", remark.note},
          {"fact", sentence(with_answers(remark.fact, audit))},
          {"because", sentence(remark.because)},
          {"see", remark.see}};
}

// The paper's statements that the audit answers, section by section.
Json printed_sections(const Audited& all, const Json& statements) {
  Json sections = Json::array();
  const std::vector<const PrintedStatement *> answered = statements_in(all.paper, all.audit);
  for (std::size_t i = 0; i < answered.size(); ++i) {
    Json one = statements.at(i);
    add_words(one, "status");
    one["words"] = answered[i]->words;
    one["words_sentence"] = sentence(answered[i]->words);
    one["missing"] = answered[i]->missing;
    if (sections.empty() || sections.back().at("title") != answered[i]->section) {
      sections.push_back({{"title", answered[i]->section}, {"statements", Json::array()}});
    }
    sections.back()["statements"].push_back(std::move(one));
  }
  return sections;
}

// The statements of the paper that a claim states: {"id", "place"}.
Json stated_by(const Paper& paper, const std::string& claim) {
  Json found = Json::array();
  for (const PrintedStatement& statement : paper.statements) {
    const std::vector<std::string> ids = stating(statement);
    if (std::ranges::find(ids, claim) != ids.end()) {
      found.push_back({{"id", statement.id}, {"place", statement.place}});
    }
  }
  return found;
}

// Gives each assumption of a claim the anchor of the list in which it stands once.
void add_assumptions(Json& list, Json& claim) {
  for (Json& one : claim.at("assumptions")) {
    const auto known = std::ranges::find_if(list, [&](const Json& other) {
      return other.at("id") == one.at("id") && other.at("latex") == one.at("latex");
    });
    if (known == list.end()) {
      one["anchor"] = fmt::format("if-{}", list.size() + 1);
      list.push_back(one);
    } else {
      one["anchor"] = known->at("anchor");
    }
  }
}

// The statuses that occur, of statements and of claims, from the best to the worst.
Json statuses_met(const Json& summary) {
  std::set<std::string> names;
  const auto add = [&names](const Json& counts) {
    for (const Json& one : counts) {
      names.insert(one.at("status"));
    }
  };
  add(summary.at("statuses"));
  for (const Json& origin : summary.at("origins")) {
    add(origin.at("statuses"));
  }
  Json met = Json::array();
  for (const StatusFacts& known : statuses()) {
    if (names.contains(known.name)) {
      met.push_back(
          {{"status", known.name}, {"status_words", spaced(known.name)}, {"meaning", known.meaning}});
    }
  }
  return met;
}

Json results(const Audited& all, const std::vector<Json>& claims) {
  Json told = Json::array();
  for (const Result& result : results_in(all)) {
    Json one = {{"id", result.id},
                {"title", result.title},
                {"setting", result.setting},
                {"theorem", sentence(result.theorem)},
                {"idea", sentence(result.idea)},
                {"see", result.see},
                {"claims", result.claims},
                {"formulas", Json::array()}};
    one["found"] = Json::array();
    for (const Json& claim : claims) {
      if (claim.at("id") == result.claims.front() && claim.at("status") != "refuted") {
        one["formulas"] = claim.at("printed");
      }
      if (result.lists && claim.at("answers") == true && claim.at("origin") == "new" &&
          std::ranges::find(result.claims, claim.at("id").get<std::string>()) != result.claims.end()) {
        one["found"].push_back(claim.at("words_sentence"));
      }
    }
    static const std::regex number(R"(\([0-9]+\))");
    one["cites"] = std::regex_search(result.setting + result.theorem, number);
    told.push_back(std::move(one));
  }
  return told;
}

}  // namespace

Json page_data(const Audited& all, const Json& json) {
  Json data = json;
  std::vector<Json> claims;
  data["numbers"] = Json::array();
  data["assumptions"] = Json::array();
  for (Json& status : data.at("summary").at("statuses")) {
    add_words(status, "status");
  }
  for (Json& origin : data.at("summary").at("origins")) {
    const bool one = origin.at("count") == 1;
    const OriginFacts& known = origin_named(origin.at("origin"));
    origin["words"] = one ? known.one : known.many;
  }
  data["statuses_met"] = statuses_met(data.at("summary"));
  data["claim_statuses"] = Json::array();
  for (const Json& status : data.at("statuses_met")) {
    if (is_status(status.at("status"))) {
      data["claim_statuses"].push_back(status);
    }
  }
  data["sections"] = printed_sections(all, data.at("statements"));
  const std::vector<PlaceRecords> places = by_place(all);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < places[i].records.size(); ++k) {
      const Record& record = *places[i].records[k];
      Json& claim = data.at("places").at(i).at("claims").at(k);
      complete_claim(claim, record, places[i].title);
      claim["states"] = stated_by(all.paper, record.claim.id);
      add_assumptions(data["assumptions"], claim);
      const Remark * remark = remark_on(all.paper, record.claim.id);
      claim["letter"] = remark ? remark_sentences(*remark, record.claim.origin, all.audit) : Json();
      if (!claim.at("remark").is_null()) {
        claim["remark"] = claim.at("letter");
      }
      claims.push_back(claim);
      if (compares(claim)) {
        data["numbers"].push_back(claim);
      }
    }
  }
  data["errata"] = errata_data(all.paper, claims);
  data["results"] = results(all, claims);
  data["findings"] = finding_data(all, claims);
  data["hypotheses_to_add"] = hypotheses_to_add(claims, data.at("findings"));
  data["verdict_lead"] = verdict_lead(all);
  data["verdict_sentence"] = verdict_sentence(all);
  data["sentence_of_ours"] = sentence_of_ours(all.audit);
  data["sentence_of_findings"] = sentence_of_findings(all);
  return data;
}

}  // namespace stickslip::report::audit
