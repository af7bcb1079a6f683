#include "numeric/machines/smooth_phase.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr long most_steps = 100000;
constexpr int most_attempts = 24;
constexpr long box_bits = 64;
constexpr int bits_of_a_length = 30;

Ball relative_velocity(const LinearPhases& phases, int side, const Vector& w) {
  return Ball(side) * (phases.oscillator().V - w(phases.speed_row()));
}

const Ball& mass_of(const LinearPhases& phases) {
  return phases.oscillator().masses[phases.oscillator().rubbing];
}

template <class M>
M value_at(const std::vector<M>& coefficients, const Ball& s) {
  M value = coefficients.back();
  for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
    value = M(value * s) + coefficients[k];
  }
  return value;
}

// a_0 b_n + a_1 b_(n-1) + … + a_n b_0.
Ball folded(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  static_assert(sizeof(Ball) == sizeof(arb_struct));
  Ball sum;
  arb_dot(sum.raw(), nullptr, 0, a.front().raw(), 1, b.back().raw(), -1, static_cast<slong>(a.size()),
          WorkingPrecision::bits());
  return sum;
}

}  // namespace

Vector smooth_rate(const LinearPhases& phases, int side, const Vector& w) {
  const model::SmoothFriction<Ball>& law = *phases.oscillator().law(side).smooth;
  Vector rate = sparse_product(phases.drift(Piece::sliding(side)), w);
  rate(phases.speed_row()) += Ball(side) * law.force(relative_velocity(phases, side, w)) / mass_of(phases);
  return rate;
}

SmoothPhase::SmoothPhase(const LinearPhases& phases, int side, const Vector& w, const Ball& T, bool reversed,
                         bool with_derivative)
    : phases_(phases),
      law_(*phases.oscillator().law(side).smooth),
      drift_(phases.drift(Piece::sliding(side))),
      side_(side),
      direction_(reversed ? -1 : 1),
      with_derivative_(with_derivative),
      states_(2 * phases.masses()),
      speed_(phases.speed_row()),
      balance_(balance(drift_)),
      balance_in_double_(zeros::in_double(balance_)),
      T_(T),
      quantum_(std::exp2(std::ceil(std::log2(std::max(T.approximate(), 1e-300))) - bits_of_a_length)) {
  const double last = T.approximate() * (1 - 1e-9);
  Vector now = w;
  constexpr double more = 1.25;  // than the step before
  double start = 0, longest = 2 * T.approximate();
  do {
    const std::optional<Step> next =
        static_cast<long>(steps_.size()) < most_steps ? step(now, start, longest) : std::nullopt;
    if (!next) {
      steps_.clear();
      return;
    }
    steps_.push_back(*next);
    now = value_at(next->w, Ball(next->length));
    start += next->length;
    longest = more * next->length;
  } while (start < last);
}

// The powers of the time since the start in w, in f(v) and, for the derivative, in f'(v), from w' and from
// the shape s = exp(-v/c): s' = -s v'/c, or s = c/(c + v): s (c + v) = c.
SmoothPhase::Series SmoothPhase::series(const Vector& w, const Matrix& derivative, std::size_t order) const {
  const bool exponential = law_.fall == model::Fall::exponential;
  const Ball drop = law_.first - law_.last;
  const Ball& m = mass_of(phases_);
  const Ball room = law_.scale + relative_velocity(phases_, side_, w);
  Series result{{w}, {}};
  std::vector<std::vector<Ball>> speeds(static_cast<std::size_t>(states_));  // rows of x_j' in the derivative
  if (with_derivative_) {
    result.derivative.push_back(derivative);
  }
  std::vector<Ball> shape, slope;
  std::vector<Ball> turns;  // what the shape is folded with: i v_i, or v_i, from i = 1
  for (std::size_t k = 0; k < order; ++k) {
    const Ball number(static_cast<long>(k));
    const Ball v = k == 0 ? relative_velocity(phases_, side_, w) : Ball(Ball(-side_) * result.w[k](speed_));
    if (k == 0) {
      shape.push_back(law_.shape(v));
    } else {
      turns.push_back(exponential ? Ball(number * v) : v);
      const Ball sum = folded(turns, shape);
      shape.push_back(-sum / (exponential ? Ball(law_.scale * number) : room));
    }
    const Ball force = (k == 0 ? law_.last : Ball(0)) + drop * shape[k] + law_.viscous * v;
    const Ball over = Ball(direction_) / (number + Ball(1));
    Vector next = sparse_product(drift_, result.w[k]);
    next(speed_) += Ball(side_) * force / m;
    result.w.emplace_back(next * over);
    if (!with_derivative_) {
      continue;
    }
    slope.push_back((k == 0 ? law_.viscous : Ball(0)) -
                    drop / law_.scale * (exponential ? shape[k] : folded(shape, shape)));
    Matrix turn = sparse_product(Matrix(drift_.topLeftCorner(states_, states_)), result.derivative[k]);
    for (Eigen::Index column = 0; column < states_; ++column) {
      std::vector<Ball>& speed = speeds[static_cast<std::size_t>(column)];
      speed.push_back(result.derivative[k](speed_, column));
      turn(speed_, column) -= folded(slope, speed) / m;
    }
    result.derivative.emplace_back(turn * over);
  }
  return result;
}

double SmoothPhase::size(const Vector& w) const {
  double most = 0;
  for (Eigen::Index i = 0; i < states_; ++i) {
    most = std::max(most, balance_in_double_(i) * abs(w(i)).upper().approximate());
  }
  return most;
}

double SmoothPhase::size(const Matrix& derivative) const {
  double most = 0;
  for (Eigen::Index i = 0; i < states_; ++i) {
    for (Eigen::Index k = 0; k < states_; ++k) {
      most = std::max(
          most, abs(derivative(i, k)).upper().approximate() * balance_in_double_(i) / balance_in_double_(k));
    }
  }
  return most;
}

// In which what follows the last terms is below the working precision, if they go on as they do.
double SmoothPhase::likely_length(const Series& series) const {
  const std::size_t order = series.w.size();
  double length = 2 * std::max(T_.approximate(), 1e-300);
  const auto shorten = [&](double whole, double term, std::size_t k) {
    if (whole > 0 && term > 0) {
      const double bits = static_cast<double>(WorkingPrecision::bits()) + std::log2(term / whole);
      length = std::min(length, std::exp2(-bits / static_cast<double>(k)));
    }
  };
  for (std::size_t k = order - 3; k < order; ++k) {
    shorten(size(series.w[0]), size(series.w[k]), k);
    if (with_derivative_) {
      shorten(1, size(series.derivative[k]), k);
    }
  }
  return length;
}

// |D - I| <= exp(nu length) - 1 in the balanced norm of row sums, nu that of the equation for D' on the box.
Matrix SmoothPhase::derivative_box(const Vector& w, double length) const {
  Matrix A = drift_.topLeftCorner(states_, states_);
  A(speed_, speed_) -= law_.slope(relative_velocity(phases_, side_, w)) / mass_of(phases_);
  for (Eigen::Index i = 0; i < states_; ++i) {
    for (Eigen::Index k = 0; k < states_; ++k) {
      A(i, k) = A(i, k) * balance_(i) / balance_(k);
    }
  }
  const Ball far = Ball(exp(Ball(zeros::norm(A) * Ball(length))) - Ball(1)).upper();
  Matrix D(states_, states_);
  for (Eigen::Index i = 0; i < states_; ++i) {
    for (Eigen::Index k = 0; k < states_; ++k) {
      D(i, k) = Ball(i == k ? 1 : 0) + scalars::within(far * balance_(k) / balance_(i));
    }
  }
  return D;
}

std::optional<SmoothPhase::Series> SmoothPhase::over(const Series& here, double length) const {
  constexpr double room = 0x1p-20;
  const WorkingPrecision scope(box_bits);
  const Ball times = Ball::hull(Ball(0), Ball(length));
  Vector box = value_at(here.w, times);
  const Vector range = box;
  const double size_of_all = std::max(size(box), 1e-300);
  for (Eigen::Index i = 0; i < box.size(); ++i) {
    box(i) += scalars::within(i < states_ ? room * size_of_all / balance_in_double_(i) : room);
  }
  const std::size_t order = here.w.size();
  const Series last = series(box, with_derivative_ ? derivative_box(box, length) : Matrix(), order);
  Ball power(1);
  for (std::size_t k = 0; k < order; ++k) {
    power *= times;
  }
  for (Eigen::Index i = 0; i < box.size(); ++i) {
    const Ball value = range(i) + last.w.back()(i) * power;
    if (!value.is_interior_to(box(i))) {
      return std::nullopt;
    }
  }
  return last;
}

std::optional<SmoothPhase::Step> SmoothPhase::step(const Vector& w, double start, double longest) const {
  constexpr long bits_for_a_term = 2;
  constexpr double spare = 0x1p8, shorter = 0.75;
  if (!std::ranges::all_of(w, [](const Ball& x) { return x.is_finite(); })) {
    return std::nullopt;
  }
  const long bits = WorkingPrecision::bits();
  const auto order = static_cast<std::size_t>(bits / bits_for_a_term);
  Series here =
      series(w, with_derivative_ ? Matrix(Matrix::Identity(states_, states_)) : Matrix(), order - 1);
  const double below = spare * std::exp2(-static_cast<double>(bits));
  double length = std::min(likely_length(here), longest);
  for (int attempt = 0; attempt <= most_attempts; ++attempt, length *= shorter) {
    length = std::floor(length / quantum_) * quantum_;
    const std::optional<Series> last = length > 0 ? over(here, length * longer) : std::nullopt;
    if (!last) {
      continue;
    }
    const double power = std::pow(length, static_cast<double>(order));
    const bool small = size(last->w.back()) * power <= below * size(w) &&
                       (!with_derivative_ || size(last->derivative.back()) * power <= below);
    if (small || attempt == most_attempts) {
      here.w.push_back(last->w.back());
      if (with_derivative_) {
        here.derivative.push_back(last->derivative.back());
      }
      return Step{start, length, here.w, here.derivative};
    }
  }
  return std::nullopt;
}

std::optional<Ball> SmoothPhase::time_in(const Step& step) const {
  const Ball s = T_ - Ball(step.start);
  return s.lower().is_negative() || (Ball(step.length * longer) - s).lower().is_negative() ? std::nullopt
                                                                                           : std::optional(s);
}

Vector SmoothPhase::end() const {
  const std::optional<Ball> s = steps_.empty() ? std::nullopt : time_in(steps_.back());
  return s ? value_at(steps_.back().w, *s) : Vector::Constant(drift_.rows(), scalars::anything());
}

Matrix SmoothPhase::derivative() const {
  const std::optional<Ball> s = steps_.empty() ? std::nullopt : time_in(steps_.back());
  if (!s) {
    return Matrix::Constant(states_, states_, scalars::anything());
  }
  Matrix D = Matrix::Identity(states_, states_);
  for (const Step& step : steps_) {
    const bool last = &step == &steps_.back();
    D = Matrix(zeros::product(value_at(step.derivative, last ? *s : Ball(step.length)), D));
  }
  return D;
}

}  // namespace stickslip::numeric::machines
