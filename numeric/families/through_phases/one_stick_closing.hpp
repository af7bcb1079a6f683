// Motions of one, two or three phases without stick and then a stick that close, as a problem of
// linear_closing.hpp: the reduced equations of model/overshooting_closing.hpp and model/slip_again.hpp.
//
// The rows are linear in the amplitudes (a, C, D) of the stick; psi is the load's phase in the middle of the
// other phases. With n periods of the load in one of the motion Theta is n Theta there. A motion that begins
// with an overshoot is the mirror image -x of one that begins with a slip, with the belt's velocity -V and
// the load half a turn later; r = -ur, where its stick ends, becomes r = ur. With one phase, tau1 = 0, no
// friction turns, and the row of z2'(tau) = V is void. The unknowns x are shares: with one and two phases x0
// of all but the stick in n periods and x1 of the second in them, with three x0 of the first two in n
// periods, x1 of the second in these and x2 of the third in what they leave.
#pragma once

#include "model/overshooting_closing.hpp"
#include "numeric/families/through_phases/linear_closing.hpp"

namespace stickslip::numeric::families {

enum class Datum { phase, friction };  // what is given: phi, or ur

// The equations' data; Theta is how long the motion lasts, `given` phi or ur.
template <class S>
struct OneStickData {
  model::ReducedData<S> d;
  S given;
};

// The durations of the phases without stick.
template <class T, int N>
[[nodiscard]] Eigen::Matrix<T, N, 1> times(const T& total, const Eigen::Matrix<T, N, 1>& x) {
  const T sum = total * x(0);
  Eigen::Matrix<T, N, 1> result;
  result(0) = sum;
  if constexpr (N >= 2) {
    result(1) = sum * x(1);
    result(0) -= result(1);
  }
  if constexpr (N == 3) {
    result(2) = T(total - sum) * x(2);
  }
  return result;
}

// A motion that closes: how long its phases last, and state and load's phase where the first begins.
template <int N>
struct ClosedTimes {
  Eigen::Matrix<Ball, N, 1> times;
  Ball stick;
  model::Vector4<Ball> Z0;
  Ball phi;  // as given, else in (-pi, pi] up to its radius
};

// Data at the working precision, and again over hardware balls. N times are unknown, 1, 2 or 3; 3 only with
// ur.
template <int N, Datum G>
struct OneStick : Sizes<N, 3, G == Datum::phase> {
  static constexpr int first = 2;

  // sound_at_origin: whether n/omega is no whole number. Where it is one the rows vanish where all phases but
  // the stick last no time.
  OneStick(const OneStickData<Ball>& data, bool sound_at_origin);

  // How long the phases last but the stick.
  [[nodiscard]] zeros::Box<N> durations(const zeros::Box<N>& x) const {
    return families::times<Ball, N>(exact.d.Theta, x);
  }
  // The unknowns where they last so long.
  [[nodiscard]] static zeros::Box<N> shares(const zeros::Box<N>& t, const Ball& total) {
    const Ball sum = N >= 2 ? t(0) + t(N >= 2 ? 1 : 0) : t(0);
    zeros::Box<N> x;
    x(0) = sum / total;
    if constexpr (N >= 2) {
      x(1) = t(1) / sum;
    }
    if constexpr (N == 3) {
      x(2) = t(2) / (total - sum);
    }
    return x;
  }
  // At the working precision; nothing where it is not determined at x.
  [[nodiscard]] static std::optional<ClosedTimes<N>> motion_at(const LinearEliminant<OneStick>& f,
                                                               const zeros::Box<N>& x);

  OneStickData<Ball> exact;
  OneStickData<scalars::HardwareBall> fast;
  bool sound_at_origin;
};

// Of a phase with this cosine and sine, later by so much: in (-pi, pi] up to its radius.
[[nodiscard]] Ball angle(const std::pair<Ball, Ball>& cos_sin, const Ball& later);

}  // namespace stickslip::numeric::families
