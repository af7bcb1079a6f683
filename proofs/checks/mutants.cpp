#include "proofs/checks/mutants.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.hpp"
#include "proofs/checks/edits.hpp"
#include "proofs/checks/premises.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/symbols/meaning.hpp"

namespace stickslip::proofs::checks {

using namespace methods;
using namespace symbols;

namespace {

// A wrong inequality may still hold at most points.
constexpr std::size_t points_for_equations = 2, points_for_inequalities = 40;

// A claim that is proved, and what it takes to put another statement to its proof.
struct Subject {
  Prover& prover;
  const Record& record;
  std::vector<PremisePoint> points = {};

  [[nodiscard]] const std::vector<Statement>& form() const { return proved_form(record); }

  // Throws what the proof throws.
  [[nodiscard]] Verdict verdict_on(std::size_t which, const Statement& statement) const {
    std::vector<Statement> statements = form();
    statements[which] = statement;
    const Claim changed = saying(record.claim, statements);
    const bool corrected = record.corrected && changed.prove_corrected;
    return (corrected ? changed.prove_corrected : changed.prove)(prover, changed).verdict;
  }

  [[nodiscard]] bool contradicted(const Statement& statement) const {
    return std::ranges::any_of(points,
                               [&](const PremisePoint& point) { return point.contradicts(statement); });
  }
  // At no point it has a value.
  [[nodiscard]] bool has_no_value(const Statement& statement) const {
    return !points.empty() && std::ranges::none_of(points, [&](const PremisePoint& point) {
      return point.evaluates(statement);
    });
  }
};

// Whether all that is printed has values there, and comes out.
bool shows(const PremisePoint& point, const std::vector<Statement>& printed) {
  try {
    return std::ranges::all_of(printed, [&](const Statement& statement) {
      return point.confirms(statement) && point.evaluates(statement);
    });
  } catch (const NoValue&) {
    return false;
  }
}

std::optional<Subject> subject(Prover& prover, const Claim& claim) {
  const bool formula = claim.kind != Kind::model && claim.kind != Kind::numbers && !claim.printed.empty();
  if (!formula) {
    return std::nullopt;
  }
  const Record& record = prover.prove(claim.id);
  const Outcome& outcome = final_outcome(record);
  if (outcome.verdict.truth != Truth::proved) {
    return std::nullopt;
  }
  const std::vector<Statement>& form = proved_form(record);
  const bool equations = std::ranges::all_of(
      form, [](const Statement& statement) { return statement.relation == Relation::equal; });
  Subject result{prover, record,
                 premise_points(premises_of(prover, record.claim, outcome),
                                equations ? points_for_equations : points_for_inequalities)};
  std::erase_if(result.points, [&](const PremisePoint& point) { return !shows(point, result.form()); });
  return result;
}

struct Judgement {
  Fate fate = Fate::survived;
  std::string reason;
};

const char * const fails_there = "it fails where all that the claim rests on holds";

// Whether the terms are equal by normal form under what the claim assumes, or are so part by part.
bool same(Derivation& derivation, const Term& a, const Term& b) {
  if (equal(a, b)) {
    return true;
  }
  if (a.shape() != b.shape()) {
    return false;
  }
  if (is_in_field(a) && is_in_field(b)) {
    try {
      static_cast<void>(derivation.combination(derivation.read(equation(a, b))));
      return true;
    } catch (const kernel::KernelError&) {
      return false;
    }
  }
  return a.op() == b.op() && a.name() == b.name() && a.number() == b.number() &&
         std::equal(a.arguments().begin(), a.arguments().end(), b.arguments().begin(), b.arguments().end(),
                    [&](const Term& x, const Term& y) { return same(derivation, x, y); });
}

// Whether both sides are those of the statement as it is printed, or each other.
bool says_the_same(const Subject& subject, std::size_t which, const Statement& statement) {
  const Statement& printed = subject.form()[which];
  Derivation derivation(subject.prover, subject.record.claim);
  return equal(statement.left, statement.right) ||
         (same(derivation, statement.left, printed.left) && same(derivation, statement.right, printed.right));
}

Judgement judge_proved(const Subject& subject, std::size_t which, const Statement& statement) {
  if (subject.contradicted(statement)) {
    return {Fate::survived, "proved, although " + std::string(fails_there)};
  }
  if (std::ranges::any_of(subject.form(),
                          [&](const Statement& printed) { return equal(printed, statement); })) {
    return {Fate::equivalent, "the claim prints it, too"};
  }
  if (says_the_same(subject, which, statement)) {
    return {Fate::equivalent, "its sides have the normal forms of those printed, or are equal"};
  }
  if (subject.points.empty()) {
    return {Fate::survived, "proved, and there is no point where it could be evaluated"};
  }
  return {Fate::equivalent,
          "proved, and it holds at the points tried where all that the claim rests on holds"};
}

Judgement judge(const Subject& subject, std::size_t which, const Statement& statement) {
  bool wrong = false;
  try {
    wrong = subject.contradicted(statement);
    if (!wrong && subject.has_no_value(statement)) {
      return {Fate::stillborn, "it has no value where all that the claim rests on holds"};
    }
  } catch (const NoValue& error) {
    return {Fate::stillborn, error.what()};
  }
  try {
    const Verdict verdict = subject.verdict_on(which, statement);
    if (verdict.truth == Truth::proved) {
      return judge_proved(subject, which, statement);
    }
    const bool refuted = wrong || verdict.truth == Truth::refuted;
    return {refuted ? Fate::refuted : Fate::unproved, wrong ? fails_there : verdict.reason};
  } catch (const InternalError& error) {  // the proof does not take such a statement
    return {wrong ? Fate::refuted : Fate::unproved, error.what()};
  }
}

// Whether the statement is drawn.
bool is_drawn(const Sampling& sampling, const std::string& id, const Statement& statement) {
  if (sampling.one_in <= 1) {
    return true;
  }
  unsigned hash = 2166136261U ^ sampling.seed;
  for (const char c : id + text(statement)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return (hash >> 8U) % sampling.one_in == 0;
}

// Calls `look` for every statement drawn that `edited` makes from what the claim prints.
void for_each(const Subject& subject, const Sampling& sampling, std::vector<Edit> (*edited)(const Statement&),
              const std::function<void(std::size_t, const Edit&)>& look) {
  for (std::size_t i = 0; i < subject.form().size(); ++i) {
    for (const Edit& edit : edited(subject.form()[i])) {
      if (is_drawn(sampling, subject.record.claim.id, edit.statement)) {
        look(i, edit);
      }
    }
  }
}

Verdict verdict_on_twin(const Subject& subject, std::size_t which, const Statement& statement) {
  try {
    return subject.verdict_on(which, statement);
  } catch (const InternalError& error) {
    return Verdict::undecided(error.what());
  }
}

void add_subject(Gate& gate, const Subject& subject) {
  const Claim& claim = subject.record.claim;
  for_each(subject, gate.sampling, edits, [&](std::size_t which, const Edit& edit) {
    const Judgement found = judge(subject, which, edit.statement);
    gate.mutants.push_back(
        {claim.id, claim.place, edit.kind, text(edit.statement), found.fate, found.reason});
  });
  for_each(subject, gate.sampling, rewritings, [&](std::size_t which, const Edit& edit) {
    gate.twins.push_back({claim.id, claim.place, edit.kind, text(edit.statement),
                          verdict_on_twin(subject, which, edit.statement)});
  });
}

Outcome outcome_on(Prover& prover, const Claim& claim, const std::vector<Statement>& statements) {
  return claim.prove(prover, saying(claim, statements));
}

// Whether the proof has refuted an edited statement by the theorem that refutes the printed one: it does not
// look at what is printed.
bool same_refutation(const Outcome& edited, const Outcome& printed) {
  return edited.theorems.size() == 1 && printed.theorems.size() == 1 &&
         edited.theorems.front().conclusion() == printed.theorems.front().conclusion();
}

}  // namespace

std::string to_string(Fate fate) {
  static constexpr std::array names{"refuted", "unproved", "meaningless", "true_too", "survived"};
  return names.at(static_cast<std::size_t>(fate));
}

Gate mutant_gate(const std::vector<Claim>& claims, const std::set<std::string>& ids, const Sampling& sampling,
                 const Progress& progress) {
  Gate gate{sampling, {}, {}};
  Prover prover(claims);
  std::size_t done = 0;
  for (const Claim& claim : claims) {
    progress(claim.id, done++, claims.size());
    if (!ids.empty() && !ids.contains(claim.id)) {
      continue;
    }
    if (const auto one = subject(prover, claim)) {
      add_subject(gate, *one);
    }
  }
  return gate;
}

namespace {

// Whether there are values with which the roots in it, if there are some, are numbers.
bool has_its_roots(Prover& prover, const Claim& claim) {
  return std::ranges::none_of(claim.assumptions, is_of_root) || obeying_point(prover, claim);
}

// What the edited statement needs that is not seen in it.
std::string needed(const Claim& claim, const Outcome& outcome) {
  std::string text;
  for (const Hypothesis& one : outcome.hypotheses) {
    if (!is_seen(one, claim, claim)) {
      text += (text.empty() ? ", where $" : ", $") + one.text + "$";
    }
  }
  return text;
}

}  // namespace

std::vector<Repair> repairs(Prover& prover, const Claim& claim, const Statement& statement,
                            const Outcome& refuted) {
  std::vector<Repair> found;
  for (const Edit& edit : edits(statement)) {
    if (equal(edit.statement.left, edit.statement.right)) {
      continue;  // which says nothing
    }
    const Claim edited = saying(claim, {edit.statement});
    const Outcome outcome = edited.prove(prover, edited);
    if (same_refutation(outcome, refuted)) {
      return found;
    }
    if (outcome.verdict.truth == Truth::proved && has_its_roots(prover, edited)) {
      found.push_back({edit.what + needed(edited, outcome), edit.statement});
    }
  }
  return found;
}

void repair(Prover& prover, Record& record) {
  std::vector<Statement> corrected;
  for (const Statement& statement : record.claim.printed) {
    if (record.claim.printed.size() > 1 &&
        outcome_on(prover, record.claim, {statement}).verdict.truth == Truth::proved) {
      corrected.push_back(statement);
      continue;
    }
    const std::vector<Repair> found = repairs(prover, record.claim, statement, record.outcome);
    if (found.empty()) {
      return;
    }
    corrected.push_back(found.front().statement);
    record.repairs.insert(record.repairs.end(), found.begin(), found.end());
  }
  record.claim.corrected = corrected;
  record.corrected = outcome_on(prover, record.claim, corrected);
}

}  // namespace stickslip::proofs::checks
