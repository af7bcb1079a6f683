// Numbers that depend on unknowns, as a scalar of the model.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include "core/ball.hpp"
#include "model/scalar_traits.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::proofs::checks {

// The value where all unknowns are 0, and where one of them is 1: all that there is to say of what is linear
// in them. An unknown is meant by its number; one that does not occur is left out.
struct WithUnknowns {
  Ball at_zero;
  std::map<std::size_t, Ball> at_one = {};

  WithUnknowns(int value = 0) : at_zero(value) {}          // NOLINT: scalars convert from int
  WithUnknowns(Ball value) : at_zero(std::move(value)) {}  // NOLINT: a number without unknowns
  [[nodiscard]] static WithUnknowns unknown(std::size_t number) {
    WithUnknowns result;
    result.at_one.emplace(number, Ball(1));
    return result;
  }

  template <class Function>
  friend WithUnknowns mapped(const Function& f, const WithUnknowns& a) {
    WithUnknowns result = Ball(f(a.at_zero));
    for (const auto& [unknown, value] : a.at_one) {
      result.at_one.emplace(unknown, f(value));
    }
    return result;
  }
  template <class Function>
  friend WithUnknowns mapped(const Function& f, const WithUnknowns& a, const WithUnknowns& b) {
    WithUnknowns result = Ball(f(a.at_zero, b.at_zero));
    for (const auto& [unknown, value] : a.at_one) {
      const auto other = b.at_one.find(unknown);
      result.at_one.emplace(unknown, f(value, other == b.at_one.end() ? b.at_zero : other->second));
    }
    for (const auto& [unknown, value] : b.at_one) {
      if (!a.at_one.contains(unknown)) {
        result.at_one.emplace(unknown, f(a.at_zero, value));
      }
    }
    return result;
  }

  friend WithUnknowns operator+(const WithUnknowns& a, const WithUnknowns& b) {
    return mapped([](const Ball& x, const Ball& y) { return Ball(x + y); }, a, b);
  }
  friend WithUnknowns operator-(const WithUnknowns& a, const WithUnknowns& b) {
    return mapped([](const Ball& x, const Ball& y) { return Ball(x - y); }, a, b);
  }
  friend WithUnknowns operator*(const WithUnknowns& a, const WithUnknowns& b) {
    return mapped([](const Ball& x, const Ball& y) { return Ball(x * y); }, a, b);
  }
  friend WithUnknowns operator/(const WithUnknowns& a, const WithUnknowns& b) {
    return mapped([](const Ball& x, const Ball& y) { return Ball(x / y); }, a, b);
  }
  friend WithUnknowns operator-(const WithUnknowns& a) { return WithUnknowns(0) - a; }
  friend WithUnknowns operator+(const WithUnknowns& a) { return a; }
  WithUnknowns& operator+=(const WithUnknowns& b) { return *this = *this + b; }
  WithUnknowns& operator-=(const WithUnknowns& b) { return *this = *this - b; }
  WithUnknowns& operator*=(const WithUnknowns& b) { return *this = *this * b; }
  WithUnknowns& operator/=(const WithUnknowns& b) { return *this = *this / b; }
  friend WithUnknowns sin(const WithUnknowns& a) {
    return mapped([](const Ball& x) { return Ball(sin(x)); }, a);
  }
  friend WithUnknowns cos(const WithUnknowns& a) {
    return mapped([](const Ball& x) { return Ball(cos(x)); }, a);
  }
  friend WithUnknowns exp(const WithUnknowns& a) {
    return mapped([](const Ball& x) { return Ball(exp(x)); }, a);
  }
  friend WithUnknowns sqrt(const WithUnknowns& a) {
    return mapped([](const Ball& x) { return Ball(sqrt(x)); }, a);
  }
  friend std::pair<WithUnknowns, WithUnknowns> sin_cos(const WithUnknowns& a) { return {sin(a), cos(a)}; }
  friend WithUnknowns abs(const WithUnknowns& a) {
    return mapped([](const Ball& x) { return Ball(abs(x)); }, a);
  }
  friend bool is_zero(const WithUnknowns& a) { return a.at_one.empty() && is_zero(a.at_zero); }
};

}  // namespace stickslip::proofs::checks

namespace Eigen {

template <>
struct NumTraits<stickslip::proofs::checks::WithUnknowns>
    : stickslip::model::ScalarTraits<stickslip::proofs::checks::WithUnknowns, 10, 100, 100> {};

}  // namespace Eigen
