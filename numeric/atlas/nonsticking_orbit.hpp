// An orbit that never sticks over a box of parameters: what it has to obey, and its multipliers.
#pragma once

#include <optional>
#include <utility>

#include "numeric/atlas/along.hpp"
#include "numeric/atlas/multipliers.hpp"
#include "numeric/atlas/sheets.hpp"

namespace stickslip::numeric::atlas {

template <class T>
class NonstickingOrbit {
 public:
  // The orbit of the sheet at the share u; nothing when it may be two.
  [[nodiscard]] static std::optional<NonstickingOrbit> at(const Sheet& sheet, const Setting<T>& s, const T& u,
                                                          const std::optional<T>& ur) {
    auto motion = motion_of<T>(sheet, s, u);
    return motion ? std::optional(NonstickingOrbit(std::move(*motion), u, ur)) : std::nullopt;
  }

  // Whether it obeys the requirement. When ur is not given, some ur > us has to be small enough: (25) and
  // (26) at ur = us.
  [[nodiscard]] Decision holds(const motion::Requirement& q, double least, Times& open) const {
    const model::Parameters<T>& a = motion_.oscillator.data;
    const T ur = ur_.value_or(a.us);
    switch (q.quantity) {
      case motion::Quantity::duration:
        return {Truth::proved};
      case motion::Quantity::slipping_friction:
        return decide_positive(a.us);
      case motion::Quantity::friction_step:
        return ur_ ? decide_positive(T(ur - a.us)) : Decision{Truth::proved};
      default:
        break;
    }
    const motion::Affine<T> form = motion::affine_form<T>(a, ur, q.quantity);
    const motion::PhaseOf<T>& phase = motion_.phases[q.phase];
    if (!q.along) {
      const T r = model::friction_at<T>(a, phase.Z, phase.load);
      return decide_positive(T(form.factor * r + form.offset));
    }
    const model::PhaseWaves<T> waves = motion::waves_of<T>(motion_.oscillator, phase);
    const auto g = [wave = model::affine<T>(form.factor, form.of_speed ? waves.zdot2 : waves.r, form.offset)](
                       const T& t) { return model::value_and_slope<T>(wave, t); };
    return is_positive_along<T>(g, phase.duration, q.touches, least, open);
  }

  [[nodiscard]] Decision stability() const { return stability_without_stick<T>(motion_.oscillator, share_); }

 private:
  NonstickingOrbit(motion::MotionOf<T> motion, const T& share, const std::optional<T>& ur)
      : motion_(std::move(motion)), share_(share), ur_(ur) {}

  motion::MotionOf<T> motion_;
  T share_;  // of the slip in the period
  std::optional<T> ur_;
};

}  // namespace stickslip::numeric::atlas
