// What a motion over a box of parameters has to obey, at all times of its phases.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/atlas/knowledge.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/motion/requirements.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

// The least value of a function of one variable over a box of parameters, where its graph is convex.

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

// The requirements on a motion over a whole box of parameters (motion/requirements.hpp): for every time of a
// phase, by mean value forms in the time and the parameters at once.

struct Decision {
  Truth truth = Truth::undecided;
  Hope hope = {};
};
// Whether x > 0 for every member, or x < 0.
template <class T>
[[nodiscard]] Decision decide_positive(const T& x) {
  return {x.over.is_positive()   ? Truth::proved
          : x.over.is_negative() ? Truth::refuted
                                 : Truth::undecided,
          hope_of(x)};
}

// Whether the parameters alone leave open nearly all that is open of x, whose variable 0 is a piece or a
// cell: no shorter one is likely to decide it.
template <class T>
[[nodiscard]] bool is_left_open_by_parameters(const T& x) {
  constexpr double nearly_all = 1.03125;
  const auto spread = x.over_from(1);
  return !spread.is_nonzero() && scalars::is_narrower(x.over, spread * decltype(spread)(nearly_all));
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
    // The slope at an end that g touches is asked of short pieces only: in what is left of a long one there
    // may be a time that refutes.
    const bool touched = from_zero || to_zero;
    constexpr double is_short = 0x1p-4;
    const T told = bent                      ? bent->least
                   : !touched                ? value
                   : last - first > is_short ? slope
                                             : at(from_zero ? -1 : 1)[1];
    if (last - first > least && !is_left_open_by_parameters(told)) {
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

// A motion over a box of parameters all of whose phases last, and what it has to obey, whatever these are.
template <class T>
struct MotionOver {
  motion::MotionOf<T> motion;
  std::optional<T> ur;  // where it is not given some ur > us has to be right, and serves if ur = us does

  // Only the open times of the phase are looked at.
  [[nodiscard]] Decision holds(const motion::Requirement& q, double least, Times& open) const {
    const model::Parameters<T>& a = motion.oscillator.data;
    const T friction = ur.value_or(a.us);
    switch (q.quantity) {
      case motion::Quantity::duration:
        return {Truth::proved};
      case motion::Quantity::slipping_friction:
        return decide_positive(a.us);
      case motion::Quantity::friction_step:
        return ur ? decide_positive(T(friction - a.us)) : Decision{Truth::proved};
      default:
        break;
    }
    const motion::Affine<T> form = motion::affine_form<T>(a, friction, q.quantity);
    const motion::PhaseOf<T>& phase = motion.phases[q.phase];
    if (!q.along) {
      const T r = model::friction_at<T>(a, phase.Z, phase.load);
      return decide_positive(T(form.factor * r + form.offset));
    }
    const model::PhaseWaves<T> waves = motion::waves_of<T>(motion.oscillator, phase);
    const auto g = [wave = model::affine<T>(form.factor, form.of_speed ? waves.zdot2 : waves.r, form.offset)](
                       const T& t) { return model::value_and_slope<T>(wave, t); };
    return is_positive_along<T>(g, phase.duration, q.touches, least, open);
  }
};

}  // namespace stickslip::numeric::atlas
