// A phase of a machine on a smooth law of friction, followed in balls.
//
// w of linear_phases.hpp obeys w' = B w + e f(v)/m, with B the drift without the friction, v the relative
// velocity and e the row of x_j'. On each of some steps w is a Taylor polynomial whose last coefficient is
// enclosed over the whole step: Lagrange's remainder, which serves the polynomial's derivatives, too.
//
// The coefficient is enclosed over a box that holds the step: one that has in its interior all values of the
// polynomial with that last coefficient. For as long as w is in the box, it is such a value; so it is inside
// and cannot have left (Corliss and Rihm's high-order enclosure).
//
// Numbers are of a kind S: balls, for one machine, or InData<Ball>, for all machines over data. There the
// box, too, is a function of the data, and what is said of a motion is said of each at its data.
#pragma once

#include <optional>
#include <vector>

#include "numeric/machines/phases/linear_phases.hpp"

namespace stickslip::numeric::machines {

// w' on a smooth phase.
template <class S>
[[nodiscard]] model::VectorX<S> smooth_rate(const LinearPhases& phases, int side, const model::VectorX<S>& w);

template <class S>
class SmoothPhaseOf {
 public:
  using Column = model::VectorX<S>;
  using Square = model::MatrixX<S>;

  // A step is enclosed for so much longer than it is taken, so that the last one reaches all members of T.
  static constexpr double longer = 1 + 0x1p-6;
  struct Step {
    double start, length;            // exact
    std::vector<Column> w;           // coefficients of the powers of the time since then
    std::vector<Square> derivative;  // likewise, of (x, x') by (x, x') at the start
  };

  // From w over [0, T]; `reversed`: from where the phase ends, against the time. The phases have to live as
  // long.
  SmoothPhaseOf(const LinearPhases& phases, int side, const Column& w, const S& T, bool reversed,
                bool with_derivative);

  // One after the other to T; none where the motion could not be enclosed.
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  // At T; not finite where the motion could not be enclosed.
  [[nodiscard]] Column end() const;
  // Of (x, x') at T by (x, x') at 0. Assumes that it was asked for.
  [[nodiscard]] Square derivative() const;

 private:
  struct Series {
    std::vector<Column> w;
    std::vector<Square> derivative;
  };
  void follow(const Column& w);
  [[nodiscard]] std::optional<Step> step(const Column& w, double start, double longest) const;
  // The coefficients of orders 0 to `order`.
  [[nodiscard]] Series series(const Column& w, const Square& derivative, std::size_t order) const;
  // Over all of a step from there: the last coefficient is the one after those.
  [[nodiscard]] std::optional<Series> over(const Series& here, double length) const;
  [[nodiscard]] Square derivative_box(const Column& w, double length) const;
  [[nodiscard]] double likely_length(const Series& series) const;
  [[nodiscard]] double size(const Column& w) const;
  [[nodiscard]] double size(const Square& derivative) const;
  [[nodiscard]] std::optional<S> time_in(const Step& step) const;

  const LinearPhases& phases_;
  const model::SmoothFriction<S>& law_;
  Square drift_;
  int side_, direction_;
  bool with_derivative_;
  Eigen::Index states_, speed_;
  Vector balance_;
  Eigen::VectorXd balance_in_double_;
  S T_;
  double quantum_;  // lengths are multiples of it, so that their sums are exact
  std::vector<Step> steps_;
};
using SmoothPhase = SmoothPhaseOf<Ball>;

}  // namespace stickslip::numeric::machines
