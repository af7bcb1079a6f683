// Section 5, example O: the closing conditions (21)-(23) with the data of Fig. 3, of tau and tau1.
#pragma once

#include <array>

#include "model/appendix3.hpp"
#include "proofs/orbits/along.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::pascal2012 {

// (47)-(51) at these times, of the frequencies omega1 and omega2: each coefficient is a definition O_a_1, …,
// in entries O_Htilde11, … of H and Gamma, which are definitions, too.
[[nodiscard]] model::ClosingCoefficients<tactics::Symbolic> closing_of_O(const kernel::Term& tau,
                                                                         const kernel::Term& tau1,
                                                                         model::Reading reading);
[[nodiscard]] model::ClosingCoefficients<Ball> closing_of_O(const Ball& tau, const Ball& tau1,
                                                            model::Reading reading);

// Of ranges of omega1, omega2, tau and tau1 ⊢ not both F_1 = 0 and F_2 = 0, (23). Throws KernelError where
// bounds do not show it.
[[nodiscard]] kernel::Theorem incompatible(const orbits::Ranges& ranges);

// The closing conditions at the values that the paper prints for an orbit.

// What conditions leave at printed decimals.
struct PrintedClosing {
  Eigen::Matrix<Ball, 5, 1> at_points;     // at the decimals themselves
  Eigen::Matrix<Ball, 5, 1> at_intervals;  // over the intervals that they stand for
  Verdict verdict;  // of "the intervals contain a zero"; undecided at best by evaluation
};

// z2'(tau) - V, then z1, z2, z1', z2' of Z(Theta) - Z0, through the flows (5), (8), (10), at (tau, tau1, z10,
// z20, zdot10); refuted when one of them is zero nowhere in the intervals. Throws DomainError outside the
// domain of orbits that stick.
[[nodiscard]] PrintedClosing printed_closing_overshooting(const numeric::motion::ExactParameters& a,
                                                          const Rational& phi,
                                                          const std::array<Decimal, 5>& printed);

}  // namespace stickslip::proofs::pascal2012
