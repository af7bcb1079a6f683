// The requirements on a motion over a whole box of parameters (motion/requirements.hpp): for every time of a
// phase, by mean value forms in the time and the parameters at once.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/motion/requirements.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

// Truth::proved or refuted, for every member, or undecided.
template <class S>
[[nodiscard]] Truth is_positive_over(const S& x) {
  return x.is_positive() ? Truth::proved : x.is_negative() ? Truth::refuted : Truth::undecided;
}

// Whether g(t) > 0 for 0 < t < T, ends included but for those that g touches: there it is zero by
// construction, and has to leave zero with nonzero speed. Refuted when some time has g < 0 for every member,
// the same share of T for all. `least` is how short pieces of the phase may become, as shares of T.
template <class S, int N>
[[nodiscard]] Truth is_positive_along(const model::Wave<scalars::Form<S, N>>& g, const scalars::Form<S, N>& T,
                                      motion::Touches touches, double least) {
  using Time = scalars::Form<S, N>;
  constexpr int most_pieces = 300;
  std::vector<std::pair<double, double>> open;
  for (int k = 7; k >= 0; --k) {
    open.emplace_back(k / 8.0, (k + 1) / 8.0);
  }
  bool all = true;
  for (int examined = 0; !open.empty() && examined < most_pieces; ++examined) {
    const auto [first, last] = open.back();
    open.pop_back();
    const double middle = (first + last) / 2;
    const Time t = T * Time::variable(middle, last - middle, 0);
    const auto [value, slope] = model::value_and_slope<Time>(g, t);
    const bool rises = touches.start && first == 0 && slope.over.is_positive();
    const bool falls = touches.end && last == 1 && slope.over.is_negative();
    if (value.over.is_positive() || rises || falls) {
      continue;
    }
    const bool sinks = touches.start && first == 0 && slope.over.is_negative();
    const bool returns = touches.end && last == 1 && slope.over.is_positive();
    if (value.over_from(1).is_negative() || sinks || returns) {
      return Truth::refuted;
    }
    // What the parameters alone leave open no shorter piece decides.
    const bool touched = (touches.start && first == 0) || (touches.end && last == 1);
    const Time& g_or_slope = touched ? slope : value;
    const S spread = g_or_slope.over_from(1);
    const bool hopeless = !spread.is_nonzero() && scalars::is_narrower(g_or_slope.over, spread * S(1.25));
    if (last - first > least && !hopeless) {
      open.emplace_back(middle, last);
      open.emplace_back(first, middle);
    } else {
      all = false;  // go on: another piece may refute it
    }
  }
  return all && open.empty() ? Truth::proved : Truth::undecided;
}

// One requirement on a motion whose phases are known to last; ur is the friction at rest.
template <class S, int N>
[[nodiscard]] Truth holds_over(const motion::Requirement& q,
                               const motion::MotionOf<scalars::Form<S, N>>& motion,
                               const std::vector<model::PhaseWaves<scalars::Form<S, N>>>& waves,
                               const scalars::Form<S, N>& ur, double least) {
  using T = scalars::Form<S, N>;
  const model::Parameters<T>& a = motion.oscillator.data;
  switch (q.quantity) {
    case motion::Quantity::duration:
      return Truth::proved;
    case motion::Quantity::slipping_friction:
      return is_positive_over(a.us.over);
    case motion::Quantity::friction_step:
      return is_positive_over(T(ur - a.us).over);
    default:
      break;
  }
  const motion::Affine<T> form = motion::affine_form<T>(a, ur, q.quantity);
  const motion::PhaseOf<T>& phase = motion.phases[q.phase];
  if (!q.along) {
    const T r = model::friction_at<T>(a, phase.Z, phase.load);
    return is_positive_over(T(form.factor * r + form.offset).over);
  }
  const model::Wave<T>& wave = form.of_speed ? waves[q.phase].zdot2 : waves[q.phase].r;
  return is_positive_along<S, N>(model::affine<T>(form.factor, wave, form.offset), phase.duration, q.touches,
                                 least);
}

}  // namespace stickslip::numeric::atlas
