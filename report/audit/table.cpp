#include "report/audit/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/names.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/tactics/text.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace tools;

namespace {

// Wide enough for a line of a terminal, never reached: one line per statement.
constexpr std::size_t unlimited = 1U << 20U;

std::string colour_of(Status status, const Style& style) {
  const proofs::methods::Tone tone = facts(status).tone;
  return style.colour ? name_of<proofs::methods::Tone::bad>(tone, "", "\x1b[32m", "\x1b[33m", "\x1b[31m")
                      : "";
}

Cell status_cell(const Record& record, const Style& style) {
  return {spaced(proofs::methods::to_string(record.status)), colour_of(record.status, style)};
}

std::string heading(const std::string& text, const Style& style) {
  return style.colour ? fmt::format("\x1b[1m{}\x1b[0m\n", text) : text + "\n";
}

// Labelled lines beneath the head of a statement; what is empty is left out.
class Details {
 public:
  explicit Details(std::size_t width) : width_(width) {}

  void add(const std::string& label, const std::string& text) {
    if (!text.empty()) {
      text_ += labelled(4, fmt::format("{:<10}", label), text, width_);
    }
  }
  void add(const std::string& label, const std::vector<proofs::symbols::Statement>& statements) {
    for (const proofs::symbols::Statement& statement : statements) {
      add(label, proofs::symbols::text(statement));
    }
  }
  void add(const std::string& label, const std::vector<proofs::methods::Hypothesis>& hypotheses) {
    for (const proofs::methods::Hypothesis& hypothesis : hypotheses) {
      add(label, hypothesis.text);
    }
  }
  void add(const std::string& verdict_label, const std::string& route_label, const Outcome& outcome) {
    const Verdict& verdict = outcome.verdict;
    add(verdict_label, verdict.reason.empty()
                           ? spaced(to_string(verdict.truth))
                           : fmt::format("{}: {}", spaced(to_string(verdict.truth)), verdict.reason));
    add(route_label, outcome.route);
    for (const proofs::kernel::Theorem& theorem : outcome.theorems) {
      add("theorem", to_string(theorem.sequent()));
    }
    add("evaluated", cross_check_line(outcome.cross_check));
    add("obeyed", proofs::methods::sentence(outcome.obeyed));
    add("where", outcome.hypotheses);
    add("for all", enumerated(outcome.free));
    add("uses", enumerated(outcome.uses));
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

// What the theorems suppose of the parameters.
std::string domain_of(const Outcome& outcome) {
  std::vector<std::string> supposed;
  proofs::methods::Reader read;
  for (const proofs::symbols::Statement& one : proofs::symbols::vocabulary_here().domain()) {
    const proofs::kernel::Formula formula = read(one);
    if (std::ranges::any_of(outcome.theorems, [&](const proofs::kernel::Theorem& theorem) {
          return theorem.hypotheses().contains(formula);
        })) {
      supposed.push_back(proofs::symbols::text(one));
    }
  }
  return enumerated(supposed);
}

std::string head(const Record& record, const Style& style) {
  const std::string colour = colour_of(record.status, style);
  return columns_of({{{record.claim.id}, {facts(record.status).meaning, colour}}}, style.width);
}

std::string tables_by_place(const Audited& all, const Style& style) {
  std::vector<Row> rows;
  std::string result;
  for (const PlaceRecords& place : by_place(all)) {
    rows.clear();
    for (const Record * record : place.records) {
      rows.push_back({{record->claim.id},
                      {record->claim.origin == Origin::paper ? "" : to_string(record->claim.origin)},
                      status_cell(*record, style),
                      {words_of(*record)}});
    }
    result += heading(place.title, style) + columns_of(rows, style.width) + "\n";
  }
  return result;
}

std::string findings(const Audited& all, const Style& style) {
  std::string result;
  for (const Record * finding : findings_by_weight(all)) {
    const Record& record = *finding;
    Details details(style.width);
    if (const Remark * remark = remark_on(all.paper, record.claim.id)) {
      details.add(facts(record.claim.origin).source ? "says" : "granted", remark->says);
      details.add("in fact", with_answers(remark->fact, all.audit));
      details.add("because", remark->because);
      details.add("see", remark->see);
      details.add("printed", record.claim.printed);
      details.add("needs", final_outcome(record).hypotheses);
      details.add("corrected", record.claim.corrected);
      result += head(record, style) + details.text();
      continue;
    }
    details.add("says", words_of(record));
    details.add("printed", record.claim.printed);
    details.add("lost", record.claim.illegible);
    details.add("why not", record.outcome.verdict.reason);
    details.add("converse", record.converse ? record.converse->verdict.reason : std::string());
    details.add("needs", final_outcome(record).hypotheses);
    details.add("inherited", enumerated(inheriting(all.audit, record)));
    details.add("corrected", record.claim.corrected);
    result += head(record, style) + details.text();
  }
  return result.empty() ? result : heading("Findings", style) + result + "\n";
}

std::string printed_numbers(const Audit& audit, const Style& style) {
  std::vector<Row> rows = {{{"statement"}, {"value"}, {"printed"}, {"proved"}, {"units off"}}};
  for (const Record& record : audit.records) {
    for (const proofs::methods::Comparison& comparison : record.outcome.comparisons) {
      rows.push_back({{record.claim.id},
                      {comparison.name},
                      {comparison.printed},
                      {readable(comparison.proved, 10)},
                      {readable(comparison.units_off, 3)}});
    }
  }
  return rows.size() == 1 ? ""
                          : heading("Printed numbers", style) + columns_of(rows, style.width) +
                                labelled(0, "units", orbits::meaning_of_units(), style.width) + "\n";
}

std::string paragraph(const std::string& text, const Style& style) {
  std::string result;
  for (const std::string& line : wrapped(text, style.width)) {
    result += line + "\n";
  }
  return result;
}

// What Coq does not certify, though it might, by reason.
std::string uncertified(const Certification& certificates, const Style& style) {
  std::map<std::string, std::string> ids;
  for (const auto& [id, one] : certificates.claims) {
    if (one.state == Certified::State::stale || one.state == Certified::State::refused) {
      std::string& list = ids[one.words];
      list += (list.empty() ? "" : ", ") + id;
    }
  }
  std::string result;
  for (const auto& [reason, list] : ids) {
    result += paragraph(fmt::format("Not certified, {}: {}.", reason, list), style);
  }
  return result;
}

std::string explanation(const Record& record, const Style& style) {
  Details details(style.width);
  details.add("kind", proofs::methods::to_string(record.claim.kind));
  details.add("origin",
              fmt::format("{}: {}", to_string(record.claim.origin), facts(record.claim.origin).meaning));
  details.add("says", words_of(record));
  details.add("printed", record.claim.printed);
  details.add("lost", record.claim.illegible);
  for (const proofs::methods::Assumption& assumption : record.claim.assumptions) {
    details.add("if", fmt::format("{}: {}", assumption.id, proofs::symbols::text(assumption.statement)));
  }
  if (record.status != Status::model) {
    details.add("verdict", "proof", record.outcome);
  }
  details.add("corrected", record.claim.corrected);
  if (record.corrected) {
    details.add("verdict", "proof", *record.corrected);
  }
  if (record.converse) {
    details.add("converse", "proof", *record.converse);
  }
  details.add("used by", enumerated(record.used_by));
  return head(record, style) + details.text();
}

}  // namespace

std::string terminal_report(const Audited& all, const Style& style, const Certification& certificates) {
  return tables_by_place(all, style) + findings(all, style) + printed_numbers(all.audit, style) +
         paragraph(summary_line(all), style) +
         paragraph(is_whole(all.paper, all.audit) ? sentence_of_findings(all) : "", style) +
         uncertified(certificates, style) +
         (certificates.line.empty() ? "" : paragraph(certificates.line, style));
}

std::string terminal_lines(const Audited& all, const Style& style) {
  std::vector<Row> rows;
  for (const Record& record : all.audit.records) {
    rows.push_back({{record.claim.id}, status_cell(record, style), {words_of(record)}});
  }
  return columns_of(rows, unlimited) + summary_line(all) + "\n";
}

std::string terminal_explanations(const Audited& all, const Style& style) {
  std::string result;
  for (const Record& record : all.audit.records) {
    result += explanation(record, style) + "\n";
  }
  return result + printed_numbers(all.audit, style) + paragraph(summary_line(all), style);
}

std::string terminal_answer(const Record& record, const Style& style) {
  const Outcome& outcome = record.outcome;
  std::vector<Row> rows;
  for (const proofs::symbols::Statement& statement : record.claim.printed) {
    rows.push_back(
        {{rows.empty() ? spaced(to_string(outcome.verdict.truth)) : "", colour_of(record.status, style)},
         {proofs::symbols::text(statement)}});
  }
  Details details(style.width);
  const bool proved = outcome.verdict.truth == Truth::proved;
  details.add(proved ? "by" : "why", proved ? outcome.route : outcome.verdict.reason);
  details.add("for all", enumerated(outcome.free));
  details.add("with", domain_of(outcome));
  details.add("where", outcome.hypotheses);
  for (const proofs::methods::Assumption& assumption : record.claim.assumptions) {
    if (outcome.assumed.contains(assumption.id)) {
      details.add("if", proofs::symbols::text(assumption.statement));
    }
  }
  details.add("uses", proved ? enumerated(outcome.uses) : "");
  for (const proofs::methods::Repair& repair : record.repairs) {
    details.add("true is",
                fmt::format("{} ({})", proofs::symbols::text(repair.statement), plain(repair.what)));
  }
  return columns_of(rows, style.width) + details.text();
}

std::string terminal_list(const std::vector<proofs::methods::Claim>& claims) {
  std::vector<Row> rows;
  for (const proofs::methods::Claim& claim : claims) {
    rows.push_back({{claim.id},
                    {proofs::methods::to_string(claim.kind)},
                    {proofs::methods::to_string(claim.origin)},
                    {claim.words}});
  }
  return columns_of(rows, unlimited);
}

}  // namespace stickslip::report::audit
