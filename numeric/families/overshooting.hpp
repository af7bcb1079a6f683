// The orbits with an overshooting part of Section 5: slip on (0, tau), overshoot on (tau, tau + tau1), stick
// on (tau + tau1, Theta); Z(Theta) = Z0 (20), z2'(0) = z2'(tau) = z2'(tau + tau1) = V (12), (18), (19).
// Either the load's phase phi is given and u_r is a result, or u_r is given and phi is.
//
// The search runs over (s, w) in [0, 1]², tau + tau1 = Theta s, tau1 = Theta s w: the closed triangle tau,
// tau1 >= 0, tau + tau1 <= Theta. The reduced equations of model/overshooting_closing.hpp are linear in the
// amplitudes, which are eliminated (through_phases.hpp); a zero of what remains counts only when the
// amplitudes that it stands for are proved to exist.
#pragma once

#include "model/overshooting_closing.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::numeric::families {

// With phi given, any real number; or with ur > 0 given, for which p > 0 is needed (DomainError).
[[nodiscard]] const Family& overshooting();

// The data of the reduced equations, at the working precision.
template <class S>
[[nodiscard]] model::ReducedData<S> overshooting_data(const motion::ExactParameters& a) {
  return model::reduced_data<S>(motion::parameters_as<S>(a), scalars::pi<S>());
}

// The motion of (tau, tau1, a, C, D): z2' = V where the overshoot begins, and the stick from its own form, as
// the reduced equations say.
template <class T>
[[nodiscard]] motion::MotionOf<T> overshooting_motion(const model::ReducedData<T>& d,
                                                      const model::Oscillator<T>& o, const T& phi,
                                                      const zeros::VectorOf<T>& x) {
  using motion::PhaseKind;
  const T total = x(0) + x(1);
  const T duration = d.Theta - total;
  const model::Vector4<T> Z0 = model::overshooting_start<T>(d, duration, x(2), x(3), x(4));
  model::Vector4<T> ZB = motion::flow<T>(o, PhaseKind::slip, phi, Z0, x(0));
  ZB(3) = d.V;
  // Half a stick before its middle, where half a stick after it is Z0.
  const model::Vector4<T> ZC = model::overshooting_start<T>(d, T(-duration), x(2), x(3), x(4));
  return {o,
          {{PhaseKind::slip, T(0), x(0), phi, Z0},
           {PhaseKind::overshoot, x(0), x(1), T(phi + d.omega * x(0)), ZB},
           {PhaseKind::stick, total, duration, T(phi + d.omega * total), ZC}}};
}

// The reduced equations for motion/closing.hpp, in x = (tau, tau1, a, C, D) and, where ur is given, phi: for
// positive durations they hold if and only if (12), (18), (19) and (20) do. Exactly one of the two is taken.
struct OvershootingClosing {
  bool takes_phi = true;
  bool takes_ur = false;

  template <class T>
  [[nodiscard]] static model::ReducedData<T> data(const zeros::VectorOf<T>& p) {
    return model::reduced_data<T>({p(0), p(1), p(2), p(3), p(4), p(5)}, T(Ball::pi()));
  }
  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    const model::ReducedData<T> d = data<T>(p);
    const std::pair<T, T> psi = sin_cos(T((takes_phi ? p(6) : x(5)) + d.omega * T(x(0) + x(1)) / T(2)));
    const auto residual = [&](const model::OvershootingRow<T>& r) {
      return T(r.a * x(2) + r.C * x(3) + r.D * x(4) + r.cos_psi * psi.second + r.sin_psi * psi.first + r.one);
    };
    const auto odd = model::overshooting_odd<T>(d, x(0), x(1));
    const auto even = model::overshooting_even<T>(d, x(0), x(1));
    zeros::VectorOf<T> f(x.size());
    f.template head<5>() << residual(odd[0]), residual(odd[1]), residual(even[0]), residual(even[1]),
        residual(model::overshooting_turn<T>(d, x(0), x(1)));
    if (takes_ur) {
      f(5) = residual(model::overshooting_friction<T>(d, p(6), x(0), x(1)));
    }
    return f;
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return overshooting_motion<T>(data<T>(p), motion::oscillator_of<T>(p), takes_phi ? p(6) : x(5), x);
  }
  // Throws InternalError unless the motion has three phases.
  [[nodiscard]] zeros::Vector unknowns(const motion::Motion& motion) const;
};

// The family over an interval of one parameter (strip.hpp), in (s, w): one strip.
[[nodiscard]] std::vector<Strip> overshooting_strips(const StripQuestion& q);

}  // namespace stickslip::numeric::families
