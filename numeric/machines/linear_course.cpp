#include "numeric/machines/linear_course.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using zeros::product;

namespace {

// More than what is lost below the range of doubles.
constexpr double tiny = 1e-290;

// The largest size, from above.
Ball largest(const Vector& v, const Vector& weights) {
  Ball most(0);
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const Ball size = abs(v(i) * weights(i));
    arb_max(most.raw(), most.raw(), size.raw(), WorkingPrecision::bits());
  }
  return most.upper();
}

}  // namespace

Watched::Watched(const LinearPhases& phases, Piece piece, const Vector& w, const Ball& T, bool reversed)
    : watch_(phases.watch(piece, reversed)), drift_(phases.drift(piece)), reversed_(reversed) {
  constexpr double most_stretches = 1e7;
  const double stretches = std::ceil(T.approximate() / watch_.length * (1 + 1e-9));
  if (stretches > 1 && stretches < most_stretches) {
    count_ = static_cast<std::size_t>(stretches);
  }
  covers_ = !(Ball(static_cast<double>(count_) * watch_.length) - T).lower().is_negative();
  stretches_.push_back({w, {}, {}, {}});
}

const Watched::Stretch& Watched::stretch(std::size_t k) const {
  // From one to the next balls grow; so every now and then from the first.
  constexpr std::size_t most_in_a_row = 16;
  while (stretches_.size() <= k) {
    const std::size_t n = stretches_.size();
    const Ball t(static_cast<double>(n) * watch_.length);
    stretches_.push_back(
        {n % most_in_a_row == 0
             ? Vector(product(exponential(drift_ * (reversed_ ? Ball(-t) : t)), stretches_[0].w))
             : Vector(product(watch_.flow, stretches_.back().w)),
         {},
         {},
         {}});
  }
  Stretch& found = stretches_[k];
  if (!found.terms.empty()) {
    return found;
  }
  for (const Vector& row : watch_.rows) {
    Ball sum(0);
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      if (!is_zero(row(i))) {
        add_product(sum, row(i), found.w(i));
      }
    }
    found.terms.push_back(sum);
    found.guess.push_back(sum.approximate());
  }
  const Ball of_w = watch_.size * largest(found.w, watch_.balance);
  for (std::size_t i = 0; i < found.rest.size(); ++i) {
    found.rest[i] = Ball(of_w * watch_.rest[i]).upper();
  }
  return found;
}

std::size_t Watched::stretch_of(double s) const {
  const double k = std::floor(s / watch_.length);
  return k > 0 ? std::min(static_cast<std::size_t>(k), count_ - 1) : 0;
}

std::array<Ball, 4> Watched::at(double s) const {
  const std::size_t k = stretch_of(s);
  const Stretch& here = stretch(k);
  // Exact: the length is a power of two.
  const Ball r = Ball(s) - Ball(static_cast<long>(k)) * Ball(watch_.length);
  std::array<Ball, 4> d;
  for (std::size_t m = here.terms.size(); m-- > 0;) {
    for (std::size_t i = 3; i > 0; --i) {
      d[i] = d[i] * r + d[i - 1];
    }
    d[0] = d[0] * r + here.terms[m];
  }
  const bool is_inside = !r.lower().is_negative() && !(Ball(watch_.length) - r).lower().is_negative();
  constexpr std::array<int, 4> factorial{1, 1, 2, 6};
  for (std::size_t i = 0; i < 4; ++i) {
    d[i] = d[i] * Ball(factorial[i]) + Ball::hull(-here.rest[i], here.rest[i]);
    if (!is_inside) {
      arb_indeterminate(d[i].raw());
    }
  }
  return d;
}

std::array<double, 4> Watched::guess_at(double s) const {
  const std::size_t k = stretch_of(s);
  const Stretch& here = stretch(k);
  const double r = s - static_cast<double>(k) * watch_.length;
  std::array<double, 4> d{};
  for (std::size_t m = here.guess.size(); m-- > 0;) {
    for (std::size_t i = 3; i > 0; --i) {
      d[i] = d[i] * r + d[i - 1];
    }
    d[0] = d[0] * r + here.guess[m];
  }
  return {d[0], d[1], 2 * d[2], 6 * d[3]};
}

motion::DerivativeBounds Watched::bounds() const {
  motion::DerivativeBounds unknown;
  arb_indeterminate(unknown.third.raw());
  arb_indeterminate(unknown.fourth.raw());
  if (!covers_) {
    return unknown;
  }
  // Sums of positive numbers in double, each a little more than it is.
  constexpr double rounding = 1 + 1e-12;
  const long exponent = std::lround(std::log2(watch_.length));
  double third = 0, fourth = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const Stretch& here = stretch(k);
    double of_third = here.rest[3].approximate(), of_fourth = here.rest[4].approximate();
    for (std::size_t m = 3; m < here.terms.size(); ++m) {
      const auto n = static_cast<double>(m);
      Ball term = abs(here.terms[m]).upper();  // times length^(m - 3)
      arb_mul_2exp_si(term.raw(), term.raw(), static_cast<long>(m - 3) * exponent);
      const double size = term.approximate() * n * (n - 1) * (n - 2);
      of_third += size;
      of_fourth += m > 3 ? size * (n - 3) / watch_.length : 0;
    }
    if (!std::isfinite(of_third) || !std::isfinite(of_fourth)) {
      return unknown;
    }
    third = std::max(third, of_third);
    fourth = std::max(fourth, of_fourth);
  }
  return {Ball(third * rounding + tiny), Ball(fourth * rounding + tiny)};
}

std::array<Ball, 4> AffineCourse::at(double s) const {
  std::array<Ball, 4> d = f_.at(s);
  for (Ball& number : d) {
    number *= Ball(sign_);
  }
  d[0] += offset_;
  return d;
}

std::array<double, 4> AffineCourse::guess_at(double s) const {
  std::array<double, 4> d = f_.guess_at(s);
  for (double& number : d) {
    number *= sign_;
  }
  d[0] += offset_.approximate();
  return d;
}

}  // namespace stickslip::numeric::machines
