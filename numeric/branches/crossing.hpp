// That a threshold is crossed: on a short part of a branch a quantity rises or falls strictly wherever it is
// not above zero, so it has one zero there at most, and passes it with a speed that is not zero.
#pragma once

#include <optional>
#include <string>

#include "numeric/branches/law.hpp"
#include "numeric/motion/monodromy.hpp"

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

// The coefficients of det(s I - A), the leading one first, by Faddeev and
// LeVerrier.
template <class S>
[[nodiscard]] std::vector<S> characteristic_polynomial(
    const Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>& A) {
  using Square = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  const auto n = static_cast<int>(A.rows());
  std::vector<S> c{S(1)};
  Square B = Square::Identity(n, n);
  for (int k = 1; k <= n; ++k) {
    const Square AB = A.lazyProduct(B);
    S trace(0);
    for (int i = 0; i < n; ++i) {
      trace += AB(i, i);
    }
    c.push_back(S(-trace / S(k)));
    B = AB;
    for (int i = 0; i < n; ++i) {
      B(i, i) += c.back();
    }
  }
  return c;
}

// The matrix of all 2 by 2 minors: its eigenvalues are the products mu_i mu_j, i < j.
template <class S>
[[nodiscard]] Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> second_compound(
    const Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>& A) {
  const auto n = static_cast<int>(A.rows());
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      pairs.emplace_back(i, j);
    }
  }
  const auto m = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> C(m, m);
  for (Eigen::Index r = 0; r < m; ++r) {
    for (Eigen::Index s = 0; s < m; ++s) {
      const auto [i, j] = pairs[static_cast<std::size_t>(r)];
      const auto [k, l] = pairs[static_cast<std::size_t>(s)];
      C(r, s) = A(i, k) * A(j, l) - A(i, l) * A(j, k);
    }
  }
  return C;
}

// The derivative of the return map, as decide_stability has it: with a stick 3 by 3.
template <class S>
[[nodiscard]] Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> return_map(const motion::MotionOf<S>& motion) {
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    if (motion.phases[k].kind == motion::PhaseKind::stick) {
      return motion::monodromy<S>(motion, k).template topLeftCorner<3, 3>();
    }
  }
  return motion::monodromy<S>(motion);
}

// Not finite where an event may not be transversal.
template <class S>
[[nodiscard]] S exit_function(Exit exit, const motion::MotionOf<S>& motion) {
  const auto M = return_map<S>(motion);
  S sum(0);
  for (const S& coefficient : characteristic_polynomial<S>(exit == Exit::pair ? second_compound<S>(M) : M)) {
    sum = S(sum * S(exit == Exit::minus_one ? -1 : 1) + coefficient);
  }
  // det(-I - M) is det(I + M) up to the sign of (-1)^n.
  return exit == Exit::minus_one && M.rows() % 2 == 1 ? S(-sum) : sum;
}

}  // namespace stickslip::numeric::branches
