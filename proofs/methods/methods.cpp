#include "proofs/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/rewrite.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/tactics/letters.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

const char * const normal_form_route = "both sides have the same normal form, for all values of the symbols";

kernel::Theorem by_itself(Derivation& derivation, std::size_t which) {
  return derivation.combination(derivation.printed(which));
}

// The printed statements that speak of nothing but what has a value.
std::vector<Statement> with_values(std::vector<Statement> printed) {
  std::erase_if(printed,
                [](const Statement& one) { return !is_in_field(one.left) || !is_in_field(one.right); });
  return printed;
}

// What a proof found out besides, which has to hold as well.
void join(Outcome& outcome, const Outcome& further) {
  if (outcome.verdict.truth == Truth::proved && further.verdict.truth != Truth::proved) {
    outcome.verdict = further.verdict;
    outcome.by_kernel = false;
  }
  outcome.hypotheses = joined(outcome.hypotheses, further.hypotheses);
  outcome.uses.insert(further.uses.begin(), further.uses.end());
  outcome.assumed.insert(further.assumed.begin(), further.assumed.end());
  outcome.decided.insert(outcome.decided.end(), further.decided.begin(), further.decided.end());
}

Outcome by_normal_form(Prover& prover, const Claim& claim, const std::vector<Statement>& meaning) {
  Outcome outcome = derived(normal_form_route, prover, claim, by_itself);
  if (!meaning.empty()) {
    Claim meant = claim;
    meant.printed = meaning;
    join(outcome, derived(normal_form_route, prover, meant, by_itself));
  }
  outcome.doubted = with_values(claim.printed);
  outcome.doubted.insert(outcome.doubted.end(), meaning.begin(), meaning.end());
  return outcome;
}

}  // namespace

Proof by_normal_form() {
  return [](Prover& prover, const Claim& claim) { return by_normal_form(prover, claim, {}); };
}

Proof by_normal_form(std::vector<Statement> meaning) {
  return [meaning = std::move(meaning)](Prover& prover, const Claim& claim) {
    return by_normal_form(prover, claim, meaning);
  };
}

Proof by_derivation(const std::string& route, Compare compare) {
  return [route, compare = std::move(compare)](Prover& prover, const Claim& claim) {
    Outcome outcome = by_normal_form(prover, claim, {});
    outcome.route = route;
    join(outcome, compared(route, prover, claim, compare));
    return outcome;
  };
}

Outcome compared(const std::string& route, Prover& prover, const Claim& claim, const Compare& compare) {
  Outcome outcome;
  outcome.route = route;
  Derivation derivation(prover, claim);
  // With what the symbols mean in place of their letters.
  const auto read = [&](const kernel::Term& term) {
    kernel::Substitution meanings;
    for (const kernel::Variable& letter : term.variables()) {
      meanings.emplace(letter, derivation.read(symbols::scalar(letter.name)));
    }
    return substitute(term, meanings);
  };
  try {
    for (const Equal& equal : compare(derivation)) {
      const kernel::Term left = read(equal.left), right = read(equal.right);
      const kernel::Formula whole = kernel::equal(left, right);  // refuses what differs in shape
      const bool apart = left.kind() == kernel::Kind::matrix && right.kind() == kernel::Kind::matrix;
      for (std::size_t i = 0; i < (apart ? left.parts().size() : 1); ++i) {
        const kernel::Formula entry = apart ? kernel::equal(left.parts()[i], right.parts()[i]) : whole;
        outcome.theorems.push_back(derivation.settled(derivation.combination(entry)));
        derivation.record(outcome, outcome.theorems.back());
      }
      outcome.decided.push_back({.left = left, .right = right});
    }
    outcome.by_kernel = true;
    outcome.verdict = Verdict::proved();
  } catch (const kernel::KernelError& error) {
    outcome = {};
    outcome.route = route;
    outcome.verdict = Verdict::undecided(error.what());
  }
  return outcome;
}

Premise Premise::at(const std::string& symbol, const Term& value) const {
  Premise result = *this;
  result.replacements.emplace(symbol, value);
  return result;
}

Premise Premise::given(const std::string& assumption, const std::string& claim) const {
  Premise result = *this;
  result.supplied.emplace(assumption, claim);
  return result;
}

Premise Premise::solved_for(const Term& product) const {
  Premise result = *this;
  result.lead = product;
  return result;
}

Premise Premise::divided_by(const Term& square) const {
  Premise result = *this;
  result.factor = square;
  return result;
}

Premise from(const std::string& id) {
  return {.id = id};
}
Premise assuming(const std::string& id) {
  return {.id = id, .assumed = true};
}

namespace {

// Rules with what each comes from in the kernel.
struct Source {
  Premise premise;
  std::size_t statement = 0;
};
struct Rules {
  std::vector<Rule> rules;
  std::vector<std::optional<Source>> sources;  // nothing for a cancellation
  std::map<std::string, Term> letters;
};

// A^{-1} A = I.
Rule cancellation(const Claim& claim, const Term& square, const Scalars& scalars) {
  for (const Assumption& assumption : claim.assumptions) {
    const Statement& stated = assumption.statement;
    if (stated.relation == Relation::not_equal && equal(stated.left, determinant(square)) &&
        stated.right.is_zero()) {
      return {polynomial(inverse(square) * square, scalars).begin()->first, {{{}, 1}}};
    }
  }
  throw UsageError(
      fmt::format("claim {} divides by {} without assuming that it can", claim.id, text(square)));
}

// Adds the statements of a premise that can be solved for what it is to be solved for; at least one.
void add_rules(Rules& known, Prover& prover, const Claim& claim, const Scalars& scalars,
               const Premise& premise) {
  if (premise.factor) {
    known.rules.push_back(cancellation(claim, *premise.factor, scalars));
    known.sources.emplace_back();
    collect_letters(inverse(*premise.factor) * *premise.factor, scalars, known.letters);
  }
  const std::vector<Rule> simplifying = known.rules;
  const std::vector<Statement> statements = statements_of(prover, claim, premise);
  for (std::size_t i = 0; i < statements.size(); ++i) {
    Statement statement = statements[i];
    if (premise.factor) {
      const Term left = inverse(*premise.factor);
      statement = {left * statement.left,
                   statement.right.is_zero() ? statement.right : left * statement.right, statement.relation};
    }
    const Polynomial lead = polynomial(premise.lead.value_or(statement.left), scalars);
    std::optional<Rule> rule;
    if (lead.size() == 1) {
      rule = solve(residual(statement, scalars), lead, simplifying);
    }
    if (rule) {
      known.rules.push_back(*std::move(rule));
      known.sources.emplace_back(Source{premise, i});
      collect_letters(statement.left, scalars, known.letters);
      collect_letters(statement.right, scalars, known.letters);
    }
  }
  if (known.rules.size() == simplifying.size()) {
    throw UsageError(
        fmt::format("claim {}: the premise {} cannot be solved as wanted", claim.id, premise.id));
  }
}

// What a trace took away, as multiples of the residuals of what the rules come from.
using Summands = std::map<std::tuple<Word, std::size_t, Word>, kernel::Term>;

Word operator+(Word a, const Word& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void add_trace(Summands& sum, const Rules& known, const std::vector<Application>& trace,
               const kernel::Term& factor, const Word& before, const Word& after) {
  for (const Application& one : trace) {
    const Rule& rule = known.rules[one.rule];
    const kernel::Term scaled = factor * one.coefficient * kernel::Term(Rational(1 / rule.scale));
    auto& total = sum.try_emplace({before + one.before, one.rule, one.after + after}, 0).first->second;
    total = total + scaled;
    add_trace(sum, known, rule.trace, -scaled, before + one.before, one.after + after);
  }
}

// The statement is what the trace took away.
kernel::Theorem by_trace(Derivation& derivation, const Rules& known, const Statement& statement,
                         const std::vector<Application>& trace) {
  Summands sum;
  add_trace(sum, known, trace, 1, {}, {});
  const auto product = [&](const Word& word) {
    std::optional<kernel::Term> result;
    for (const std::string& letter : word) {
      const kernel::Term next = derivation.read(known.letters.at(letter));
      result = result ? *result * next : next;
    }
    return result.value_or(1);
  };
  std::vector<kernel::Multiple> multiples;
  for (const auto& [place, coefficient] : sum) {
    const auto& [before, rule, after] = place;
    const kernel::Term scale = tactics::quotient(coefficient, 1);
    if (scale == kernel::Term(0)) {
      continue;
    }
    kernel::Term left = scale * product(before);
    const kernel::Term right = product(after);
    const auto& source = known.sources[rule];
    if (!source) {
      const kernel::Term unit = product(known.rules[rule].lead);
      multiples.push_back(
          {derivation.combination(equal(unit, kernel::identity(unit.type().rows))), left, right});
      continue;
    }
    if (source->premise.factor) {
      left = left * derivation.read(inverse(*source->premise.factor));
    }
    const kernel::Theorem equation = derivation.premise(source->premise, source->statement);
    // An inverse is replaced before its determinant is asked for.
    if (equation.conclusion().parts()[0].kind() == kernel::Kind::inverse) {
      derivation.give(equation);
    } else {
      multiples.push_back({equation, left, right});
    }
  }
  return derivation.combination(derivation.read(statement), multiples);
}

}  // namespace

Proof by_rewriting(std::vector<Premise> premises) {
  return by_kernel("replacing equals by equals, with the premises listed",
                   [premises = std::move(premises)](Derivation& derivation, std::size_t which) {
                     const Claim& claim = derivation.claim();
                     const Statement& printed = claim.printed[which];
                     const Scalars scalars = [&](const Term& number) {
                       return tactics::quotient(derivation.with_values(derivation.read(number)), 1);
                     };
                     Rules known;
                     for (const Premise& premise : premises) {
                       add_rules(known, derivation.prover(), claim, scalars, premise);
                     }
                     for (const Term& side : {printed.left, printed.right}) {
                       collect_letters(side, scalars, known.letters);
                     }
                     const Rewritten rewritten = rewrite(residual(printed, scalars), known.rules);
                     if (!rewritten.rest.empty()) {
                       throw kernel::KernelError("the premises leave " + text(rewritten.rest));
                     }
                     return by_trace(derivation, known, printed, rewritten.trace);
                   });
}

Proof by_premises(std::vector<Premise> premises) {
  return by_kernel("what the premises say; what they assume beyond this is supplied by the claims listed",
                   [premises = std::move(premises)](Derivation& derivation, std::size_t which) {
                     const Statement& printed = derivation.claim().printed[which];
                     for (const Premise& premise : premises) {
                       const std::vector<Statement> made =
                           statements_of(derivation.prover(), derivation.claim(), premise);
                       const auto same = std::ranges::find_if(
                           made, [&](const Statement& one) { return equal(one, printed); });
                       if (same != made.end()) {
                         return derivation.premise(premise, static_cast<std::size_t>(same - made.begin()));
                       }
                     }
                     throw kernel::KernelError("no premise says " + text(printed));
                   });
}

}  // namespace stickslip::proofs::methods
