// Motions of two sticks and between them two phases without, STST, OTST, OTOT, that close: a problem of
// linear_closing.hpp.
//
// The phases last t, T1, t', T2. On a stick, s the time from its middle, x2 = a + V s and x1 = chi x2 + C sin
// s
// + D cos s: (10) with z2' = V at both ends. Between two sticks mode j, y_j = lambda_k x1 - x2, k the other
// mode, obeys y_j'' + omega_j² y_j = -f, f = ± eta us + p cos(omega s + psi), s the time from the phase's
// middle, t its duration. Multiplied by sin(omega_j s) and cos(omega_j s) and integrated from end to end,
//   odd_j:  omega_j cos(alpha_j) (y+ - y-)/2 - sin(alpha_j) (y'+ + y'-)/2 = S_j,   alpha_j = omega_j t/2,
//   even_j: omega_j sin(alpha_j) (y+ + y-)/2 + cos(alpha_j) (y'+ - y'-)/2 = -C_j,
// S_j and C_j half the integrals of sin(omega_j s) f and cos(omega_j s) f: a motion is one if and only if all
// four hold. As t goes to 0 both even_j say that x1' is continuous, for x2' = V at both ends. So odd_1,
// odd_2, even_1 are taken and, divided by t/2,
//   lambda_1 even_1 - lambda_2 even_2,
// of which x2'' = 0 is left at t = 0. Where a stick ends r = ur before a slip, -ur before an overshoot (12).
// Ten rows in the amplitudes (a, C, D) of either stick and in (cos psi, sin psi, 1), psi the load's phase in
// the middle of the first stick.
//
// The unknowns are x0 = (t + T1)/(n Theta), the shares x1 of t in t + T1 and x2 of t' in t' + T2.
#pragma once

#include <array>

#include "numeric/families/through_phases/one_stick_closing.hpp"

namespace stickslip::numeric::families {

template <class S>
struct TwoSticksData : model::ReducedData<S> {  // Theta is how long the motion lasts, n periods
  S ur;
  std::array<int, 2> sign;  // of the friction on the two phases: 1 for a slip, -1 for an overshoot
};

struct TwoSticks : Sizes<3, 6, false> {
  static constexpr int first = 4;

  explicit TwoSticks(const TwoSticksData<Ball>& data);

  // t, T1, t'; and the unknowns where they last so long.
  [[nodiscard]] zeros::Box<3> durations(const zeros::Box<3>& x) const {
    const Ball sum = exact.Theta * x(0);
    return {sum * x(1), sum * (Ball(1) - x(1)), (exact.Theta - sum) * x(2)};
  }
  [[nodiscard]] static zeros::Box<3> shares(const zeros::Box<3>& t, const Ball& total) {
    const Ball sum = t(0) + t(1);
    return {sum / total, t(0) / sum, t(2) / (total - sum)};
  }
  // From the first phase on; `stick` is T2. At the working precision; nothing where it is not determined at
  // x.
  [[nodiscard]] static std::optional<ClosedTimes<3>> motion_at(const LinearEliminant<TwoSticks>& f,
                                                               const zeros::Box<3>& x);

  TwoSticksData<Ball> exact;
  TwoSticksData<scalars::HardwareBall> fast;
};

}  // namespace stickslip::numeric::families
