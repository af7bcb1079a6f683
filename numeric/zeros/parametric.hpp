// Zeros of f(x, p) for all parameters p of a box P at once, and what follows from them, to first order in p.
//
// Evaluating formulas over wide balls treats every occurrence of a parameter as a different one. Here each
// quantity g is instead g(x(p0), p0) + dg/dp (P - p0), p0 = mid P, with the total derivative dg/dp over the
// whole box, by jets; dx/dp = -(df/dx)⁻¹ df/dp. This is the mean value theorem, not an approximation.
//
// A problem has x of N unknowns and, for T = Ball and jets over balls,
//   template <class T>
//   Eigen::Matrix<T, N, 1> closing(const Eigen::Matrix<T, N, 1>& x, const ParameterVector<T>& p) const
#pragma once

#include "numeric/zeros/inflation.hpp"

namespace stickslip::numeric::zeros {

// chi, eta, us, V, omega, p, and one more that the problem names.
inline constexpr int parameter_count = 7;
template <class T>
using ParameterVector = Eigen::Matrix<T, parameter_count, 1>;
using ParameterJet = scalars::Jet<Ball, parameter_count>;
using Sensitivities = Eigen::Matrix<Ball, Eigen::Dynamic, parameter_count>;

template <int N>
struct ParametricProof {
  Verdict verdict;           // of "for each p in P there is exactly one zero x(p) in `unique`"
  Box<N> at_middle;          // contains x(p0)
  Box<N> box;                // contains x(p) for all p
  Box<N> unique;             // contains no other zero, for any p
  Sensitivities derivative;  // contains dx/dp for all p
  // Meaningless unless proved, except for this: the parameter that widens the first Krawczyk image most.
  int widest = 0;
};

namespace detail {

// f as a function of x alone at fixed parameters.
template <int N, class F>
struct AtParameters {
  const F& f;
  ParameterVector<Ball> p;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, N, 1> operator()(const Eigen::Matrix<T, N, 1>& x) const {
    ParameterVector<T> lifted;
    for (int i = 0; i < parameter_count; ++i) {
      lifted(i) = T(p(i));
    }
    return f.template closing<T>(x, lifted);
  }
};

// df/dx and df/dp over X × P.
template <int N>
struct Slopes {
  BallMatrix<N> by_x;
  Eigen::Matrix<Ball, N, parameter_count> by_p;
};
template <int N, class F>
[[nodiscard]] Slopes<N> slopes(const F& f, const Box<N>& X, const ParameterVector<Ball>& P) {
  using T = scalars::Jet<Ball, N + parameter_count>;
  Eigen::Matrix<T, N, 1> x;
  ParameterVector<T> p;
  for (int i = 0; i < N; ++i) {
    x(i) = T::variable(X(i), i);
  }
  for (int i = 0; i < parameter_count; ++i) {
    p(i) = P(i).is_exact() ? T(P(i)) : T::variable(P(i), N + i);
  }
  const Eigen::Matrix<T, N, 1> value = f.template closing<T>(x, p);
  constexpr std::size_t first_parameter = N;
  Slopes<N> result;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      result.by_x(i, j) = value(i).partials[static_cast<std::size_t>(j)];
    }
    for (int j = 0; j < parameter_count; ++j) {
      result.by_p(i, j) = value(i).partials[first_parameter + static_cast<std::size_t>(j)];
    }
  }
  return result;
}

// Contains all D with (I - E) D = R for members of the balls. In the norm max |v_i|/w_i, w the radii of X,
// each member of E is smaller than q < 1, so each column of D is bounded by that of R over 1 - q; then D = R
// + E D. Nothing when q < 1 is not certain.
template <int N>
[[nodiscard]] std::optional<Sensitivities> solve_near_identity(const BallMatrix<N>& E, const Sensitivities& R,
                                                               const Box<N>& X) {
  const auto grow = [](Ball& largest, const Ball& x) {
    arb_max(largest.raw(), largest.raw(), x.upper().raw(), WorkingPrecision::bits());
  };
  Ball q(0);
  for (int i = 0; i < N; ++i) {
    Ball row(0);
    for (int j = 0; j < N; ++j) {
      row += abs(E(i, j)) * X(j).radius() / X(i).radius();
    }
    grow(q, row);
  }
  if (!(q - Ball(1)).is_negative()) {
    return std::nullopt;
  }
  Sensitivities D = R;
  for (int j = 0; j < parameter_count; ++j) {
    Ball norm(0);
    for (int i = 0; i < N; ++i) {
      grow(norm, abs(R(i, j)) / X(i).radius());
    }
    for (int i = 0; i < N; ++i) {
      const Ball bound = (norm / (Ball(1) - q) * X(i).radius()).upper();
      D(i, j) = Ball::hull(-bound, bound);
    }
  }
  D = (R + E * D).eval();
  return Sensitivities(R + E * D);
}

// The parameter whose spread moves the zero most.
template <int N>
[[nodiscard]] int widest_parameter(const Sensitivities& R, const ParameterVector<Ball>& spread) {
  int widest = 0;
  double most = -1;
  for (int j = 0; j < parameter_count; ++j) {
    for (int i = 0; i < N; ++i) {
      const double moved = (R(i, j) * spread(j)).radius().approximate();
      if (moved > most) {
        most = moved;
        widest = j;
      }
    }
  }
  return widest;
}

}  // namespace detail

// One zero for each p in P, near the guess. x(p0) is found first; then the box grows with Krawczyk's image
//   x(p0) + R (P - p0) + E (X - x(p0)),  R = -Y f_p(X, P),  E = I - Y f_x(X, P),
// until that lies inside it. Undecided when it does not: split P, best in the parameter `widest`.
template <int N, class F>
[[nodiscard]] ParametricProof<N> prove_over_parameters(const F& f, const ParameterVector<Ball>& P,
                                                       const Box<N>& guess) {
  ParametricProof<N> result;
  const ParameterVector<Ball> p0 = P.unaryExpr([](const Ball& b) { return b.midpoint(); });
  const ParameterVector<Ball> spread = P - p0;
  const detail::AtParameters<N, F> at_middle{f, p0};
  const std::optional<Box<N>> point = newton<Ball, N>(at_middle, midpoint<N>(guess), 1);
  Box<N> m = point ? midpoint<N>(*point) : midpoint<N>(guess);
  for (int k = 0; k < 6; ++k) {
    const std::optional<Box<N>> better = newton<Ball, N>(at_middle, m, 1);
    m = better ? midpoint<N>(*better) : m;
  }
  const ZeroProof<N> middle = prove_zero_by_inflation<N>(at_middle, m);
  result.verdict = middle.verdict;
  if (middle.verdict.truth != Truth::proved) {
    return result;
  }
  result.at_middle = middle.box;
  Box<N> X = inflate<N>(middle.box, 2);
  for (int round = 0; round < 16; ++round) {
    const detail::Slopes<N> slope = detail::slopes<N>(f, X, P);
    const std::optional<BallMatrix<N>> Y = approximate_inverse<Ball, N>(slope.by_x);
    if (!Y) {
      break;
    }
    const BallMatrix<N> E = BallMatrix<N>::Identity() - *Y * slope.by_x;
    const Sensitivities R = -(*Y * slope.by_p);
    const Box<N> by_parameters = R * spread;
    const Box<N> K = result.at_middle + by_parameters + E * Box<N>(X - result.at_middle);
    if (round == 0) {
      result.widest = detail::widest_parameter<N>(R, spread);
    }
    if (is_interior<N>(K, X)) {
      const std::optional<Sensitivities> D = detail::solve_near_identity<N>(E, R, X);
      if (!D) {
        break;
      }
      result.unique = X;
      result.derivative = *D;
      result.box = *intersection<N>(K, Box<N>(result.at_middle + *D * spread));
      return result;
    }
    for (int i = 0; i < N; ++i) {
      const Ball r = K(i).radius() * Ball(1.2) + Ball(0x1p-80);
      if (!(r - Ball(2)).is_negative()) {
        result.verdict = Verdict::undecided("the box outgrows every bound: split the parameters");
        return result;
      }
      X(i) = K(i).midpoint() + Ball::hull(-r, r);
    }
  }
  result.verdict = Verdict::undecided("no box around the guess passed Krawczyk's test: split the parameters");
  return result;
}

// g over the whole box: its value at the middle plus its derivative times the spread, or the value that the
// jet carries where that is narrower.
[[nodiscard]] inline Ball over_parameters(const ParameterJet& g, const Ball& at_middle,
                                          const ParameterVector<Ball>& spread) {
  Ball sum = at_middle;
  for (int i = 0; i < parameter_count; ++i) {
    sum += g.partials[static_cast<std::size_t>(i)] * spread(i);
  }
  const std::optional<Ball> both = intersection(sum, g.value);
  return both ? *both : sum;
}

}  // namespace stickslip::numeric::zeros
