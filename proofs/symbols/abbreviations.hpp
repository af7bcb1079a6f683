// Scalars that the paper writes for an expression: the entries of Appendix 3, phi_B, phi_C, the determinants
// of (22).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::symbols {

// What the name stands for; nothing for a name that stands for itself.
[[nodiscard]] std::optional<Term> abbreviated(const std::string& name);

// The claim that says so; empty where it needs none.
[[nodiscard]] std::string abbreviation_defined_in(const std::string& name);

// For an entry such as Htilde13: the names with one index changed, and the same entry of the other matrices
// H, h, Htilde. Empty for any other name.
[[nodiscard]] std::vector<std::string> entry_siblings(const std::string& name);

// The entries of a 4x4 matrix by the paper's letter: Entries{"Htilde"}(1, 3) is "Htilde13".
struct Entries {
  std::string letter;
  [[nodiscard]] Term operator()(int row, int column) const;
};

// The coefficients of equation i of (21): a_i, b_i, c_i, d_i.
[[nodiscard]] Term coefficient(char letter, int equation);

// The determinant of (22) with these columns, of coefficients, in rows 1, 2, 3; `-d` for the negative column.
[[nodiscard]] Term determinant_of_columns(const std::array<std::string, 3>& columns);

}  // namespace stickslip::proofs::symbols
