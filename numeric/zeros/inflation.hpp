// ε-inflation: existence where the size of the box to test is not known beforehand, over whole boxes of
// parameters too.
#pragma once

#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::zeros {

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
