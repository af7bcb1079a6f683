// Motions of one or two phases without stick and then a stick that close: the reduced equations of
// model/overshooting_closing.hpp as functions of the durations alone, for the search of zeros/search.hpp.
//
// Its equations are rows, linear in the amplitudes (a, C, D) of the stick and in (cos psi, sin psi, 1), psi
// the load's phase in the middle of the other phases. With n periods of the load in one of the motion Theta
// is n Theta there. A motion that begins with an overshoot is the mirror image -x of one that begins with a
// slip, with the belt's velocity -V and the load half a turn later; r = -ur, where its stick ends, becomes r
// = ur. With one phase, tau1 = 0, no friction turns, and the row of z2'(tau) = V is void.
//
// (a, C, D) are eliminated. Given the load's phase, as many numbers remain as there are times, and must
// vanish. Given ur one row more remains, that of (12), and each is one of (cos psi, sin psi, 1): the vector
// product n of two of them is parallel to that, so a motion closes exactly if n1² + n2² = n3² and, with two
// times, the third row is orthogonal to n, as long as n3 ≠ 0. Nothing is divided by but the pivots of the
// amplitudes. The unknowns x are shares: x0 of all phases but the stick in n periods, x1 of the second in
// them.
#pragma once

#include <optional>

#include "model/overshooting_closing.hpp"
#include "numeric/families/family.hpp"
#include "numeric/scalars/hardware_ball.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

enum class Datum { phase, friction };  // what is given: phi, or ur

// The equations' data; Theta is how long the motion lasts, `given` phi or ur.
template <class S>
struct OneStickData {
  model::OvershootingData<S> d;
  S given;
};

// The durations of the phases without stick.
template <class T, int N>
[[nodiscard]] Eigen::Matrix<T, N, 1> times(const T& total, const Eigen::Matrix<T, N, 1>& x) {
  const T sum = total * x(0);
  Eigen::Matrix<T, N, 1> result;
  if constexpr (N == 2) {
    result(1) = sum * x(1);
    result(0) = sum - result(1);
  } else {
    result(0) = sum;
  }
  return result;
}

// Data at the working precision, and again over hardware balls. N times are unknown, 1 or 2.
template <int N, Datum G>
struct OneStick {
  static constexpr int rows = N + (G == Datum::phase ? 3 : 4);
  static constexpr int loads = G == Datum::phase ? 1 : 3;  // columns for the load and 1
  static constexpr int columns = 3 + loads;
  static constexpr int left = rows - 3;

  // sound_at_origin: whether n/omega is no whole number. Where it is one the rows vanish with x0.
  OneStick(const OneStickData<Ball>& data, bool sound_at_origin);

  OneStickData<Ball> exact;
  OneStickData<scalars::HardwareBall> fast;
  bool sound_at_origin;
};

// A motion that closes: how long its phases last, and state and load's phase where the first begins.
template <int N>
struct OneStickMotion {
  Eigen::Matrix<Ball, N, 1> times;
  Ball stick;
  model::Vector4<Ball> Z0;
  Ball phi;  // as given, else in (-pi, pi] up to its radius
};

// The functions with rows combined as fits a box. Not finite where a pivot may vanish. Where they are finite
// and vanish, all rows hold for one value of the unknowns, provided the combinations are invertible.
template <int N, Datum G>
struct OneStickEliminant {
  OneStick<N, G> problem;
  Eigen::Matrix<Ball, OneStick<N, G>::rows, OneStick<N, G>::rows> combinations;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, N, 1> operator()(const Eigen::Matrix<T, N, 1>& x) const;
  // Nothing where that is not determined at x.
  [[nodiscard]] std::optional<OneStickMotion<N>> motion(const zeros::Box<N>& x) const;
};

// With invertible combinations; nothing where there are none.
template <int N, Datum G>
[[nodiscard]] std::optional<OneStickEliminant<N, G>> eliminant_near(const OneStick<N, G>& problem,
                                                                    const zeros::Box<N>& X);

inline constexpr const char * dependent =
    "the amplitudes cannot be eliminated: the equations for them may be dependent";

// The part of X that may hold a motion that closes; exactly one in a box that contains X, or none in X.
template <int N, Datum G>
[[nodiscard]] std::optional<zeros::Box<N>> contract(const OneStick<N, G>& problem, const zeros::Box<N>& X);
template <int N, Datum G>
[[nodiscard]] zeros::Decision<N> decide(const OneStick<N, G>& problem, const zeros::Box<N>& X);

// A proved zero to so many bits, and the functions near it. recipe(): the problem at the working precision.
template <int N, Datum G>
struct RefinedZero {
  OneStickEliminant<N, G> f;
  zeros::Box<N> x;
  Place place;  // of all shares together
};
template <int N, Datum G, class Recipe>
[[nodiscard]] RefinedZero<N, G> refined(const Recipe& recipe, const zeros::FoundZero<N>& found, long bits) {
  const auto near = eliminant_near<N, G>(recipe(), found.zero);
  const auto here = [&] { return OneStickEliminant<N, G>{recipe(), near->combinations}; };
  RefinedZero<N, G> result{here(), zeros::refine<N>(here, found.zero, bits), Place::inside};
  for (int i = 0; i < N; ++i) {
    const Place at = place(result.x(i));
    if (at == Place::outside || result.place == Place::inside) {
      result.place = at;
    }
  }
  return result;
}

}  // namespace stickslip::numeric::families
