// The symmetric orbits of Section 4: slip on (0, tau), stick on (tau, Theta), T = Theta - tau, with
// Z(tau) = E Z0 (13) and Z0 = Gamma(T) E Z0 (15).
#pragma once

#include "model/symmetric.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::numeric::families {

[[nodiscard]] const Family& symmetric();

// The two load phases that the symmetry allows.
enum class LoadPhase {
  first,   // phi = (pi - omega tau)/2, the paper's
  second,  // that plus pi
};

// The reduced equations, which hold if and only if all components of (13) and (15) do, in x = (tau, C), C the
// amplitude of z1 about chi z2 during the stick; for motion/closing.hpp.
struct SymmetricClosing {
  static constexpr bool takes_phi = false, takes_ur = false;
  LoadPhase phase;

  template <class T>
  [[nodiscard]] model::SymmetricData<T> data(const zeros::VectorOf<T>& p) const {
    return {model::reduced_data<T>({p(0), p(1), p(2), p(3), p(4), p(5)}, T(Ball::pi())),
            T(phase == LoadPhase::first ? 1 : -1)};
  }
  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return model::symmetric_closing<T>(data<T>(p), x(0), x(1));
  }
  // The stick begins at E Z0 (13).
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    using motion::PhaseKind;
    const model::SymmetricData<T> a = data<T>(p);
    const T& tau = x(0);
    const model::Vector4<T> Z0 = model::symmetric_start<T>(a, tau, x(1));
    const model::Vector4<T> ZC(T(-Z0(0)), T(-Z0(1)), Z0(2), Z0(3));
    const T phi = model::symmetric_phase<T>(a, T(Ball::pi()), tau);
    return {motion::oscillator_of<T>(p),
            {{PhaseKind::slip, T(0), tau, phi, Z0},
             {PhaseKind::stick, tau, T(a.Theta - tau), T(phi + a.omega * tau), ZC}}};
  }
  // Throws InternalError unless the motion has two phases.
  [[nodiscard]] zeros::Vector unknowns(const motion::Motion& motion) const;
};

// The data of the reduced equations at the working precision, for either load phase.
[[nodiscard]] model::SymmetricData<Ball> symmetric_data(const motion::ExactParameters& a, LoadPhase phase);

// The reduced equations with the amplitude C eliminated, as a function of u = tau/Theta in [0, 1]. It
// vanishes at every orbit, and elsewhere only where C cannot be had from either equation.
struct SymmetricEliminant {
  model::SymmetricData<Ball> data;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 1, 1> operator()(const Eigen::Matrix<T, 1, 1>& u) const {
    const model::SymmetricData<T> d{model::lift<T>(data), T(data.sigma)};
    return Eigen::Matrix<T, 1, 1>(model::symmetric_eliminant<T>(d, T(d.Theta * u(0))));
  }
};

}  // namespace stickslip::numeric::families
