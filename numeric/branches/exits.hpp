// The ways in which a multiplier can cross the unit circle, and where a branch turns, as functions of the
// motion over any scalar.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/symmetric_closing.hpp"
#include "numeric/motion/multipliers.hpp"

namespace stickslip::numeric::branches {

// The ways in which a multiplier can cross the unit circle, as functions that vanish exactly then: det(I -
// M), det(I + M), and the product of 1 - mu_i mu_j over i < j, which also vanishes for a real pair mu, 1/mu.
enum class Exit { plus_one, minus_one, pair };
inline constexpr std::array exits{Exit::plus_one, Exit::minus_one, Exit::pair};
[[nodiscard]] std::string to_string(Exit exit);

// From the coefficients of motion/multipliers.hpp, whose leading one is positive where the friction law is
// obeyed: that times the function, for a pair its square. Where it is negative, a multiplier is outside: if
// all were inside, each would be a product of positive factors.
template <class S>
[[nodiscard]] S exit_function(Exit exit, const std::vector<S>& c) {
  const auto n = static_cast<int>(c.size()) - 1;
  if (exit != Exit::pair) {
    S sum(0);
    for (int k = 0; k <= n; ++k) {
      sum += exit == Exit::minus_one && (n - k) % 2 == 1 ? S(-c[static_cast<std::size_t>(k)])
                                                         : c[static_cast<std::size_t>(k)];
    }
    return sum;
  }
  // By the elementary symmetric functions of the multipliers, e4 = 0 with a stick.
  const auto e = [&](int k) {
    const S& coefficient = c[static_cast<std::size_t>(n - k)];
    return k % 2 == 1 ? S(-coefficient) : coefficient;
  };
  const S three = e(0) * e(0) - e(0) * e(2) + e(1) * e(3) - e(3) * e(3);
  return n == 3 ? three
                : S(three +
                    e(4) * S(e(1) * e(3) + S(2) * e(2) - S(1) - e(1) * e(1) - e(4) * S(S(1) + e(2) - e(4))));
}

// The exit functions of a motion that obeys the friction law, each as factors: their product is a positive
// multiple of it if `is_regular`, the rate r' at the end of a stick or 1, is positive; else they say nothing.
template <class S>
struct ExitFactors {
  std::array<std::vector<S>, exits.size()> of;
  S is_regular;

  [[nodiscard]] const std::vector<S>& operator[](Exit exit) const {
    return of[static_cast<std::size_t>(exit)];
  }
};

// The coefficients of a polynomial whose zeros are the multipliers, but for zeros: that of the return map
// seen where a stick begins, with more than one. Then not finite where one of them may end at rest.
template <class S>
[[nodiscard]] std::vector<S> multiplier_coefficients(const motion::MotionOf<S>& motion) {
  std::size_t stick = 0, sticks = 0;
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    if (motion.phases[k].kind == motion::PhaseKind::stick) {
      stick = k;
      ++sticks;
    }
  }
  if (sticks < 2) {
    return motion::multiplier_polynomial(motion);
  }
  const model::Matrix4<S> M = motion::monodromy<S>(motion, stick);
  const auto minor = [&](int i, int j) { return S(M(i, i) * M(j, j) - M(i, j) * M(j, i)); };
  const S det = M(0, 0) * minor(1, 2) - M(0, 1) * S(M(1, 0) * M(2, 2) - M(1, 2) * M(2, 0)) +
                M(0, 2) * S(M(1, 0) * M(2, 1) - M(1, 1) * M(2, 0));
  return {S(-det), S(minor(0, 1) + minor(0, 2) + minor(1, 2)), S(-M(0, 0) - M(1, 1) - M(2, 2)), S(1)};
}

template <class S>
[[nodiscard]] ExitFactors<S> exit_factors(const motion::MotionOf<S>& motion) {
  const std::vector<S> c = multiplier_coefficients(motion);
  ExitFactors<S> result{{}, c.back()};
  for (const Exit exit : exits) {
    result.of[static_cast<std::size_t>(exit)] = {exit_function(exit, c)};
  }
  return result;
}

// Those of a symmetric orbit. For the multiplier 1 they are r' times the two factors that the symmetry gives
// det(I - M) (atlas/symmetric_orbit.hpp),
//   lambda_2 s_2 P_1 - lambda_1 s_1 P_2  and  omega_1 P_1 E_2 - omega_2 P_2 E_1,
//   E_j = lambda_j omega_j (s_j + k omega_j c_j),  k = (r - us)/r' at the break-away,
// for chi eta (lambda_j - 1) = lambda_j omega_j². Each is far larger than their product where the stick
// hardly lasts: there a multiplier is near 1.
template <class S>
[[nodiscard]] ExitFactors<S> symmetric_exit_factors(const motion::MotionOf<S>& motion) {
  const model::Parameters<S>& a = motion.oscillator.data;
  const model::Modes<S>& m = motion.oscillator.modes;
  const motion::PhaseOf<S>& slip = motion.phases.at(0);
  const S& tau = slip.duration;
  const S period = tau + motion.phases.at(1).duration;
  const S step = model::friction_at<S>(a, slip.Z, slip.load) - a.us;
  ExitFactors<S> result = exit_factors(motion);
  struct Mode {
    S P, sine, E;
  };
  const auto mode = [&](const S& omega, const S& lambda) {
    const std::pair<S, S> at_half = sin_cos(S(omega * tau / S(2)));
    return Mode{model::stick_transfer<S>(omega, period, tau).odd, at_half.first,
                S(lambda * omega * S(result.is_regular * at_half.first + step * omega * at_half.second))};
  };
  const Mode one = mode(m.omega1, m.lambda1), two = mode(m.omega2, m.lambda2);
  result.of[0] = {S(m.lambda2 * two.sine * one.P - m.lambda1 * one.sine * two.P),
                  S(m.omega1 * one.P * two.E - m.omega2 * two.P * one.E)};
  return result;
}

// Vanishes where a branch along which the load's phase is given turns: det(I - M), M the derivative of the
// map from one start of the first phase to the next, both at that phase of the load whatever the friction,
// after a stick. With the friction given instead, that of the return map does so.
template <class S>
[[nodiscard]] S turn_at_given_phase(const motion::MotionOf<S>& motion) {
  model::Matrix4<S> M = motion::tangent_flow<S>(motion.oscillator, motion.phases.front());
  for (std::size_t k = 1; k < motion.phases.size(); ++k) {
    M = motion::saltation_between<S>(motion.oscillator, motion.phases[k - 1].kind, motion.phases[k]) * M;
    M = motion::tangent_flow<S>(motion.oscillator, motion.phases[k]) * M;
  }
  const auto d = [&](int i, int j) { return S(S(i == j ? 1 : 0) - M(i, j)); };
  const auto minor = [&](int j, int k) { return S(d(1, j) * d(2, k) - d(1, k) * d(2, j)); };
  return d(0, 0) * minor(1, 2) - d(0, 1) * minor(0, 2) + d(0, 2) * minor(0, 1);
}

}  // namespace stickslip::numeric::branches
