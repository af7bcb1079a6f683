// The symmetric orbits of Section 4: slip on (0, tau), stick on (tau, Theta), T = Theta - tau, with
// Z(tau) = E Z0 (13) and Z0 = Gamma(T) E Z0 (15).
//
// Approximation in floats, bounds in balls, conclusion by Krawczyk's test on the two reduced equations of
// model/symmetric_closing.hpp, which are equivalent to all components of (13) and (15).
#pragma once

#include <array>
#include <vector>

#include "core/printed.hpp"
#include "model/symmetric.hpp"
#include "model/symmetric_closing.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::families {

// The two load phases that the symmetry allows.
enum class LoadPhase {
  first,   // phi = (pi - omega tau)/2, the paper's
  second,  // phi = (pi - omega tau)/2 + pi
};

// The data of the reduced equations at the working precision.
template <class S>
[[nodiscard]] model::SymmetricData<S> symmetric_data(const motion::ExactParameters& a, LoadPhase phase) {
  const S chi = scalars::scalar<S>(a.chi);
  const S omega = scalars::scalar<S>(a.omega);
  return {chi,
          model::modes<S>(chi, scalars::scalar<S>(a.eta)),
          scalars::scalar<S>(a.V),
          omega,
          scalars::scalar<S>(a.p),
          S(S(2) * scalars::pi<S>() / omega),
          S(phase == LoadPhase::first ? 1 : -1)};
}

// The reduced equations as a function of x = (tau, C).
template <class S>
struct SymmetricClosing {
  model::SymmetricData<S> data;

  template <class T>
  [[nodiscard]] model::Vector2<T> operator()(const model::Vector2<T>& x) const {
    return model::symmetric_closing<T>(lifted<T>(), x(0), x(1));
  }
  template <class T>
  [[nodiscard]] model::SymmetricData<T> lifted() const {
    return {T(data.chi), model::lift<T>(data.m), T(data.V),    T(data.omega),
            T(data.p),   T(data.Theta),          T(data.sigma)};
  }
};

// The paper's own four equations (16) as a function of x = (tau, z10, z20, zdot10).
template <class S>
struct Equations16 {
  model::SymmetricData<S> data;
  model::Vector2<S> Q;

  template <class T>
  [[nodiscard]] model::Vector4<T> operator()(const model::Vector4<T>& x) const {
    const model::Vector2<T> z0(x(1), x(2));
    const model::Vector2<T> zdot0(x(3), T(data.V));
    return model::symmetric_residual<T>(T(data.chi), model::lift<T>(data.m), model::lift<T>(Q), T(data.omega),
                                        T(data.Theta), x(0), z0, zdot0);
  }
};

// (16) at the working precision; its Q changes sign with the load phase.
template <class S>
[[nodiscard]] Equations16<S> equations_16(const motion::ExactParameters& a, LoadPhase phase) {
  const model::SymmetricData<S> data = symmetric_data<S>(a, phase);
  return {data, model::Vector2<S>(model::Q<S>(motion::parameters_as<S>(a), data.m) * data.sigma)};
}

// What an orbit is known by; each member contains the exact value.
template <class S>
struct SymmetricState {
  S tau, T, Theta, phi;
  S z10, z20, zdot10, zdot20;  // the state at the beginning of the slip
  S x10, x20;                  // the same as displacements
  S ur;                        // from (12)
  S C;                         // amplitude of z1 about chi z2 during the stick
};

struct SymmetricOrbit {
  LoadPhase phase = LoadPhase::first;
  SymmetricState<Ball> state;
  Ball tau_unique;  // no other orbit of this load phase has tau here and C in C_unique
  Ball C_unique;
  long bits = 0;                    // the precision that the state was computed with
  model::Vector4<Ball> residual13;  // Z(tau) - E Z0 by the flow (5): each contains 0
  model::Vector4<Ball> residual15;  // Z0 - Gamma(T) E Z0: each contains 0
  model::Vector4<Ball> residual16;  // the paper's four equations: each contains 0
};

// Its slip and its stick, which begins at E Z0 (13), at the precision of the orbit.
[[nodiscard]] motion::Motion motion_of(const motion::ExactParameters& a, const SymmetricOrbit& orbit);

// Whether there is exactly one orbit near a guess.
struct SymmetricProof {
  Verdict existence;
  SymmetricOrbit orbit;  // meaningless unless existence is proved
};

// tau and C of the orbits that a scan of the eliminant over (0, Theta) finds in double: guesses, maybe not
// all.
[[nodiscard]] std::vector<model::Vector2<double>> symmetric_guesses(const motion::ExactParameters& a,
                                                                    LoadPhase phase);

// Everything about an orbit from (tau, C), over any numeric scalar.
template <class S>
[[nodiscard]] SymmetricState<S> symmetric_state(const motion::ExactParameters& a, LoadPhase phase,
                                                const model::Vector2<S>& tau_C) {
  const model::SymmetricData<S> data = symmetric_data<S>(a, phase);
  const S tau = tau_C(0);
  const model::Vector4<S> Z0 = model::symmetric_start<S>(data, tau, tau_C(1));
  const model::Vector2<S> x0 = Z0.template head<2>() + model::d0<S>(data.chi, scalars::scalar<S>(a.us));
  const S phi = model::symmetric_phase<S>(data, scalars::pi<S>(), tau);
  return {
      tau,
      S(data.Theta - tau),
      data.Theta,
      phi,
      Z0(0),
      Z0(1),
      Z0(2),
      Z0(3),
      x0(0),
      x0(1),
      model::friction_at_rest<S>(motion::parameters_as<S>(a), model::Vector2<S>(Z0.template head<2>()), phi),
      tau_C(1)};
}

// Everything about the orbit at a proved (tau, C), at the working precision, with its residuals; the boxes of
// uniqueness are left empty.
[[nodiscard]] SymmetricOrbit describe_symmetric(const motion::ExactParameters& a, LoadPhase phase,
                                                const zeros::Box<2>& tau_C);

// Proves the orbit near a guess and encloses it to `digits` significant decimal digits or more.
// Throws DomainError outside the domain of require_stick_slip_domain.
[[nodiscard]] SymmetricProof prove_symmetric(const motion::ExactParameters& a, LoadPhase phase,
                                             const model::Vector2<double>& guess, int digits);

// All orbits that the scan (see list_symmetric for a list that is proved to be complete) of both load phases
// finds, each proved or with the reason why not.
[[nodiscard]] std::vector<SymmetricProof> solve_symmetric(const motion::ExactParameters& a, int digits);

// (16) at printed values of (tau, z10, z20, zdot10).
struct PrintedZero {
  model::Vector4<Ball> at_points;     // at the decimals themselves
  model::Vector4<Ball> at_intervals;  // over the intervals that they stand for
  // Of "the printed intervals contain a zero of (16)": refuted when no zero lies in them, proved when
  // Krawczyk's test on them says so.
  Verdict verdict;
};
[[nodiscard]] PrintedZero printed_zero_of_16(const motion::ExactParameters& a, LoadPhase phase,
                                             const std::array<Decimal, 4>& printed);

}  // namespace stickslip::numeric::families
