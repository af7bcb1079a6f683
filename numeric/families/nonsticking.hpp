// Orbits that never stick: slip on (0, tau), overshoot on (tau, Theta), for any V and with tau free.
//
// They are the zeros (delta, mu) of the two equations of model/nonsticking.hpp, delta = omega tau/2 in [0,
// pi], mu = phi + delta modulo 2 pi.
//
// Off resonance at most one motion of period Theta never sticks, whatever its number of transitions, so at
// most one of the zeros obeys z2' < V and z2' > V on its phases. For let w be the difference of two under the
// same load. With M = diag(eta, 1) the matrix M K is symmetric and positive definite, and by (2), (4)
//   E = (w'ᵀ M w' + wᵀ M K w)/2,   E' = eta (x2' - y2') (u(x2') - u(y2')) <= 0,
// because u = us sign(V - x2') does not increase. E returns after a period, so u(x2') = u(y2') almost always,
// and w moves freely with period Theta: it is zero unless some omega_j is a multiple of omega. For V = 0 the
// motion -x(t + Theta/2) is another under the same load, hence the same: (54) holds for every motion that
// never sticks, without the assumption of two transitions.
//
// At resonance, omega_j = k omega with k > 1, mode j returns after a period only if the friction has no part
// of its frequency (the load has none): sin(k omega tau/2) = 0, tau = l Theta/k with 0 < l < k. Then mode j
// is free, and motions that close come in families. For V = 0, w above is the sum of x and its mirror image,
// with u(x2') = u(y2') again, so tau = Theta/2, and k is even; for odd k there is none. With two resonances
// both hold. With x that obeys the law, x - w/2 does, has the phases of x, and is its own mirror image: so
// where none of the two motions that are, (34), obeys it, none does, and else those that do are one of them
// with a free oscillation of mode j added.
#pragma once

#include "model/nonsticking.hpp"
#include "numeric/families/family.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::families {

// For any V and, if it is given, any ur: without it ur_max, the largest for which (25) and (26) hold, is a
// result. At resonance, omega_j = k omega with an integer k > 1, what the list may hold is unresolved, with
// that reason. At V = 0, however, it is empty for k odd, and for k even it has the motions that are their own
// mirror images, with a remark that they are not alone. The search throws DomainError for k = 1.
// When the load does not act on x2 (q2 = 0: p = 0 or omega = 1) there is none for V ≠ 0. For V = 0 there is
// none that obeys the friction law, and others are not looked for: w = x - Q cos(omega t + phi) moves without
// load and has w2' = x2', so with E as above E' = -eta us |x2'|, and E returns only if x2' = 0 always.
[[nodiscard]] const Family& nonsticking();

// The reduced equations at balls around the parameters.
struct TwoSlips {
  model::Oscillator<Ball> o;
  model::Vector2<Ball> c;  // modal_rest
  Ball pi;

  template <class T>
  [[nodiscard]] model::Vector2<T> operator()(const model::Vector2<T>& x) const {
    return model::two_slips<T>(model::lift<T>(o.data), model::lift<T>(o.modes), T(o.Q(1)), model::lift<T>(c),
                               T(pi), x(0), x(1));
  }
};
[[nodiscard]] TwoSlips two_slips_of(const model::Parameters<Ball>& a);

// The motion that (delta, mu) stand for.
template <class T>
[[nodiscard]] motion::MotionOf<T> two_slips_motion(const model::Oscillator<T>& o, const T& pi, const T& delta,
                                                   const T& mu) {
  const auto states = model::two_slips_states<T>(o.data.V, o.modes, o.Q, model::modal_rest<T>(o.modes, o.d0),
                                                 o.data.omega, pi, delta, mu);
  const T tau = T(2) * delta / o.data.omega;
  const T tau1 = T(2) * (pi - delta) / o.data.omega;
  return {o,
          {{motion::PhaseKind::slip, T(0), tau, T(mu - delta), states.Z0},
           {motion::PhaseKind::overshoot, tau, tau1, T(mu + delta), states.ZB}}};
}

// The same equations for motion/closing.hpp.
struct NonstickingClosing {
  static constexpr bool takes_phi = false, takes_ur = false;

  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    const model::Oscillator<T> o = motion::oscillator_of<T>(p);
    return model::two_slips<T>(o.data, o.modes, o.Q(1), model::modal_rest<T>(o.modes, o.d0), T(Ball::pi()),
                               x(0), x(1));
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return two_slips_motion<T>(motion::oscillator_of<T>(p), T(Ball::pi()), x(0), x(1));
  }
  // Throws InternalError unless the motion has two phases.
  [[nodiscard]] zeros::Vector unknowns(const motion::Motion& motion) const;
};

// The least load amplitude at which the half-period orbit of Section 6 exists: (36) and x2' < 0 on the whole
// slip.
//
// With B = -q2 omega sin(phi), which (35) fixes whatever the load, and C = q2 omega cos(phi) > 0 the slip has
//   x2'(t) = g(t) + B cos(omega t) - C sin(omega t),  0 <= t <= pi/omega,
// where g is free of the load. It obeys x2' < 0 exactly if C exceeds
//   S = sup over 0 < t < pi/omega of (g(t) + B cos(omega t))/sin(omega t),
// and (36) exactly if C exceeds eta ur/omega. As p/(q2 omega) is fixed by the data, p > least says both.

struct LeastLoad {
  Ball speed_push;     // S
  Ball friction_push;  // eta ur/omega
  Ball p;              // the least |p|
};

// Assumes an orbit with V = 0, tau = Theta/2 and C > 0. S is bracketed between a C for which a time with x2'
// > 0 is proved and one for which there is none; the bracket has `digits` digits. Throws InternalError when
// the motion has no slip of half a period to begin with.
[[nodiscard]] LeastLoad least_load(const motion::Motion& motion, const Ball& ur, int digits);

}  // namespace stickslip::numeric::families
