// What the methods of proof share: statements evaluated under a claim's assumptions, decided by normal form,
// and everything that took recorded in an outcome.
#pragma once

#include <map>
#include <set>
#include <string>

#include "proofs/methods/claim.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/symbols/meaning.hpp"
#include "symbolic/algebra/decide.hpp"

namespace stickslip::proofs::methods {

// An assumption of the form "scalar = value", which is put in wherever the scalar stands; the value does not
// speak of it.
[[nodiscard]] bool is_substitution(const Assumption& assumption);

// The names of the symbols with which the term changes. F0 and R mention the load's phase without showing it.
[[nodiscard]] std::set<std::string> names_in(const symbols::Term& term);
[[nodiscard]] bool depends_on(const symbols::Term& term, const std::string& name);

// What the claim's assumptions give to scalars.
struct Given {
  std::map<std::string, symbols::Term> values;

  // Throws InternalError if one would have a value in terms of itself.
  explicit Given(const Claim& claim);
  // Refers to this object, which has to outlive it.
  [[nodiscard]] symbols::Lookup<GiNaC::ex> lookup() const;

 private:
  [[nodiscard]] bool leads_to(const symbols::Term& term, const std::string& name) const;
};

// What a premise offers to the claim: the form that was proved, or is assumed, with symbols replaced.
[[nodiscard]] std::vector<symbols::Statement> statements_of(Prover& prover, const Claim& claim,
                                                            const Premise& premise);

// Adds the claim's substitutions that the term depends on, and the claims that define what it speaks of.
void record_assumptions(Outcome& outcome, const Claim& claim, const symbols::Term& term);
void record_definitions(Outcome& outcome, const Claim& claim, const symbols::Term& term);

// Adds the hypothesis that the factor does not vanish, in terms of the parameters.
void record_nonzero(Outcome& outcome, const Claim& claim, const GiNaC::ex& factor);

// Sets the verdict on left = right and adds what that took to the outcome.
void decide(Outcome& outcome, const Claim& claim, const symbolic::algebra::Matrix& left,
            const symbolic::algebra::Matrix& right);
void decide(Outcome& outcome, const Claim& claim, const symbols::Statement& statement);

// Where the outcome is undecided: refuted, if it is a theorem that there are values with which all that the
// claim assumes holds and an equation that the outcome doubts does not (counterexample.cpp).
void look_for_witness(Outcome& outcome, Prover& prover, const Claim& claim);

}  // namespace stickslip::proofs::methods
