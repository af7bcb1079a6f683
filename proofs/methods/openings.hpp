// Which definitions a proof may look into.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::methods {

// The definitions in some formulas, and in one another, by what a proof opens them for.
struct Openings {
  static constexpr const char * coefficients = "21";  // what the coefficients of (21) stand under in `closed`

  kernel::Definitions names;     // of what is put together: Z_0, Q, delta_0
  kernel::Definitions formulas;  // of matrices and functions of the model: H(t), F(t), Gamma(t)
  std::map<std::string, kernel::Definitions> closed;  // of scalars, by the claim that says what they are

  [[nodiscard]] kernel::Definitions all() const;
  // All but the coefficients of (21), which are long and irreducible enough as names.
  [[nodiscard]] kernel::Definitions in_parameters() const;
  // All but those closed scalars whose claim is not among these.
  [[nodiscard]] kernel::Definitions with(const std::set<std::string>& ids) const;
};
[[nodiscard]] Openings openings(const std::vector<kernel::Formula>& formulas);

}  // namespace stickslip::proofs::methods
