// The derivative of the return map of a periodic motion, and its characteristic polynomial, over any scalar.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/error.hpp"
#include "model/saltation.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

// The derivative of the return map of a periodic motion, over any scalar.

// The derivative of the flow of one phase: H of (5), (8), Gamma of (10).
template <class S>
[[nodiscard]] model::Matrix4<S> tangent_flow(const model::Oscillator<S>& o, const PhaseOf<S>& phase) {
  return phase.kind == PhaseKind::stick ? model::Gamma<S>(o.data.chi, phase.duration)
                                        : model::H<S>(o.modes, phase.duration);
}

// The places of the phases that stick.
template <class S>
[[nodiscard]] std::vector<std::size_t> sticks_of(const MotionOf<S>& motion) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    if (motion.phases[k].kind == PhaseKind::stick) {
      places.push_back(k);
    }
  }
  return places;
}

// The friction force on a phase at the friction at rest r (4): us, -us, or r.
template <class S>
[[nodiscard]] S friction_on(PhaseKind kind, const S& us, const S& r) {
  return kind == PhaseKind::slip ? us : (kind == PhaseKind::overshoot ? S(-us) : r);
}

// The saltation matrix where `next` begins after a phase of the kind `before`. Its entries are not finite
// where the event is not transversal. Throws InternalError when both are of one kind.
template <class S>
[[nodiscard]] model::Matrix4<S> saltation_between(const model::Oscillator<S>& o, PhaseKind before,
                                                  const PhaseOf<S>& next) {
  if (before == next.kind) {
    throw InternalError("two phases of one kind after each other");
  }
  if (next.kind == PhaseKind::stick) {
    return model::landing<S>();
  }
  const model::Parameters<S>& a = o.data;
  const S r = model::friction_at<S>(a, next.Z, next.load);
  const auto acceleration = [&](PhaseKind kind) {
    return model::belt_acceleration<S>(a.eta, friction_on<S>(kind, a.us, r), r);
  };
  if (before == PhaseKind::stick) {
    return model::break_away<S>(a.chi, acceleration(next.kind),
                                model::friction_rate<S>(a, next.Z, next.load));
  }
  return model::crossing<S>(acceleration(before), acceleration(next.kind));
}

// The derivative of the map from the state where phase `first` begins to the state one period later, the
// load's phase being what it was: the product of the flows' and the events' derivatives. Assumes that the
// motion closes and obeys the friction law with every event transversal; at least one phase.
template <class S>
[[nodiscard]] model::Matrix4<S> monodromy(const MotionOf<S>& motion, std::size_t first = 0) {
  const std::size_t count = motion.phases.size();
  model::Matrix4<S> M = tangent_flow<S>(motion.oscillator, motion.phases.at(first));
  for (std::size_t k = 1; k <= count; ++k) {
    const PhaseOf<S>& before = motion.phases[(first + k - 1) % count];
    const PhaseOf<S>& next = motion.phases[(first + k) % count];
    M = saltation_between<S>(motion.oscillator, before.kind, next) * M;
    if (k < count) {
      M = tangent_flow<S>(motion.oscillator, next) * M;
    }
  }
  return M;
}

// The characteristic polynomial of the derivative of a motion's return map, over any scalar: its zeros are
// the multipliers.

// c[0] + c[1] x + … + c[n] x^n, for a motion with at most one stick. Without, n = 4 and c[4] = 1. With one,
// n = 3, the map being seen where the stick begins, and c[3] is the rate r' of (4) at which it ends: times
// that rate all coefficients stay bounded where it vanishes, though the map does not. The same up to that
// factor as that of the derivative above, by formulas in which little cancels, over wide boxes too. Throws
// InternalError for a motion with two sticks.
//
// Phi, the product of the flows H and of the crossings diag(1, 1, 1, rho), has a known inverse, H(-t) and
// 1/rho, and a known determinant, the product of all rho. Without stick, with traces,
//   c[3] = -tr Phi,  c[2] = ((tr Phi)² - tr Phi²)/2,  c[1] = -det tr Phi⁻¹,  c[0] = det.
// A stick begins without deviation of z2' and ends with (I + e4 s/r') Gamma, s a row with s4 = 0. So the map
// is A G/r', G the first three rows and columns of Gamma, det G = 1, and A those of Phi (r' I + e4 s). With
// r = (-s, r'), q = r Phi⁻¹ and p the last column of Phi⁻¹, K = Phi with its last row replaced by r has
//   det K = det Phi q4 = det A/r'²,  K⁻¹ = Phi⁻¹ - p (q - e4)/q4, whose first rows and columns are r' A⁻¹.
template <class T>
[[nodiscard]] std::vector<T> multiplier_polynomial(const MotionOf<T>& motion) {
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
  const std::vector<std::size_t> all = sticks_of(motion);
  if (all.size() > 1) {
    throw InternalError("a motion with two sticks");
  }
  const bool sticks = !all.empty();
  const std::size_t stick = sticks ? all.front() : count;
  Matrix4 Phi = Matrix4::Identity();
  Matrix4 inverse = Matrix4::Identity();
  T det(1);
  const auto cross = [&](PhaseKind before, const PhaseOf<T>& next) {
    const T rho = saltation_between<T>(o, before, next)(3, 3);
    for (int i = 0; i < 4; ++i) {
      Phi(3, i) = rho * Phi(3, i);
      inverse(i, 3) = inverse(i, 3) / rho;
    }
    det = det * rho;
  };
  const std::size_t first = sticks ? stick + 1 : 0;
  for (std::size_t k = 0; k + (sticks ? 1 : 0) < count; ++k) {
    const PhaseOf<T>& phase = motion.phases[(first + k) % count];
    if (k > 0) {
      cross(motion.phases[(first + k - 1) % count].kind, phase);
    }
    Phi = times(model::H<T>(o.modes, phase.duration), Phi);
    inverse = times(inverse, model::H<T>(o.modes, T(-phase.duration)));
  }
  if (!sticks) {
    cross(motion.phases.back().kind, motion.phases.front());
    const T sum = trace(Phi);
    return {det, T(-det * trace(inverse)), T((sum * sum - trace(times(Phi, Phi))) / T(2)), T(-sum), T(1)};
  }
  // r' I + e4 s, by its entries for r' = 1.
  const model::Parameters<T>& a = o.data;
  const PhaseOf<T>& next = motion.phases[first % count];
  const T rate = model::friction_rate<T>(a, next.Z, next.load);
  const T r_at_end = model::friction_at<T>(a, next.Z, next.load);
  const T after = model::belt_acceleration<T>(a.eta, friction_on<T>(next.kind, a.us, r_at_end), r_at_end);
  Matrix4 break_away = model::break_away<T>(a.chi, after, T(1));
  for (int i = 0; i < 4; ++i) {
    break_away(i, i) = rate;
  }
  const T& lasts = motion.phases[stick].duration;
  using Matrix3 = Eigen::Matrix<T, 3, 3>;
  const Matrix3 A = times(Phi, break_away).template topLeftCorner<3, 3>();
  Eigen::Matrix<T, 1, 4> r = -break_away.row(3);
  r(3) = rate;
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
  return {T(-det * q(3)), T(det * trace(times(G(T(-lasts)), adjugate))), T(-trace(times(A, G(lasts)))), rate};
}

}  // namespace stickslip::numeric::motion
