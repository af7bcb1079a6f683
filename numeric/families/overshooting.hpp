// The orbits with an overshooting part of Section 5: slip on (0, tau), overshoot on (tau, tau + tau1), stick
// on (tau + tau1, Theta); Z(Theta) = Z0 (20), z2'(0) = z2'(tau) = z2'(tau + tau1) = V (12), (18), (19).
//
// The search runs over (s, w) in [0, 1]², tau + tau1 = Theta s, tau1 = Theta s w: the closed triangle tau,
// tau1
// >= 0, tau + tau1 <= Theta. The reduced equations of model/overshooting_closing.hpp are linear in the
// amplitudes, which are eliminated by determinants; a zero of those counts only when the amplitudes that it
// stands for are proved to exist.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/printed.hpp"
#include "model/overshooting_closing.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

// The data of the reduced equations at the working precision.
template <class S>
[[nodiscard]] model::OvershootingData<S> overshooting_data(const motion::ExactParameters& a) {
  const model::Parameters<S> b = motion::parameters_as<S>(a);
  const S Theta = S(2) * scalars::pi<S>() / b.omega;
  return {b.chi, b.eta, model::modes<S>(b.chi, b.eta), b.us, b.V, b.omega, b.p, Theta};
}

// What an orbit is known by; each member contains the exact value.
template <class S>
struct OvershootingState {
  S tau, tau1, T, Theta, phi;  // phi in (-pi, pi] when it is a result
  S z10, z20, zdot10, zdot20;  // the state at the beginning of the slip
  S x10, x20;                  // the same as displacements
  S ur;                        // from (12)
};

struct OvershootingOrbit {
  OvershootingState<Ball> state;
  zeros::Box<2> unique;             // no other orbit has ((tau + tau1)/Theta, tau1/(tau + tau1)) in this box
  long bits = 0;                    // the precision that the state was computed with
  model::Vector4<Ball> residual20;  // Z(Theta) - Z0 through the flows (5), (8), (10): each contains 0
  Ball residual18;                  // z2'(tau) - V
  Ball residual19;                  // z2'(tau + tau1) - V
};

// Its three phases through the flows, at the precision of the orbit.
[[nodiscard]] motion::Motion motion_of(const motion::ExactParameters& a, const OvershootingOrbit& orbit);

// What the times leave open: the motion on the stick and the load's phase (model/overshooting_closing.hpp).
struct StickAmplitudes {
  Ball a, C, D, phi;
};

// Everything about the orbit at proved times and amplitudes, at the working precision, closed through the
// flows and not through the reduction; the box of uniqueness is left empty. Throws InternalError when a
// residual excludes 0.
[[nodiscard]] OvershootingOrbit describe_overshooting(const motion::ExactParameters& a, const Ball& tau,
                                                      const Ball& tau1, const StickAmplitudes& amplitude);

// Whether there is exactly one orbit near a guess.
struct OvershootingProof {
  Verdict existence;
  OvershootingOrbit orbit;  // meaningless unless existence is proved
};

// Proves the orbit at the load phase phi near the guess (tau, tau1) and encloses it to `digits` significant
// decimal digits or more. Undecided when no box around the guess passes Krawczyk's test, or the orbit reaches
// an edge of the triangle. Throws DomainError outside the domain of require_stick_slip_domain.
[[nodiscard]] OvershootingProof prove_overshooting_at_phase(const motion::ExactParameters& a,
                                                            const Rational& phi,
                                                            const model::Vector2<double>& guess, int digits);

// A part of the triangle in which the search could not decide.
struct UnresolvedTimes {
  Ball tau, tau1;
  std::string reason;
};

struct OvershootingList {
  std::vector<OvershootingOrbit> orbits;  // sorted by tau + tau1; the existence of each is proved
  std::vector<UnresolvedTimes> unresolved;
  long cells = 0;  // examined by the search

  // No orbit in the closed triangle is missing from the list.
  [[nodiscard]] bool complete() const { return unresolved.empty(); }
};

// All orbits at the load phase phi (exactly as given, any real number), u_r being a result.
// Throws DomainError outside the domain of require_stick_slip_domain.
[[nodiscard]] OvershootingList list_overshooting_at_phase(const motion::ExactParameters& a,
                                                          const Rational& phi, int digits);

// All orbits whose friction at rest is u_r (exactly as given), the load's phase phi being a result in (-pi,
// pi]. Throws DomainError outside that domain, for p = 0, where no phase is left to meet u_r, and for u_r <=
// 0.
[[nodiscard]] OvershootingList list_overshooting_at_friction(const motion::ExactParameters& a,
                                                             const Rational& ur, int digits);

// The closing conditions at printed values of (tau, tau1, z10, z20, zdot10), through the flows (5), (8),
// (10).
struct PrintedClosing {
  // z2'(tau) - V, then the components z1, z2, z1', z2' of Z(Theta) - Z0.
  std::array<Ball, 5> at_points;     // at the decimals themselves
  std::array<Ball, 5> at_intervals;  // over the intervals that they stand for
  // Of "the printed intervals contain an orbit": refuted when a condition excludes it, else undecided.
  Verdict verdict;
};
[[nodiscard]] PrintedClosing printed_closing_overshooting(const motion::ExactParameters& a,
                                                          const Rational& phi,
                                                          const std::array<Decimal, 5>& printed);

}  // namespace stickslip::numeric::families
