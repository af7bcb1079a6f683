// The closing conditions of closing_rows.hpp with the state and the load's phase eliminated: functions of the
// unknown times alone, for the search of zeros/search.hpp.
//
// The state's three columns are eliminated; then N + 1 rows of (cos phi, sin phi, 1) remain. The vector
// product n of two of them is parallel to (cos phi, sin phi, 1), so a motion closes exactly if n1² + n2² =
// n3² and, with two times, the third row is orthogonal to n, as long as n3 ≠ 0. Nothing is divided by but the
// pivots of the state. The unknowns x are shares: x0 of all phases but the stick in n periods, x1 of the
// second in them.
#pragma once

#include <optional>
#include <vector>

#include "numeric/scalars/hardware_ball.hpp"
#include "numeric/words/closing_rows.hpp"
#include "numeric/words/word_orbit.hpp"
#include "numeric/zeros/elimination.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::words {

inline constexpr const char * dependent = "the equations for the state may be dependent";

// A word's question at the working precision, and again over hardware balls.
template <int N>
struct ClosingProblem {
  ClosingProblem(const WordQuestion& question, const Word& word, long periods);

  // tau, or tau and tau1.
  template <class T>
  [[nodiscard]] static Eigen::Matrix<T, N, 1> times(const T& total, const Eigen::Matrix<T, N, 1>& x) {
    const T sum = total * x(0);
    Eigen::Matrix<T, N, 1> result;
    result(0) = sum;
    if constexpr (N == 2) {
      result(1) = sum * x(1);
      result(0) = sum * (T(1) - x(1));
    }
    return result;
  }

  model::Oscillator<Ball> oscillator;
  std::vector<motion::PhaseKind> phases;  // the stick last
  ClosingData<Ball> exact;
  ClosingData<scalars::HardwareBall> fast;
  bool whole = false;  // n/omega is a whole number
};

// (z10, z20, z10'), cos phi and sin phi.
struct StateAndLoad {
  Eigen::Matrix<Ball, 3, 1> z;
  Ball cosine, sine;
};

// The functions with rows combined as fits a box. Not finite where a pivot may vanish.
template <int N>
struct Eliminant {
  ClosingProblem<N> problem;
  Eigen::Matrix<Ball, closing_rows<N>, closing_rows<N>> combinations;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, N, 1> operator()(const Eigen::Matrix<T, N, 1>& x) const;
  // Nothing where that is not determined at x.
  [[nodiscard]] std::optional<StateAndLoad> solved(const zeros::Box<N>& x) const;
};

// With combinations that lose no row; nothing where there are none.
template <int N>
[[nodiscard]] std::optional<Eliminant<N>> eliminant_near(const ClosingProblem<N>& problem,
                                                         const zeros::Box<N>& X);

// The part of X that may hold a motion; exactly one in a box that contains X, or none in X.
template <int N>
[[nodiscard]] std::optional<zeros::Box<N>> contract(const ClosingProblem<N>& problem, const zeros::Box<N>& X);
template <int N>
[[nodiscard]] zeros::Decision<N> decide(const ClosingProblem<N>& problem, const zeros::Box<N>& X);

}  // namespace stickslip::numeric::words
