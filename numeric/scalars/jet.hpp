// Forward-mode first derivatives: a value with its N partial derivatives. A Jet is a scalar of the model, so
// every formula of model/ gives its own derivatives, over double and balls alike. Over balls the
// value and each partial contain the exact ones for every member of the arguments.
//
// N is known to the compiler where speed counts, in searches. With N = Eigen::Dynamic the number of partials
// is that of the variables a value depends on, and a constant has none: one type, compiled once, for problems
// of any size.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/sinc.hpp"
#include "model/scalar_traits.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::scalars {

using stickslip::sin_cos;  // of double, which has no namespace of its own

// Whether a number is exactly zero: then products with it need not be computed.
[[nodiscard]] inline bool is_zero(double x) {
  return x == 0;
}

template <class S, int N>
struct Jet {
  static constexpr bool sized = N != Eigen::Dynamic;
  using Partials = std::conditional_t<sized, std::array<S, static_cast<std::size_t>(N)>, std::vector<S>>;

  S value = S(0);
  Partials partials = zeros();

  Jet() = default;
  Jet(int constant) : value(constant) {}           // NOLINT: scalars convert from int
  Jet(S constant) : value(std::move(constant)) {}  // NOLINT: a constant has no derivative

  // The i-th argument of a function of `count` arguments, at `at`.
  [[nodiscard]] static Jet variable(const S& at, int i, int count = N) {
    Jet x(at);
    x.reach(static_cast<std::size_t>(count));
    x.partials[static_cast<std::size_t>(i)] = S(1);
    return x;
  }

  // The derivative by the i-th argument, also of a constant.
  [[nodiscard]] S partial(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return k < partials.size() ? partials[k] : S(0);
  }

  // The chain rule for g(this): value g, derivative slope.
  [[nodiscard]] Jet chain(S g, const S& slope) const {
    Jet result(std::move(g));
    result.reach(partials.size());
    for (std::size_t i = 0; i < partials.size(); ++i) {
      if (!is_zero(partials[i])) {
        result.partials[i] = slope * partials[i];
      }
    }
    return result;
  }

  Jet& operator+=(const Jet& b) {
    value += b.value;
    return each(b, [](S& slope, const S& other) { slope += other; });
  }
  Jet& operator-=(const Jet& b) {
    value -= b.value;
    return each(b, [](S& slope, const S& other) { slope -= other; });
  }
  Jet& operator*=(const Jet& b) {
    if (this == &b) {
      return *this *= Jet(b);
    }
    for (S& slope : partials) {
      if (!is_zero(slope)) {
        slope *= b.value;
      }
    }
    each(b, [this](S& slope, const S& other) { add_product(slope, value, other); });
    value *= b.value;
    return *this;
  }
  Jet& operator/=(const Jet& b) {
    if (this == &b) {
      return *this /= Jet(b);
    }
    value /= b.value;
    each(b, [this](S& slope, const S& other) { slope -= value * other; });
    for (S& slope : partials) {
      if (!is_zero(slope)) {
        slope /= b.value;
      }
    }
    return *this;
  }

  friend Jet operator+(Jet a, const Jet& b) { return std::move(a += b); }
  friend Jet operator-(Jet a, const Jet& b) { return std::move(a -= b); }
  friend Jet operator*(Jet a, const Jet& b) { return std::move(a *= b); }
  friend Jet operator/(Jet a, const Jet& b) { return std::move(a /= b); }
  friend Jet operator-(const Jet& a) { return a.chain(S(-a.value), S(-1)); }
  friend Jet operator+(const Jet& a) { return a; }

  friend std::pair<Jet, Jet> sin_cos(const Jet& a) {
    const std::pair<S, S> both = sin_cos(a.value);
    return {a.chain(both.first, both.second), a.chain(both.second, S(-both.first))};
  }
  // Exactly zero with all its derivatives, so that what it multiplies can be skipped.
  friend bool is_zero(const Jet& a) {
    return is_zero(a.value) &&
           std::all_of(a.partials.begin(), a.partials.end(), [](const S& x) { return is_zero(x); });
  }

  friend bool is_nonzero(const Jet& a) { return is_nonzero(a.value); }
  // sum += factor b, the factor a constant.
  friend void add_product(Jet& sum, const S& factor, const Jet& b) {
    add_product(sum.value, factor, b.value);
    sum.each(b, [&](S& slope, const S& other) { add_product(slope, factor, other); });
  }

  friend Jet sin(const Jet& a) {
    const std::pair<S, S> both = sin_cos(a.value);
    return a.chain(both.first, both.second);
  }
  friend Jet cos(const Jet& a) {
    const std::pair<S, S> both = sin_cos(a.value);
    return a.chain(both.second, S(-both.first));
  }
  friend Jet sqrt(const Jet& a) {
    using std::sqrt;
    const S root = S(sqrt(a.value));
    return a.chain(root, S(S(1) / (S(2) * root)));
  }
  friend Jet sinc(const Jet& a) { return a.chain(S(sinc(a.value)), S(sinc_slope(a.value))); }

 private:
  [[nodiscard]] static Partials zeros() {
    Partials z;
    if constexpr (sized) {
      z.fill(S(0));
    }
    return z;
  }
  // Changes each partial by that of b, unless that is exactly zero.
  template <class Change>
  Jet& each(const Jet& b, const Change& change) {
    reach(b.partials.size());
    for (std::size_t i = 0; i < b.partials.size(); ++i) {
      if (!is_zero(b.partials[i])) {
        change(partials[i], b.partials[i]);
      }
    }
    return *this;
  }
  // At least so many partials.
  void reach(std::size_t count) {
    if constexpr (!sized) {
      if (partials.size() < count) {
        partials.resize(count, S(0));
      }
    }
  }
};

// The arguments of a function of N variables at x, ready for differentiation.
template <class S, int N>
[[nodiscard]] Eigen::Matrix<Jet<S, N>, N, 1> variables(const Eigen::Matrix<S, N, 1>& x) {
  const auto count = static_cast<int>(x.size());
  Eigen::Matrix<Jet<S, N>, N, 1> jets;
  jets.resize(count);
  for (int i = 0; i < count; ++i) {
    jets(i) = Jet<S, N>::variable(x(i), i, count);
  }
  return jets;
}

template <class S, int M, int N>
[[nodiscard]] Eigen::Matrix<S, M, 1> values(const Eigen::Matrix<Jet<S, N>, M, 1>& f) {
  return f.unaryExpr([](const Jet<S, N>& jet) { return jet.value; });
}

// Row i holds the partial derivatives of f(i) by the first `count` arguments.
template <class S, int M, int N>
[[nodiscard]] Eigen::Matrix<S, M, N> jacobian(const Eigen::Matrix<Jet<S, N>, M, 1>& f, int count = N) {
  Eigen::Matrix<S, M, N> result;
  result.resize(f.size(), count);
  for (int i = 0; i < f.size(); ++i) {
    for (int j = 0; j < count; ++j) {
      result(i, j) = f(i).partial(j);
    }
  }
  return result;
}

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <class S, int N>
struct NumTraits<stickslip::numeric::scalars::Jet<S, N>>
    : stickslip::model::ScalarTraits<stickslip::numeric::scalars::Jet<S, N>, 4, 100, 200> {};

}  // namespace Eigen
