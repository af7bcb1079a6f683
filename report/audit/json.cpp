#include "report/audit/json.hpp"

#include "core/decimal.hpp"
#include "proofs/tactics/text.hpp"
#include "report/audit/mutants.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/orbits.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace proofs::symbols;
using namespace tools;

namespace {

using proofs::methods::Audit;
using proofs::methods::Claim;
using proofs::methods::Outcome;
using proofs::methods::Record;

Json as_it_is(const std::string& text) {
  return text;
}

Json ball(const BallText& text) {
  return {{"mid", text.mid}, {"rad", text.rad}};
}

Json formula(const proofs::symbols::Statement& statement) {
  return {{"latex", proofs::symbols::latex(statement)}, {"text", proofs::symbols::text(statement)}};
}

Json repair(const proofs::methods::Repair& r) {
  Json json = {{"what", plain(r.what)}};
  json.update(formula(r.statement));
  return json;
}

Json hypothesis(const proofs::methods::Hypothesis& h) {
  return {{"latex", h.latex}, {"text", h.text}, {"origin", h.origin}, {"visible", h.visible}};
}

Json symbol(const std::string& name) {
  return {{"name", name}, {"latex", symbolic::typeset::latex_name(name)}};
}

Json coordinate(const Coordinate& c) {
  Json json = symbol(c.name);
  json["value"] = to_string(c.value);
  return json;
}

// Enough to tell the sides apart. The digits beyond depend on the order of GiNaC's sums, which no two runs
// share.
constexpr int witness_digits = 10;
constexpr int digits_of_units = 4;

Json witness(const std::optional<Witness>& w) {
  if (!w) {
    return nullptr;
  }
  return {{"point", list_of(w->point, coordinate)},
          {"component", w->component},
          {"left", ball(to_text(w->left, witness_digits))},
          {"right", ball(to_text(w->right, witness_digits))}};
}

Json comparison(const proofs::methods::Comparison& c) {
  return {{"name", c.name},
          {"latex", c.latex},
          {"printed", c.printed},
          {"proved", ball(to_text(c.proved))},
          {"units_off", ball(to_text(c.units_off, digits_of_units))},
          {"verdict", to_string(c.verdict.truth)},
          {"reason", plain(c.verdict.reason)}};
}

Json cross_check(const proofs::methods::CrossCheck& c) {
  return {{"formulas", c.formulas},       {"exact_points", c.exact_points},
          {"ball_points", c.ball_points}, {"premise_points", c.premise_points},
          {"unchecked", c.unchecked},     {"line", cross_check_line(c)}};
}

Json sequent(const proofs::kernel::Theorem& theorem) {
  return to_string(theorem.sequent());
}

Json outcome(const Outcome& o) {
  return {{"verdict", to_string(o.verdict.truth)},
          {"reason", plain(o.verdict.reason)},
          {"witness", witness(o.verdict.witness)},
          {"route", plain(o.route)},
          {"hypotheses", list_of(o.hypotheses, hypothesis)},
          {"uses", list_of(o.uses, as_it_is)},
          {"free", list_of(o.free, symbol)},
          {"at", list_of(o.at, coordinate)},
          {"comparisons", list_of(o.comparisons, comparison)},
          {"cross_check", cross_check(o.cross_check)},
          {"theorems", list_of(o.theorems, sequent)},
          {"by_kernel", o.by_kernel},
          {"obeyed", to_string(o.obeyed)}};
}

bool needs_assumption(const Record& record, const std::string& id) {
  return record.outcome.assumed.contains(id) || (record.corrected && record.corrected->assumed.contains(id));
}

Json assumptions(const Record& record) {
  return list_of(record.claim.assumptions, [&record](const proofs::methods::Assumption& assumption) {
    Json json = {{"id", assumption.id}};
    json.update(formula(assumption.statement));
    json["needed"] = needs_assumption(record, assumption.id);
    return json;
  });
}

Json remark(const Remark * r, const Audit& audit) {
  if (!r) {
    return nullptr;
  }
  return {{"place", plain(r->place)},
          {"says", plain(r->says)},
          {"fact", plain(with_answers(r->fact, audit))},
          {"because", plain(r->because)},
          {"see", r->see}};
}

Json result(const Result& r) {
  return {{"id", r.id},
          {"title", plain(r.title)},
          {"theorem", plain(r.theorem)},
          {"idea", plain(r.idea)},
          {"see", r.see},
          {"claims", list_of(r.claims, as_it_is)}};
}

Json claim(const Paper& paper, const Audit& audit, const Record& record, const Certification& certificates) {
  const Claim& c = record.claim;
  return {{"id", c.id},
          {"place", c.place},
          {"kind", proofs::methods::to_string(c.kind)},
          {"origin", proofs::methods::to_string(c.origin)},
          {"words", plain(words_of(record))},
          {"status", proofs::methods::to_string(record.status)},
          {"meaning", proofs::methods::facts(record.status).meaning},
          {"finding", is_finding(record)},
          {"printed", list_of(c.printed, formula)},
          {"corrected", list_of(c.corrected, formula)},
          {"assumptions", assumptions(record)},
          {"outcome", outcome(record.outcome)},
          {"corrected_outcome", record.corrected ? outcome(*record.corrected) : Json(nullptr)},
          {"converse", record.converse ? outcome(*record.converse) : Json(nullptr)},
          {"repairs", list_of(record.repairs, repair)},
          {"illegible", plain(c.illegible)},
          {"remark", remark(is_finding(record) ? remark_on(paper, c.id) : nullptr, audit)},
          {"used_by", list_of(record.used_by, as_it_is)},
          {"certificate", to_json(certificates, c.id)}};
}

Json status_count(const StatusCount& entry) {
  return {{"status", proofs::methods::to_string(entry.status)},
          {"meaning", proofs::methods::facts(entry.status).meaning},
          {"count", entry.count}};
}

Json origin_count(const OriginCount& entry) {
  const OriginFacts& known = proofs::methods::facts(entry.origin);
  return {{"origin", known.name},
          {"meaning", known.meaning},
          {"count", entry.count},
          {"statuses", list_of(entry.statuses, status_count)}};
}

Json summary(const Paper& paper, const Audit& audit) {
  return {{"statements", statements_in(paper, audit).size()},
          {"statuses", list_of(count_statements(paper, audit), status_count)},
          {"claims", audit.records.size()},
          {"origins", list_of(count_origins(audit), origin_count)},
          {"decided", all_decided(audit)},
          {"line", summary_line(paper, audit)}};
}

Json printed_statement(const Paper& paper, const PrintedStatement& statement, const Audit& audit) {
  const Status status = status_of(paper, statement, audit);
  return {{"id", statement.id},
          {"section", statement.section},
          {"place", statement.place},
          {"kind", proofs::methods::to_string(statement.kind)},
          {"words", plain(statement.words)},
          {"status", proofs::methods::to_string(status)},
          {"meaning", proofs::methods::facts(status).meaning},
          {"claims", list_of(statement.claims, as_it_is)},
          {"or_read", list_of(statement.or_read, as_it_is)},
          {"example", statement.example},
          {"missing", plain(statement.missing)},
          {"see", list_of(statement.see, as_it_is)}};
}

Json printed_statements(const Paper& paper, const Audit& audit) {
  return list_of(statements_in(paper, audit), [&](const PrintedStatement * statement) {
    return printed_statement(paper, *statement, audit);
  });
}

Json bibliography(const proofs::methods::Bibliography& b) {
  return {{"author", b.author}, {"title", b.title}, {"journal", b.journal}, {"doi", b.doi}};
}

Json place(const Paper& paper, const Audit& audit, const PlaceRecords& p, const Certification& certificates) {
  return {{"id", p.id}, {"title", p.title}, {"claims", list_of(p.records, [&](const Record * record) {
                                               return claim(paper, audit, *record, certificates);
                                             })}};
}

Json example(const ExampleOrbits& e) {
  const auto printed = [](const PrintedResult& result) -> Json {
    return {{"name", result.name}, {"value", result.value.text}, {"sign_lost", result.sign_lost}};
  };
  return {{"name", e.example.name},
          {"figure", e.example.figure},
          {"printed", list_of(e.example.results, printed)},
          {"orbits", orbits::to_json(e.list)}};
}

}  // namespace

Json to_json(const Paper& paper, const Audit& audit, const std::string& command,
             const std::vector<ExampleOrbits>& examples, const std::optional<proofs::checks::Gate>& gate,
             const Certification& certificates) {
  Json json = provenance(command);
  json["paper"] = bibliography(paper.bibliography);
  json["summary"] = summary(paper, audit);
  json["summary"]["certificates"] = certificates.line;
  json["statements"] = printed_statements(paper, audit);
  json["places"] = list_of(by_place(paper, audit),
                           [&](const PlaceRecords& p) { return place(paper, audit, p, certificates); });
  json["results"] = list_of(results_in(paper, audit), result);
  json["examples"] = list_of(examples, example);
  json["mutants"] = gate ? to_json(*gate) : Json(nullptr);
  return json;
}

}  // namespace stickslip::report::audit
