#include "report/audit/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>

#include "proofs/methods/prover.hpp"
#include "report/audit/summary.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;

namespace {

using proofs::methods::Audit;
using proofs::methods::Hypothesis;
using proofs::methods::Outcome;
using proofs::methods::Record;

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
  return group.origins.size() + group.inherited_by.size();
}

}  // namespace

std::string verdict_lead(const Paper& paper, const Audit& audit) {
  Status worst = Status::as_printed;
  for (const StatusCount& entry : count_statements(paper, audit)) {
    if (entry.status < Status::in_part) {
      worst = entry.status;
    }
  }
  return facts(worst).lead;
}

std::string verdict_sentence(const Paper& paper, const Audit& audit) {
  std::vector<std::string> parts;
  for (const StatusCount& entry : count_statements(paper, audit)) {
    const StatusFacts& known = facts(entry.status);
    parts.push_back(fmt::format("{} {}", entry.count, entry.count == 1 ? known.one : known.many));
  }
  if (parts.empty()) {
    return {};
  }
  const std::size_t total = statements_in(paper, audit).size();
  return fmt::format("Of {} of {}, {}.", tools::counted(total, "statement"), source_of(audit),
                     fmt::join(parts, "; "));
}

std::string sentence_of_ours(const Audit& audit) {
  std::vector<std::string> parts;
  std::size_t total = 0;
  for (const OriginCount& entry : count_origins(audit)) {
    const OriginFacts& known = facts(entry.origin);
    if (!known.source) {
      parts.push_back(fmt::format("{} {}", entry.count, entry.count == 1 ? known.one : known.many));
      total += entry.count;
    }
  }
  return parts.empty()
             ? ""
             : fmt::format("Beside these {} claim{} of our own {} counted apart: {}.", total,
                           total == 1 ? "" : "s", total == 1 ? "is" : "are", fmt::join(parts, ", "));
}

std::string sentence_of_findings(const Paper& paper, const Audit& audit) {
  std::set<std::string> refuted;
  std::size_t found = 0;
  for (const Record& record : audit.records) {
    found += is_finding(record) ? 1 : 0;
    if (record.status == Status::refuted) {
      refuted.insert(record.claim.id);
    }
  }
  std::set<std::string> said;
  std::size_t statements = 0;
  for (const PrintedStatement * statement : statements_in(paper, audit)) {
    bool states = false;
    for (const std::string& id : stating(*statement)) {
      if (refuted.contains(id)) {
        said.insert(id);
        states = true;
      }
    }
    statements += states ? 1 : 0;
  }
  if (found == 0) {
    return {};
  }
  std::string result =
      "A finding is a claim, not a statement: one claim may state several statements, and some claims state "
      "none";
  if (!refuted.empty()) {
    result +=
        fmt::format("; of {} refuted claim{} {} state{} {} of the statements", refuted.size(),
                    refuted.size() == 1 ? "" : "s", said.size(), said.size() == 1 ? "s" : "", statements);
  }
  if (said.size() < refuted.size()) {
    result += fmt::format(", the others what {} takes for granted", source_of(audit));
  }
  return result + ".";
}

std::vector<const Record *> findings_by_weight(const Paper& paper, const Audit& audit) {
  std::vector<const Record *> found;
  for (const Record& record : audit.records) {
    if (is_finding(record)) {
      found.push_back(&record);
    }
  }
  const auto last = static_cast<std::ptrdiff_t>(paper.remarks.size());
  std::ranges::stable_sort(found, std::less<>(), [&](const Record * record) {
    const Remark * remark = remark_on(paper, record->claim.id);
    const bool taken_for_granted = remark && !facts(record->claim.origin).source;
    return !remark ? last : remark - paper.remarks.data() + (taken_for_granted ? last + 1 : 0);
  });
  return found;
}

Status HypothesisGroup::status() const {
  return needing(hypotheses);
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
    group.inherited_by.merge(inheriting(audit, record));
  }
  std::vector<HypothesisGroup> sorted;
  for (auto& [texts, group] : groups) {
    for (const Record * origin : group.origins) {
      group.inherited_by.erase(origin->claim.id);
    }
    sorted.push_back(std::move(group));
  }
  std::ranges::stable_sort(sorted, std::greater<>(), weight);
  return sorted;
}

}  // namespace stickslip::report::audit
