#include "proofs/methods/gate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/reading.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

namespace {

void add_domain(Formulas& formulas) {
  const std::vector<Formula> domain = domain_of(all({formulas.begin(), formulas.end()}).variables());
  formulas.insert(domain.begin(), domain.end());
}

// What holds of the same values: the formula, or what it says of those that it says there are. False if two
// of these have one name.
bool collect(const Formula& formula, Variables& named, Formulas& holding) {
  holding.insert(formula);
  if (formula.kind() == kernel::Kind::exists) {
    const Variable value{formula.name(), formula.binds()};
    return named.insert(value).second && collect(opened(formula, value), named, holding);
  }
  return formula.kind() != kernel::Kind::conjunction ||
         std::ranges::all_of(formula.parts(),
                             [&](const Formula& part) { return collect(part, named, holding); });
}

class Gate {
 public:
  Gate(Prover& prover, const Claim& claim, const std::vector<symbols::Statement>& form,
       const Outcome& outcome)
      : claim_(claim), form_(form), outcome_(outcome), derivation_(prover, claim) {}

  void proved() {
    require(!outcome_.theorems.empty(), "it is called a theorem, and there is none");
    require(form_.empty() || outcome_.theorems.size() == form_.size(),
            "there is not one theorem for each statement");
    for (std::size_t i = 0; i < outcome_.theorems.size(); ++i) {
      const Theorem& theorem = outcome_.theorems[i];
      require(form_.empty() || theorem.conclusion() == read_(form_[i]),
              "a theorem says something else than what is printed: " + to_string(theorem.conclusion()));
      require(form_.empty() || !rests_on_other_roots(theorem, claim_, form_[i]),
              "it rests on a root that another statement speaks of");
      rests_on_what_is_said(theorem);
    }
  }

  void refuted() {
    require(outcome_.theorems.size() == 1, "the refutation is not one theorem");
    const Theorem& theorem = outcome_.theorems[0];
    const Formulas assumed = form_.empty() ? Formulas{} : assumed_by(saying(claim_, {}));
    require((!form_.empty() && assumed.empty()) || says_that_there_are_values(theorem, assumed),
            "where it is refuted need not lie in the domain, or obey what is assumed");
    require(form_.empty() || std::ranges::any_of(form_,
                                                 [&](const auto& one) {
                                                   Formulas all = assumed_by(saying(claim_, {one}));
                                                   all.insert(negation(read_(one)));
                                                   add_domain(all);
                                                   return says_that_there_are_values(theorem, all);
                                                 }),
            "what is printed is not what is refuted");
  }

 private:
  void require(bool holds, const std::string& what) const {
    if (!holds) {
      throw InternalError(fmt::format("claim {}: {}", claim_.id, what));
    }
  }

  // Hypotheses that are assumed, of the domain, or d ≠ 0, which the outcome reports; of a claim in words also
  // ranges of letters, which its theorem states.
  void rests_on_what_is_said(const Theorem& theorem) {
    Formulas more;
    for (const Formula& one : theorem.hypotheses()) {
      if (form_.empty() && is_inequality(one)) {
        more.insert(one);
      }
    }
    Outcome found;
    try {
      derivation_.record(found, theorem, more);
    } catch (const KernelError& error) {
      require(false, error.what());
    }
    for (const Hypothesis& one : found.hypotheses) {
      require(std::ranges::any_of(outcome_.hypotheses,
                                  [&](const Hypothesis& other) { return other.text == one.text; }),
              "it divides by something without a word: " + one.text);
    }
  }

  const Claim& claim_;
  const std::vector<symbols::Statement>& form_;
  const Outcome& outcome_;
  Derivation derivation_;
  Reader read_;
};

}  // namespace

Formulas assumed_by(const Claim& claim) {
  Formulas result;
  Reader read;
  for (const Assumption& assumption : claim.assumptions) {
    result.insert(read(assumption.statement));
  }
  add_domain(result);
  return result;
}

bool says_that_there_are_values(const Theorem& theorem, const Formulas& all) {
  Variables named;
  Formulas holding;
  const Formula& conclusion = theorem.conclusion();
  const bool needs_none = !all.empty() && conclusion.variables().empty();  // 1 = 2 fails for no values at all
  return theorem.hypotheses().empty() && (conclusion.kind() == kernel::Kind::exists || needs_none) &&
         collect(conclusion, named, holding) && std::ranges::includes(holding, all, Before{}) &&
         std::ranges::all_of(all, [&](const Formula& one) {
           return std::ranges::includes(named, one.variables(), Before{});
         });
}

void pass_gate(Prover& prover, const Claim& claim, const std::vector<symbols::Statement>& form,
               const Outcome& outcome) {
  if (!outcome.by_kernel) {
    if (!outcome.theorems.empty()) {
      throw InternalError(fmt::format("claim {}: it has theorems, and its verdict is not theirs", claim.id));
    }
    return;
  }
  Gate gate(prover, claim, form, outcome);
  if (outcome.verdict.truth == Truth::proved) {
    gate.proved();
  } else if (outcome.verdict.truth == Truth::refuted) {
    gate.refuted();
  }
}

}  // namespace stickslip::proofs::methods
