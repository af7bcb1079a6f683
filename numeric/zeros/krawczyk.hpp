// Existence and uniqueness of zeros of f: Rⁿ → Rⁿ by Krawczyk's test, and their enclosure to any precision.
//
// A function is a functor with
//   template <class T> Eigen::Matrix<T, N, 1> operator()(const Eigen::Matrix<T, N, 1>& x) const
// for T = S and T = Jet<S, N>, whose data are scalars of kind S. A recipe is a callable that returns such a
// functor over balls with its data rounded at the working precision of the moment.
//
// N is known to the compiler where speed counts; Eigen::Dynamic serves problems of any size.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "core/verdict.hpp"
#include "numeric/scalars/jet.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::zeros {

template <int N>
using Box = Eigen::Matrix<Ball, N, 1>;

// f(x) and its Jacobian there.
template <class S, int N, class F>
[[nodiscard]] std::pair<Eigen::Matrix<S, N, 1>, Eigen::Matrix<S, N, N>> linearise(
    const F& f, const Eigen::Matrix<S, N, 1>& x) {
  const Eigen::Matrix<scalars::Jet<S, N>, N, 1> jets = f(scalars::variables<S, N>(x));
  return {scalars::values<S, N, N>(jets), scalars::jacobian<S, N, N>(jets, static_cast<int>(x.size()))};
}

template <int N>
[[nodiscard]] Box<N> midpoint(const Box<N>& box) {
  return midpoints(box);
}

// Every component strictly inside.
template <int N>
[[nodiscard]] bool is_interior(const Box<N>& inner, const Box<N>& outer) {
  for (int i = 0; i < inner.size(); ++i) {
    if (!inner(i).is_finite() || !inner(i).is_interior_to(outer(i))) {
      return false;
    }
  }
  return true;
}

// Whether all members of one box are in the other.
template <int N>
[[nodiscard]] bool contains(const Box<N>& outer, const Box<N>& inner) {
  for (int i = 0; i < inner.size(); ++i) {
    if (!outer(i).contains(inner(i))) {
      return false;
    }
  }
  return true;
}

// A ball that contains every common member; nothing when there is none.
[[nodiscard]] inline std::optional<Ball> intersection(const Ball& a, const Ball& b) {
  Ball common;
  if (arb_intersection(common.raw(), a.raw(), b.raw(), WorkingPrecision::bits()) == 0) {
    return std::nullopt;
  }
  return common;
}

template <int N>
[[nodiscard]] std::optional<Box<N>> intersection(const Box<N>& a, const Box<N>& b) {
  Box<N> common = a;
  for (int i = 0; i < a.size(); ++i) {
    const std::optional<Ball> c = intersection(a(i), b(i));
    if (!c) {
      return std::nullopt;
    }
    common(i) = *c;
  }
  return common;
}

// Krawczyk's operator K(X) = m - Y f(m) + (I - Y f'(X)) (X - m), m in X, Y near f'(m)⁻¹. Every zero of f in
// X lies in K(X); if K(X) lies in the interior of X then f has exactly one zero in X. Nothing when f'(X) is
// not finite or its midpoint is singular.
template <int N, class S = Ball>
[[nodiscard]] std::optional<Eigen::Matrix<S, N, 1>> krawczyk_image(
    const std::type_identity_t<Eigen::Matrix<S, N, 1>>& m,
    const std::type_identity_t<Eigen::Matrix<S, N, 1>>& at_m,
    const std::type_identity_t<Eigen::Matrix<S, N, N>>& slope,
    const std::type_identity_t<Eigen::Matrix<S, N, 1>>& X) {
  using SquareMatrix = Eigen::Matrix<S, N, N>;
  const std::optional<SquareMatrix> Y = approximate_inverse<S, N>(slope);
  if (!Y) {
    return std::nullopt;
  }
  const SquareMatrix rest = SquareMatrix::Identity(X.size(), X.size()) - product(*Y, slope);
  const Eigen::Matrix<S, N, 1> K = m - product(*Y, at_m) + product(rest, Eigen::Matrix<S, N, 1>(X - m));
  for (int i = 0; i < K.size(); ++i) {
    if (!K(i).is_finite()) {
      return std::nullopt;
    }
  }
  return K;
}

// The same for a function, about the box's midpoint.
template <int N, class F>
[[nodiscard]] std::optional<Box<N>> krawczyk_operator(const F& f, const Box<N>& X) {
  const Box<N> m = midpoint<N>(X);
  return krawczyk_image<N>(m, f(m), linearise<Ball, N>(f, X).second, X);
}

// A proof that f has exactly one zero in `unique`, and that it lies in `box`; or the reason why it failed.
template <int N>
struct ZeroProof {
  Verdict verdict;  // of "there is exactly one zero in `unique`"
  Box<N> box;       // contains the zero; meaningless unless proved
  Box<N> unique;    // contains no other
};

// The conclusion of Krawczyk's test on X as it stands: no inflation, no search.
template <int N, class F>
[[nodiscard]] ZeroProof<N> krawczyk_test(const F& f, const Box<N>& X) {
  const std::optional<Box<N>> K = krawczyk_operator<N>(f, X);
  if (!K) {
    return {Verdict::undecided("the Jacobian over the box is unbounded or singular at its midpoint"), X, X};
  }
  if (is_interior<N>(*K, X)) {
    return {Verdict::proved(), *K, X};
  }
  if (!intersection<N>(*K, X)) {
    return {Verdict::refuted("Krawczyk's image of the box is disjoint from it: the box holds no zero"), X, X};
  }
  return {Verdict::undecided("Krawczyk's image of the box does not lie inside it"), X, X};
}

// The box with the same midpoint whose radii are `radius` times the scale of each component, max(1, |mid|).
template <int N>
[[nodiscard]] Box<N> box_around(const Box<N>& point, double radius) {
  Box<N> box = point;
  for (int i = 0; i < point.size(); ++i) {
    const Ball m = point(i).midpoint();
    const Ball r = Ball(radius * std::max(1.0, std::abs(m.approximate())));
    box(i) = m + Ball::hull(-r, r);
  }
  return box;
}

// The box enlarged about its midpoint by the factor.
template <int N>
[[nodiscard]] Box<N> inflate(const Box<N>& box, double factor) {
  Box<N> larger = box;
  for (int i = 0; i < box.size(); ++i) {
    const Ball r = box(i).radius() * Ball(factor) + Ball(1e-18);
    larger(i) = box(i).midpoint() + Ball::hull(-r, r);
  }
  return larger;
}

// Newton's method in floats from x until the step no longer shrinks, at most `steps` times. A proposal:
// nothing when a Jacobian is singular or the iteration leaves the finite numbers.
template <class S, int N, class F>
[[nodiscard]] std::optional<Eigen::Matrix<S, N, 1>> newton(const F& f, Eigen::Matrix<S, N, 1> x, int steps) {
  for (int k = 0; k < steps; ++k) {
    const auto [value, slope] = linearise<S, N>(f, x);
    const std::optional<Eigen::Matrix<S, N, N>> Y = approximate_inverse<S, N>(slope);
    if (!Y) {
      return std::nullopt;
    }
    x -= product(*Y, value);
    for (int i = 0; i < x.size(); ++i) {
      if (!std::isfinite(magnitude(x(i)))) {
        return std::nullopt;
      }
    }
  }
  return x;
}

// The largest radius of a component, as a power of two: 2^result bounds it from above. Very negative for an
// exact box.
template <int N>
[[nodiscard]] long radius_exponent(const Box<N>& box) {
  long largest = -1000000000L;
  for (int i = 0; i < box.size(); ++i) {
    if (!box(i).is_exact()) {
      largest = std::max(largest, fmpz_get_si(MAG_EXPREF(arb_radref(box(i).raw()))));
    }
  }
  return largest;
}

// Shrinks a proved enclosure until its radii are below 2^-bits: one Krawczyk step at each precision, doubling
// it from 128 bits up. Returns the best enclosure reached (always correct); it falls short only where the
// problem is too ill-conditioned for 256 guard bits.
template <int N, class Recipe>
[[nodiscard]] Box<N> refine(const Recipe& recipe, Box<N> box, long bits) {
  long precision = 128;
  for (int stalled = 0; stalled < 3 && radius_exponent<N>(box) > -bits;) {
    const long before = radius_exponent<N>(box);
    precision = std::clamp(-2 * before + 64, 128L, bits + 64 + 64 * stalled);
    const WorkingPrecision scope(precision);
    const Box<N> m = midpoint<N>(box);
    const Box<N> at_m = recipe()(m);
    const BallMatrix<N> slope = [&] {  // no sharper than the box is small
      const WorkingPrecision half(std::clamp(-before + 64, 64L, precision));
      return linearise<Ball, N>(recipe(), box).second;
    }();
    const std::optional<Box<N>> K = krawczyk_image<N>(m, at_m, slope, box);
    const std::optional<Box<N>> smaller = K ? intersection<N>(*K, box) : std::nullopt;
    if (smaller) {
      box = *smaller;
    }
    stalled = radius_exponent<N>(box) < before ? 0 : stalled + 1;
  }
  return box;
}

// ε-inflation: existence where the size of the box to test is not known beforehand, over whole boxes of
// parameters too.

// Whether f has exactly one zero near the guess, for each member of the balls that f holds as data. The box
// grows to a fifth more than Krawczyk's image of it until the image lies inside. Undecided when the image
// keeps outgrowing the box: for wide data, split them. `box` contains the zero of every member, `unique` no
// other.
template <int N, class F>
[[nodiscard]] ZeroProof<N> prove_zero_by_inflation(const F& f, const Box<N>& guess) {
  Box<N> X = box_around<N>(guess, 0x1p-60);
  for (int round = 0; round < 24; ++round) {
    const std::optional<Box<N>> K = krawczyk_operator<N>(f, X);
    if (!K) {
      break;
    }
    if (is_interior<N>(*K, X)) {
      return {Verdict::proved(), *K, X};
    }
    for (int i = 0; i < X.size(); ++i) {
      const Ball r = (*K)(i).radius() * Ball(1.2) + Ball(0x1p-80);
      if (!(r - Ball(2)).is_negative()) {
        return {Verdict::undecided("the box outgrows every bound: split the parameters"), guess, guess};
      }
      X(i) = (*K)(i).midpoint() + Ball::hull(-r, r);
    }
  }
  return {Verdict::undecided("no box around the guess passed Krawczyk's test: split the parameters"), guess,
          guess};
}

}  // namespace stickslip::numeric::zeros
