#include "numeric/machines/phases/smooth_phase.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr long most_steps = 100000;
constexpr int most_attempts = 24;
constexpr long box_bits = 64;
constexpr int bits_of_a_length = 30;

// For all data.
const Ball& over_all(const Ball& x) {
  return x;
}
Ball over_all(const InData<Ball>& x) {
  return x.all();
}
// Adds a number of the ball, another for each of the data.
void widen(Ball& x, const Ball& by) {
  x += by;
}
void widen(InData<Ball>& x, const Ball& by) {
  x.rest += by;
}

// As sparse_product, over data, too.
template <class S, class M>
M product_of_sparse(const model::MatrixX<S>& A, const M& B) {
  M C = M::Constant(A.rows(), B.cols(), S(Ball(0)));
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index k = 0; k < A.cols(); ++k) {
      for (Eigen::Index l = 0; l < B.cols() && !is_none(A(i, k)); ++l) {
        add_product(C(i, l), A(i, k), B(k, l));
      }
    }
  }
  return C;
}

// Of matrices without zeros.
Matrix dense_product(const Matrix& A, const Matrix& B) {
  return zeros::product(A, B);
}
model::MatrixX<InData<Ball>> dense_product(const model::MatrixX<InData<Ball>>& A,
                                           const model::MatrixX<InData<Ball>>& B) {
  return entries(together(A) * together(B));
}

template <class M, class T>
M times(const M& A, const T& x) {
  using S = typename M::Scalar;
  return A.unaryExpr([&](const S& entry) { return S(entry * x); });
}
template <class S>
model::MatrixX<S> constant(const Matrix& A) {
  return A.unaryExpr([](const Ball& entry) { return S(entry); });
}

template <class M, class T>
M value_at(const std::vector<M>& coefficients, const T& s) {
  M value = coefficients.back();
  for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
    value = times(value, s);
    value += coefficients[k];
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
InData<Ball> folded(const std::vector<InData<Ball>>& a, const std::vector<InData<Ball>>& b) {
  InData<Ball> sum(Ball(0));
  for (std::size_t k = 0; k < a.size(); ++k) {
    add_product(sum, a[k], b[b.size() - 1 - k]);
  }
  return sum;
}

template <class S>
model::MatrixX<S> drift_of(const LinearPhases& phases, int side) {
  if constexpr (std::is_same_v<S, Ball>) {
    return phases.drift(Piece::sliding(side));
  } else {
    return entries(phases.drift_in_data(Piece::sliding(side)));
  }
}

template <class S>
S relative_velocity(const LinearPhases& phases, int side, const model::VectorX<S>& w) {
  return (phases.numbers<S>().V - w(phases.speed_row())) * Ball(side);
}

// Which the Taylor polynomials are taken to: over data more is left out by those in the data.
template <class S>
long bits_in_time() {
  return std::is_same_v<S, Ball> ? WorkingPrecision::bits() : std::min(WorkingPrecision::bits(), 44L);
}

// What the friction does to x_j''.
template <class S>
S pushed(const LinearPhases& phases, int side, const S& force) {
  const auto& o = phases.numbers<S>();
  return force * Ball(side) / o.masses[o.rubbing];
}

}  // namespace

template <class S>
model::VectorX<S> smooth_rate(const LinearPhases& phases, int side, const model::VectorX<S>& w) {
  const model::SmoothFriction<S>& law = *phases.numbers<S>().law(side).smooth;
  model::VectorX<S> rate = product_of_sparse(drift_of<S>(phases, side), w);
  rate(phases.speed_row()) += pushed<S>(phases, side, law.force(relative_velocity(phases, side, w)));
  return rate;
}

template <class S>
SmoothPhaseOf<S>::SmoothPhaseOf(const LinearPhases& phases, int side, const Column& w, const S& T,
                                bool reversed, bool with_derivative)
    : phases_(phases),
      law_(*phases.numbers<S>().law(side).smooth),
      drift_(drift_of<S>(phases, side)),
      side_(side),
      direction_(reversed ? -1 : 1),
      with_derivative_(with_derivative),
      states_(2 * phases.masses()),
      speed_(phases.speed_row()),
      balance_(balance(phases.drift(Piece::sliding(side)))),
      balance_in_double_(zeros::in_double(balance_)),
      T_(T),
      quantum_(
          std::exp2(std::ceil(std::log2(std::max(over_all(T).approximate(), 1e-300))) - bits_of_a_length)) {
  follow(w);
}

// The last step has to begin before all members of T, so one that would end among them is taken shorter.
template <class S>
void SmoothPhaseOf<S>::follow(const Column& w) {
  constexpr double more = 1.25;  // than the step before
  const Ball all = over_all(T_);
  const double first = all.lower().approximate() * (1 - 1e-9), last = all.upper().approximate();
  Column now = w;
  double start = 0, longest = 2 * last;
  do {
    std::optional<Step> next =
        static_cast<long>(steps_.size()) < most_steps ? step(now, start, longest) : std::nullopt;
    if (next && start + next->length >= first && start + next->length * longer < last) {
      next = step(now, start, first - start);
    }
    if (!next) {
      steps_.clear();
      return;
    }
    steps_.push_back(*next);
    now = value_at(next->w, Ball(next->length));
    start += next->length;
    longest = more * next->length;
  } while (start < first);
}

// The powers of the time since the start in w, in f(v) and, for the derivative, in f'(v), from w' and from
// the shape s = exp(-v/c): s' = -s v'/c, or s = c/(c + v): s (c + v) = c.
template <class S>
auto SmoothPhaseOf<S>::series(const Column& w, const Square& derivative, std::size_t order) const -> Series {
  const bool exponential = law_.fall == model::Fall::exponential;
  const S drop = law_.first - law_.last;
  const S room = law_.scale + relative_velocity(phases_, side_, w);
  Series result{{w}, {}};
  std::vector<std::vector<S>> speeds(static_cast<std::size_t>(states_));  // rows of x_j' in the derivative
  if (with_derivative_) {
    result.derivative.push_back(derivative);
  }
  const Square of_states = drift_.topLeftCorner(states_, states_);
  std::vector<S> shape, slope;
  std::vector<S> turns;  // what the shape is folded with: i v_i, or v_i, from i = 1
  for (std::size_t k = 0; k < order; ++k) {
    const Ball number(static_cast<long>(k));
    const S v = k == 0 ? relative_velocity(phases_, side_, w) : S(result.w[k](speed_) * Ball(-side_));
    if (k == 0) {
      shape.push_back(law_.shape(v));
    } else {
      turns.push_back(exponential ? S(v * number) : v);
      const S sum = folded(turns, shape);
      shape.push_back(-sum / (exponential ? S(law_.scale * number) : room));
    }
    const S force = (k == 0 ? law_.last : S(Ball(0))) + drop * shape[k] + law_.viscous * v;
    const Ball over = Ball(direction_) / (number + Ball(1));
    Column next = product_of_sparse(drift_, result.w[k]);
    next(speed_) += pushed<S>(phases_, side_, force);
    result.w.push_back(times(next, over));
    if (!with_derivative_) {
      continue;
    }
    slope.push_back((k == 0 ? law_.viscous : S(Ball(0))) -
                    drop / law_.scale * (exponential ? shape[k] : folded(shape, shape)));
    Square turn = product_of_sparse(of_states, result.derivative[k]);
    for (Eigen::Index column = 0; column < states_; ++column) {
      std::vector<S>& speed = speeds[static_cast<std::size_t>(column)];
      speed.push_back(result.derivative[k](speed_, column));
      turn(speed_, column) -= pushed<S>(phases_, 1, folded(slope, speed));
    }
    result.derivative.push_back(times(turn, over));
  }
  return result;
}

template <class S>
double SmoothPhaseOf<S>::size(const Column& w) const {
  double most = 0;
  for (Eigen::Index i = 0; i < states_; ++i) {
    most = std::max(most, balance_in_double_(i) * abs(over_all(w(i))).upper().approximate());
  }
  return most;
}

template <class S>
double SmoothPhaseOf<S>::size(const Square& derivative) const {
  double most = 0;
  for (Eigen::Index i = 0; i < states_; ++i) {
    for (Eigen::Index k = 0; k < states_; ++k) {
      most = std::max(most, abs(over_all(derivative(i, k))).upper().approximate() * balance_in_double_(i) /
                                balance_in_double_(k));
    }
  }
  return most;
}

// In which what follows the last terms is below those bits, if they go on as they do.
template <class S>
double SmoothPhaseOf<S>::likely_length(const Series& series) const {
  const std::size_t order = series.w.size();
  double length = 2 * std::max(over_all(T_).approximate(), 1e-300);
  const auto shorten = [&](double whole, double term, std::size_t k) {
    if (whole > 0 && term > 0) {
      const double bits = static_cast<double>(bits_in_time<S>()) + std::log2(term / whole);
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
template <class S>
auto SmoothPhaseOf<S>::derivative_box(const Column& w, double length) const -> Square {
  Matrix A = phases_.drift(Piece::sliding(side_)).topLeftCorner(states_, states_);
  A(speed_, speed_) -= over_all(pushed<S>(phases_, 1, law_.slope(relative_velocity(phases_, side_, w))));
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
  return constant<S>(D);
}

template <class S>
auto SmoothPhaseOf<S>::over(const Series& here, double length) const -> std::optional<Series> {
  constexpr double room = 0x1p-20;
  const WorkingPrecision scope(box_bits);
  const Ball all = Ball::hull(Ball(0), Ball(length));
  Column box = value_at(here.w, all);
  const double size_of_all = std::max(size(box), 1e-300);
  const auto room_of = [&](Eigen::Index i) {
    return scalars::within(i < states_ ? room * size_of_all / balance_in_double_(i) : room);
  };
  for (Eigen::Index i = 0; i < box.size(); ++i) {
    widen(box(i), room_of(i));
  }
  const std::size_t order = here.w.size();
  const Series last = series(box, with_derivative_ ? derivative_box(box, length) : Square(), order);
  Ball power(1);
  for (std::size_t k = 0; k < order; ++k) {
    power *= all;
  }
  for (Eigen::Index i = 0; i < box.size(); ++i) {
    if (!Ball(over_all(last.w.back()(i)) * power).is_interior_to(room_of(i))) {
      return std::nullopt;
    }
  }
  return last;
}

template <class S>
auto SmoothPhaseOf<S>::step(const Column& w, double start, double longest) const -> std::optional<Step> {
  constexpr long bits_for_a_term = std::is_same_v<S, Ball> ? 2 : 3;
  constexpr double spare = 0x1p8, shorter = 0.75;
  if (!std::ranges::all_of(w, [](const S& x) { return over_all(x).is_finite(); })) {
    return std::nullopt;
  }
  const long bits = bits_in_time<S>();
  const auto order = static_cast<std::size_t>(bits / bits_for_a_term);
  Series here =
      series(w, with_derivative_ ? constant<S>(Matrix::Identity(states_, states_)) : Square(), order - 1);
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

template <class S>
std::optional<S> SmoothPhaseOf<S>::time_in(const Step& step) const {
  const S time = T_ - S(Ball(step.start));
  const Ball s = over_all(time);
  return s.lower().is_negative() || (Ball(step.length * longer) - s).lower().is_negative()
             ? std::nullopt
             : std::optional(time);
}

template <class S>
auto SmoothPhaseOf<S>::end() const -> Column {
  const std::optional<S> s = steps_.empty() ? std::nullopt : time_in(steps_.back());
  return s ? value_at(steps_.back().w, *s) : Column::Constant(drift_.rows(), S(scalars::anything()));
}

template <class S>
auto SmoothPhaseOf<S>::derivative() const -> Square {
  const std::optional<S> s = steps_.empty() ? std::nullopt : time_in(steps_.back());
  if (!s) {
    return Square::Constant(states_, states_, S(scalars::anything()));
  }
  Square D = constant<S>(Matrix::Identity(states_, states_));
  for (const Step& step : steps_) {
    const bool last = &step == &steps_.back();
    D = dense_product(last ? value_at(step.derivative, *s) : value_at(step.derivative, Ball(step.length)), D);
  }
  return D;
}

template class SmoothPhaseOf<Ball>;
template class SmoothPhaseOf<InData<Ball>>;
template Vector smooth_rate(const LinearPhases&, int, const Vector&);
template model::VectorX<InData<Ball>> smooth_rate(const LinearPhases&, int,
                                                  const model::VectorX<InData<Ball>>&);

}  // namespace stickslip::numeric::machines
