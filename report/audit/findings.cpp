#include "report/audit/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "proofs/methods/prover.hpp"
#include "report/audit/summary.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;

namespace {

using proofs::methods::Audit;
using proofs::methods::Hypothesis;
using proofs::methods::Outcome;
using proofs::methods::Record;
using proofs::methods::Status;

struct Phrase {
  const char * one;
  const char * many;
};

Phrase phrase_of(Status status) {
  switch (status) {
    case Status::as_printed:
      return {"is proved exactly as printed", "are proved exactly as printed"};
    case Status::model:
      return {"belongs to the model and is taken as given", "belong to the model and are taken as given"};
    case Status::needs_hypotheses:
      return {"is proved under hypotheses that the paper does not state",
              "are proved under hypotheses that the paper does not state"};
    case Status::checked:
      return {"is a check in floating point that agrees", "are checks in floating point that agree"};
    case Status::digits_off:
      return {"gives printed digits that are not the correctly rounded ones",
              "give printed digits that are not the correctly rounded ones"};
    case Status::misprint_corrected:
      return {"is misprinted, and its corrected form is proved",
              "are misprinted, and their corrected forms are proved"};
    case Status::necessary_not_sufficient:
      return {"is necessary but not sufficient", "are necessary but not sufficient"};
    case Status::refuted:
      return {"is refuted", "are refuted"};
    case Status::undecided:
      return {"is undecided", "are undecided"};
    case Status::rests_on_unproved:
      return {"rests on something unproved", "rest on something unproved"};
  }
  return {"", ""};
}

bool any(const Audit& audit, std::initializer_list<Status> statuses) {
  return std::ranges::any_of(audit.records, [&](const Record& record) {
    return std::ranges::find(statuses, record.status) != statuses.end();
  });
}

std::vector<Hypothesis> own_hypotheses(const Record& record) {
  std::vector<Hypothesis> own;
  for (const Hypothesis& hypothesis : final_outcome(record).hypotheses) {
    if (hypothesis.origin == record.claim.id) {
      own.push_back(hypothesis);
    }
  }
  return own;
}

std::size_t weight(const HypothesisGroup& group) {
  return group.origins.size() + group.heirs.size();
}

}  // namespace

std::string verdict_lead(const Audit& audit) {
  if (any(audit, {Status::undecided, Status::rests_on_unproved})) {
    return "Not everything is decided.";
  }
  if (any(audit, {Status::refuted})) {
    return "The paper does not hold everywhere.";
  }
  if (any(audit, {Status::misprint_corrected, Status::necessary_not_sufficient, Status::digits_off})) {
    return "The paper holds, with corrections.";
  }
  return any(audit, {Status::needs_hypotheses}) ? "The paper holds, under hypotheses that it does not state."
                                                : "The paper holds as printed.";
}

std::string verdict_sentence(const Audit& audit) {
  std::vector<std::string> parts;
  for (const StatusCount& entry : count_statuses(audit)) {
    const Phrase phrase = phrase_of(entry.status);
    parts.push_back(fmt::format("{} {}", entry.count, entry.count == 1 ? phrase.one : phrase.many));
  }
  if (parts.empty()) {
    return {};
  }
  const std::size_t total = audit.records.size();
  return fmt::format("Of {} statement{}, {}.", total, total == 1 ? "" : "s", fmt::join(parts, "; "));
}

std::vector<HypothesisGroup> hypothesis_groups(const Audit& audit) {
  std::map<std::set<std::string>, HypothesisGroup> groups;
  for (const Record& record : audit.records) {
    const std::vector<Hypothesis> own = own_hypotheses(record);
    std::set<std::string> texts;
    for (const Hypothesis& hypothesis : own) {
      texts.insert(hypothesis.text);
    }
    if (own.empty()) {
      continue;
    }
    HypothesisGroup& group = groups[texts];
    group.hypotheses = own;
    group.origins.push_back(&record);
    group.heirs.merge(inheriting(audit, record));
  }
  std::vector<HypothesisGroup> sorted;
  for (auto& [texts, group] : groups) {
    for (const Record * origin : group.origins) {
      group.heirs.erase(origin->claim.id);
    }
    sorted.push_back(std::move(group));
  }
  std::ranges::stable_sort(sorted, std::greater<>(), weight);
  return sorted;
}

}  // namespace stickslip::report::audit
