#include "report/audit/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/decimal.hpp"
#include "report/audit/findings.hpp"
#include "report/audit/summary.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace tools;

namespace {

using proofs::methods::Status;

constexpr int number_digits = 10;
constexpr int unit_digits = 3;

std::string short_ball(const Json& ball, int digits) {
  return readable({ball.at("mid").get<std::string>(), ball.at("rad").get<std::string>()}, digits);
}

// The difference in units, or that it is next to nothing.
std::string units_off(const Json& ball) {
  const Rational mid = parse_decimal(ball.at("mid").get<std::string>()).value;
  const Rational rad = parse_decimal(ball.at("rad").get<std::string>()).value;
  return abs(mid) + rad < Rational(1, 1000) ? "under 0.001" : short_ball(ball, unit_digits);
}

// The nearest whole number, halves upwards.
mpz_class nearest(const Rational& value) {
  const Rational shifted = value + Rational(1, 2);
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return quotient;
}

// The ball rounded to the digits that are printed, or the whole ball where it leaves that open.
std::string rounded_like(const std::string& printed, const Json& ball) {
  const Decimal decimal = parse_decimal(printed);
  const Rational mid = parse_decimal(ball.at("mid").get<std::string>()).value;
  const Rational rad = parse_decimal(ball.at("rad").get<std::string>()).value;
  const mpz_class low = nearest((mid - rad) / decimal.unit);
  if (low != nearest((mid + rad) / decimal.unit)) {
    return short_ball(ball, number_digits);
  }
  const std::size_t point = printed.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
  std::string digits = mpz_class(abs(low)).get_str();
  digits.insert(0, digits.size() > decimals ? 0 : decimals + 1 - digits.size(), '0');
  if (decimals > 0) {
    digits.insert(digits.size() - decimals, ".");
  }
  return (low < 0 ? "-" : "") + digits;
}

// The value of the key without underscores: "as printed" for as_printed.
void add_words(Json& object, const std::string& key) {
  object[key + "_words"] = spaced(object.at(key));
}

std::string capitalised(std::string words) {
  if (!words.empty()) {
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  }
  return words;
}

// With a capital and a full stop, unless it begins with a formula.
std::string sentence(std::string words) {
  const std::vector<ProsePart> parts = prose_parts(words);
  if (!parts.empty() && !parts.front().formula) {
    words = capitalised(words);
  }
  return words.empty() || words.ends_with('.') ? words : words + ".";
}

void complete_coordinates(Json& coordinates) {
  for (Json& coordinate : coordinates) {
    coordinate["value_latex"] = coordinate.at("value");
  }
}

void complete_outcome(Json& outcome, const std::string& id) {
  add_words(outcome, "verdict");
  outcome["verdict_capital"] = capitalised(outcome.at("verdict_words"));
  complete_coordinates(outcome.at("at"));
  for (Json& hypothesis : outcome.at("hypotheses")) {
    hypothesis["foreign"] = hypothesis.at("origin") != id;
  }
  for (Json& comparison : outcome.at("comparisons")) {
    comparison["proved_short"] = short_ball(comparison.at("proved"), number_digits);
    comparison["rounded"] = rounded_like(comparison.at("printed"), comparison.at("proved"));
    comparison["units_off_short"] = units_off(comparison.at("units_off"));
  }
}

void complete_claim(Json& claim, const std::string& place_title) {
  add_words(claim, "status");
  claim["examined"] = claim.at("status") != proofs::methods::to_string(Status::model);
  claim["place_title"] = place_title;
  claim["words_sentence"] = sentence(claim.at("words"));
  const std::string id = claim.at("id");
  complete_outcome(claim.at("outcome"), id);
  for (const char * further : {"corrected_outcome", "converse"}) {
    if (!claim.at(further).is_null()) {
      complete_outcome(claim.at(further), id);
    }
  }
  const Json& corrected = claim.at("corrected_outcome");
  claim["needs"] = (corrected.is_null() ? claim.at("outcome") : corrected).at("hypotheses");
}

struct GroupWords {
  std::vector<Status> statuses;
  const char * title;
  const char * explanation;
};

const std::array<GroupWords, 4>& groups_of_claims() {
  static const std::array<GroupWords, 4> groups{{
      {{Status::undecided, Status::rests_on_unproved},
       "Not decided",
       "Neither proved nor refuted, or proved from something that is not."},
      {{Status::refuted},
       "Refuted",
       "False as printed, with a witness, and in no corrected form that was found."},
      {{Status::misprint_corrected},
       "Misprints",
       "False as printed, with a witness; the form that the derivation supports is proved."},
      {{Status::necessary_not_sufficient},
       "Necessary, not sufficient",
       "It follows from what it is deduced from, but does not give that back."},
  }};
  return groups;
}

Json group(const std::string& title, const std::string& explanation) {
  return {{"title", title},
          {"explanation", explanation},
          {"claims", Json::array()},
          {"numbers", Json::array()},
          {"hypotheses_groups", Json::array()}};
}

void add_group(Json& findings, Json group, std::size_t count) {
  if (count > 0) {
    group["count"] = count;
    findings.push_back(std::move(group));
  }
}

bool has_status(const Json& claim, Status status) {
  return claim.at("status") == proofs::methods::to_string(status);
}

bool compares(const Json& claim) {
  return !claim.at("outcome").at("comparisons").empty();
}

// What is known about the hypotheses that this claim brings in, as far as the claims that show it are proved.
Json judgements_of(const Paper& paper, const proofs::methods::Audit& audit, const std::string& origin) {
  const auto is_shown = [&](const Judgement& judgement) {
    return std::ranges::all_of(judgement.shown_by, [&](const std::string& id) {
      return std::ranges::any_of(audit.records, [&](const proofs::methods::Record& record) {
        return record.claim.id == id && record.outcome.verdict.truth == Truth::proved;
      });
    });
  };
  Json json = Json::array();
  for (const Judgement& judgement : paper.judgements) {
    if (judgement.origin == origin && is_shown(judgement)) {
      json.push_back({{"matters", judgement.matters ? "matters" : "does not matter"},
                      {"words", judgement.words},
                      {"shown_by", judgement.shown_by}});
    }
  }
  return json;
}

Json hypothesis_group(const Paper& paper, const proofs::methods::Audit& audit, const HypothesisGroup& g) {
  Json json = {{"hypotheses", Json::array()},
               {"origins", Json::array()},
               {"heirs", g.heirs},
               {"heirs_count", g.heirs.size()}};
  for (const proofs::methods::Hypothesis& hypothesis : g.hypotheses) {
    json["hypotheses"].push_back({{"latex", hypothesis.latex}});
  }
  for (const proofs::methods::Record * origin : g.origins) {
    json["origins"].push_back({{"id", origin->claim.id},
                               {"words", origin->claim.words},
                               {"judgements", judgements_of(paper, audit, origin->claim.id)}});
  }
  return json;
}

Json hypotheses_finding(const Paper& paper, const proofs::methods::Audit& audit) {
  Json json =
      group("Hypotheses that the paper does not state",
            "The proofs divide by these; where one of them vanishes, the statements behind it are not "
            "claimed. Each is shown once, with all statements that inherit it.");
  for (const HypothesisGroup& g : hypothesis_groups(audit)) {
    json["hypotheses_groups"].push_back(hypothesis_group(paper, audit, g));
  }
  return json;
}

Json findings(const Paper& paper, const proofs::methods::Audit& audit, const std::vector<Json>& claims) {
  Json all = Json::array();
  for (const GroupWords& words : groups_of_claims()) {
    Json one = group(words.title, words.explanation);
    for (const Json& claim : claims) {
      for (const Status status : words.statuses) {
        if (has_status(claim, status)) {
          one["claims"].push_back(claim);
        }
      }
    }
    const std::size_t count = one.at("claims").size();
    add_group(all, std::move(one), count);
  }
  Json digits = group("Digits", "Printed numbers that are not the correctly rounded ones.");
  for (const Json& claim : claims) {
    if (has_status(claim, Status::digits_off)) {
      digits[compares(claim) ? "numbers" : "claims"].push_back(claim);
    }
  }
  const std::size_t off = digits.at("numbers").size() + digits.at("claims").size();
  add_group(all, std::move(digits), off);
  Json hypotheses = hypotheses_finding(paper, audit);
  const std::size_t groups = hypotheses.at("hypotheses_groups").size();
  add_group(all, std::move(hypotheses), groups);
  return all;
}

}  // namespace

Json page_data(const Paper& paper, const proofs::methods::Audit& audit, const Json& json) {
  Json data = json;
  std::vector<Json> claims;
  data["numbers"] = Json::array();
  for (Json& status : data.at("summary").at("statuses")) {
    add_words(status, "status");
  }
  for (Json& place : data.at("places")) {
    for (Json& claim : place.at("claims")) {
      complete_claim(claim, place.at("title"));
      claims.push_back(claim);
      if (compares(claim)) {
        data["numbers"].push_back(claim);
      }
    }
  }
  data["findings"] = findings(paper, audit, claims);
  data["errata"] = Json::array();
  for (const Json& claim : claims) {
    if (has_status(claim, Status::misprint_corrected) ||
        (has_status(claim, Status::digits_off) && compares(claim))) {
      data["errata"].push_back(claim);
    }
  }
  data["verdict_lead"] = verdict_lead(audit);
  data["verdict_sentence"] = verdict_sentence(audit);
  return data;
}

}  // namespace stickslip::report::audit
