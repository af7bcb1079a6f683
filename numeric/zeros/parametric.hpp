// Zeros of f(x, p) for all parameters p of a box P at once, and what follows from them, to first order in p.
//
// Evaluating formulas over wide balls treats every occurrence of a parameter as a different one. Here each
// quantity g is instead g(x(p0), p0) + dg/dp (P - p0), p0 = mid P, with the total derivative dg/dp over the
// whole box, by jets; dx/dp = -(df/dx)⁻¹ df/dp. This is the mean value theorem, not an approximation.
//
// f is any functor with as many equations as unknowns and any number of parameters, with, for T = Ball and
// ParameterJet,
//   template <class T>
//   VectorOf<T> closing(const VectorOf<T>& x, const VectorOf<T>& p) const
// Parameters that are exact numbers cost nothing: jets have partials for the others only.
#pragma once

#include <vector>

#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::zeros {

template <class T>
using VectorOf = Eigen::Matrix<T, Eigen::Dynamic, 1>;
using Vector = VectorOf<Ball>;
using Matrix = BallMatrix<Eigen::Dynamic>;
using ParameterJet = scalars::Jet<Ball, Eigen::Dynamic>;

// f as a function of x alone at fixed parameters.
template <class F>
struct AtParameters {
  const F& f;
  Vector p;

  template <class T>
  [[nodiscard]] VectorOf<T> operator()(const VectorOf<T>& x) const {
    return f.template closing<T>(x, p.template cast<T>());
  }
};

// The zeros as functions of the parameters, and how quantities that depend on both are bounded over the box.
struct ParametricProof {
  Verdict verdict;              // of "for each p in P there is exactly one zero x(p) in `unique`"
  Vector p0;                    // mid P
  Vector at_middle;             // contains x(p0)
  Vector box;                   // contains x(p) for all p
  Vector unique;                // contains no other zero, for any p
  VectorOf<ParameterJet> x, p;  // as jets by those parameters that are no exact numbers
  Vector spread;                // P - p0 of those
  // Meaningless unless proved, except for this: the parameter that widens the first Krawczyk image most.
  int widest = 0;

  // A quantity g(x(p), p) over the whole box: its value at the middle plus its derivative times the spread,
  // or the value that the jet carries where that is narrower.
  [[nodiscard]] Ball over_box(const ParameterJet& g, const Ball& middle) const {
    Ball sum = middle;
    for (int j = 0; j < spread.size(); ++j) {
      sum += g.partial(j) * spread(j);
    }
    return intersection(sum, g.value).value_or(sum);
  }
};

namespace detail {

// The inexact parameters' places.
[[nodiscard]] inline std::vector<int> inexact(const Vector& P) {
  std::vector<int> places;
  for (int j = 0; j < P.size(); ++j) {
    if (!P(j).is_exact()) {
      places.push_back(j);
    }
  }
  return places;
}

// Arguments as jets; those at the places are the variables first, first + 1, … of `count`.
[[nodiscard]] inline VectorOf<ParameterJet> as_jets(const Vector& values, const std::vector<int>& places,
                                                    int first, int count) {
  VectorOf<ParameterJet> jets = values.cast<ParameterJet>();
  for (const int place : places) {
    jets(place) = ParameterJet::variable(values(place), first++, count);
  }
  return jets;
}

// Contains all D with (I - E) D = R for members of the balls. In the norm max |v_i|/w_i, w the radii of X,
// each member of E is smaller than q < 1, so each column of D is bounded by that of R over 1 - q; then D = R
// + E D. Nothing when q < 1 is not certain.
[[nodiscard]] inline std::optional<Matrix> solve_near_identity(const Matrix& E, const Matrix& R,
                                                               const Vector& X) {
  const auto grow = [](Ball& largest, const Ball& x) {
    arb_max(largest.raw(), largest.raw(), x.upper().raw(), WorkingPrecision::bits());
  };
  Ball q(0);
  for (int i = 0; i < X.size(); ++i) {
    Ball row(0);
    for (int j = 0; j < X.size(); ++j) {
      row += abs(E(i, j)) * X(j).radius() / X(i).radius();
    }
    grow(q, row);
  }
  if (!(q - Ball(1)).is_negative()) {
    return std::nullopt;
  }
  Matrix D = R;
  for (int j = 0; j < R.cols(); ++j) {
    Ball norm(0);
    for (int i = 0; i < X.size(); ++i) {
      grow(norm, abs(R(i, j)) / X(i).radius());
    }
    for (int i = 0; i < X.size(); ++i) {
      D(i, j) = scalars::within(norm / (Ball(1) - q) * X(i).radius());
    }
  }
  D = (R + product(E, D)).eval();
  return Matrix(R + product(E, D));
}

// The column of R whose parameter moves the zero most.
[[nodiscard]] inline int widest_column(const Matrix& R, const Vector& spread) {
  int widest = 0;
  double most = -1;
  for (int j = 0; j < R.cols(); ++j) {
    for (int i = 0; i < R.rows(); ++i) {
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

// A zero at the parameters p near the guess: Newton's method, then a box that grows by Krawczyk's image.
template <class F>
[[nodiscard]] ZeroProof<Eigen::Dynamic> prove_zero_at(const F& f, const Vector& p, const Vector& guess) {
  const AtParameters<F> at_p{f, p};
  Vector m = midpoint<Eigen::Dynamic>(guess);
  for (int k = 0; k < 7; ++k) {
    const std::optional<Vector> better = newton<Ball, Eigen::Dynamic>(at_p, m, 1);
    if (!better) {
      break;
    }
    const Vector step = *better - m;
    m = midpoint<Eigen::Dynamic>(*better);
    const auto is_small = [](const Ball& x) { return std::abs(x.approximate()) < 0x1p-50; };
    if (std::all_of(step.begin(), step.end(), is_small)) {
      break;
    }
  }
  return prove_zero_by_inflation<Eigen::Dynamic>(at_p, m);
}

// One zero for each p in P, near the guess. x(p0) is found first; then the box grows with Krawczyk's image
//   x(p0) + R (P - p0) + E (X - x(p0)),  R = -Y f_p(X, P),  E = I - Y f_x(X, P),
// until that lies inside it. Undecided when it does not: split P, best in the parameter `widest`.
template <class F>
[[nodiscard]] ParametricProof prove_over_parameters(const F& f, const Vector& P, const Vector& guess) {
  const auto n = static_cast<int>(guess.size());
  const std::vector<int> wide = detail::inexact(P);
  const auto m = static_cast<int>(wide.size());
  ParametricProof result;
  result.p0 = midpoint<Eigen::Dynamic>(P);
  result.spread = Vector(P - result.p0)(wide);
  const ZeroProof<Eigen::Dynamic> middle = prove_zero_at(f, result.p0, guess);
  result.verdict = middle.verdict;
  if (middle.verdict.truth != Truth::proved) {
    return result;
  }
  result.at_middle = middle.box;
  const VectorOf<ParameterJet> p = detail::as_jets(P, wide, n, n + m);
  Vector X = inflate<Eigen::Dynamic>(middle.box, 2);
  for (int round = 0; round < 16; ++round) {
    const VectorOf<ParameterJet> x = scalars::variables<Ball, Eigen::Dynamic>(X);
    const Matrix slope = scalars::jacobian<Ball, Eigen::Dynamic, Eigen::Dynamic>(
        f.template closing<ParameterJet>(x, p), n + m);
    const Matrix by_x = slope.leftCols(n);
    const std::optional<Matrix> Y = approximate_inverse<Ball, Eigen::Dynamic>(by_x);
    if (!Y) {
      break;
    }
    const Matrix E = Matrix::Identity(n, n) - product(*Y, by_x);
    const Matrix R = -product(*Y, slope.rightCols(m));
    const Vector by_parameters = product(R, result.spread);
    const Vector K = result.at_middle + by_parameters + product(E, Vector(X - result.at_middle));
    if (round == 0 && m > 0) {
      result.widest = wide[static_cast<std::size_t>(detail::widest_column(R, result.spread))];
    }
    if (is_interior<Eigen::Dynamic>(K, X)) {
      const std::optional<Matrix> D = detail::solve_near_identity(E, R, X);
      if (!D) {
        break;
      }
      result.unique = X;
      result.box = *intersection<Eigen::Dynamic>(K, Vector(result.at_middle + product(*D, result.spread)));
      result.p = detail::as_jets(P, wide, 0, m);
      result.x = result.box.cast<ParameterJet>();
      for (int i = 0; i < n; ++i) {
        result.x(i).partials.assign(D->row(i).begin(), D->row(i).end());
      }
      return result;
    }
    for (int i = 0; i < n; ++i) {
      const Ball r = K(i).radius() * Ball(1.2) + Ball(0x1p-80);
      if (!(r - Ball(2 * std::max(1.0, std::abs(K(i).approximate())))).is_negative()) {
        result.verdict = Verdict::undecided("the box outgrows every bound: split the parameters");
        return result;
      }
      X(i) = K(i).midpoint() + Ball::hull(-r, r);
    }
  }
  result.verdict = Verdict::undecided("no box around the guess passed Krawczyk's test: split the parameters");
  return result;
}

// Whether X, a box around that of the proof, holds no zero but the proof's either, for any p: by Krawczyk's
// test. False also when it is not known.
template <class F>
[[nodiscard]] bool holds_one_zero(const F& f, const ParametricProof& proof, const Vector& X) {
  const auto n = static_cast<int>(X.size());
  const VectorOf<ParameterJet> p =
      proof.p.unaryExpr([](const ParameterJet& q) { return ParameterJet(q.value); });
  const Matrix by_x = scalars::jacobian<Ball, Eigen::Dynamic, Eigen::Dynamic>(
      f.template closing<ParameterJet>(scalars::variables<Ball, Eigen::Dynamic>(X), p), n);
  const std::optional<Matrix> Y = approximate_inverse<Ball, Eigen::Dynamic>(by_x);
  if (!Y) {
    return false;
  }
  // Two zeros x, y in X: (I - E)(x - y) = 0 for a member of E, so none are two where E has a norm below 1.
  const Matrix E = Matrix::Identity(n, n) - product(*Y, by_x);
  return detail::solve_near_identity(E, Matrix::Zero(n, 1), X).has_value();
}

}  // namespace stickslip::numeric::zeros
