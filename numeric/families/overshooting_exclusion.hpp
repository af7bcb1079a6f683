// What excludes boxes of (s, w) before the linear unknowns of Section 5 are eliminated
// (overshooting_rows.hpp).
#pragma once

#include "numeric/families/overshooting_rows.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

using BoxJet = scalars::Jet<Ball, 2>;

// A family's two odd rows over a box and at its middle.
template <class Family>
struct OddRows {
  Eigen::Matrix<BoxJet, 2, Family::unknowns + 1> over;
  Eigen::Matrix<Ball, 2, Family::unknowns + 1> at_m;
};

// The part of X, m its middle, that the odd rows alone leave. phi given: left C + right = 0, and their
// determinant must vanish. u_r given: nothing is left where |sin psi| > 1.
[[nodiscard]] std::optional<zeros::Box<2>> contract_by_odd_rows(const OddRows<OvershootingAtPhase>& o,
                                                                const zeros::Box<2>& m,
                                                                const zeros::Box<2>& X);
[[nodiscard]] std::optional<zeros::Box<2>> contract_by_odd_rows(const OddRows<OvershootingAtFriction>& o,
                                                                const zeros::Box<2>& m,
                                                                const zeros::Box<2>& X);

// omega = 1/k: near tau + tau1 = 0 the odd rows vanish like its cube, but for a part that does not. Whether
// that excludes X.
[[nodiscard]] bool excluded_at_origin(const OvershootingAtPhase& f, const zeros::Box<2>& X);
[[nodiscard]] bool excluded_at_origin(const OvershootingAtFriction& f, const zeros::Box<2>& X);

// False when, a, C and D eliminated, one of the last three rows holds for no |cos psi|, |sin psi| <= 1.
[[nodiscard]] bool is_possible(const RowsOf<BoxJet, OvershootingAtFriction>& eliminated);

}  // namespace stickslip::numeric::families
