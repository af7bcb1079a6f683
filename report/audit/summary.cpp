#include "report/audit/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <utility>
#include <vector>

#include "proofs/methods/prover.hpp"
#include "report/audit/page_data.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::audit {

using namespace tools;
using namespace proofs::methods;

namespace {

std::string title_of(const Paper& paper, const std::string& place) {
  const auto section = std::ranges::find(paper.sections, place, &Section::id);
  return section == paper.sections.end() ? place : section->title;
}

std::vector<StatusCount> counted(const std::vector<Status>& found) {
  std::vector<StatusCount> counts;
  for (const StatusFacts& row : statuses()) {
    const auto count = std::ranges::count(found, row.status);
    if (count > 0) {
      counts.push_back({row.status, static_cast<std::size_t>(count)});
    }
  }
  return counts;
}

// "2 converses: 1 proved, 1 refuted".
std::string count_in_words(std::size_t total, const std::string& what,
                           const std::vector<StatusCount>& counts) {
  return fmt::format("{} {}{}{}", total, what, counts.empty() ? "" : ": ",
                     enumerated(counts, [](const StatusCount& entry) {
                       return fmt::format("{} {}", entry.count, spaced(to_string(entry.status)));
                     }));
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
  return group.origins.size() + group.inherited_by.size();
}

}  // namespace

std::vector<StatusCount> count_statements(const Audited& all) {
  std::vector<Status> found;
  for (const PrintedStatement * statement : statements_in(all.paper, all.audit)) {
    found.push_back(status_of(all.paper, *statement, all.audit));
  }
  return counted(found);
}

std::vector<OriginCount> count_origins(const Audit& audit) {
  std::vector<OriginCount> counts;
  for (const OriginFacts& row : origins()) {
    std::vector<Status> found;
    for (const Record& record : audit.records) {
      if (record.claim.origin == row.origin) {
        found.push_back(record.status);
      }
    }
    if (!found.empty()) {
      counts.push_back({row.origin, found.size(), counted(found)});
    }
  }
  return counts;
}

std::string source_of(const Audit& audit) {
  for (const OriginCount& entry : count_origins(audit)) {
    if (const char * source = facts(entry.origin).source) {
      return source;
    }
  }
  return facts(Origin::paper).source;
}

std::string with_answers(const std::string& sentence, const Audit& audit) {
  static const std::regex asked(R"(\{([0-9A-Z]+\.[A-Za-z0-9.]+)\})");
  std::smatch match;
  if (!std::regex_search(sentence, match, asked)) {
    return sentence;
  }
  const auto record =
      std::ranges::find_if(audit.records, [&](const Record& one) { return one.claim.id == match[1].str(); });
  const bool found = record != audit.records.end() && !record->outcome.found.empty();
  return match.prefix().str() + (found ? record->outcome.found : "see " + match[1].str()) +
         with_answers(match.suffix().str(), audit);
}

bool is_finding(const Record& record) {
  if (needs_something(record)) {
    return std::ranges::any_of(record.outcome.hypotheses, [&](const proofs::methods::Hypothesis& hypothesis) {
      return hypothesis.origin == record.claim.id;
    });
  }
  return facts(record.status).finding;
}

std::vector<Result> results_in(const Audited& all) {
  const auto is_decided = [&](const std::string& id) {
    return std::ranges::any_of(all.audit.records, [&](const Record& record) {
      return record.claim.id == id && facts(record.status).decided;
    });
  };
  std::vector<Result> results;
  for (const Result& result : all.paper.results) {
    if (std::ranges::all_of(result.claims, is_decided)) {
      results.push_back(result);
    }
  }
  return results;
}

std::set<std::string> inheriting(const Audit& audit, const Record& record) {
  std::set<std::string> ids;
  for (const Record& other : audit.records) {
    const proofs::methods::Outcome& outcome = final_outcome(other);
    for (const proofs::methods::Hypothesis& hypothesis : outcome.hypotheses) {
      if (hypothesis.origin == record.claim.id && other.claim.id != record.claim.id) {
        ids.insert(other.claim.id);
      }
    }
  }
  return ids;
}

bool all_decided(const Audit& audit) {
  return std::ranges::all_of(audit.records,
                             [](const Record& record) { return facts(record.status).decided; });
}

std::vector<std::string> unexpected(const proofs::methods::Audit& audit) {
  std::vector<std::string> result;
  for (const proofs::methods::Record& record : audit.records) {
    const std::string status = to_string(record.status);
    if (!record.claim.expected.empty() && record.claim.expected != status) {
      result.push_back(
          fmt::format("{} is {}, and not {} as expected", record.claim.id, status, record.claim.expected));
    }
  }
  return result;
}

bool any_refuted(const Audit& audit) {
  return std::ranges::any_of(audit.records, [](const Record& record) { return facts(record.status).fails; });
}

std::string cross_check_line(const proofs::methods::CrossCheck& check) {
  if (check.formulas == 0) {
    return check.unchecked.empty() ? "" : "by no further engine: " + check.unchecked;
  }
  const std::string what =
      check.formulas == 1 ? "1 formula agrees " : tools::counted(check.formulas, "formula") + " agree ";
  if (check.premise_points > 0) {
    return what + fmt::format("in balls at {} where all that the claim rests on holds",
                              tools::counted(check.premise_points, "real point"));
  }
  const std::string exactly =
      check.exact_points > 0
          ? fmt::format("exactly at {} and ", tools::counted(check.exact_points, "rational point"))
          : "";
  return what + exactly + fmt::format("in balls at {}", tools::counted(check.ball_points, "real point")) +
         (check.unchecked.empty() ? "" : "; " + check.unchecked);
}

std::string summary_line(const Audited& all) {
  const bool whole = is_whole(all.paper, all.audit);
  std::vector<std::string> ours;
  for (const OriginCount& entry : count_origins(all.audit)) {
    if (!whole || !facts(entry.origin).source) {
      const OriginFacts& known = facts(entry.origin);
      ours.push_back(count_in_words(entry.count, entry.count == 1 ? known.one : known.many, entry.statuses));
    }
  }
  const std::string claims = enumerated(ours, std::identity(), "; ");
  if (!whole) {
    return (claims.empty() ? "no claims" : claims) + ".";
  }
  const std::size_t total = statements_in(all.paper, all.audit).size();
  const std::string what = (total == 1 ? "statement of " : "statements of ") + source_of(all.audit);
  return count_in_words(total, what, count_statements(all)) + "." +
         (claims.empty() ? "" : " Beside them " + claims + ".");
}

std::vector<PlaceRecords> by_place(const Audited& all) {
  std::vector<PlaceRecords> places;
  for (const Record& record : all.audit.records) {
    const auto same = [&record](const PlaceRecords& place) { return place.id == record.claim.place; };
    auto place = std::ranges::find_if(places, same);
    if (place == places.end()) {
      places.push_back({record.claim.place, title_of(all.paper, record.claim.place), {}});
      place = std::prev(places.end());
    }
    place->records.push_back(&record);
  }
  return places;
}

std::string verdict_lead(const Audited& all) {
  Status worst = Status::as_printed;
  for (const StatusCount& entry : count_statements(all)) {
    if (entry.status < Status::in_part) {
      worst = entry.status;
    }
  }
  return facts(worst).lead;
}

std::string verdict_sentence(const Audited& all) {
  const std::vector<StatusCount> counts = count_statements(all);
  const auto in_words = [](const StatusCount& entry) {
    const StatusFacts& known = facts(entry.status);
    return tools::counted(entry.count, known.one, known.many);
  };
  const std::size_t total = statements_in(all.paper, all.audit).size();
  return counts.empty() ? ""
                        : fmt::format("Of {} of {}, {}.", tools::counted(total, "statement"),
                                      source_of(all.audit), enumerated(counts, in_words, "; "));
}

std::string sentence_of_ours(const Audit& audit) {
  std::vector<std::string> parts;
  std::size_t total = 0;
  for (const OriginCount& entry : count_origins(audit)) {
    const OriginFacts& known = facts(entry.origin);
    if (!known.source) {
      parts.push_back(tools::counted(entry.count, known.one, known.many));
      total += entry.count;
    }
  }
  return parts.empty() ? ""
                       : fmt::format("Beside these {} claim{} of our own {} counted apart: {}.", total,
                                     total == 1 ? "" : "s", total == 1 ? "is" : "are", enumerated(parts));
}

std::string sentence_of_findings(const Audited& all) {
  std::set<std::string> refuted;
  std::size_t found = 0;
  for (const Record& record : all.audit.records) {
    found += is_finding(record) ? 1 : 0;
    if (record.status == Status::refuted) {
      refuted.insert(record.claim.id);
    }
  }
  std::set<std::string> said;
  std::size_t statements = 0;
  for (const PrintedStatement * statement : statements_in(all.paper, all.audit)) {
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
    result += fmt::format(", the others what {} takes for granted", source_of(all.audit));
  }
  return result + ".";
}

std::vector<const Record *> findings_by_weight(const Audited& all) {
  std::vector<const Record *> found;
  for (const Record& record : all.audit.records) {
    if (is_finding(record)) {
      found.push_back(&record);
    }
  }
  const auto last = static_cast<std::ptrdiff_t>(all.paper.remarks.size());
  std::ranges::stable_sort(found, std::less<>(), [&](const Record * record) {
    const Remark * remark = remark_on(all.paper, record->claim.id);
    const bool taken_for_granted = remark && !facts(record->claim.origin).source;
    return !remark ? last : remark - all.paper.remarks.data() + (taken_for_granted ? last + 1 : 0);
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

namespace {

// All claims that the proofs of a record use.
std::set<std::string> used_by_proofs_of(const Record& record) {
  std::set<std::string> all = record.outcome.uses;
  for (const std::optional<Outcome>& further : {record.corrected, record.converse}) {
    if (further) {
      all.insert(further->uses.begin(), further->uses.end());
    }
  }
  return all;
}

// How many claims of one place the proofs of another use.
std::size_t count_uses(const PlaceRecords& used, const PlaceRecords& user) {
  std::set<std::string> ids;
  for (const Record * record : user.records) {
    ids.merge(used_by_proofs_of(*record));
  }
  return static_cast<std::size_t>(std::ranges::count_if(
      used.records, [&](const Record * record) { return ids.contains(record->claim.id); }));
}

// "Section 2" of "Section 2: the model".
std::string without_subject(const std::string& title) {
  return title.substr(0, title.find(':'));
}

// 1 for one claim, 2 for two or three, 3 for four to seven, 4 for more.
int shade(std::size_t count) {
  return std::min(4, static_cast<int>(std::bit_width(count)));
}

}  // namespace

Json uses_of_places(const Audited& all) {
  const std::vector<PlaceRecords> places = by_place(all);
  Json parts = Json::array();
  for (const PlaceRecords& user : places) {
    Json rests_on = Json::array(), row = Json::array();
    for (const PlaceRecords& used : places) {
      const std::size_t count = used.id == user.id ? 0 : count_uses(used, user);
      row.push_back({{"short", without_subject(used.title)},
                     {"count", count == 0 ? "" : std::to_string(count)},
                     {"weight", shade(count)}});
      if (count > 0) {
        rests_on.push_back({{"id", used.id}, {"title", used.title}});
      }
    }
    parts.push_back({{"id", user.id},
                     {"title", user.title},
                     {"short", without_subject(user.title)},
                     {"has_rests_on", !rests_on.empty()},
                     {"rests_on", rests_on},
                     {"row", row}});
  }
  return {{"parts", parts}};
}

}  // namespace stickslip::report::audit
