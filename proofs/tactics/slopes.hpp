// Formulas that speak of rates: there are functions D1, D2, … with D1(t) = f'(t) for all times t, where f may
// speak of those before, and something holds of them. So methods/reading.hpp reads d/dt.
#pragma once

#include <functional>

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// What holds, with the derivatives put in; any other formula as it is. Throws KernelError for what is no
// derivative.
[[nodiscard]] Formula with_slopes(const Formula& formula);

// ⊢ the formula, by how that is shown of what is to hold then; `settled` is each derivative with fewer
// hypotheses. Throws KernelError where a hypothesis is left that speaks of the time.
using Shown = std::function<Theorem(const Formula&)>;
using Settled = std::function<Theorem(const Theorem&)>;
[[nodiscard]] Theorem there_are_slopes(const Formula& formula, const Settled& settled, const Shown& shown);

// ⊢ not the formula, which has no variables, by how the negation is shown of what is to hold then.
[[nodiscard]] Theorem there_are_no_slopes(const Formula& formula, const Shown& shown_not);

}  // namespace stickslip::proofs::tactics
