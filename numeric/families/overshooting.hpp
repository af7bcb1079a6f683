// The orbits with an overshooting part of Section 5: slip on (0, tau), overshoot on (tau, tau + tau1), stick
// on (tau + tau1, Theta); Z(Theta) = Z0 (20), z2'(0) = z2'(tau) = z2'(tau + tau1) = V (12), (18), (19).
// Either the load's phase phi is given and u_r is a result, or u_r is given and phi is.
//
// The search runs over (s, w) in [0, 1]², tau + tau1 = Theta s, tau1 = Theta s w: the closed triangle tau,
// tau1 >= 0, tau + tau1 <= Theta. The reduced equations of model/overshooting_closing.hpp are linear in the
// amplitudes, which are eliminated (overshooting_rows.hpp); a zero of what remains counts only when the
// amplitudes that it stands for are proved to exist.
#pragma once

#include "model/overshooting_closing.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::numeric::families {

// With phi given, any real number; or with ur > 0 given, for which p > 0 is needed (DomainError).
[[nodiscard]] const Family& overshooting();

// The data of the reduced equations at the working precision.
template <class S>
[[nodiscard]] model::OvershootingData<S> overshooting_data(const motion::ExactParameters& a) {
  const model::Parameters<S> b = motion::parameters_as<S>(a);
  const S Theta = S(2) * scalars::pi<S>() / b.omega;
  return {b.chi, b.eta, model::modes<S>(b.chi, b.eta), b.us, b.V, b.omega, b.p, Theta};
}

}  // namespace stickslip::numeric::families
