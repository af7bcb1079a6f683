// The requirements on a motion over a whole box of parameters (motion/requirements.hpp): for every time of a
// phase, by mean value forms in the time and the parameters at once.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/atlas/convex.hpp"
#include "numeric/atlas/knowledge.hpp"
#include "numeric/motion/requirements.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

// Truth::proved or refuted, for every member, or undecided.
template <class S>
[[nodiscard]] Truth is_positive_over(const S& x) {
  return x.is_positive() ? Truth::proved : x.is_negative() ? Truth::refuted : Truth::undecided;
}

struct Decision {
  Truth truth = Truth::undecided;
  Hope hope = {};
};
template <class T>
[[nodiscard]] Decision decide_positive(const T& x) {
  return {is_positive_over(x.over), hope_of(x)};
}

// Whether g(t) > 0 for 0 < t < duration, ends included except for those that g touches: there it is zero by
// construction, and has to leave zero with nonzero speed. Refuted when some time has g < 0 for every member,
// the same share of the duration for all. Only the open times are looked at, and those that stay open are
// left there. g(t) is the value with its derivative by t; `least` is how short pieces of the phase may
// become, as shares of the duration.
template <class T, class G>
[[nodiscard]] Decision is_positive_along(const G& g, const T& duration, motion::Touches touches, double least,
                                         Times& open) {
  constexpr int most_pieces = 300;
  constexpr double longest = 0.5;
  Times todo(open.rbegin(), open.rend());
  open.clear();
  Hope hope{true};
  for (int examined = 0; !todo.empty(); ++examined) {
    const auto [first, last] = todo.back();
    todo.pop_back();
    if (examined >= most_pieces) {
      open.emplace_back(first, last);
      hope.is_promising = false;
      continue;
    }
    const double middle = (first + last) / 2;
    const auto halve = [&, first = first, last = last] {
      todo.emplace_back(middle, last);
      todo.emplace_back(first, middle);
    };
    if (last - first > longest) {
      halve();
      continue;
    }
    const bool from_zero = touches.start && first == 0;
    const bool to_zero = touches.end && last == 1;
    const std::array<T, 2> over = g(duration * T::variable(middle, last - middle, 0));
    const auto& [value, slope] = over;
    if (value.over.is_positive() || (from_zero && slope.over.is_positive()) ||
        (to_zero && slope.over.is_negative())) {
      continue;
    }
    if (value.over_from(1).is_negative() || (from_zero && slope.over.is_negative()) ||
        (to_zero && slope.over.is_positive())) {
      return {Truth::refuted};
    }
    const T half = duration * T(decltype(duration.at)(last - middle));
    const auto at = [&, half_length = last - middle](double e) {
      return g(duration * T(decltype(duration.at)(std::clamp(middle + e * half_length, 0.0, 1.0))));
    };
    const auto bent = convex<T>(over, half, from_zero, to_zero, at);
    if (bent && bent->is_proved) {
      continue;
    }
    if (bent && bent->is_refuted) {
      return {Truth::refuted};
    }
    // What the parameters alone leave open no shorter piece decides. The slope at an end that g touches is
    // asked of short pieces only: in what is left of a long one there may be a time that refutes.
    const bool touched = from_zero || to_zero;
    constexpr double is_short = 0x1p-4;
    const T told = bent                      ? bent->least
                   : !touched                ? value
                   : last - first > is_short ? slope
                                             : at(from_zero ? -1 : 1)[1];
    const auto spread = told.over_from(1);
    const bool hopeless =
        !spread.is_nonzero() && scalars::is_narrower(told.over, spread * decltype(spread)(1.25));
    if (last - first > least && !hopeless) {
      halve();
    } else {
      open.emplace_back(first, last);  // go on: another piece may refute it
      Hope here = hope_of(told, 1);
      here.is_below = here.is_below != (to_zero && !bent);  // there it has to fall
      hope = hope.of_both(here);
    }
  }
  if (open.empty()) {
    return {Truth::proved};
  }
  // Next to an end that g touches only the slope tells, of one piece up to that end.
  const auto gap = [](const auto& a, const auto& b) { return a.second != b.first; };
  if (touches.start && open.front().first == 0) {
    const auto last = std::adjacent_find(open.begin(), open.end(), gap);
    const auto end = last == open.end() ? last : last + 1;
    open.front().second = (end - 1)->second;
    open.erase(open.begin() + 1, end);
  }
  if (touches.end && open.back().second == 1) {
    auto first = open.end() - 1;
    while (first != open.begin() && !gap(*(first - 1), *first)) {
      --first;
    }
    first->second = 1;
    open.erase(first + 1, open.end());
  }
  return {Truth::undecided, hope};
}

}  // namespace stickslip::numeric::atlas
