// The closing conditions of Section 5 as the paper writes them: the five linear equations (21) for z10, z20
// and z1'(0) with the coefficients (47)-(51) of Appendix 3, Cramer's rule (22) and what remains for tau and
// tau1, (23).
//
// Derivation. Z_C = H(tau + tau1)(Z0 - F0) + F_C + 2 L(tau1) d0 is the state after the slip (5) and the
// overshoot (8), and (20) with the stick (10) says Z_C = Gamma(-T) Z0, T = Theta - tau - tau1. Its components
// z1, z2, z1' are equations 1, 2, 3; z2' at tau (18) and at tau + tau1 (19) equal to V are 4 and 5; z2'(0) =
// V. Gamma_1 is even and Gamma_2, Gamma_3 are odd in T, which decides the signs in front of Gamma_ij.
#pragma once

#include <array>
#include <utility>

#include "model/flows.hpp"

namespace stickslip::model {

// What (47)-(51) are written in. Entries of a matrix count from 1 in the paper.
template <class S>
struct Appendix3Letters {
  Matrix4<S> H, h, Htilde;  // H(tau), H(tau1), H(tau + tau1)
  Matrix4<S> Gamma;         // Gamma(T)
  Vector2<S> Q, d0;
  S omega, V, T;
  S phi, phiB, phiC;  // the load's phase at 0, tau, tau + tau1
};

template <class S>
[[nodiscard]] Appendix3Letters<S> appendix3_letters(const S& chi, const Modes<S>& m, const Vector2<S>& Q,
                                                    const Vector2<S>& d0, const S& omega, const S& V,
                                                    const S& phi, const S& tau, const S& tau1, const S& T) {
  const S phiB = omega * tau + phi;
  const S phiC = phiB + omega * tau1;
  return {H<S>(m, tau), H<S>(m, tau1), H<S>(m, S(tau + tau1)), Gamma<S>(chi, T), Q, d0, omega, V, T, phi,
          phiB,         phiC};
}

// (21): equation i is a[i-1] z10 + b[i-1] z20 + c[i-1] z1'(0) + d[i-1] = 0.
template <class S>
struct ClosingCoefficients {
  std::array<S, 5> a, b, c, d;
};
// Calls visit(letter, i, coefficient), i from 1, for each of the twenty.
template <class Coefficients, class Visit>
void each_coefficient(Coefficients& k, const Visit& visit) {
  for (const auto& [letter, column] : {std::pair{'a', &k.a}, {'b', &k.b}, {'c', &k.c}, {'d', &k.d}}) {
    for (int i = 1; i <= 5; ++i) {
      visit(letter, i, column->at(static_cast<std::size_t>(i) - 1));
    }
  }
}

// c_1 is printed with the other sign of Gamma_13; nothing else differs.
enum class Reading { derived, printed };

// (47)-(51).
template <class S>
[[nodiscard]] ClosingCoefficients<S> appendix3(const Appendix3Letters<S>& l,
                                               Reading reading = Reading::derived) {
  using std::cos;
  using std::sin;
  const S one(1);
  const S two(2);
  const S cos_phi = S(cos(l.phi));
  const S sin_phi = S(sin(l.phi));
  // The entries of row i of a matrix, counted from 1, where the paper has them.
  const auto H = [&](int i, int j) -> const S& { return l.H(i - 1, j - 1); };
  const auto h = [&](int i, int j) -> const S& { return l.h(i - 1, j - 1); };
  const auto Ht = [&](int i, int j) -> const S& { return l.Htilde(i - 1, j - 1); };
  const auto G = [&](int i, int j) -> const S& { return l.Gamma(i - 1, j - 1); };
  const S& q1 = l.Q(0);
  const S& q2 = l.Q(1);
  const S& d01 = l.d0(0);
  const S& d02 = l.d0(1);
  const S c1 = reading == Reading::printed ? S(Ht(1, 3) - G(1, 3)) : S(Ht(1, 3) + G(1, 3));
  // -(x1 q1 + x2 q2) cos(phi) + omega (x3 q1 + x4 q2) sin(phi): what -F0 contributes.
  const auto load = [&](const S& x1, const S& x2, const S& x3, const S& x4) {
    return S(l.omega * S(x3 * q1 + x4 * q2) * sin_phi - S(x1 * q1 + x2 * q2) * cos_phi);
  };
  return {
      {S(Ht(1, 1) - G(1, 1)), Ht(2, 1), S(Ht(3, 1) + G(3, 1)), H(4, 1), Ht(4, 1)},
      {S(Ht(1, 2) - G(1, 2)), S(Ht(2, 2) - one), S(Ht(3, 2) + G(3, 2)), H(4, 2), Ht(4, 2)},
      {c1, Ht(2, 3), S(Ht(1, 1) - G(1, 1)), H(2, 1), Ht(2, 1)},
      {S(load(Ht(1, 1), Ht(1, 2), Ht(1, 3), Ht(1, 4)) + q1 * S(cos(l.phiC)) + two * (h(1, 1) - one) * d01 +
         two * h(1, 2) * d02 + (Ht(1, 4) + G(1, 4)) * l.V),
       S(load(Ht(2, 1), Ht(2, 2), Ht(2, 3), Ht(2, 4)) + q2 * S(cos(l.phiC)) + two * h(2, 1) * d01 +
         two * (h(2, 2) - one) * d02 + (Ht(2, 4) + l.T) * l.V),
       S(load(Ht(3, 1), Ht(3, 2), Ht(1, 1), Ht(1, 2)) - l.omega * q1 * S(sin(l.phiC)) + two * h(3, 1) * d01 +
         two * h(3, 2) * d02 + (Ht(1, 2) - G(1, 2)) * l.V),
       S((H(2, 2) - one) * l.V - q2 * l.omega * S(sin(l.phiB)) + load(H(4, 1), H(4, 2), H(2, 1), H(2, 2))),
       S((Ht(2, 2) - one) * l.V - q2 * l.omega * S(sin(l.phiC)) +
         load(Ht(4, 1), Ht(4, 2), Ht(2, 1), Ht(2, 2)) + two * (h(4, 1) * d01 + h(4, 2) * d02))}};
}

// (22): z10 = Delta1/Delta, z20 = Delta2/Delta, z1'(0) = Delta3/Delta, from equations 1, 2, 3 where Delta is
// not zero.
template <class S>
struct CramerDeterminants {
  S Delta, Delta1, Delta2, Delta3;
};

template <class S>
[[nodiscard]] CramerDeterminants<S> cramer(const ClosingCoefficients<S>& k) {
  // The determinant with these columns, in rows 1, 2, 3.
  const auto det = [](const std::array<S, 5>& x, const std::array<S, 5>& y, const std::array<S, 5>& z) {
    return S(x[0] * S(y[1] * z[2] - y[2] * z[1]) - x[1] * S(y[0] * z[2] - y[2] * z[0]) +
             x[2] * S(y[0] * z[1] - y[1] * z[0]));
  };
  return {det(k.a, k.b, k.c), S(-det(k.d, k.b, k.c)), det(k.d, k.a, k.c), det(k.d, k.b, k.a)};
}

// (23): F_1 and F_2, both zero where all five equations have a solution; conversely, where Delta is not zero.
template <class S>
[[nodiscard]] std::array<S, 2> compatibility(const ClosingCoefficients<S>& k) {
  const CramerDeterminants<S> c = cramer<S>(k);
  const auto F = [&](std::size_t row) {
    return S(k.a[row] * c.Delta1 + k.b[row] * c.Delta2 + k.c[row] * c.Delta3 + k.d[row] * c.Delta);
  };
  return {F(3), F(4)};
}

}  // namespace stickslip::model
