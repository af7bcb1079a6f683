// The reduced equations of motions of one or two phases without stick and then a stick
// (one_stick_closing.hpp) with all linear unknowns eliminated, over any scalar of boxes (scalars/form.hpp):
// at shares of the period, for whole boxes of parameters.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "numeric/families/strip.hpp"
#include "numeric/families/through_phases/one_stick_rows.hpp"

namespace stickslip::numeric::families {

// All linear unknowns eliminated from the rows: (a, C, D), where ur is given cos psi and sin psi, too, and
// the functions that vanish where all rows hold for some values of the unknowns, `linear`.
template <class T, class P>
struct WithoutLinear {
  static constexpr int U = P::columns - 1;
  Eigen::Matrix<T, P::times, 1> vanish;
  Eigen::Matrix<T, U, 1> linear;
};

// Nothing where the rows may be dependent. P: a OneStick.
template <class P, class T, class S>
[[nodiscard]] std::optional<WithoutLinear<T, P>> eliminated(const AllRows<P, T>& rows) {
  constexpr int R = P::rows, C = P::columns, U = C - 1;
  const Eigen::Matrix<S, R, C> at_middle = rows.unaryExpr([](const T& x) { return x.at; });
  const auto combinations = zeros::proposed_combinations<R, C>(at_middle);
  if (!combinations) {
    return std::nullopt;
  }
  Eigen::Matrix<T, R, C> m =
      zeros::combined_rows<T, R, C>(Eigen::Matrix<S, R, R>(combinations->template cast<S>()), rows);
  if (!zeros::eliminate<T, R, C>(m, 0, U)) {
    return std::nullopt;
  }
  WithoutLinear<T, P> result;
  result.linear = zeros::back_substituted<T, R, C>(m);
  for (int i = U; i < R; ++i) {
    result.vanish(i - U) = m(i, U);
  }
  if constexpr (P::loads == 3) {
    const T &cosine = result.linear(3), &sine = result.linear(4);
    result.vanish(R - U) = cosine * cosine + (sine - T(1)) * (sine + T(1));
  }
  return result;
}

namespace detail {

inline Ball as_ball(const Ball& x) {
  return x;
}
inline Ball as_ball(const scalars::HardwareBall& x) {
  return x.ball();
}

// Of (x, y), up to full turns: in a short interval, on the negative x axis too.
[[nodiscard]] inline Ball angle_of(const Ball& x, const Ball& y) {
  Ball result;
  const bool turned = x.is_negative();
  arb_atan2(result.raw(), (turned ? -y : y).raw(), (turned ? -x : x).raw(), WorkingPrecision::bits());
  return turned ? result + Ball::pi() : result;
}

// What the rows still say of the load's phase psi where only a, C and D are eliminated: |1's part| of each is
// at most the length of the other two, and the vector product n of two of them is parallel to (cos psi, sin
// psi, 1), so n1² + n2² = n3². This needs no division by what may vanish where psi is hardly determined.
template <class P, class T, class S>
void add_load(const AllRows<P, T>& rows, Reduced<T>& result) {
  const AllRows<P, S> at_middle = rows.unaryExpr([](const T& x) { return x.at; });
  const auto combinations = combinations_for<P, S>(at_middle);
  if (!combinations) {
    return;
  }
  const auto left = left_for_load<P, T>(zeros::combined_rows<T, P::rows, P::columns>(
      Eigen::Matrix<S, P::rows, P::rows>(combinations->template cast<S>()), rows));
  if (!left) {
    return;
  }
  for (int i = 0; i < P::left; ++i) {
    const S a = (*left)(i, 0).over, b = (*left)(i, 1).over, c = (*left)(i, 2).over;
    result.excluded = result.excluded || (c * c - a * a - b * b).is_positive();
    for (int j = i + 1; j < P::left; ++j) {
      result.vanish.push_back(circle<T>(direction<P, T>(*left, i, j)));
    }
  }
}

}  // namespace detail

// With ur given, for strips: what is known at the shares x, N = 1 or 2; the unknowns are the durations of the
// phases without stick, a, C, D and phi.
template <int N, class T, class S>
[[nodiscard]] Reduced<T> reduced_at_friction(const OneStickData<T>& data, const Eigen::Matrix<T, N, 1>& x) {
  using P = OneStick<N, Datum::friction>;
  const AllRows<P, T> rows = rows_of<N, Datum::friction, T>(data, x);
  // sin psi - 1 and sin psi + 1, times the determinant of the odd rows in (C, sin psi).
  constexpr int one = P::columns - 1;
  const T odd = det2<T>(rows(0, 1), rows(0, one), rows(1, 1), rows(1, one));
  const T size = det2<T>(rows(0, 1), rows(0, one - 1), rows(1, 1), rows(1, one - 1));
  const auto above = T(size - odd).over, below = T(-odd - size).over;
  Reduced<T> result;
  result.excluded =
      (above.is_positive() && below.is_positive()) || (above.is_negative() && below.is_negative());
  if (result.excluded) {
    return result;
  }
  const auto rest = eliminated<P, T, S>(rows);
  detail::add_load<P, T, S>(rows, result);
  if (!rest || result.excluded) {
    return result;
  }
  const Eigen::Matrix<T, N, 1> t = times<T, N>(data.d.Theta, x);
  T total(0);
  for (int i = 0; i < N; ++i) {
    result.vanish.push_back(rest->vanish(i));
    result.x.push_back(scalars::ends(t(i).over));
    total += t(i);
  }
  for (int i = 0; i < 3; ++i) {
    result.x.push_back(scalars::ends(rest->linear(i).over));
  }
  const Ball psi =
      detail::angle_of(detail::as_ball(rest->linear(3).over), detail::as_ball(rest->linear(4).over));
  result.x.push_back(scalars::ends(psi - detail::as_ball(T(data.d.omega * total / T(2)).over)));
  return result;
}

}  // namespace stickslip::numeric::families
