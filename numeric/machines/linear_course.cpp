#include "numeric/machines/linear_course.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/machines/smooth_phase.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using zeros::product;

namespace {

// More than what is lost below the range of doubles.
constexpr double tiny = 1e-290;
constexpr std::array<int, 5> factorial{1, 1, 2, 6, 24};

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
    : drift_(phases.drift(piece)), reversed_(reversed), covers_(false) {
  if (phases.is_smooth(piece)) {
    follow(phases, piece, w, T);
    return;
  }
  watch_ = &phases.watch(piece, reversed);
  constexpr double most_stretches = 1e7;
  const double stretches = std::ceil(T.approximate() / watch_->length * (1 + 1e-9));
  if (stretches > 1 && stretches < most_stretches) {
    count_ = static_cast<std::size_t>(stretches);
  }
  covers_ = !(Ball(static_cast<double>(count_) * watch_->length) - T).lower().is_negative();
  stretches_.push_back({0, watch_->length, w, {}, {}, {}});
}

void Watched::follow(const LinearPhases& phases, Piece piece, const Vector& w, const Ball& T) {
  const SmoothPhase phase(phases, piece.side(), w, T, reversed_, false);
  const Eigen::Index speed = phases.masses() + phases.rubbing();
  for (const SmoothPhase::Step& step : phase.steps()) {
    stretches_.push_back({step.start, step.length * SmoothPhase::longer, {}, {}, {}, {}});
    for (const Vector& coefficient : step.w) {
      stretches_.back().terms.push_back(coefficient(speed));
      stretches_.back().guess.push_back(coefficient(speed).approximate());
    }
  }
  count_ = stretches_.size();
  covers_ = count_ > 0 &&
            !(Ball(stretches_.back().start) + Ball(stretches_.back().length) - T).lower().is_negative();
}

const Watched::Stretch& Watched::stretch(std::size_t k) const {
  // From one to the next balls grow; so every now and then from the first.
  constexpr std::size_t most_in_a_row = 16;
  while (stretches_.size() <= k) {
    const std::size_t n = stretches_.size();
    const double start = static_cast<double>(n) * watch_->length;
    const Ball t(start);
    stretches_.push_back(
        {start,
         watch_->length,
         n % most_in_a_row == 0
             ? Vector(product(exponential(drift_ * (reversed_ ? Ball(-t) : t)), stretches_[0].w))
             : Vector(product(watch_->flow, stretches_.back().w)),
         {},
         {},
         {}});
  }
  Stretch& found = stretches_[k];
  if (!found.terms.empty()) {
    return found;
  }
  for (const Vector& row : watch_->rows) {
    Ball sum(0);
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      if (!is_zero(row(i))) {
        add_product(sum, row(i), found.w(i));
      }
    }
    found.terms.push_back(sum);
    found.guess.push_back(sum.approximate());
  }
  const Ball of_w = watch_->size * largest(found.w, watch_->balance);
  for (std::size_t i = 0; i < found.rest.size(); ++i) {
    found.rest[i] = Ball(of_w * watch_->rest[i]).upper();
  }
  return found;
}

std::size_t Watched::stretch_of(double s) const {
  if (watch_ == nullptr) {
    const auto after = std::ranges::upper_bound(stretches_, s, {}, &Stretch::start);
    return after == stretches_.begin() ? 0 : static_cast<std::size_t>(after - stretches_.begin()) - 1;
  }
  const double k = std::floor(s / watch_->length);
  return k > 0 ? std::min(static_cast<std::size_t>(k), count_ - 1) : 0;
}

std::array<Ball, 4> Watched::at(const Ball& s, std::size_t derivative) const {
  std::array<Ball, 4 + most_derivatives> d;
  const std::size_t count = 4 + derivative;
  const bool known = count_ > 0;
  bool is_inside = false;
  if (known) {
    const Stretch& here = stretch(stretch_of(s.approximate()));
    const Ball r = s - Ball(here.start);
    is_inside = !r.lower().is_negative() && !(Ball(here.length) - r).lower().is_negative();
    for (std::size_t m = here.terms.size(); m-- > 0;) {
      for (std::size_t i = count - 1; i > 0; --i) {
        d[i] *= r;
        d[i] += d[i - 1];
      }
      d[0] *= r;
      d[0] += here.terms[m];
    }
    for (std::size_t i = 0; i < count; ++i) {
      d[i] = d[i] * Ball(factorial[i]) + Ball::hull(-here.rest[i], here.rest[i]);
    }
  }
  std::array<Ball, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = d[i + derivative];
    if (!is_inside) {
      arb_indeterminate(result[i].raw());
    }
  }
  return result;
}

std::array<double, 4> Watched::guess_at(double s, std::size_t derivative) const {
  std::array<double, 4 + most_derivatives> d{};
  if (count_ > 0) {
    const Stretch& here = stretch(stretch_of(s));
    const double r = s - here.start;
    for (std::size_t m = here.guess.size(); m-- > 0;) {
      for (std::size_t i = d.size() - 1; i > 0; --i) {
        d[i] = d[i] * r + d[i - 1];
      }
      d[0] = d[0] * r + here.guess[m];
    }
  }
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = d[i + derivative] * factorial[i + derivative];
  }
  return result;
}

motion::DerivativeBounds Watched::bounds(std::size_t derivative) const {
  motion::DerivativeBounds unknown;
  arb_indeterminate(unknown.third.raw());
  arb_indeterminate(unknown.fourth.raw());
  if (!covers_) {
    return unknown;
  }
  const std::size_t lowest = 3 + derivative;
  // Sums of positive numbers in double, each a little more than it is.
  constexpr double rounding = 1 + 1e-12;
  double third = 0, fourth = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const Stretch& here = stretch(k);
    Ball power(1);  // length^(m - lowest)
    double of_third = here.rest[lowest].approximate(), of_fourth = here.rest[lowest + 1].approximate();
    for (std::size_t m = lowest; m < here.terms.size(); ++m) {
      double size = Ball(abs(here.terms[m]).upper() * power).approximate();
      for (std::size_t i = 0; i < lowest; ++i) {
        size *= static_cast<double>(m - i);
      }
      of_third += size;
      of_fourth += size * static_cast<double>(m - lowest) / here.length;
      power *= Ball(here.length);
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
  std::array<Ball, 4> d = f_.at(Ball(view_.origin) + Ball(view_.direction * s), view_.derivative);
  int sign = sign_;
  for (Ball& number : d) {
    number *= Ball(sign);
    sign *= view_.direction;
  }
  d[0] += offset_;
  return d;
}

std::array<double, 4> AffineCourse::guess_at(double s) const {
  std::array<double, 4> d = f_.guess_at(view_.origin + view_.direction * s, view_.derivative);
  int sign = sign_;
  for (double& number : d) {
    number *= sign;
    sign *= view_.direction;
  }
  d[0] += offset_.approximate();
  return d;
}

}  // namespace stickslip::numeric::machines
