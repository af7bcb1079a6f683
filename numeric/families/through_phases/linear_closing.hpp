// Closing conditions that are rows, linear in the amplitudes of sticks and in (cos psi, sin psi, 1), psi the
// load's phase somewhere in the motion, with coefficients that are functions of the durations alone; as
// functions of the durations, for the search of zeros/search.hpp.
//
// The amplitudes are eliminated. Given the load's phase, as many numbers remain as there are times, and must
// vanish. Given ur one row more remains, and each is one of (cos psi, sin psi, 1): the vector product n of
// two of them is parallel to that, so a motion closes exactly if n1² + n2² = n3² and the other rows are
// orthogonal to n, as long as n3 ≠ 0. Nothing is divided by but the pivots of the amplitudes.
//
// A problem P is a set of such rows with its data, at the working precision and again over hardware balls:
//   P::times         how many numbers the durations are functions of: the unknowns x, shares in [0, 1]
//   P::amplitudes    the rows' first columns
//   P::loads         their last ones: 1 where the load's phase is given, else 3, for cos psi, sin psi and 1
//   first_rows<T>(P, x), other_rows<T>(P, x)   the rows, P::first of them and the rest, over T
//   look(P, first rows over the box, at its middle, box)   the part of the box that the first rows leave
//   is_excluded(P, X)                          whether X holds no motion for a reason that the rows do not
//   see
// The functions that are templates over T are found by argument-dependent lookup where
// linear_closing_search.hpp is included: by the source file of the problem, which instantiates
// LinearEliminant.
#pragma once

#include <optional>

#include "numeric/families/family.hpp"
#include "numeric/scalars/hardware_ball.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

// The sizes of a problem.
template <int Times, int Amplitudes, bool PhaseGiven>
struct Sizes {
  static constexpr int times = Times;
  static constexpr int amplitudes = Amplitudes;
  static constexpr int loads = PhaseGiven ? 1 : 3;
  static constexpr int left = Times + (PhaseGiven ? 0 : 1);  // rows, once the amplitudes are eliminated
  static constexpr int rows = Amplitudes + left;
  static constexpr int columns = Amplitudes + loads;
};

template <class P, class T>
using Unknowns = Eigen::Matrix<T, P::times, 1>;
template <class P, class T>
using AllRows = Eigen::Matrix<T, P::rows, P::columns>;
template <class P, class T>
using FirstRows = Eigen::Matrix<T, P::first, P::columns>;
template <class P, class T>
using OtherRows = Eigen::Matrix<T, P::rows - P::first, P::columns>;

// The linear unknowns where the rows hold.
template <class P>
struct Linear {
  Eigen::Matrix<Ball, P::amplitudes, 1> amplitudes;
  std::optional<std::pair<Ball, Ball>> cos_sin_psi;  // where the load's phase is not given
};

// The functions with rows combined as fits a box. Not finite where a pivot may vanish. Where they are finite
// and vanish, all rows hold for one value of the unknowns, provided the combinations are invertible.
template <class P>
struct LinearEliminant {
  using Jet = scalars::Jet<Ball, P::times>;
  using Box = Unknowns<P, Ball>;

  P problem;
  Eigen::Matrix<Ball, P::rows, P::rows> combinations;

  // With invertible combinations, as fits this box; nothing where there are none.
  [[nodiscard]] static std::optional<LinearEliminant> near(const P& problem, const Box& X);
  // The part of X that may hold a motion that closes; exactly one in a box that contains X, or none in X.
  [[nodiscard]] static std::optional<Box> contract(const P& problem, const Box& X);
  [[nodiscard]] static zeros::ZeroProof<P::times> decide(const P& problem, const Box& X);

  [[nodiscard]] Box operator()(const Box& x) const { return at<Ball>(x); }
  [[nodiscard]] Unknowns<P, Jet> operator()(const Unknowns<P, Jet>& x) const { return at<Jet>(x); }
  // Nothing where they are not determined at x.
  [[nodiscard]] std::optional<Linear<P>> linear(const Box& x) const;

 private:
  template <class T>
  [[nodiscard]] Unknowns<P, T> at(const Unknowns<P, T>& x) const;
};

inline constexpr const char * dependent =
    "the amplitudes cannot be eliminated: the equations for them may be dependent";

}  // namespace stickslip::numeric::families
