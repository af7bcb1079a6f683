// The overshooting family over a box of parameters, phi given: its closing conditions as two functions of (s,
// w) of families/overshooting.hpp, and an orbit, what it has to obey, and its multipliers.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "numeric/atlas/along.hpp"
#include "numeric/atlas/multipliers.hpp"
#include "numeric/atlas/zeros_in_patches.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/through_phases/one_stick_reduced.hpp"
#include "numeric/motion/multipliers.hpp"

namespace stickslip::numeric::atlas {

template <class S, int N>
struct OvershootingOrbit : MotionOver<scalars::Form<S, N>> {
  using T = scalars::Form<S, N>;
  static constexpr auto phi_given = families::Datum::phase;

  // What the closing conditions are written in.
  struct Setting {
    model::Oscillator<T> o;
    families::OneStickData<T> closing;
  };
  [[nodiscard]] static Setting setting(const model::Parameters<T>& data, const T& phi) {
    return {model::oscillator<T>(data), {model::reduced_data<T>(data, T(scalars::pi<S>())), phi}};
  }

  // Two functions that vanish where the rows hold for some amplitudes (a, C, D); nothing when the rows, for
  // any member, can't. With C_j and o_j the odd rows' coefficients of C and 1, these rows hold for one C if
  //   C_1 o_2 - C_2 o_1 = 0
  // and not both C_j vanish: (C_1² + C_2²) C = -(C_1 o_1 + C_2 o_2). With that C in the turn the other three
  // rows hold for one (a, D) if the determinant of their columns a, D and 1 vanishes and the columns a and D
  // are independent. Nothing is divided by: where the amplitudes grow beyond all bounds, as they do next to
  // the fold of the paper's orbit, the functions are as good as anywhere.
  [[nodiscard]] static std::optional<std::array<T, 2>> look(const Setting& setting, const T& s, const T& w) {
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const auto odd = families::odd_rows<2, phi_given, T>(setting.closing, sw);
    const T& C1 = odd(0, 1);
    const T& C2 = odd(1, 1);
    const T of_odd = families::det2<T>(C1, odd(0, 3), C2, odd(1, 3));
    if (of_odd.over.is_nonzero()) {
      return std::nullopt;
    }
    const T C = C1 * C1 + C2 * C2;
    const T o = C1 * odd(0, 3) + C2 * odd(1, 3);
    const auto rows = families::even_rows<2, phi_given, T>(setting.closing, sw);  // of a, C, D, 1
    const auto minor = [&](int k, int l) {
      return families::det2<T>(rows(0, k), rows(0, l), rows(1, k), rows(1, l));
    };
    const T of_even = minor(0, 2);
    const T without_C = rows(2, 0) * minor(2, 3) - rows(2, 2) * minor(0, 3) + rows(2, 3) * of_even;
    return std::array<T, 2>{of_odd, T(C * without_C - o * rows(2, 1) * of_even)};
  }

  // That of the zero (s, w), with positive durations, and ur is r where the stick ends, by (12); nothing when
  // its amplitudes may be unbounded.
  [[nodiscard]] static std::optional<OvershootingOrbit> at(const Setting& setting, const T& s, const T& w) {
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const auto reduced = families::eliminated<families::OneStick<2, phi_given>, T, S>(
        families::rows_of<2, phi_given, T>(setting.closing, sw));
    if (!reduced) {
      return std::nullopt;
    }
    zeros::VectorOf<T> x(5);
    x.template head<2>() = families::times<T, 2>(setting.closing.d.Theta, sw);
    x.template tail<3>() = reduced->linear;
    motion::MotionOf<T> motion =
        families::overshooting_motion<T>(setting.closing.d, setting.o, setting.closing.given, x);
    const motion::PhaseOf<T>& first = motion.phases[0];
    const T ur = model::friction_at<T>(motion.oscillator.data, first.Z, first.load);
    return OvershootingOrbit{{std::move(motion), ur}};
  }

  // Of an admissible orbit: then the rate at which the stick ends is positive.
  [[nodiscard]] Decision stability() const {
    const std::vector<T> c = motion::multiplier_polynomial<T>(this->motion);
    return is_inside_unit_circle<T>({T(-c[2] / c[3]), T(c[1] / c[3]), T(-c[0] / c[3])},
                                    T((c[0] + c[1] + c[2] + c[3]) / c[3]));
  }
};

}  // namespace stickslip::numeric::atlas
