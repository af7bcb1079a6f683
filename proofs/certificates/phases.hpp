// Arguments of cos, sin and exp as sums of phases, for the addition theorems.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::certificates {

struct Expansion {
  std::string argument;  // in Coq
  std::string sum;       // "(omega1 * tau) + (omega1 * tau) + - (PI / 2)": what it equals
};

struct Expansions {
  std::vector<Expansion> arguments;  // those that are not a phase themselves
  std::vector<std::string> phases;
  bool of_zero = false;  // whether 0 is among them
};

struct Phases {
  Expansions circles;       // of cos and sin
  Expansions exponentials;  // of exp
};

// Numbers in arguments, as 3 in cos(3 + t), without signs: those together that have a phase in common.
using Numbers = std::vector<std::set<Rational>>;
[[nodiscard]] std::set<Rational> numbers_in_phases(const std::vector<kernel::Term>& terms);
// With variables in the place of their phases: where an identity is seen still, they may be apart.
[[nodiscard]] std::vector<kernel::Term> apart(const std::vector<kernel::Term>& terms, const Numbers& numbers);

// Of all cos, sin and exp in the terms, which are as Coq will have them: definitions that are to be looked
// into are unfolded. Nothing is proved here; Coq checks each sum.
[[nodiscard]] Phases phases_of(const std::vector<kernel::Term>& terms, const Numbers& numbers);

}  // namespace stickslip::proofs::certificates
