#include "proofs/methods/gate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/reading.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

namespace {

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
      rests_on_what_is_said(theorem);
    }
  }

  void refuted() {
    require(outcome_.theorems.size() == 1 && outcome_.theorems[0].hypotheses().empty(),
            "the refutation is not one theorem that rests on nothing");
    Formula said = outcome_.theorems[0].conclusion();
    while (said.kind() == kernel::Kind::exists) {
      said = opened(said, Variable{said.name(), said.binds()});
    }
    if (form_.empty()) {
      return;
    }
    const Formulas parts(said.parts().begin(), said.parts().end());
    require(std::ranges::all_of(claim_.assumptions,
                                [&](const auto& one) { return parts.contains(read_(one.statement)); }),
            "what is assumed need not hold where it is refuted");
    require(std::ranges::any_of(form_, [&](const auto& one) { return parts.contains(negation(read_(one))); }),
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

void pass_gate(Prover& prover, const Claim& claim, const std::vector<symbols::Statement>& form,
               const Outcome& outcome) {
  if (!outcome.by_kernel) {
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
