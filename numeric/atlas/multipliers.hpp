// Whether all multipliers of a motion lie inside the unit circle, by the coefficients of their polynomial:
// over any scalar with enclosures, without the multipliers.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/verdict.hpp"
#include "numeric/motion/monodromy.hpp"

namespace stickslip::numeric::atlas {

// The characteristic polynomial x^n + c[n-1] x^(n-1) + … + c[0] of the return map's derivative, for a motion
// with at most one stick: n = 4 without, n = 3 with one, the map being seen where it begins. The same as that
// of motion/monodromy.hpp, by formulas in which little cancels, over wide boxes too.
//
// Phi, the product of the flows H and of the crossings diag(1, 1, 1, rho), has a known inverse, H(-t) and
// 1/rho, and a known determinant, the product of all rho. Without stick, with traces,
//   c[3] = -tr Phi,  c[2] = ((tr Phi)² - tr Phi²)/2,  c[1] = -det tr Phi⁻¹,  c[0] = det.
// A stick begins without deviation of z2' and ends with (I + e4 s) Gamma, s a row with s4 = 0. So the map is
// A G, G the first three rows and columns of Gamma, det G = 1, and A those of Phi (I + e4 s). With
// r = (-s, 1), q = r Phi⁻¹ and p the last column of Phi⁻¹, K = Phi with its last row replaced by r has
//   det K = det Phi q4 = det A,  K⁻¹ = Phi⁻¹ - p (q - e4)/q4,  whose first three rows and columns are A⁻¹.
template <class T>
[[nodiscard]] std::vector<T> characteristic_polynomial(const motion::MotionOf<T>& motion) {
  using Matrix4 = model::Matrix4<T>;
  const auto times = [](const auto& a, const auto& b) { return a.lazyProduct(b).eval(); };
  const auto trace = [](const auto& a) {
    T sum = a(0, 0);
    for (int i = 1; i < a.rows(); ++i) {
      sum += a(i, i);
    }
    return sum;
  };
  const model::Oscillator<T>& o = motion.oscillator;
  const std::size_t count = motion.phases.size();
  std::size_t stick = count;
  for (std::size_t k = 0; k < count; ++k) {
    if (motion.phases[k].kind == motion::PhaseKind::stick) {
      if (stick < count) {
        throw InternalError("a motion with two sticks");
      }
      stick = k;
    }
  }
  const bool sticks = stick < count;
  Matrix4 Phi = Matrix4::Identity();
  Matrix4 inverse = Matrix4::Identity();
  T det(1);
  const auto cross = [&](motion::PhaseKind before, const motion::PhaseOf<T>& next) {
    const T rho = motion::saltation_between<T>(o, before, next)(3, 3);
    for (int i = 0; i < 4; ++i) {
      Phi(3, i) = rho * Phi(3, i);
      inverse(i, 3) = inverse(i, 3) / rho;
    }
    det = det * rho;
  };
  const std::size_t first = sticks ? stick + 1 : 0;
  for (std::size_t k = 0; k + (sticks ? 1 : 0) < count; ++k) {
    const motion::PhaseOf<T>& phase = motion.phases[(first + k) % count];
    if (k > 0) {
      cross(motion.phases[(first + k - 1) % count].kind, phase);
    }
    Phi = times(model::H<T>(o.modes, phase.duration), Phi);
    inverse = times(inverse, model::H<T>(o.modes, T(-phase.duration)));
  }
  if (!sticks) {
    cross(motion.phases.back().kind, motion.phases.front());
    const T sum = trace(Phi);
    return {det, T(-det * trace(inverse)), T((sum * sum - trace(times(Phi, Phi))) / T(2)), T(-sum)};
  }
  const Matrix4 break_away =
      motion::saltation_between<T>(o, motion::PhaseKind::stick, motion.phases[first % count]);
  const T& lasts = motion.phases[stick].duration;
  using Matrix3 = Eigen::Matrix<T, 3, 3>;
  const Matrix3 A = times(Phi, break_away).template topLeftCorner<3, 3>();
  Eigen::Matrix<T, 1, 4> r = -break_away.row(3);
  r(3) = T(1);
  const Eigen::Matrix<T, 1, 4> q = times(r, inverse);
  Matrix3 adjugate;  // of A, over det Phi
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      adjugate(i, j) = q(3) * inverse(i, j) - inverse(i, 3) * q(j);
    }
  }
  const auto G = [&](const T& t) {
    return Matrix3(model::Gamma<T>(o.data.chi, t).template topLeftCorner<3, 3>());
  };
  return {T(-det * q(3)), T(det * trace(times(G(T(-lasts)), adjugate))), T(-trace(times(A, G(lasts))))};
}

// Proved: all zeros of x^n + … + c[0] have |x| < 1. Refuted: one has |x| > 1. Both for every member; T has a
// member `over`, its enclosure.
//
// By p(1) < 0 and (-1)^n p(-1) < 0, each of which means a real zero beyond; then by Schur and Cohn: with
// k = p(0), the polynomial (p(x) - k x^n p(1/x))/(x (1 - k²)) of degree n - 1 has as many zeros outside the
// circle as p, provided |k| < 1; and |k| > 1 is the product of the moduli of all zeros.
template <class T>
[[nodiscard]] Truth is_inside_unit_circle(std::vector<T> c) {
  const auto less_than_one = [](const T& k) {
    const T rest = T(1) - k * k;
    return rest.over.is_positive()   ? Truth::proved
           : rest.over.is_negative() ? Truth::refuted
                                     : Truth::undecided;
  };
  T at_one(1);
  T at_minus_one(1);
  for (std::size_t i = c.size(); i-- > 0;) {
    at_one += c[i];
    at_minus_one = c[i] - at_minus_one;
  }
  if (c.size() % 2 == 1) {
    at_minus_one = -at_minus_one;
  }
  if (at_one.over.is_negative() || at_minus_one.over.is_negative()) {
    return Truth::refuted;
  }
  while (!c.empty()) {
    const T k = c.front();
    const Truth here = less_than_one(k);
    if (here != Truth::proved) {
      return here;
    }
    const std::size_t n = c.size();
    const T rest = T(1) - k * k;
    std::vector<T> reduced;
    for (std::size_t i = 1; i < n; ++i) {
      reduced.push_back((c[i] - k * c[n - i]) / rest);
    }
    c = std::move(reduced);
  }
  return Truth::proved;
}

}  // namespace stickslip::numeric::atlas
