// The least value of a function of one variable over a box of parameters, where its graph is convex.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

template <class T>
struct Convex {
  bool is_proved = false;   // g is positive all over the piece, except for an end that it touches
  bool is_refuted = false;  // negative somewhere, at the same place for every member
  T least;                  // not above g anywhere on the piece; the slope inwards at the end that g touches
};

// Of g on a piece |e| <= 1, e = (t - middle)/half; nothing where g may not be convex. over: g and its
// derivative by t, with e the first variable; at(e): the same at one place. An end that g touches: g is zero
// there by construction, at most one of the two. With g'' at least k > 0,
//   g >= g(e) + g'(e) (t - t_e) + k (t - t_e)²/2 >= g(e) - g'(e)²/(2 k).
template <class T, class G>
[[nodiscard]] std::optional<Convex<T>> convex(const std::array<T, 2>& over, const T& half, bool touches_start,
                                              bool touches_end, const G& at) {
  using S = std::decay_t<decltype(half.over)>;
  const S& bend = over[1].slopes[0];  // g'' half
  const double least_bend = scalars::ends(bend).first;
  if (!(least_bend > 0) || !half.over.is_positive()) {
    return std::nullopt;
  }
  if (touches_start || touches_end) {
    // The graph lies above the tangent there.
    const T slope = touches_start ? at(-1)[1] : -at(1)[1];
    return Convex<T>{slope.over.is_positive(), slope.over.is_negative(), slope};
  }
  const double lowest = -over[1].at.approximate() / bend.approximate();
  const auto [value, slope] = at(std::clamp(lowest, -1.0, 1.0));
  const bool rises_on = lowest <= -1 && slope.over.is_positive();
  const bool falls_until = lowest >= 1 && slope.over.is_negative();
  const T least = rises_on || falls_until ? value : value - slope * slope * half / T(S(2) * S(least_bend));
  return Convex<T>{least.over.is_positive(), value.over.is_negative(), least};
}

}  // namespace stickslip::numeric::atlas
