// That a threshold is crossed: on a short part of a branch a quantity rises or falls strictly wherever it is
// not above zero, so it has one zero there at most, and passes it with a speed that is not zero.
#pragma once

#include <optional>
#include <string>

#include "numeric/branches/law.hpp"
#include "numeric/motion/multipliers.hpp"

namespace stickslip::numeric::branches {

// How a quantity goes along the part.
enum class Trend {
  above,    // positive all the way
  rising,   // with a positive derivative wherever it is not positive
  falling,  // with a negative one
  unknown,
};

// Of the margin of a condition. Along a phase the margin is the infimum over time of g(t) or of g(t)/t next
// to an end that g touches, and it rises if g does at each time at which it is not positive: then the set of
// parameters where the condition holds has one end. Times count from the end of the phase that is nearer.
[[nodiscard]] Trend trend_of(const motion::Requirement& requirement,
                             const motion::MotionOf<zeros::ParameterJet>& motion,
                             const std::optional<zeros::ParameterJet>& ur);

// Of the lesser of two quantities.
[[nodiscard]] Trend joined(Trend a, Trend b);

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
