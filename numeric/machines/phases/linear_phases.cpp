#include "numeric/machines/phases/linear_phases.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/sinc.hpp"
#include "numeric/machines/machine.hpp"
#include "numeric/machines/phases/exponential.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::PhaseKind;

namespace {

// The longest stretch in units of 1/nu.
constexpr double longest = 4;
constexpr std::size_t fewest_terms = 14;
// Of an exponential from one beside it.
constexpr int most_terms = 1000;
// Exponentials of a piece: one for each of its phases in most words.
constexpr std::size_t most_kept = 64;

}  // namespace

LinearPhases::LinearPhases(const model::FrictionOscillator<Ball>& oscillator)
    : oscillator_(oscillator), n_(static_cast<Eigen::Index>(oscillator.size())) {
  for (const model::HarmonicForce<Ball>& load : oscillator.loads) {
    if (load.k != 0 && std::find(multiples_.begin(), multiples_.end(), load.k) == multiples_.end()) {
      multiples_.push_back(load.k);
    }
  }
  size_ = 2 * n_ + 1 + 2 * static_cast<Eigen::Index>(multiples_.size());
  const Eigen::VectorXd half =
      start_box(model::mapped<double>(oscillator, [](const Ball& x) { return x.approximate(); })).half;
  units_ = Vector::Constant(size_, Ball(1));
  units_.head(2 * n_) = half.unaryExpr([](double x) { return Ball(std::exp2(std::round(std::log2(x)))); });
  r_ = -forces_on(oscillator_, rubbing());
}

LinearPhases::LinearPhases(const OscillatorInData& machines)
    : LinearPhases(model::mapped<Ball>(machines.numbers, [](const InData<Ball>& x) { return x.all(); })) {
  machines_ = machines;
}

template <class S>
model::VectorX<S> LinearPhases::forces_on(const model::FrictionOscillator<S>& oscillator,
                                          Eigen::Index mass) const {
  model::VectorX<S> F = model::VectorX<S>::Constant(size_, S(Ball(0)));
  for (Eigen::Index k = 0; k < n_; ++k) {
    F(k) -= oscillator.stiffness(mass, k);
    F(n_ + k) -= oscillator.damping(mass, k);
  }
  for (const model::HarmonicForce<S>& load : oscillator.loads) {
    if (static_cast<Eigen::Index>(load.mass) != mass) {
      continue;
    }
    if (load.k == 0) {
      F(2 * n_) += load.cosine;
      continue;
    }
    F(row_of_cosine(load.k)) += load.cosine;
    F(row_of_cosine(load.k) + 1) += load.sine;
  }
  return F;
}

template <class S>
model::MatrixX<S> LinearPhases::forces(const model::FrictionOscillator<S>& oscillator, Piece piece) const {
  const Eigen::Index j = rubbing();
  model::MatrixX<S> F = model::MatrixX<S>::Constant(size_, size_, S(Ball(0)));
  for (const int multiple : multiples_) {
    const Eigen::Index k = row_of_cosine(multiple);
    F(k + 1, k) = oscillator.omega * Ball(multiple);
    F(k, k + 1) -= F(k + 1, k);
  }
  for (Eigen::Index i = 0; i < n_; ++i) {
    F(i, n_ + i) = S(Ball(1));
    if (i != j || piece.kind != PhaseKind::stick) {
      F.row(n_ + i) = forces_on(oscillator, i).transpose();
    }
  }
  if (piece.kind == PhaseKind::stick) {
    return F;
  }
  // m x_j'' = u - r, u = side (force + slope (side (V - x_j') - from)).
  if (piece.number < 0 || static_cast<std::size_t>(piece.number) >= oscillator.law(piece.side()).pieces()) {
    throw InternalError("the friction law has no such piece");
  }
  if (is_smooth(piece)) {
    return F;
  }
  const model::SlidingPiece<S>& law =
      oscillator.law(piece.side()).sliding[static_cast<std::size_t>(piece.number)];
  F(n_ + j, n_ + j) -= law.slope;
  F(n_ + j, 2 * n_) += (law.force - law.slope * law.from) * Ball(piece.side()) + law.slope * oscillator.V;
  return F;
}

const Matrix& LinearPhases::drift(Piece piece) const {
  const auto [entry, is_new] = drifts_.try_emplace(piece);
  if (is_new && machines_) {
    entry->second = drift_in_data(piece).all();
  } else if (is_new) {
    entry->second = forces(oscillator_, piece);
    for (Eigen::Index i = 0; i < n_; ++i) {
      for (Eigen::Index k = 0; k < size_; ++k) {
        entry->second(n_ + i, k) /= oscillator_.masses[static_cast<std::size_t>(i)];
      }
    }
  }
  return entry->second;
}

const InData<Matrix>& LinearPhases::drift_in_data(Piece piece) const {
  const auto [entry, is_new] = drifts_in_data_.try_emplace(piece);
  if (!is_new) {
    return entry->second;
  }
  InData<Matrix> inverse(Matrix::Identity(size_, size_));  // of M
  for (Eigen::Index i = n_; i < 2 * n_; ++i) {
    const InData<Ball> one =
        reciprocal(number([&](const auto& o) { return o.masses[static_cast<std::size_t>(i - n_)]; }));
    inverse.c[0](i, i) = Ball(0);
    inverse += mapped(one, [&](const Ball& x) {
      Matrix A = Matrix::Constant(size_, size_, Ball(0));
      A(i, i) = x;
      return A;
    });
  }
  return entry->second =
             product(inverse, together(forces(machines_->numbers, piece)), sparse_product<Matrix>);
}

namespace {

// The projections on the eigenvectors of A, which has one or two.
std::vector<Matrix> projections(const Matrix& A, const std::vector<Ball>& eigenvalues) {
  const Matrix one = Matrix::Identity(A.rows(), A.cols());
  if (eigenvalues.size() == 1) {
    return {one};
  }
  const Ball apart = eigenvalues[1] - eigenvalues[0];
  const Matrix second = Matrix(A - one * eigenvalues[0]) / apart;
  return {one - second, second};
}

std::vector<Ball> eigenvalues_of(const Matrix& A) {
  if (A.rows() == 1) {
    return {A(0, 0)};
  }
  const Ball middle = (A(0, 0) + A(1, 1)) / Ball(2), half = (A(0, 0) - A(1, 1)) / Ball(2);
  const Ball apart = sqrt(half * half + A(0, 1) * A(1, 0));
  return {middle - apart, middle + apart};
}

// The submatrix of these rows and columns.
Matrix part_of(const Matrix& B, const std::vector<Eigen::Index>& rows,
               const std::vector<Eigen::Index>& columns) {
  return B(rows, columns);
}

}  // namespace

// Of the masses that move, x'' = -A x + G u with u the rest of w, u' = Omega u, and u(t) = U u: with P such
// that x = P u is a motion, x - P u moves freely, by c = cos(sqrt(A) t) and s = sin(sqrt(A) t)/sqrt(A).
std::optional<LinearPhases::Modes> LinearPhases::make_modes(Piece piece) const {
  const Matrix& B = drift(piece);
  const bool sticks = piece.kind == PhaseKind::stick;
  if (machines_) {
    return std::nullopt;
  }
  std::vector<Eigen::Index> moving, velocities, rest;  // x of the masses that move, x', and u, in w
  for (Eigen::Index i = 0; i < size_; ++i) {
    const bool is_state = i < 2 * n_ && !(sticks && i % n_ == rubbing());
    (!is_state ? rest : i < n_ ? moving : velocities).push_back(i);
  }
  const bool is_damped =
      !part_of(B, velocities, velocities).unaryExpr([](const Ball& x) { return is_zero(x); }).all();
  if (is_smooth(piece) || moving.empty() || moving.size() > 2 || is_damped) {
    return std::nullopt;
  }
  const Matrix A = -part_of(B, velocities, moving);
  const std::vector<Ball> squares = eigenvalues_of(A);
  // Divided by their difference, numbers nearer than this lose too many of their digits.
  const auto are_apart = [](const Ball& a, const Ball& b) {
    return (abs(a - b) - abs(a) * Ball(0x1p-16)).is_positive();
  };
  Modes modes;
  for (const Ball& square : squares) {
    if (!square.is_positive() || !(modes.frequencies.empty() || are_apart(square, squares[0]))) {
      return std::nullopt;
    }
    modes.frequencies.push_back(sqrt(square));
  }
  const std::vector<Matrix> onto = projections(A, squares);
  // u is at rest but for what the belt takes along, or turns with a multiple of the load's frequency.
  const Matrix Omega = part_of(B, rest, rest), G = part_of(B, velocities, rest);
  Matrix P = Matrix::Constant(G.rows(), G.cols(), Ball(0));
  for (Eigen::Index k = 0; k < G.cols(); ++k) {
    Ball turn(0);  // (its frequency)²
    for (Eigen::Index i = 0; i < G.cols(); ++i) {
      turn -= Omega(i, k) * Omega(k, i);
    }
    for (std::size_t m = 0; m < squares.size(); ++m) {
      if (!are_apart(squares[m], turn)) {
        return std::nullopt;
      }
      P.col(k) += zeros::product(onto[m], Vector(G.col(k))) / (squares[m] - turn);
    }
  }
  const Matrix P_rate = sparse_product(P, Omega), none = Matrix::Constant(A.rows(), A.cols(), Ball(0)),
               still = Matrix::Constant(size_, size_, Ball(0));
  std::vector<Matrix> factors;
  const auto add_driven = [&](const Matrix& all) {
    const Matrix U = part_of(all, rest, rest);
    Matrix& flow = factors.emplace_back(still);
    flow(rest, rest) = U;
    flow(moving, rest) = zeros::product(P, U);
    flow(velocities, rest) = zeros::product(P_rate, U);
  };
  const auto add_free = [&](const Matrix& c, const Matrix& s, const Matrix& s_rate) {
    Matrix& flow = factors.emplace_back(still);
    flow(moving, moving) = flow(velocities, velocities) = c;
    flow(moving, velocities) = s;
    flow(velocities, moving) = s_rate;
    flow(moving, rest) = -zeros::product(c, P) - zeros::product(s, P_rate);
    flow(velocities, rest) = -zeros::product(s_rate, P) - zeros::product(c, P_rate);
  };
  Matrix constant = Matrix::Identity(size_, size_), growing = still;
  for (const int multiple : multiples_) {
    const Eigen::Index k = row_of_cosine(multiple);
    constant(k, k) = constant(k + 1, k + 1) = Ball(0);
  }
  growing.block(0, n_, n_, n_) = Matrix::Identity(n_, n_);
  add_driven(constant);
  add_driven(growing);
  for (std::size_t m = 0; m < squares.size(); ++m) {
    const Ball& frequency = modes.frequencies[m];
    add_free(onto[m], none, none);
    add_free(none, onto[m] / frequency, onto[m] * Ball(-frequency));
  }
  for (const int multiple : multiples_) {
    const Eigen::Index k = row_of_cosine(multiple);
    modes.frequencies.emplace_back(Ball(multiple) * oscillator_.omega);
    Matrix cosine = still, sine = still;
    cosine(k, k) = cosine(k + 1, k + 1) = sine(k + 1, k) = Ball(1);
    sine(k, k + 1) = Ball(-1);
    add_driven(cosine);
    add_driven(sine);
  }
  modes.factors.resize(static_cast<Eigen::Index>(factors.size()), size_ * size_);
  for (Eigen::Index i = 0; i < modes.factors.rows(); ++i) {
    modes.factors.row(i) = factors[static_cast<std::size_t>(i)].reshaped().transpose();
  }
  return modes;
}

Matrix LinearPhases::in_closed_form(const Modes& modes, const Ball& t) const {
  Matrix functions(1, modes.factors.rows());
  functions(0) = Ball(1);
  functions(1) = t;
  for (std::size_t m = 0; m < modes.frequencies.size(); ++m) {
    const auto [sine, cosine] = sin_cos(Ball(modes.frequencies[m] * t));
    functions(static_cast<Eigen::Index>(2 * m + 2)) = cosine;
    functions(static_cast<Eigen::Index>(2 * m + 3)) = sine;
  }
  return zeros::product(functions, modes.factors).reshaped(size_, size_);
}

const std::optional<LinearPhases::Modes>& LinearPhases::modes(Piece piece) const {
  const auto found = modes_.find(piece);
  return found != modes_.end() ? found->second : modes_.emplace(piece, make_modes(piece)).first->second;
}

// exp(B m) exp(B p) exp(B d), with h = m + p + d, m a number, p a polynomial that is kept and d its rest.
InData<Matrix> LinearPhases::flow(Piece piece, const InData<Ball>& h) const {
  const auto over = [&](const InData<Ball>& time) {
    return exponential(
        product(drift_in_data(piece), time, [](const Matrix& B, const Ball& x) { return Matrix(B * x); }),
        units_);
  };
  InData<Ball> p = h;
  std::vector<OverTime>& kept = flows_over_times_[piece];
  auto found = std::ranges::find_if(kept, [&](const OverTime& one) {
    return std::ranges::equal(one.h.c, h.c,
                              [](const Ball& a, const Ball& b) { return arb_equal(a.raw(), b.raw()) != 0; });
  });
  if (found == kept.end()) {
    const Exponential& known = nearest(piece, h.c[0].midpoint());
    p.c[0] -= known.middle;
    p.rest = Ball(0);
    if (kept.size() >= most_kept) {
      kept.erase(kept.begin());
    }
    kept.push_back({h, is_zero(p.all()) ? known.in_data : InData<Matrix>(known.in_data * over(p))});
    found = kept.end() - 1;
  }
  InData<Ball> d(Ball(0));
  d.rest = h.rest;
  return is_zero(d.rest) ? found->flow : InData<Matrix>(found->flow * over(d));
}

Matrix LinearPhases::flow_at(Piece piece, const Ball& t) const {
  if (machines_) {
    return exponential(drift_in_data(piece) * t, units_).all();
  }
  const std::optional<Modes>& known = modes(piece);
  return known ? in_closed_form(*known, t) : exponential(drift(piece) * t);
}

const Ball& LinearPhases::norm(Piece piece) const {
  const auto [entry, is_new] = norms_.try_emplace(piece);
  if (is_new) {
    entry->second = size_in(units_, drift(piece));
  }
  return entry->second;
}

// A closed form costs less than the way from another.
const LinearPhases::Exponential& LinearPhases::nearest(Piece piece, const Ball& t) const {
  constexpr double near_enough = 0x1p-10;
  const bool is_closed = modes(piece).has_value();
  std::vector<Exponential>& all = flows_[piece];
  const auto distance = [&](const Exponential& one) { return std::abs(Ball(one.middle - t).approximate()); };
  auto found = std::ranges::min_element(all, {}, distance);
  if (found == all.end() ||
      !(distance(*found) * norm(piece).approximate() <= (is_closed ? 0 : near_enough))) {
    if (all.size() >= (is_closed ? 1 : most_kept)) {
      all.erase(all.begin());
    }
    if (machines_) {
      const InData<Matrix> flow = exponential(drift_in_data(piece) * t, units_);
      all.push_back({t, flow.all(), flow});
    } else {
      all.push_back({t, flow_at(piece, t), {}});
    }
    found = all.end() - 1;
  }
  return *found;
}

Ball LinearPhases::size_of(const Vector& w) const {
  Ball size(0);
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    size = Ball::hull(size, Ball(abs(w(i)) / units_(i)).upper()).upper();
  }
  return size;
}

namespace {

// Adds to x the terms next(x, 1), next(next(x, 1), 2), … of exp(B d) x, until the rest of the series is small
// enough. Returns that, in parts of |x|: with s = |B| |d| < 1 at most s^k/k! / (1 - s/(k + 1)).
template <class X, class Next>
Ball add_terms(X& x, const Ball& s, double enough, const Next& next) {
  X term = x;
  Ball rest = s;  // of the terms from the k-th on, if they go on as a geometric series
  for (int k = 1; k == 1 || rest.approximate() > enough; ++k) {
    term = next(term, k);
    x += term;
    rest *= s / Ball(k + 1);
    if (!rest.is_finite() || k > most_terms) {
      break;
    }
  }
  const Ball room = Ball(1) - s;
  return room.is_positive() ? Ball(rest / room).upper() : scalars::anything();
}

}  // namespace

// exp(B (m + d)) X = exp(B m) exp(B d) X: from one exponential to those beside it.
template <class M>
M LinearPhases::moved(Piece piece, const Ball& h, M X) const {
  const Matrix& B = drift(piece);
  const Ball& norm = this->norm(piece);
  const Exponential& known = nearest(piece, h.midpoint());
  const Ball d = h - known.middle;
  if (is_zero(d)) {
    return zeros::product(known.of_middle, X);
  }
  const double radius = Ball(norm * d.radius()).approximate();
  const double enough =
      std::max(radius * radius / 4, std::exp2(-static_cast<double>(WorkingPrecision::bits())));
  Vector sizes(X.cols());
  for (Eigen::Index k = 0; k < X.cols(); ++k) {
    sizes(k) = size_of(X.col(k));
  }
  const Ball share = add_terms(X, Ball(norm * abs(d)).upper(), enough, [&](const M& term, int k) {
    return M(sparse_product(B, term) * Ball(d / Ball(k)));
  });
  for (Eigen::Index k = 0; k < X.cols(); ++k) {
    for (Eigen::Index i = 0; i < X.rows(); ++i) {
      X(i, k) += scalars::within(units_(i) * sizes(k) * share);
    }
  }
  return zeros::product(known.of_middle, X);
}

// In closed form a wide ball would be one in each of its terms.
Matrix LinearPhases::flow(Piece piece, const Ball& h) const {
  constexpr double narrow = 0x1p-50;
  const bool is_narrow = h.is_exact() || (norm(piece) * h.radius()).approximate() < narrow;
  return is_narrow && modes(piece) ? flow_at(piece, h)
                                   : moved(piece, h, Matrix(Matrix::Identity(size_, size_)));
}

Vector LinearPhases::after(Piece piece, const Ball& h, const Vector& w) const {
  return moved(piece, h, w);
}

LinearPhases::Watch LinearPhases::make_watch(Piece piece, bool reversed) const {
  const Matrix& B = drift(piece);
  if (reversed) {
    Watch watch = this->watch(piece, false);
    for (Eigen::Index m = 1; m < watch.rows.rows(); m += 2) {
      watch.rows.row(m) *= Ball(-1);
    }
    watch.flow = flow_at(piece, Ball(-watch.length));
    return watch;
  }
  const Matrix transposed = B.transpose();
  Vector term = piece.kind == PhaseKind::stick ? r_ : speed();
  Watch watch{{}, balance(B), {}, {}, 1, {}, {}};
  Matrix balanced = B;
  for (Eigen::Index i = 0; i < size_; ++i) {
    watch.size += abs(term(i)) / watch.balance(i);
    for (Eigen::Index k = 0; k < size_; ++k) {
      balanced(i, k) = balanced(i, k) * watch.balance(i) / watch.balance(k);
    }
  }
  watch.nu = zeros::norm(balanced);
  watch.length = std::exp2(std::floor(std::log2(longest / std::max(watch.nu.approximate(), 1e-100))));
  watch.flow = flow_at(piece, Ball(watch.length));
  const double below = std::exp2(-static_cast<double>(WorkingPrecision::bits()));
  double size = 1;
  std::vector<Vector> rows;
  while (rows.size() < fewest_terms || size > below) {
    rows.push_back(term);
    const auto m = static_cast<int>(rows.size());
    term = sparse_product(transposed, term) * Ball(Ball(1) / Ball(m));
    size *= longest / m;
  }
  watch.rows.resize(static_cast<Eigen::Index>(rows.size()), size_);
  for (std::size_t m = 0; m < rows.size(); ++m) {
    watch.rows.row(static_cast<Eigen::Index>(m)) = rows[m].transpose();
  }
  // The sum over m >= M of nu^i (nu r)^(m - i)/(m - i)!, whose terms fall at least by half from one to the
  // next if 2 nu r is at most M - i + 1.
  const Ball reach = watch.nu * Ball(watch.length);
  const auto fewest = static_cast<long>(rows.size() - watch.rest.size()) + 2;
  const bool is_short = !(Ball(fewest) - Ball(2) * reach).lower().is_negative();
  Ball factor(2);
  for (std::size_t i = 0; i < watch.rest.size(); ++i) {
    watch.rest[i] = factor;
    for (std::size_t m = 1; m + i <= rows.size(); ++m) {
      watch.rest[i] = watch.rest[i] * reach / Ball(static_cast<long>(m));
    }
    watch.rest[i] = is_short ? watch.rest[i] : scalars::anything();
    factor = factor * watch.nu;
  }
  return watch;
}

const LinearPhases::Watch& LinearPhases::watch(Piece piece, bool reversed) const {
  const auto found = watches_.find({piece, reversed});
  return found != watches_.end()
             ? found->second
             : watches_.emplace(std::pair(piece, reversed), make_watch(piece, reversed)).first->second;
}

Vector LinearPhases::whole(const Vector& state, const Ball& theta) const {
  Vector w(size_);
  w.head(2 * n_) = state;
  w(2 * n_) = Ball(1);
  for (const int multiple : multiples_) {
    const Eigen::Index k = row_of_cosine(multiple);
    const auto [sine, cosine] = sin_cos(Ball(Ball(multiple) * theta));
    w(k) = cosine;
    w(k + 1) = sine;
  }
  return w;
}

InData<Matrix> LinearPhases::watched(Piece piece) const {
  return piece.kind == PhaseKind::stick && machines_
             ? together(forces_on(machines_->numbers, rubbing()).transpose()) * Ball(-1)
             : InData<Matrix>(Matrix((piece.kind == PhaseKind::stick ? r_ : speed()).transpose()));
}

InData<Matrix> LinearPhases::whole(const InData<Matrix>& state, const InData<Ball>& theta) const {
  const auto number_at = [&](Eigen::Index row) {
    return [&, row](const Ball& x) { return Matrix(placed(x, row, size_)); };
  };
  InData<Matrix> w = mapped(state, [&](const Matrix& x) { return placed(x, 0, size_); });
  w += InData<Matrix>(number_at(2 * n_)(Ball(1)));
  for (const int multiple : multiples_) {
    const auto [sine, cosine] = sin_cos(theta * Ball(multiple));
    w += mapped(cosine, number_at(row_of_cosine(multiple)));
    w += mapped(sine, number_at(row_of_cosine(multiple) + 1));
  }
  return w;
}

std::vector<Eigen::Index> LinearPhases::rows_but_speed() const {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(2 * n_));
  std::iota(rows.begin(), rows.end(), 0);
  rows.erase(rows.begin() + speed_row());
  return rows;
}

Vector LinearPhases::speed() const {
  return Vector::Unit(size_, speed_row());
}
Vector LinearPhases::one() const {
  return Vector::Unit(size_, 2 * n_);
}

}  // namespace stickslip::numeric::machines
