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
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/nonsticking.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

// The equations over parameters that are balls: exact data, or a whole box of them.
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

// The two phases at (delta, mu), c = modal_rest.
template <class S>
[[nodiscard]] motion::MotionOf<S> two_slips_motion(const model::Oscillator<S>& o, const model::Vector2<S>& c,
                                                   const S& half_turn, const S& delta, const S& mu) {
  const S& omega = o.data.omega;
  const auto states = model::two_slips_states<S>(o.data.V, o.modes, o.Q, c, omega, half_turn, delta, mu);
  const S tau = S(2) * delta / omega;
  const S tau1 = S(2) * (half_turn - delta) / omega;
  return {o,
          {{motion::PhaseKind::slip, S(0), tau, S(mu - delta), states.Z0},
           {motion::PhaseKind::overshoot, tau, tau1, S(mu + delta), states.ZB}}};
}

// What an orbit is known by; each ball contains the exact value.
struct NonstickingOrbit {
  Ball tau, tau1, Theta, phi;  // tau + tau1 = Theta; phi in [-pi, pi] or a little outside
  Ball x10, x20, xdot10;       // at t = 0, where x2' = V
  // The largest admissible u_r is ur_max = min(r(0), -r(tau)): (25) and (26) hold exactly for u_r < ur_max.
  Ball ur_max;
  motion::Motion motion;  // the two phases
  zeros::Box<2> box;      // contains (delta, mu)
  zeros::Box<2> unique;   // contains no other zero
};

// The orbit whose (delta, mu) lies in the box: everything that follows from the two numbers.
[[nodiscard]] NonstickingOrbit describe_nonsticking(const TwoSlips& f, const zeros::Box<2>& box,
                                                    const zeros::Box<2>& unique);

// Whether there is exactly one orbit near a guess.
struct NonstickingProof {
  Verdict existence;
  NonstickingOrbit orbit;  // meaningless unless existence is proved
};

// Proves the orbit near the guess (delta, mu) and encloses it to `digits` digits. Throws DomainError like
// list_nonsticking.
[[nodiscard]] NonstickingProof prove_nonsticking(const motion::ExactParameters& a,
                                                 const model::Vector2<double>& guess, int digits);

// A part of the domain in which the search could not decide.
struct UnresolvedNonsticking {
  Ball tau, mu;
  std::string reason;
};

struct NonstickingList {
  std::vector<NonstickingOrbit> orbits;  // by increasing tau, admissible or not
  std::vector<UnresolvedNonsticking> unresolved;
  long cells = 0;  // examined by the search

  // No motion with 0 < tau < Theta that closes with x2' = V at 0 and tau is missing.
  [[nodiscard]] bool complete() const { return unresolved.empty(); }
};

// The complete list, each orbit enclosed to `digits` digits. Throws DomainError outside the domain of
// require_model_domain and at resonance, omega_j = k omega with an integer k, where closed motions are not
// isolated or do not exist. When the load does not act on x2 (q2 = 0: p = 0 or omega = 1) there is none for
// V ≠ 0; for V = 0 the load's phase is then free and the whole domain is left unresolved.
[[nodiscard]] NonstickingList list_nonsticking(const motion::ExactParameters& a, int digits);

// The conditions of the family, and for V = 0, tau = Theta/2 also (36). Without u_r those that need it are
// replaced by room_for_friction.
[[nodiscard]] std::vector<motion::Condition> nonsticking_conditions(const NonstickingOrbit& orbit,
                                                                    const std::optional<Ball>& ur);

// (36), which is about the half-period orbit: nothing unless V = 0 and delta = omega tau/2 may be pi/2.
[[nodiscard]] std::optional<motion::Condition> condition_36(const model::Oscillator<Ball>& o,
                                                            const Ball& delta, const Ball& phi,
                                                            const Ball& ur);

// "ur_max > us": some u_r > u_s satisfies (25) and (26).
[[nodiscard]] motion::Condition room_for_friction(const Ball& ur_max, const Ball& us);

}  // namespace stickslip::numeric::families
