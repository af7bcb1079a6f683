// What the methods of proof share: what a claim's assumptions give, and what a proof took recorded in its
// outcome.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "proofs/methods/claim.hpp"
#include "proofs/methods/methods.hpp"

namespace stickslip::proofs::methods {

// An assumption of the form "scalar = value", which is put in wherever the scalar stands; the value does not
// speak of it, and the symbol is not pi.
[[nodiscard]] bool is_substitution(const Assumption& assumption);

// The claim that prints these statements. Of each root sqrt(a) in them, and in what it assumes, it assumes
// that its square is a and that it is not negative: so it speaks of where its roots are numbers.
[[nodiscard]] Claim saying(Claim claim, std::vector<symbols::Statement> statements);
// Whether the claim assumes this for a root only.
[[nodiscard]] bool is_of_root(const Assumption& assumption);
// Whether the theorem, of this statement of the claim, assumes something of roots in other statements: those
// may be numbers in fewer places.
[[nodiscard]] bool rests_on_other_roots(const kernel::Theorem& theorem, const Claim& claim,
                                        const symbols::Statement& statement);

// The names of the symbols with which the term changes. F0 and R mention the load's phase without showing it.
[[nodiscard]] std::set<std::string> names_in(const symbols::Term& term);
[[nodiscard]] bool depends_on(const symbols::Term& term, const std::string& name);

// What the claim's assumptions give to scalars: one value to each, none in terms of itself.
struct Given {
  std::map<std::string, symbols::Term> values;

  Given() = default;
  explicit Given(const Claim& claim);
  // Where nobody names the proof also of what says "value = scalar", and of "scalar = scalar" one of both; a
  // proof that is named says itself what it puts in.
  [[nodiscard]] static Given in_both_directions(const Claim& claim);

  // Adds "scalar = value", unless the scalar has a value or this one leads back to it. Whether it did.
  bool take(const symbols::Statement& statement);

  // Whether the assumption is one of the values. A second value of a scalar, or one that leads back to it, is
  // a condition.
  [[nodiscard]] bool takes(const Assumption& assumption) const;
  // The assumption as "scalar = value", where that is one of the values, in whichever direction it is said.
  [[nodiscard]] std::optional<symbols::Statement> value_in(const Assumption& assumption) const;

 private:
  [[nodiscard]] bool leads_to(const symbols::Term& term, const std::string& name) const;
};

// What a premise offers to the claim: the form that was proved, or is assumed, with symbols replaced.
[[nodiscard]] std::vector<symbols::Statement> statements_of(Prover& prover, const Claim& claim,
                                                            const Premise& premise);

// Adds the claims that define what the term speaks of.
void record_definitions(Outcome& outcome, const Claim& claim, const symbols::Term& term);

// Whether the claim that brought the hypothesis in prints a division, or a tangent, by something that is zero
// where the hypothesis fails. Of another claim only what a source prints is seen, none of our own formulas.
[[nodiscard]] bool is_seen(const Hypothesis& hypothesis, const Claim& needing, const Claim& origin);

}  // namespace stickslip::proofs::methods
