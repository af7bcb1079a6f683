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
  Series() : first_(0) {}
  Series(int constant) : first_(constant) {}           // NOLINT: scalars convert from int
  Series(S constant) : first_(std::move(constant)) {}  // NOLINT: a constant has no derivative

  // The variable at t0, to the order n.
  [[nodiscard]] static Series variable(S t0, std::size_t order) {
    Series t(std::move(t0));
    t.rest_.resize(order, S(0));
    if (order > 0) {
      t.rest_[0] = S(1);
    }
    return t;
  }

  [[nodiscard]] std::size_t size() const { return rest_.size() + 1; }
  // c_k; 0 beyond the last.
  [[nodiscard]] S operator[](std::size_t k) const { return k < size() ? at(k) : S(0); }
  // The derivative, known to one order less.
  [[nodiscard]] Series derivative() const {
    Series slope;
    slope.rest_.resize(std::max<std::size_t>(size(), 2) - 2, S(0));
    for (std::size_t k = 1; k < size(); ++k) {
      slope.at(k - 1) = S(static_cast<int>(k)) * at(k);
    }
    return slope;
  }

  Series& operator+=(const Series& b) {
    rest_.resize(std::max(size(), b.size()) - 1, S(0));
    for (std::size_t k = 0; k < b.size(); ++k) {
      at(k) += b.at(k);
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
    for (std::size_t k = 0; k < a.size(); ++k) {
      a.at(k) = -a.at(k);
    }
    return a;
  }
  friend Series operator*(const Series& a, const Series& b) {
    if (a.rest_.empty() && b.rest_.empty()) {
      return S(a.first_ * b.first_);
    }
    Series product = sized(a, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size() && i + j < product.size(); ++j) {
        product.at(i + j) += a.at(i) * b.at(j);
      }
    }
    return product;
  }
  friend Series operator/(const Series& a, const Series& b) {
    if (a.rest_.empty() && b.rest_.empty()) {
      return S(a.first_ / b.first_);
    }
    Series quotient = sized(a, b);
    for (std::size_t k = 0; k < quotient.size(); ++k) {
      S rest = a[k];
      for (std::size_t j = 1; j <= k && j < b.size(); ++j) {
        rest -= b.at(j) * quotient.at(k - j);
      }
      quotient.at(k) = rest / b.at(0);
    }
    return quotient;
  }
  // From s' = u' c, c' = -u' s.
  friend std::pair<Series, Series> sin_cos(const Series& u) {
    Series s = sized(u, u), c = s;
    std::tie(s.at(0), c.at(0)) = sin_cos(u.at(0));
    for (std::size_t k = 1; k < u.size(); ++k) {
      for (std::size_t j = 1; j <= k; ++j) {
        const S slope = S(static_cast<int>(j)) * u.at(j) / S(static_cast<int>(k));
        s.at(k) += slope * c.at(k - j);
        c.at(k) -= slope * s.at(k - j);
      }
    }
    return {s, c};
  }
  friend Series sin(const Series& u) { return sin_cos(u).first; }
  friend Series cos(const Series& u) { return sin_cos(u).second; }
  // From e' = u' e.
  friend Series exp(const Series& u) {
    Series e = sized(u, u);
    e.at(0) = exp(u.at(0));
    for (std::size_t k = 1; k < u.size(); ++k) {
      for (std::size_t j = 1; j <= k; ++j) {
        e.at(k) += S(static_cast<int>(j)) * u.at(j) * e.at(k - j) / S(static_cast<int>(k));
      }
    }
    return e;
  }
  // Exactly zero with all its derivatives, so that what it multiplies can be skipped.
  friend bool is_zero(const Series& a) {
    return is_zero(a.first_) &&
           std::all_of(a.rest_.begin(), a.rest_.end(), [](const S& c) { return is_zero(c); });
  }

 private:
  [[nodiscard]] static Series sized(const Series& a, const Series& b) {
    Series zeros;
    zeros.rest_.resize(std::max(a.size(), b.size()) - 1, S(0));
    return zeros;
  }
  [[nodiscard]] const S& at(std::size_t k) const { return k == 0 ? first_ : rest_[k - 1]; }
  [[nodiscard]] S& at(std::size_t k) { return k == 0 ? first_ : rest_[k - 1]; }

  S first_;              // most series are constants, and take no memory of their own
  std::vector<S> rest_;  // c_1, c_2, …
};

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <class S>
struct NumTraits<stickslip::numeric::scalars::Series<S>>
    : stickslip::model::ScalarTraits<stickslip::numeric::scalars::Series<S>, 4, 100, 200> {};

}  // namespace Eigen
