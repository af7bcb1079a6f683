// The overshooting family over a box of parameters, phi given: its closing conditions as two functions of (s,
// w) of families/overshooting.hpp, and an orbit, what it has to obey, and its multipliers.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "numeric/atlas/conditions_over.hpp"
#include "numeric/atlas/multipliers.hpp"
#include "numeric/atlas/zeros_in_patches.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/overshooting_reduced.hpp"
#include "numeric/motion/multipliers.hpp"

namespace stickslip::numeric::atlas {

template <class S, int N>
class OvershootingOrbit {
  using T = scalars::Form<S, N>;
  static constexpr auto phi_given = families::Datum::phase;

 public:
  // What the closing conditions are written in.
  struct Setting {
    model::Oscillator<T> o;
    families::OneStickData<T> closing;
  };
  [[nodiscard]] static Setting setting(const model::Parameters<T>& data, const T& phi) {
    return {model::oscillator<T>(data), {families::overshooting_data_of<T, S>(data), phi}};
  }

  // The odd rows alone exclude much, for little.
  [[nodiscard]] static Seen<T> look(const Setting& setting, const T& s, const T& w) {
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const auto odd = families::odd_rows<2, phi_given, T>(setting.closing, sw);
    if (families::det2<T>(odd(0, 1), odd(0, 3), odd(1, 1), odd(1, 3)).over.is_nonzero()) {
      return {true, {}, {}};
    }
    const auto reduced = families::eliminated<phi_given, T, S>(
        families::stacked<2, phi_given, T>(odd, families::other_rows<2, phi_given, T>(setting.closing, sw)));
    if (!reduced) {
      return {};
    }
    return {false, std::array<T, 2>{reduced->vanish(0), reduced->vanish(1)},
            [reduced = *reduced] { return reduced.is_equivalent(); }};
  }

  // That of the zero (s, w), with positive durations; nothing when its amplitudes may be unbounded.
  [[nodiscard]] static std::optional<OvershootingOrbit> at(const Setting& setting, const T& s, const T& w) {
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const auto reduced =
        families::eliminated<phi_given, T, S>(families::rows_at<2, phi_given, T>(setting.closing, sw));
    if (!reduced) {
      return std::nullopt;
    }
    zeros::VectorOf<T> x(5);
    x.template head<2>() = families::times<T, 2>(setting.closing.d.Theta, sw);
    x.template tail<3>() = reduced->linear;
    return OvershootingOrbit(
        families::overshooting_motion<T>(setting.closing.d, setting.o, setting.closing.given, x));
  }

  // ur is r where the stick ends, by (12).
  [[nodiscard]] Decision holds(const motion::Requirement& q, double least, Times& open) const {
    return holds_over<T>(motion_, ur_, false, q, least, open);
  }

  // Of an admissible orbit: then the rate at which the stick ends is positive.
  [[nodiscard]] Decision stability() const {
    const std::vector<T> c = motion::multiplier_polynomial<T>(motion_);
    return is_inside_unit_circle<T>({T(-c[2] / c[3]), T(c[1] / c[3]), T(-c[0] / c[3])},
                                    T((c[0] + c[1] + c[2] + c[3]) / c[3]));
  }

 private:
  explicit OvershootingOrbit(motion::MotionOf<T> motion)
      : motion_(std::move(motion)),
        ur_(model::friction_at<T>(motion_.oscillator.data, motion_.phases[0].Z, motion_.phases[0].load)) {}

  motion::MotionOf<T> motion_;
  T ur_;
};

}  // namespace stickslip::numeric::atlas
