// Taylor polynomials in one variable: a scalar of the model whose coefficients are any scalar, so that every
// formula of model/ gives its own derivatives in time, of any order. Over balls each coefficient contains the
// exact one for every member of the arguments.
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "core/sinc.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::numeric::scalars {

// f(t0 + h) = c0 + c1 h + … + cn hⁿ + o(hⁿ). A constant has one coefficient; all that depend on the variable
// have the n + 1 of the variable they came from, and those are not mixed with others.
template <class S>
class Series {
 public:
  Series() : coefficients_{S(0)} {}
  Series(int constant) : coefficients_{S(constant)} {}        // NOLINT: scalars convert from int
  Series(S constant) : coefficients_{std::move(constant)} {}  // NOLINT: a constant has no derivative

  // The variable at t0, to the order n.
  [[nodiscard]] static Series variable(S t0, std::size_t order) {
    Series t(std::move(t0));
    t.coefficients_.resize(order + 1, S(0));
    if (order > 0) {
      t.coefficients_[1] = S(1);
    }
    return t;
  }

  [[nodiscard]] std::size_t size() const { return coefficients_.size(); }
  // c_k; 0 beyond the last.
  [[nodiscard]] S operator[](std::size_t k) const { return k < size() ? coefficients_[k] : S(0); }
  // The derivative, known to one order less.
  [[nodiscard]] Series derivative() const {
    Series slope;
    slope.coefficients_.resize(std::max<std::size_t>(size(), 2) - 1, S(0));
    for (std::size_t k = 1; k < size(); ++k) {
      slope.coefficients_[k - 1] = S(static_cast<int>(k)) * coefficients_[k];
    }
    return slope;
  }

  Series& operator+=(const Series& b) {
    coefficients_.resize(std::max(size(), b.size()), S(0));
    for (std::size_t k = 0; k < b.size(); ++k) {
      coefficients_[k] += b.coefficients_[k];
    }
    return *this;
  }
  Series& operator-=(const Series& b) { return *this += -b; }
  Series& operator*=(const Series& b) { return *this = *this * b; }
  Series& operator/=(const Series& b) { return *this = *this / b; }

  friend Series operator+(Series a, const Series& b) { return std::move(a += b); }
  friend Series operator-(Series a, const Series& b) { return std::move(a -= b); }
  friend Series operator+(const Series& a) { return a; }
  friend Series operator-(Series a) {
    for (S& c : a.coefficients_) {
      c = -c;
    }
    return a;
  }
  friend Series operator*(const Series& a, const Series& b) {
    Series product = sized(a, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size() && i + j < product.size(); ++j) {
        product.coefficients_[i + j] += a.coefficients_[i] * b.coefficients_[j];
      }
    }
    return product;
  }
  friend Series operator/(const Series& a, const Series& b) {
    Series quotient = sized(a, b);
    for (std::size_t k = 0; k < quotient.size(); ++k) {
      S rest = a[k];
      for (std::size_t j = 1; j <= k && j < b.size(); ++j) {
        rest -= b.coefficients_[j] * quotient.coefficients_[k - j];
      }
      quotient.coefficients_[k] = rest / b.coefficients_[0];
    }
    return quotient;
  }
  // From s' = u' c, c' = -u' s.
  friend std::pair<Series, Series> sin_cos(const Series& u) {
    Series s = sized(u, u), c = s;
    std::tie(s.coefficients_[0], c.coefficients_[0]) = sin_cos(u.coefficients_[0]);
    for (std::size_t k = 1; k < u.size(); ++k) {
      for (std::size_t j = 1; j <= k; ++j) {
        const S slope = S(static_cast<int>(j)) * u.coefficients_[j] / S(static_cast<int>(k));
        s.coefficients_[k] += slope * c.coefficients_[k - j];
        c.coefficients_[k] -= slope * s.coefficients_[k - j];
      }
    }
    return {s, c};
  }
  friend Series sin(const Series& u) { return sin_cos(u).first; }
  friend Series cos(const Series& u) { return sin_cos(u).second; }
  // Exactly zero with all its derivatives, so that what it multiplies can be skipped.
  friend bool is_zero(const Series& a) {
    return std::all_of(a.coefficients_.begin(), a.coefficients_.end(), [](const S& c) { return is_zero(c); });
  }

 private:
  [[nodiscard]] static Series sized(const Series& a, const Series& b) {
    Series zeros;
    zeros.coefficients_.resize(std::max(a.size(), b.size()), S(0));
    return zeros;
  }

  std::vector<S> coefficients_;
};

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <class S>
struct NumTraits<stickslip::numeric::scalars::Series<S>>
    : stickslip::model::ScalarTraits<stickslip::numeric::scalars::Series<S>, 4, 100, 200> {};

}  // namespace Eigen
