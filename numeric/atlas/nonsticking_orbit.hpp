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

  // When ur is not given, some ur > us has to be small enough: (25) and (26) at ur = us.
  [[nodiscard]] Decision holds(const motion::Requirement& q, double least, Times& open) const {
    return holds_over<T>(motion_, ur_.value_or(motion_.oscillator.data.us), !ur_, q, least, open);
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
