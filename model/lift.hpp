// Lifting: the same data over a wider scalar, so that data known as numbers enter a formula over jets.
#pragma once

#include "model/parameters.hpp"

namespace stickslip::model {

template <class T, class S>
[[nodiscard]] Modes<T> lift(const Modes<S>& m) {
  return {T(m.omega1), T(m.omega2), T(m.lambda1), T(m.lambda2)};
}

template <class T, class S>
[[nodiscard]] Vector2<T> lift(const Vector2<S>& v) {
  return {T(v(0)), T(v(1))};
}

template <class T, class S>
[[nodiscard]] Parameters<T> lift(const Parameters<S>& a) {
  return {T(a.chi), T(a.eta), T(a.us), T(a.V), T(a.omega), T(a.p)};
}

}  // namespace stickslip::model
