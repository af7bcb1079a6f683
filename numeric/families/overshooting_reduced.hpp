// The reduced equations of the overshooting family with all linear unknowns eliminated, over any scalar of
// boxes (scalars/form.hpp): at (s, w) of overshooting.hpp, for whole boxes of parameters.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "numeric/families/one_stick_rows.hpp"
#include "numeric/families/strip.hpp"

namespace stickslip::numeric::families {

// All linear unknowns eliminated from the rows: (a, C, D), where ur is given cos psi and sin psi, too, and
// the functions that vanish where all rows hold for some values of the unknowns, `linear`.
template <class T, Datum G>
struct WithoutLinear {
  static constexpr int U = OneStick<2, G>::columns - 1;
  Eigen::Matrix<T, 2, 1> vanish;
  Eigen::Matrix<T, U, 1> linear;
};

// Nothing where the rows may be dependent.
template <Datum G, class T, class S>
[[nodiscard]] std::optional<WithoutLinear<T, G>> eliminated(const AllRows<OneStick<2, G>, T>& rows) {
  constexpr int R = OneStick<2, G>::rows;
  constexpr int C = OneStick<2, G>::columns;
  const Eigen::Matrix<S, R, C> at_middle = rows.unaryExpr([](const T& x) { return x.at; });
  const auto combinations = zeros::proposed_combinations<R, C>(at_middle);
  if (!combinations) {
    return std::nullopt;
  }
  Eigen::Matrix<T, R, C> m =
      zeros::combined_rows<T, R, C>(Eigen::Matrix<S, R, R>(combinations->template cast<S>()), rows);
  if (!zeros::eliminate<T, R, C>(m, 0, C - 1)) {
    return std::nullopt;
  }
  const Eigen::Matrix<T, C - 1, 1> u = zeros::back_substituted<T, R, C>(m);
  if constexpr (G == Datum::phase) {
    return WithoutLinear<T, G>{{m(3, 3), m(4, 3)}, u};
  } else {
    return WithoutLinear<T, G>{{m(5, 5), T(u(3) * u(3) + (u(4) - T(1)) * (u(4) + T(1)))}, u};
  }
}

}  // namespace stickslip::numeric::families
