#include "numeric/machines/linear_course.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using zeros::product;

namespace {

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
      add_product(sum, row(i), found.w(i));
    }
    found.terms.push_back(sum);
    found.guess.push_back(sum.approximate());
  }
  // The derivative number i of what is left out is at most the sum over m >= M of
  //   size |S w| nu^i (nu r)^(m - i)/(m - i)!,
  // whose terms fall at least by half from one to the next for nu r <= 1.
  const Ball reach = watch_.nu * Ball(watch_.length);
  const bool is_short = !(Ball(1) - reach).lower().is_negative();
  const Ball of_w = watch_.size * largest(found.w, watch_.balance);
  Ball factor = of_w;
  for (std::size_t i = 0; i < found.rest.size(); ++i) {
    Ball next = factor;
    for (std::size_t m = 1; m + i <= watch_.rows.size(); ++m) {
      next = next * reach / Ball(static_cast<long>(m));
    }
    if (is_short) {
      found.rest[i] = Ball(Ball(2) * next).upper();
    } else {
      arb_indeterminate(found.rest[i].raw());
    }
    factor = factor * watch_.nu;
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
  motion::DerivativeBounds most;
  if (!covers_) {
    arb_indeterminate(most.third.raw());
    return {most.third, most.third};
  }
  const auto raise = [](Ball& bound, const Ball& value) {
    arb_max(bound.raw(), bound.raw(), value.raw(), WorkingPrecision::bits());
  };
  for (std::size_t k = 0; k < count_; ++k) {
    const Stretch& here = stretch(k);
    Ball third = here.rest[3];
    Ball fourth = here.rest[4];
    Ball power(1);
    for (std::size_t m = 3; m < here.terms.size(); ++m) {
      const auto n = static_cast<long>(m);
      const Ball term = abs(here.terms[m]) * Ball(n * (n - 1) * (n - 2)) * power;
      third += term;
      if (m > 3) {
        fourth += term * Ball(n - 3) / Ball(watch_.length);
      }
      power *= Ball(watch_.length);
    }
    raise(most.third, third);
    raise(most.fourth, fourth);
  }
  return {most.third.upper(), most.fourth.upper()};
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
