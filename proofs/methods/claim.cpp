#include "proofs/methods/claim.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace stickslip::proofs::methods {

std::string to_string(Kind kind) {
  constexpr std::array names{"definition", "model",   "identity", "step",   "theorem",
                             "condition",  "numbers", "words",    "figure", "check"};
  return names.at(static_cast<std::size_t>(kind));
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

const std::vector<StatusFacts>& statuses() {
  static const std::vector<StatusFacts> all = [] {
    constexpr std::array sentences{&StatusFacts::meaning, &StatusFacts::one,     &StatusFacts::many,
                                   &StatusFacts::lead,    &StatusFacts::heading, &StatusFacts::explanation};
    constexpr std::array tones{"quiet", "good", "notable", "bad"};
    std::vector<StatusFacts> read;
    std::size_t next = 0;
    std::istringstream lines(statuses_text().front().second);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("  ")) {
        read.back().*sentences.at(next++) = line.substr(2);
      } else if (!line.empty()) {
        const std::string words = line.substr(line.find(':') + 1) + ",";
        const auto says = [&](const std::string& word) {
          return words.find(" " + word + ",") != std::string::npos;
        };
        read.push_back({.status = static_cast<Status>(read.size()),
                        .name = line.substr(0, line.find(':')),
                        .tone = static_cast<Tone>(std::ranges::find_if(tones, says) - tones.begin()),
                        .stands = says("stands"),
                        .of_claims = !says("of statements"),
                        .decided = !says("open"),
                        .finding = !says("no finding"),
                        .fails = says("fails")});
        next = 0;
      }
    }
    return read;
  }();
  return all;
}

const StatusFacts& facts(Status status) {
  return statuses().at(static_cast<std::size_t>(status));
}

std::string to_string(Obeyed obeyed) {
  constexpr std::array names{"none_needed", "theorem", "balls", "unknown", "by_contradiction"};
  return names.at(static_cast<std::size_t>(obeyed));
}

std::string sentence(Obeyed obeyed) {
  constexpr std::array sentences{"", "by something, says a theorem", "by values, in balls",
                                 "vacuous or unknown: nothing is known with which all that is assumed holds",
                                 "by nothing: that is what is claimed"};
  return sentences.at(static_cast<std::size_t>(obeyed));
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
