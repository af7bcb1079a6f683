// Forward-mode first derivatives: a value with its N partial derivatives. A Jet is a scalar of the model, so
// every formula of model/ gives its own derivatives, over double, CLN floats and balls alike. Over balls the
// value and each partial contain the exact ones for every member of the arguments.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "numeric/scalars.hpp"
#include "numeric/sinc.hpp"

namespace stickslip {

template <class S, int N>
struct Jet {
  S value = S(0);
  std::array<S, N> partials = zeros();

  Jet() = default;
  Jet(int constant) : value(constant) {}       // NOLINT: scalars convert from int
  Jet(const S& constant) : value(constant) {}  // NOLINT: a constant has no derivative

  // The i-th argument of a function, at `at`.
  [[nodiscard]] static Jet variable(const S& at, int i) {
    Jet x(at);
    x.partials[static_cast<std::size_t>(i)] = S(1);
    return x;
  }

  // The chain rule for g(this): value g, derivative slope.
  [[nodiscard]] Jet chain(const S& g, const S& slope) const {
    Jet result(g);
    for (std::size_t i = 0; i < N; ++i) {
      result.partials[i] = slope * partials[i];
    }
    return result;
  }

  Jet& operator+=(const Jet& b) {
    value += b.value;
    for (std::size_t i = 0; i < N; ++i) {
      partials[i] += b.partials[i];
    }
    return *this;
  }
  Jet& operator-=(const Jet& b) {
    value -= b.value;
    for (std::size_t i = 0; i < N; ++i) {
      partials[i] -= b.partials[i];
    }
    return *this;
  }
  Jet& operator*=(const Jet& b) { return *this = *this * b; }
  Jet& operator/=(const Jet& b) { return *this = *this / b; }

  friend Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend Jet operator-(Jet a, const Jet& b) { return a -= b; }
  friend Jet operator-(const Jet& a) { return a.chain(S(-a.value), S(-1)); }
  friend Jet operator+(const Jet& a) { return a; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet result(S(a.value * b.value));
    for (std::size_t i = 0; i < N; ++i) {
      result.partials[i] = a.value * b.partials[i] + a.partials[i] * b.value;
    }
    return result;
  }
  friend Jet operator/(const Jet& a, const Jet& b) {
    const S reciprocal = S(1) / b.value;
    Jet result(S(a.value * reciprocal));
    for (std::size_t i = 0; i < N; ++i) {
      result.partials[i] = (a.partials[i] - result.value * b.partials[i]) * reciprocal;
    }
    return result;
  }

  friend Jet sin(const Jet& a) {
    using std::cos;
    using std::sin;
    return a.chain(S(sin(a.value)), S(cos(a.value)));
  }
  friend Jet cos(const Jet& a) {
    using std::cos;
    using std::sin;
    return a.chain(S(cos(a.value)), S(-sin(a.value)));
  }
  friend Jet sqrt(const Jet& a) {
    using std::sqrt;
    const S root = S(sqrt(a.value));
    return a.chain(root, S(S(1) / (S(2) * root)));
  }
  friend Jet sinc(const Jet& a) { return a.chain(S(sinc(a.value)), S(sinc_slope(a.value))); }

 private:
  [[nodiscard]] static std::array<S, N> zeros() {
    std::array<S, N> z;
    z.fill(S(0));
    return z;
  }
};

// The arguments of a function of N variables at x, ready for differentiation.
template <class S, int N>
[[nodiscard]] Eigen::Matrix<Jet<S, N>, N, 1> variables(const Eigen::Matrix<S, N, 1>& x) {
  Eigen::Matrix<Jet<S, N>, N, 1> jets;
  for (int i = 0; i < N; ++i) {
    jets(i) = Jet<S, N>::variable(x(i), i);
  }
  return jets;
}

template <class S, int M, int N>
[[nodiscard]] Eigen::Matrix<S, M, 1> values(const Eigen::Matrix<Jet<S, N>, M, 1>& f) {
  Eigen::Matrix<S, M, 1> result;
  for (int i = 0; i < M; ++i) {
    result(i) = f(i).value;
  }
  return result;
}

// Row i holds the partial derivatives of f(i).
template <class S, int M, int N>
[[nodiscard]] Eigen::Matrix<S, M, N> jacobian(const Eigen::Matrix<Jet<S, N>, M, 1>& f) {
  Eigen::Matrix<S, M, N> result;
  for (int i = 0; i < M; ++i) {
    for (int j = 0; j < N; ++j) {
      result(i, j) = f(i).partials[static_cast<std::size_t>(j)];
    }
  }
  return result;
}

}  // namespace stickslip

namespace Eigen {

template <class S, int N>
struct NumTraits<stickslip::Jet<S, N>> : GenericNumTraits<stickslip::Jet<S, N>> {
  using Real = stickslip::Jet<S, N>;
  using NonInteger = stickslip::Jet<S, N>;
  using Nested = stickslip::Jet<S, N>;
  using Literal = stickslip::Jet<S, N>;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 4,
    AddCost = 100,
    MulCost = 200
  };
};

}  // namespace Eigen
