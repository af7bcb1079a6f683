#include "report/audit/json.hpp"

#include "core/decimal.hpp"
#include "proofs/tactics/text.hpp"
#include "report/audit/mutants.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/orbits.hpp"
#include "symbolic/typeset/names.hpp"

template <>
struct stickslip::report::tools::SampleOf<stickslip::proofs::methods::Hypothesis> {
  [[nodiscard]] static proofs::methods::Hypothesis made() { return {0, "", "", ""}; }
};
template <>
struct stickslip::report::tools::SampleOf<stickslip::proofs::methods::ExampleOrbits> {
  [[nodiscard]] static proofs::methods::ExampleOrbits made() {
    return {{}, SampleOf<numeric::OrbitList>::made()};
  }
};

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace proofs::symbols;
using namespace tools;

namespace {

// All that the JSON is made of.
struct Written : Audited {
  const std::string& command;
  const std::vector<ExampleOrbits>& examples;
  const std::optional<proofs::checks::Gate>& gate;
  const Certification& certificates;
};

// A printed number.
const Json like_decimal = {{"pattern", "^([+-]?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?|nan)$"}};
const Json not_empty = {{"minLength", 1}};

Json verdicts() {
  return names_through(Truth::checked);
}

Json names_of_statuses(bool of_claims) {
  std::vector<std::string> names;
  for (const StatusFacts& known : statuses()) {
    if (known.of_claims || !of_claims) {
      names.emplace_back(known.name);
    }
  }
  return one_of(names);
}

void write_formula(Object& json, const proofs::symbols::Statement& statement) {
  json.has("latex", proofs::symbols::latex(statement));
  json.has("text", proofs::symbols::text(statement));
}

void write_repair(Object& json, const proofs::methods::Repair& r) {
  json.has("what", plain(r.what));
  write_formula(json, r.statement);
}

void write_hypothesis(Object& json, const proofs::methods::Hypothesis& h) {
  json.has("latex", h.latex);
  json.has("text", h.text);
  json.has("origin", h.origin, "The claim whose proof brought it in.");
  json.has("visible", h.visible,
           "Whether that claim prints a division by something that is zero where this is.");
}

void write_symbol(Object& json, const std::string& name) {
  json.has("name", name);
  json.has("latex", symbolic::typeset::latex_name(name));
}

void write_coordinate(Object& json, const Coordinate& c) {
  write_symbol(json, c.name);
  json.has("value", c.value);
}

// Enough to tell the sides apart. The digits beyond depend on the order of GiNaC's sums, which no two runs
// share.
constexpr int witness_digits = 10;
constexpr int digits_of_units = 4;

void write_witness(Object& json, const Witness& w) {
  json.list("point", w.point, write_coordinate);
  json.has("component", w.component, "Which entry of a vector or matrix, (2,1); empty for a scalar.");
  json.has("left", to_text(w.left, witness_digits));
  json.has("right", to_text(w.right, witness_digits));
}

void write_comparison(Object& json, const proofs::methods::Comparison& c) {
  json.has("name", c.name);
  json.has("latex", c.latex);
  json.has("printed", c.printed, like_decimal);
  json.has("proved", to_text(c.proved));
  json.has("units_off", to_text(c.units_off, digits_of_units));
  json.has("verdict", c.verdict.truth, verdicts());
  json.has("reason", plain(c.verdict.reason));
}

void write_cross_check(Object& json, const proofs::methods::CrossCheck& c) {
  const Json count = {{"minimum", 0}};
  json.has("formulas", c.formulas, count);
  json.has("exact_points", c.exact_points, count);
  json.has("ball_points", c.ball_points, count);
  json.has("premise_points", c.premise_points, count);
  json.has("unchecked", c.unchecked);
  json.has("line", cross_check_line(c));
}

std::vector<std::string> sequents(const std::vector<proofs::kernel::Theorem>& theorems) {
  std::vector<std::string> texts;
  for (const proofs::kernel::Theorem& theorem : theorems) {
    texts.push_back(to_string(theorem.sequent()));
  }
  return texts;
}

void write_outcome(Object& json, const Outcome& o) {
  json.has("verdict", o.verdict.truth, verdicts());
  json.has("reason", plain(o.verdict.reason));
  json.or_null("witness", o.verdict.witness, write_witness);
  json.has("route", plain(o.route));
  json.list("hypotheses", o.hypotheses, write_hypothesis);
  json.has("uses", o.uses);
  json.list("free", o.free, write_symbol);
  json.list("at", o.at, write_coordinate);
  json.list("comparisons", o.comparisons, write_comparison);
  json.object(
      "cross_check", [&](Object& to) { write_cross_check(to, o.cross_check); },
      "How two further engines looked at the verdict: formulas evaluated, rational points at which each "
      "agrees exactly, real points at which each agrees in balls, real points where what the claim rests on "
      "holds and what it prints, too; or why there was nothing to evaluate.");
  json.has("theorems", sequents(o.theorems),
           "The kernel's theorems of what is printed, in its order, as sequents: hypotheses |- conclusion.");
  json.has("by_kernel", o.by_kernel, "Whether the verdict is that of the kernel's theorems alone.");
  json.has(
      "obeyed", o.obeyed,
      with(names_through(Obeyed::by_contradiction),
           "Whether there are values with which all that is assumed holds: by a theorem of the kernel, at a "
           "point in balls, as far as is known none (motions included), none at all (which is what a proof "
           "by contradiction says), or nothing is assumed."));
  json.rules({{"if", {{"properties", {{"verdict", {{"const", to_string(Truth::proved)}}}}}}},
              {"else", {{"properties", {{"reason", not_empty}}}}}});
}

bool needs_assumption(const Record& record, const std::string& id) {
  return record.outcome.assumed.contains(id) || (record.corrected && record.corrected->assumed.contains(id));
}

void write_remark(Object& json, const Remark& r, const Audit& audit) {
  json.has("place", plain(r.place), not_empty);
  json.has("says", plain(r.says), not_empty);
  json.has("fact", plain(with_answers(r.fact, audit)), not_empty);
  json.has("because", plain(r.because), not_empty);
  json.has("see", r.see, with(of_program, "A command that shows it."));
}

void write_result(Object& json, const Result& r) {
  json.has("id", r.id, {{"pattern", "^[a-z-]+$"}});
  json.has("title", plain(r.title), not_empty);
  json.has("theorem", plain(r.theorem), with(not_empty, "With all hypotheses."));
  json.has("idea", plain(r.idea), with(not_empty, "Of the proof."));
  json.has("see", r.see, with(of_program, "The command that checks it."));
  json.has("claims", r.claims, {{"minItems", 1}});
}

void write_claim(Object& json, const Record& record, const Written& all) {
  const Claim& c = record.claim;
  json.has("id", c.id);
  json.has("place", c.place);
  json.has("kind", c.kind,
           one_of({"definition", "model", "identity", "step", "theorem", "condition", "numbers", "check"}));
  json.has("origin", c.origin, with(names_through(Origin::auxiliary), "Whose statement it is."));
  json.has("words", plain(words_of(record)));
  json.has("status", record.status, names_of_statuses(true));
  json.has("meaning", proofs::methods::facts(record.status).meaning);
  json.has("finding", is_finding(record));
  json.list("printed", c.printed, write_formula);
  json.list("corrected", c.corrected, write_formula);
  json.list("assumptions", c.assumptions, [&](Object& to, const proofs::methods::Assumption& assumption) {
    to.has("id", assumption.id);
    write_formula(to, assumption.statement);
    to.has("needed", needs_assumption(record, assumption.id));
  });
  json.object("outcome", [&](Object& to) { write_outcome(to, record.outcome); });
  json.or_null("corrected_outcome", record.corrected, write_outcome);
  json.or_null("converse", record.converse, write_outcome);
  json.list("repairs", record.repairs, write_repair);
  json.has("illegible", plain(c.illegible));
  json.or_null(
      "remark", is_finding(record) ? remark_on(all.paper, c.id) : nullptr,
      [&](Object& to, const Remark& remark) { write_remark(to, remark, all.audit); },
      "What there is to say about a claim that does not hold as the paper has it.");
  json.has("used_by", record.used_by);
  json.object("certificate", [&](Object& to) { write_certificate(to, all.certificates, c.id); });
}

void write_status_count(Object& json, const StatusCount& entry, bool of_claims) {
  json.has("status", entry.status, names_of_statuses(of_claims));
  json.has("meaning", proofs::methods::facts(entry.status).meaning);
  json.has("count", entry.count);
}

void write_summary(Object& json, const Written& all) {
  const auto of_statements = [](Object& to, const StatusCount& entry) {
    write_status_count(to, entry, false);
  };
  json.has("statements", statements_in(all.paper, all.audit).size(),
           "How many statements of the paper are answered.");
  json.list("statuses", count_statements(all), of_statements);
  json.has("claims", all.audit.records.size());
  json.list("origins", count_origins(all.audit), [](Object& to, const OriginCount& entry) {
    to.has("origin", entry.origin, names_through(Origin::auxiliary));
    to.has("meaning", proofs::methods::facts(entry.origin).meaning);
    to.has("count", entry.count, {{"minimum", 1}});
    to.list("statuses", entry.statuses,
            [](Object& one, const StatusCount& status) { write_status_count(one, status, true); });
  });
  json.has("decided", all_decided(all.audit));
  json.has("line", summary_line(all));
  json.has("certificates", all.certificates.line,
           "How many claims Coq certified, in a sentence or two; empty if nobody looked.");
}

void write_statement(Object& json, const PrintedStatement& statement, const Audited& all) {
  const Status status = status_of(all.paper, statement, all.audit);
  json.has("id", statement.id, {{"pattern", "^S[0-9]{3}$"}});
  json.has("section", statement.section);
  json.has("place", statement.place);
  json.has("kind", statement.kind, names_through(Kind::figure));
  json.has("words", plain(statement.words), not_empty);
  json.has(
      "status", status,
      with(names_of_statuses(false),
           "The worst of its claims', or on_one_reading where claims of two readings differ; proved, where "
           "none of them is printed."));
  json.has("meaning", proofs::methods::facts(status).meaning);
  json.has("claims", statement.claims, "The claims that state it.");
  json.has("or_read", statement.or_read, "The claims that state it on another fair reading.");
  json.has("example", statement.example, "The example at whose data alone it speaks; empty for all others.");
  json.has("missing", plain(statement.missing), "What they leave unsaid; without claims, why there is none.");
  json.has("see", statement.see, "Claims that touch it, and say something else.");
}

void write_bibliography(Object& json, const proofs::methods::Bibliography& b) {
  json.has("author", b.author);
  json.has("title", b.title);
  json.has("journal", b.journal);
  json.has("doi", b.doi);
}

void write_example(Object& json, const ExampleOrbits& e) {
  json.has("name", e.example.name);
  json.has("figure", e.example.figure);
  json.list("printed", e.example.results, [](Object& to, const PrintedResult& result) {
    to.has("name", result.name);
    to.has("value", result.value.text, like_decimal);
    to.has("sign_lost", result.sign_lost);
  });
  json.object("orbits", [&](Object& to) { orbits::write_orbits(to, e.list); });
}

void write_audit(Object& json, const Written& all) {
  write_provenance(json, all.command, not_empty);  // that of another paper has a program of its own
  json.object("paper", [&](Object& to) { write_bibliography(to, all.paper.bibliography); });
  json.object("summary", [&](Object& to) { write_summary(to, all); });
  json.list(
      "statements", statements_in(all.paper, all.audit),
      [&](Object& to, const PrintedStatement& statement) { write_statement(to, statement, all); },
      "The paper's statements, in words of our own: all in an audit; of stickslip check those whose claims "
      "were all asked for.");
  json.list("places", by_place(all), [&](Object& to, const PlaceRecords& place) {
    to.has("id", place.id);
    to.has("title", place.title);
    to.list("claims", place.records,
            [&](Object& one, const Record& record) { write_claim(one, record, all); });
  });
  json.list("results", results_in(all), write_result,
            "What the audit found beyond the paper, the strongest first.");
  json.list("examples", all.examples, write_example,
            "All orbits at the data of the paper's figures; empty for stickslip check.");
  json.or_null("mutants", all.gate, write_gate,
               "Wrong statements made on purpose by single edits, put to the claims' own proofs; null where "
               "that was not asked for. Refuted: fails where all that the claim rests on holds; unproved: "
               "the proof does not go through; meaningless: does not evaluate; true_too: proved, and has the "
               "normal form of what is printed or holds at the points tried; survived: proved, and nothing "
               "else says that it is true. Twins are the same statements written another way.");
  json.has("interrupted", std::optional<bool>(),
           with({{"const", true}}, "The audit was ended before all claims were examined; absent otherwise."));
}

}  // namespace

Json to_json(const Audited& all, const std::string& command, const std::vector<ExampleOrbits>& examples,
             const std::optional<proofs::checks::Gate>& gate, const Certification& certificates) {
  return written(Written{all, command, examples, gate, certificates}, write_audit);
}

File schema() {
  const Paper paper;
  const Audit audit;
  return schema_file("audit",
                     "stickslip audit: every statement of the paper, and every claim, with its verdict",
                     schema_by(Written{{paper, audit}, "stickslip audit", {}, {}, {}}, write_audit));
}

}  // namespace stickslip::report::audit
