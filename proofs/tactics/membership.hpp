// Equations that follow from others as polynomials do.
#pragma once

#include <optional>
#include <vector>

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::tactics {

// Factors m_k with goal = m_1 given_1 + m_2 given_2 + …, all of them numbers, as rational functions of what
// is not rational in them, where cos(x)² + sin(x)² = 1; by a Gröbner basis of the numerators, lexicographic,
// in bounded work. Nothing where it finds none. A proposal: the kernel decides.
[[nodiscard]] std::optional<std::vector<kernel::Term>> multipliers(const kernel::Term& goal,
                                                                   const std::vector<kernel::Term>& given);

}  // namespace stickslip::proofs::tactics
