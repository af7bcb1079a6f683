// A phase of a machine on a smooth law of friction, followed in balls.
//
// w of linear_phases.hpp obeys w' = B w + e f(v)/m, with B the drift without the friction, v the relative
// velocity and e the row of x_j'. On each of some steps w is a Taylor polynomial whose last coefficient is
// enclosed over the whole step: Lagrange's remainder, which serves the polynomial's derivatives, too.
//
// The coefficient is enclosed over a box that holds the step: one that has in its interior all values of the
// polynomial with that last coefficient. For as long as w is in the box, it is such a value; so it is inside
// and cannot have left (Corliss and Rihm's high-order enclosure).
#pragma once

#include <optional>
#include <vector>

#include "numeric/machines/linear_phases.hpp"

namespace stickslip::numeric::machines {

// w' on a smooth phase.
[[nodiscard]] Vector smooth_rate(const LinearPhases& phases, int side, const Vector& w);

class SmoothPhase {
 public:
  // A step is enclosed for so much longer than it is taken, so that the last one reaches all members of T.
  static constexpr double longer = 1 + 0x1p-6;
  struct Step {
    double start, length;            // exact
    std::vector<Vector> w;           // coefficients of the powers of the time since then
    std::vector<Matrix> derivative;  // likewise, of (x, x') by (x, x') at the start
  };

  // From w over [0, T]; `reversed`: from where the phase ends, against the time. The phases have to live as
  // long.
  SmoothPhase(const LinearPhases& phases, int side, const Vector& w, const Ball& T, bool reversed,
              bool with_derivative);

  // One after the other to T; none where the motion could not be enclosed.
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  // At T; not finite where the motion could not be enclosed.
  [[nodiscard]] Vector end() const;
  // Of (x, x') at T by (x, x') at 0. Assumes that it was asked for.
  [[nodiscard]] Matrix derivative() const;

 private:
  struct Series {
    std::vector<Vector> w;
    std::vector<Matrix> derivative;
  };
  [[nodiscard]] std::optional<Step> step(const Vector& w, double start, double longest) const;
  // The coefficients of orders 0 to `order`.
  [[nodiscard]] Series series(const Vector& w, const Matrix& derivative, std::size_t order) const;
  // Over all of a step from there: the last coefficient is the one after those.
  [[nodiscard]] std::optional<Series> over(const Series& here, double length) const;
  [[nodiscard]] Matrix derivative_box(const Vector& w, double length) const;
  [[nodiscard]] double likely_length(const Series& series) const;
  [[nodiscard]] double size(const Vector& w) const;
  [[nodiscard]] double size(const Matrix& derivative) const;
  [[nodiscard]] std::optional<Ball> time_in(const Step& step) const;

  const LinearPhases& phases_;
  const model::SmoothFriction<Ball>& law_;
  const Matrix& drift_;
  int side_, direction_;
  bool with_derivative_;
  Eigen::Index states_, speed_;
  Vector balance_;
  Eigen::VectorXd balance_in_double_;
  Ball T_;
  double quantum_;  // lengths are multiples of it, so that their sums are exact
  std::vector<Step> steps_;
};

}  // namespace stickslip::numeric::machines
