// Next to a fold: there a zero u of f moves fast with a parameter q, and says little of the motion at the
// zero; but q is a function of u, and of the other parameters, that hardly varies.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "numeric/atlas/knowledge.hpp"

namespace stickslip::numeric::atlas {

template <class T>
struct SteepZero {
  T u;  // the k-th variable of the forms, over all of the bracket
  T q;  // the parameter that was this variable, at the zero
};

// For each member of a box the zero u in the bracket, and its parameter q, are among these, which reach
// somewhat beyond the box. f(u, q): Form -> Form, at the other parameters of the box; `axis` is q as the k-th
// variable. Nothing where q may be no function of u.
//
// With e, e_q and e_i the shares of u, q and the other parameters, |·| <= 1, and slopes over all of them,
//   f = f(0) + f_u e + f_q e_q + sum of f_i e_i.
// If f_q ≠ 0 and E = -(f(0) + f_u [-1, 1] + sum of f_i [-1, 1])/f_q lies within (-1, 1), then for all e and
// e_i there is exactly one e_q in [-1, 1] with f = 0, and its slopes are -f_u/f_q and -f_i/f_q.
template <class S, int N, class F>
[[nodiscard]] std::optional<SteepZero<scalars::Form<S, N>>> steep_zero(const F& f, const Bracket& zero, int k,
                                                                       const scalars::Form<S, N>& axis) {
  using T = scalars::Form<S, N>;
  const auto place = static_cast<std::size_t>(k);
  const double middle = zero.first + (zero.last - zero.first) / 2;
  const double reach = std::nextafter(std::max(zero.last - middle, middle - zero.first), INFINITY);
  const double centre = axis.at.approximate();
  double radius = 1.25 * axis.slopes[place].approximate();
  for (int attempt = 0; attempt < 3; ++attempt) {
    const T value = f(T::variable(middle, reach, 0), T::variable(centre, radius, k));
    const S& by_q = value.slopes[place];
    if (!by_q.is_nonzero()) {
      return std::nullopt;
    }
    T share;  // e_q, with e as the k-th variable
    share.at = -value.at / by_q;
    for (std::size_t i = 1; i < share.slopes.size(); ++i) {
      share.slopes[i] = -value.slopes[i == place ? 0 : i] / by_q;
    }
    share.over = share.at + scalars::sway(share.slopes);
    const auto [low, high] = scalars::ends(share.over);
    if (low > -1 && high < 1) {
      return SteepZero<T>{T::variable(middle, reach, k), T(T(S(centre)) + T(S(radius)) * share)};
    }
    const double needed = 1.25 * std::max(std::abs(low), std::abs(high));
    if (!(needed < 16)) {
      return std::nullopt;
    }
    radius *= std::max(needed, 1.25);
  }
  return std::nullopt;
}

}  // namespace stickslip::numeric::atlas
