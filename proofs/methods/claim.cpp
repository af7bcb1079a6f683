#include "proofs/methods/claim.hpp"

#include <algorithm>

namespace stickslip::proofs::methods {

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::definition:
      return "definition";
    case Kind::model:
      return "model";
    case Kind::identity:
      return "identity";
    case Kind::step:
      return "step";
    case Kind::theorem:
      return "theorem";
    case Kind::condition:
      return "condition";
    case Kind::numbers:
      return "numbers";
    case Kind::words:
      return "words";
    case Kind::figure:
      return "figure";
    case Kind::check:
      return "check";
  }
  return {};
}

const std::vector<OriginFacts>& origins() {
  static const char * const granted = "The paper takes for granted";
  static const std::vector<OriginFacts> all{
      {Origin::paper, "paper", "claim of the paper", "claims of the paper",
       "printed: a statement of the paper names it", "The paper says", "the paper"},
      {Origin::textbook, "textbook", "claim of text books", "claims of text books",
       "as text books give it: the original is not at hand", "Text books say", "text books"},
      {Origin::reading, "reading", "reading", "readings",
       "what the paper means or takes for granted, and does not print", granted},
      {Origin::converse, "converse", "converse", "converses",
       "the other direction of something printed, which the paper does not assert", granted},
      {Origin::new_result, "new", "new result", "new results", "a result of this audit", granted},
      {Origin::auxiliary, "auxiliary", "auxiliary claim", "auxiliary claims",
       "a step of ours on the way to others, or a check of our own", granted},
  };
  return all;
}

const OriginFacts& facts(Origin origin) {
  return origins()[static_cast<std::size_t>(origin)];
}

std::string to_string(Origin origin) {
  return facts(origin).name;
}

namespace {

const char * const holds = "The paper holds as printed.";
const char * const with_corrections = "The paper holds, with corrections.";
const char * const not_everything = "Not everything is decided.";
const char * const open = "Not decided";
const char * const why_open = "Neither proved nor refuted, or proved from something that is not.";

}  // namespace

const std::vector<StatusFacts>& statuses() {
  static const std::vector<StatusFacts> all{
      {.status = Status::as_printed,
       .name = "as_printed",
       .meaning = "proved as printed",
       .one = "is proved exactly as printed",
       .many = "are proved exactly as printed",
       .lead = holds,
       .tone = Tone::good,
       .stands = true,
       .finding = false},
      {.status = Status::proved,
       .name = "proved",
       .meaning = "proved; there is no print to compare it with",
       .one = "is proved",
       .many = "are proved",
       .lead = "What is stated is proved.",
       .tone = Tone::good,
       .stands = true,
       .finding = false},
      {.status = Status::decided_in_balls,
       .name = "decided_in_balls",
       .meaning = "decided in balls, outside the kernel: no theorem says it",
       .one = "is decided in balls, outside the kernel",
       .many = "are decided in balls, outside the kernel",
       .lead = holds,
       .tone = Tone::good,
       .stands = true,
       .finding = false},
      {.status = Status::model,
       .name = "model",
       .meaning = "part of the model, taken as given",
       .one = "belongs to the model and is taken as given",
       .many = "belong to the model and are taken as given",
       .lead = holds,
       .tone = Tone::quiet,
       .stands = true,
       .finding = false},
      {.status = Status::premise,
       .name = "premise",
       .meaning = "a premise: a condition that is imposed, and follows from nothing",
       .one = "is a premise, imposed and deduced from nothing",
       .many = "are premises, imposed and deduced from nothing",
       .lead = holds,
       .tone = Tone::quiet,
       .stands = true,
       .finding = false},
      {.status = Status::checked,
       .name = "checked",
       .meaning = "agrees with a computation in floating point, which proves nothing",
       .one = "is a check in floating point that agrees",
       .many = "are checks in floating point that agree",
       .lead = holds,
       .tone = Tone::quiet,
       .finding = false},
      {.status = Status::where_defined,
       .name = "where_defined",
       .meaning = "proved wherever the printed formulas are defined",
       .one = "is proved wherever its printed formulas are defined",
       .many = "are proved wherever their printed formulas are defined",
       .lead = holds,
       .tone = Tone::good,
       .stands = true,
       .heading = "Where the printed formulas are not defined",
       .explanation = "Printed formulas divide by these, so that who reads them sees where they say nothing; "
                      "here is what is true there. Each is shown once, with all statements that inherit it."},
      {.status = Status::needs_hypotheses,
       .name = "needs_hypotheses",
       .meaning = "proved under a hypothesis that no printed formula shows",
       .one = "is proved under hypotheses that the paper does not state",
       .many = "are proved under hypotheses that the paper does not state",
       .lead = "The paper holds, under hypotheses that it does not state.",
       .tone = Tone::notable,
       .stands = true,
       .heading = "Hypotheses that the paper does not state",
       .explanation =
           "The proofs divide by these, and the paper's formulas do not; where one of them vanishes, "
           "the statements behind it are not claimed. Each is shown once, with all statements that inherit "
           "it."},
      {.status = Status::digits_off,
       .name = "digits_off",
       .meaning = "printed digits are not the correctly rounded ones",
       .one = "gives printed digits that are not the correctly rounded ones",
       .many = "give printed digits that are not the correctly rounded ones",
       .lead = with_corrections,
       .tone = Tone::notable,
       .fails = true,
       .heading = "Digits",
       .explanation =
           "Printed numbers that are not the correctly rounded ones; printed data are taken as exact."},
      {.status = Status::misprint_corrected,
       .name = "misprint_corrected",
       .meaning = "misprint: refuted as printed, the corrected form is proved",
       .one = "is misprinted, and its corrected form is proved",
       .many = "are misprinted, and their corrected forms are proved",
       .lead = with_corrections,
       .tone = Tone::bad,
       .stands = true,
       .heading = "Misprints",
       .explanation = "False as printed, with a witness; the form that the derivation supports is proved."},
      {.status = Status::necessary_not_sufficient,
       .name = "necessary_not_sufficient",
       .meaning = "proved to be necessary, refuted to be sufficient",
       .one = "is necessary but not sufficient",
       .many = "are necessary but not sufficient",
       .lead = with_corrections,
       .tone = Tone::notable,
       .stands = true,
       .heading = "Necessary, not sufficient",
       .explanation = "It follows from what it is deduced from, but does not give that back."},
      {.status = Status::on_one_reading,
       .name = "on_one_reading",
       .meaning = "true on one fair reading, false on another",
       .one = "is proved on one fair reading and refuted on another",
       .many = "are proved on one fair reading and refuted on another",
       .lead = with_corrections,
       .tone = Tone::notable,
       .of_claims = false,
       .finding = false},
      {.status = Status::refuted,
       .name = "refuted",
       .meaning = "refuted",
       .one = "is refuted",
       .many = "are refuted",
       .lead = "The paper does not hold everywhere.",
       .tone = Tone::bad,
       .fails = true,
       .heading = "Refuted",
       .explanation = "False as printed, with a witness, and in no corrected form that was found."},
      {.status = Status::rests_on_unproved,
       .name = "rests_on_unproved",
       .meaning = "proved, but something that it uses is not",
       .one = "rests on something unproved",
       .many = "rest on something unproved",
       .lead = not_everything,
       .tone = Tone::notable,
       .decided = false,
       .heading = open,
       .explanation = why_open},
      {.status = Status::undecided,
       .name = "undecided",
       .meaning = "undecided",
       .one = "is undecided",
       .many = "are undecided",
       .lead = not_everything,
       .tone = Tone::notable,
       .decided = false,
       .heading = open,
       .explanation = why_open},
      {.status = Status::in_part,
       .name = "in_part",
       .meaning = "stated in part: what is proved says less",
       .one = "is stated by our claims in part only",
       .many = "are stated by our claims in part only",
       .lead = not_everything,
       .tone = Tone::quiet,
       .of_claims = false,
       .decided = false,
       .finding = false},
      {.status = Status::not_stated,
       .name = "not_stated",
       .meaning = "stated by no claim, for the reason given",
       .one = "is stated by no claim of ours",
       .many = "are stated by no claim of ours",
       .lead = not_everything,
       .tone = Tone::quiet,
       .of_claims = false,
       .decided = false,
       .finding = false},
  };
  return all;
}

const StatusFacts& facts(Status status) {
  return statuses()[static_cast<std::size_t>(status)];
}

std::string to_string(Obeyed obeyed) {
  switch (obeyed) {
    case Obeyed::none_needed:
      return "none_needed";
    case Obeyed::theorem:
      return "theorem";
    case Obeyed::balls:
      return "balls";
    case Obeyed::by_contradiction:
      return "by_contradiction";
    case Obeyed::unknown:
      break;
  }
  return "unknown";
}

std::string sentence(Obeyed obeyed) {
  switch (obeyed) {
    case Obeyed::none_needed:
      return "";
    case Obeyed::theorem:
      return "by something, says a theorem";
    case Obeyed::balls:
      return "by values, in balls";
    case Obeyed::by_contradiction:
      return "by nothing: that is what is claimed";
    case Obeyed::unknown:
      break;
  }
  return "vacuous or unknown: nothing is known with which all that is assumed holds";
}

std::string to_string(Status status) {
  return facts(status).name;
}

bool is_status(const std::string& word) {
  return std::ranges::any_of(statuses(),
                             [&](const StatusFacts& row) { return word == row.name && row.of_claims; });
}

Status needing(const std::vector<Hypothesis>& hypotheses) {
  return std::ranges::all_of(hypotheses, &Hypothesis::visible) ? Status::where_defined
                                                               : Status::needs_hypotheses;
}

bool needs_something(const Record& record) {
  return record.status == Status::where_defined || record.status == Status::needs_hypotheses;
}

std::string words_of(const Record& record) {
  const std::string& found = record.outcome.found;
  return record.claim.words + (found.empty() ? "" : ": " + found);
}

std::vector<Claim> joined(const std::vector<std::vector<Claim>>& lists) {
  std::vector<Claim> all;
  for (const std::vector<Claim>& list : lists) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace stickslip::proofs::methods
