#include "numeric/branches/crossing.hpp"

namespace stickslip::numeric::branches {

using namespace motion;
using zeros::ParameterJet;

namespace {

constexpr double shortest_time = 0x1p-24;
constexpr long most_times = 20000;

Trend trend(const ParameterJet& g) {
  if (g.value.is_positive()) {
    return Trend::above;
  }
  const Ball slope = g.partial(0);
  return slope.is_positive() ? Trend::rising : slope.is_negative() ? Trend::falling : Trend::unknown;
}

double above(const Ball& x) {
  return arf_get_d(arb_midref(x.upper().raw()), ARF_RND_CEIL);
}

// g at the times from a to b, by its slope in time; the derivative by the driver at a fixed time.
ParameterJet over(const model::Wave<ParameterJet>& g, const model::Wave<ParameterJet>& slope, double a,
                  double b) {
  const Ball times = Ball::hull(Ball(a), Ball(b));
  const Ball middle = times.midpoint();
  ParameterJet value = model::value<ParameterJet>(g, ParameterJet(times));
  const ParameterJet form =
      model::value<ParameterJet>(g, ParameterJet(middle)) +
      model::value<ParameterJet>(slope, ParameterJet(times)) * ParameterJet(Ball(times - middle));
  value.value = zeros::intersection(value.value, form.value).value_or(form.value);
  return value;
}

// The infimum over 0 < t <= last of g, or of g/t at a touched start: there g(t)/t is a mean of g'.
Trend from_start(const model::Wave<ParameterJet>& g, double last, bool touched) {
  const model::Wave<ParameterJet> slope = model::derivative(g);
  const model::Wave<ParameterJet> curvature = model::derivative(slope);
  Trend all = Trend::above;
  std::vector<std::pair<double, double>> open{{0, last}};
  for (long count = 0; !open.empty(); ++count) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Trend here = trend(a == 0 && touched ? over(slope, curvature, a, b) : over(g, slope, a, b));
    if (const Trend both = joined(all, here); both != Trend::unknown) {
      all = both;
      continue;
    }
    if (b - a < shortest_time || count > most_times) {
      return Trend::unknown;
    }
    const double middle = a + (b - a) / 2;
    open.emplace_back(middle, b);
    open.emplace_back(a, middle);
  }
  return all;
}

}  // namespace

Trend joined(Trend a, Trend b) {
  return a == Trend::above ? b : b == Trend::above || a == b ? a : Trend::unknown;
}

Trend trend_of(const Requirement& q, const MotionOf<ParameterJet>& motion,
               const std::optional<ParameterJet>& ur) {
  const model::Parameters<ParameterJet>& a = motion.oscillator.data;
  const ParameterJet friction = ur.value_or(ParameterJet(0));
  if (q.quantity == Quantity::duration) {
    return trend(motion.phases.at(q.phase).duration);
  }
  if (q.quantity == Quantity::slipping_friction) {
    return trend(a.us);
  }
  if (q.quantity == Quantity::friction_step) {
    return trend(ParameterJet(friction - a.us));
  }
  const PhaseOf<ParameterJet>& phase = motion.phases.at(q.phase);
  const Affine<ParameterJet> form = affine_form<ParameterJet>(a, friction, q.quantity);
  if (!q.along) {
    return trend(
        ParameterJet(form.factor * model::friction_at<ParameterJet>(a, phase.Z, phase.load) + form.offset));
  }
  const model::PhaseWaves<ParameterJet> waves = waves_of<ParameterJet>(motion.oscillator, phase);
  const model::Wave<ParameterJet> g =
      model::affine<ParameterJet>(form.factor, form.of_speed ? waves.zdot2 : waves.r, form.offset);
  const double half = above(phase.duration.value) / 2;
  return joined(from_start(g, half, q.touches.start),
                from_start(model::reversed<ParameterJet>(g, phase.duration), half, q.touches.end));
}

}  // namespace stickslip::numeric::branches
