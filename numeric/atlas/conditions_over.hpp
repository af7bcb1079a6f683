// What a motion over a box of parameters has to obey, whatever its phases.
#pragma once

#include "numeric/atlas/along.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::atlas {

// Whether a motion all of whose phases last obeys the requirement at the friction ur; where `ur_is_free` some
// ur > us has to be right, and serves if ur = us does. Only the open times of the phase are looked at.
template <class T>
[[nodiscard]] Decision holds_over(const motion::MotionOf<T>& motion, const T& ur, bool ur_is_free,
                                  const motion::Requirement& q, double least, Times& open) {
  const model::Parameters<T>& a = motion.oscillator.data;
  switch (q.quantity) {
    case motion::Quantity::duration:
      return {Truth::proved};
    case motion::Quantity::slipping_friction:
      return decide_positive(a.us);
    case motion::Quantity::friction_step:
      return ur_is_free ? Decision{Truth::proved} : decide_positive(T(ur - a.us));
    default:
      break;
  }
  const motion::Affine<T> form = motion::affine_form<T>(a, ur, q.quantity);
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

}  // namespace stickslip::numeric::atlas
