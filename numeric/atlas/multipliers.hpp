// Whether all multipliers of an admissible orbit lie inside the unit circle, over any scalar with enclosures:
// without the multipliers, for each family by what is particular to it. T has a member `over`, its enclosure.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "core/verdict.hpp"
#include "numeric/atlas/along.hpp"
#include "numeric/motion/multipliers.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

// Orbits that never stick. Admissible ones are stable, except for coincidences of frequencies.
//
// On C⁴ let E(w) = (w'* M w' + w* M K w)/2, M = diag(eta, 1), for which M K is symmetric and positive
// definite. The flow H of a deviation w keeps E. A crossing of the belt multiplies w2' by rho = a+/a, the
// accelerations x2'' = eta (u - r) after and before it. By (26) r < -ur < -us where an overshoot begins, so
// rho = (-us - r)/(us - r) lies in (0, 1), and by (25) likewise rho = (r - us)/(r + us) where a slip begins:
// E falls by (1 - rho²) |w2'|²/2. So no multiplier exceeds 1 in size. If |mu| = 1 and Phi w = mu w, nothing
// is lost at either crossing: w2'(0) = w2'(tau) = 0, and H(Theta) w = mu w. Hence w is a sum of modes
// exp(i nu t) with nu among ±omega1, ±omega2 and exp(i nu Theta) = mu. One mode alone has no zero of w2', for
// lambda_j ≠ 0. Two, nu and nu', may have one at 0, and then have one at tau if and only if
// exp(i (nu - nu') tau) = 1. Here |nu - nu'| is one of 2 omega1, 2 omega2, omega1 + omega2, omega2 - omega1,
// and a whole multiple k omega since both have the same mu; with tau = u Theta the rest reads: k u is whole.
// Three modes with one mu make three of those four such multiples.
//
// Proved unless a member may be such a coincidence; then undecided. share is u.
template <class T>
[[nodiscard]] Decision stability_without_stick(const model::Oscillator<T>& o, const T& share) {
  const model::Modes<T>& m = o.modes;
  int multiples = 0;
  for (const T& difference :
       {T(T(2) * m.omega1), T(T(2) * m.omega2), T(m.omega1 + m.omega2), T(m.omega2 - m.omega1)}) {
    const auto [low, high] = scalars::ends(T(difference / o.data.omega).over);
    const double k = std::max(std::ceil(low), 1.0);
    if (high < k) {
      continue;
    }
    ++multiples;
    if (!(high < k + 1)) {
      return {Truth::undecided};
    }
    const auto [least, greatest] = scalars::ends(T(T(static_cast<int>(k)) * share).over);
    if (!(greatest < std::ceil(least))) {
      return {Truth::undecided};
    }
  }
  return {multiples < 3 ? Truth::proved : Truth::undecided};
}

// The elementary symmetric functions e1, e2, e3 of the three multipliers of a motion that slips for tau and
// sticks for `lasts`, besides the multiplier 0 of its landing.
//
// The map is seen where the stick begins, for deviations (z1, z2, z1'): G, the first three rows and columns
// of Gamma(T); at the break-away the deviation s (z1, z2, z1') of z2', s a row with s3 = 0; then the slip, H
// = H(tau), after which z2' is dropped. With H3 the first three rows and columns of H, h the first three of
// its last column, the map is A G, A = H3 + h s.
//   e1 = tr(H3 G) + s G h.
//   e3 = det A, since det G = 1. The graph of s has the normal q0 = (-s, 1), so with det H = 1
//   det A = (q0 H⁻¹)4, and adj A = e3 (H⁻¹)3 - p q, p and q the first three of H⁻¹ e4 and of q0 H⁻¹.
//   e2 = tr(adj(A G)) = e3 tr(G⁻¹ (H⁻¹)3) - q G⁻¹ p.
// Both flows are reversible: H⁻¹ = R H R with R = diag(-1, -1, 1, 1), and so is G. Hence
//   e3 = H44 + s h,  e2 = e3 tr(H3 G) - w G h,  w the first three of (s, 1) H.
//
// s = kappa (-1, 1, 0), kappa = chi x2''(0+)/r' (model/saltation.hpp).
template <class T>
[[nodiscard]] std::array<T, 3> symmetric_functions(const T& chi, const model::Modes<T>& modes, const T& tau,
                                                   const T& lasts, const T& kappa) {
  const auto [sine1, cosine1] = sin_cos(T(modes.omega1 * tau));
  const auto [sine2, cosine2] = sin_cos(T(modes.omega2 * tau));
  const auto [sine, cosine] = sin_cos(lasts);
  const T d = T(1) / T(modes.lambda2 - modes.lambda1);
  // Lambda diag(a, b) Lambda⁻¹ (38).
  const auto block = [&](const T& a, const T& b) {
    const T first = d * a, second = d * b, difference = second - first;
    return model::matrix<T>(T(modes.lambda2 * first - modes.lambda1 * second), difference,
                            T(-modes.lambda1 * modes.lambda2 * difference),
                            T(modes.lambda2 * second - modes.lambda1 * first));
  };
  const model::Matrix2<T> H1 = block(cosine1, cosine2);
  const model::Matrix2<T> H2 = block(T(sine1 / modes.omega1), T(sine2 / modes.omega2));
  const model::Matrix2<T> H3 = block(T(-modes.omega1 * sine1), T(-modes.omega2 * sine2));
  // By (41) G = [[c, chi (1 - c), s], [0, 1, 0], [-s, chi s, c]], c = cos(lasts), s = sin(lasts).
  const std::array<T, 3> h{H2(0, 1), H2(1, 1), H1(0, 1)};
  const std::array<T, 3> Gh{T(cosine * h[0] + chi * T(T(1) - cosine) * h[1] + sine * h[2]), h[1],
                            T(sine * T(chi * h[1] - h[0]) + cosine * h[2])};
  const T trace = T(2) * cosine * H1(0, 0) + sine * T(H3(0, 0) - H2(0, 0)) +
                  chi * T(T(T(1) - cosine) * H1(1, 0) + sine * H2(1, 0)) + H1(1, 1);
  const T along_s = Gh[1] - Gh[0];  // s G h, without kappa
  const T along_w = (kappa * T(H1(1, 0) - H1(0, 0)) + H3(1, 0)) * Gh[0] +
                    (kappa * T(H1(1, 1) - H1(0, 1)) + H3(1, 1)) * Gh[1] +
                    (kappa * T(H2(1, 0) - H2(0, 0)) + H1(1, 0)) * Gh[2];
  const T e3 = H1(1, 1) + kappa * T(h[1] - h[0]);
  return {T(trace + kappa * along_s), T(e3 * trace - along_w), e3};
}

// Whether the zeros a, b, c of x³ - e1 x² + e2 x - e3, for real e1, e2, e3, all lie inside the unit circle;
// at_one has the sign of 1 - e1 + e2 - e3.
// Proved if these four are positive for every member, refuted (one lies outside) if one of them is negative:
//   (1-a)(1-b)(1-c) = 1 - e1 + e2 - e3,           (1+a)(1+b)(1+c) = 1 + e1 + e2 + e3,
//   (1-ab)(1-bc)(1-ca) = 1 - e2 + e1 e3 - e3²,    1 - (abc)² = 1 - e3².
// For inside the circle each factor is positive, or one of two conjugate ones. Now let all four be positive.
// If b and c are conjugate, the first two say |a| < 1, and the third is (1 - |b|²) |1 - ab|². If all are
// real, an even number of them exceeds 1, and an even number is less than -1. If a, b > 1, then |c| <= 1 and
// by the third (1 - bc)(1 - ca) < 0, say ca > 1: then abc > 1, against the fourth. As well for a, b < -1.
template <class T>
[[nodiscard]] Decision is_inside_unit_circle(const std::array<T, 3>& e, const T& at_one) {
  const auto& [e1, e2, e3] = e;
  const T square = e3 * e3;
  bool all = true;
  Hope hope{true};
  for (const T& quantity :
       {T(T(1) - square), at_one, T(T(1) + e1 + e2 + e3), T(T(1) - e2 + e1 * e3 - square)}) {
    const Decision decision = decide_positive(quantity);
    if (decision.truth == Truth::refuted) {
      return {Truth::refuted};
    }
    if (decision.truth == Truth::undecided) {
      all = false;
      hope = hope.of_both(decision.hope);
    }
  }
  return {all ? Truth::proved : Truth::undecided, hope};
}

}  // namespace stickslip::numeric::atlas
