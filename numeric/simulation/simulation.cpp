#include "numeric/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/domain.hpp"
#include "core/sinc.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::simulation {

using namespace motion;
using model::Vector4;

namespace {

// Shorter than this, no time has passed.
constexpr double instant = 1e-15;
// What is left of a time and is this part of a step is a whole one, up to rounding.
constexpr double whole_step = 1 - 1e-13;
// So many transitions in one instant, and the mass is held.
constexpr int most_at_once = 32;
// The limits of the paper's data: within them no product that is formed overflows (discriminants square), and
// a step is far longer than an instant.
constexpr double greatest_length = 1e100;  // of states, V, us, ur and p
constexpr double greatest_frequency = 1e10;
// For how long a mass is held at first that neither slips nor has r turn back.
constexpr double shortest_hold = 1e-9;
// What rounding can do to a sum, in parts of its terms.
constexpr double units = 8 * 0x1p-53;
// Terms of a Taylor polynomial below this part of it are left out, as those beyond its order are.
constexpr double least_term = 1e-17;

const model::Parameters<double>& in_domain(const model::Parameters<double>& a, double ur, double phi,
                                           const Vector4<double>& X) {
  require(a.chi >= 1e-100 && a.chi < 1, "chi", a.chi, "1e-100 <= chi < 1");
  require(a.eta >= 1e-20 && a.eta <= 1e20, "eta", a.eta, "1e-20 <= eta <= 1e20");
  require(a.us > 0 && a.us <= greatest_length, "us", a.us, "0 < us <= 1e100");
  require(std::abs(a.V) <= greatest_length, "V", a.V, "-1e100 <= V <= 1e100");
  require(a.omega >= 1e-100 && a.omega <= greatest_frequency, "omega", a.omega, "1e-100 <= omega <= 1e10");
  require(a.p >= 0 && a.p <= greatest_length, "p", a.p, "0 <= p <= 1e100");
  require(ur >= a.us && ur <= greatest_length, "ur", ur, "us <= ur <= 1e100");
  require(std::isfinite(phi), "phi", phi, "a finite number");
  for (int i = 0; i < 4; ++i) {
    require(std::abs(X(i)) <= greatest_length, "the state", X(i), "numbers from -1e100 to 1e100");
  }
  return a;
}

// The lowest coefficient that is not zero decides whether a function grows where it is zero: its order if it
// does, else 0.
int order_of_growth(const Cubic& g) {
  for (std::size_t k = 1; k < 4; ++k) {
    if (g.c[k] != 0) {
      return g.c[k] > 0 ? static_cast<int>(k) : 0;
    }
  }
  return 0;
}

// The order of the zero that the distance has where a part of a step begins and from where it grows, 0 where
// there is none; -1 when it does not grow. `begins`: it is zero there, and leaves zero at this rate.
inline int zeros(Cubic& g, double rounding, bool begins, double rate) {
  if (begins) {
    g.c[0] = 0;
    g.c[1] = rate;
    const int zero_order = order_of_growth(g);
    return zero_order == 0 ? -1 : zero_order;
  }
  if (g.c[0] > rounding) {
    return 0;
  }
  if (!(g.c[1] > 0)) {
    return -1;
  }
  g.c[0] = 0;
  return 1;
}

// Whether the distance is zero at t, up to rounding, and falls.
inline bool comes_to_zero(const Cubic& g, double t, double rounding) {
  const auto& [c0, c1, c2, c3] = g.c;
  return c0 + t * (c1 + t * (c2 + t * c3)) + g.rest * t * t * t * t <= rounding &&
         c1 + t * (2 * c2 + t * 3 * c3) + 4 * g.rest * t * t * t < 0;
}

// sign f + offset.
inline Cubic affine(const Cubic& f, double sign, double offset) {
  return {{sign * f.c[0] + offset, sign * f.c[1], sign * f.c[2], sign * f.c[3]}, f.rest};
}

// y = A x, by blocks of rows that stay in registers.
template <class A, class X, class Y>
inline void multiply(const A& a, const X& x, Y& y) {
  Eigen::Index i = 0;
  const auto blocks_of = [&]<int rows>() {
    for (; i + rows <= a.rows(); i += rows) {
      Eigen::Matrix<double, rows, 1> sum = a.template block<rows, 1>(i, 0) * x(0);
      for (Eigen::Index k = 1; k < a.cols(); ++k) {
        sum += a.template block<rows, 1>(i, k) * x(k);
      }
      y.template segment<rows>(i) = sum;
    }
  };
  blocks_of.template operator()<8>();
  blocks_of.template operator()<4>();
  blocks_of.template operator()<2>();
  blocks_of.template operator()<1>();
}

}  // namespace

double friction_at_rest(const model::Parameters<double>& a, const Vector4<double>& X, double psi) {
  return a.chi * (X(1) - X(0)) - a.p / a.eta * std::cos(psi);
}

template <int N, int L>
SimulationOf<N, L>::SimulationOf(const model::FrictionOscillator<double>& o, double phi, const State& X)
    : n_(static_cast<Eigen::Index>(o.size())),
      j_(static_cast<Eigen::Index>(o.rubbing)),
      m_(o.masses[o.rubbing]),
      V_(o.V),
      forward_(o.forward.at_rest),
      backward_(o.backward.at_rest),
      omega_(o.omega),
      Theta_(o.is_autonomous() ? std::numeric_limits<double>::infinity() : 2 * std::numbers::pi / o.omega) {
  std::vector<double> frequencies;
  for (const model::HarmonicForce<double>& load : o.loads) {
    const double frequency = load.k * omega_;
    if (load.k != 0 && std::find(frequencies.begin(), frequencies.end(), frequency) == frequencies.end()) {
      frequencies.push_back(frequency);
    }
  }
  L_ = static_cast<Eigen::Index>(frequencies.size());
  frequencies_ = Eigen::Map<const Eigen::VectorXd>(frequencies.data(), L_);
  w_.setZero(2 * n_ + 1 + 2 * L_);
  acceleration_.resize(n_);
  rates_.setZero(n_, w_.size());
  rates_.template leftCols<N>(n_) = -o.stiffness;
  rates_.template middleCols<N>(n_, n_) = -o.damping;
  for (const model::HarmonicForce<double>& load : o.loads) {
    const auto i = static_cast<Eigen::Index>(load.mass);
    if (load.k == 0) {
      rates_(i, 2 * n_) += load.cosine;
      continue;
    }
    const auto l = std::find(frequencies.begin(), frequencies.end(), load.k * omega_) - frequencies.begin();
    rates_(i, 2 * n_ + 1 + 2 * l) += load.cosine;
    rates_(i, 2 * n_ + 2 + 2 * l) += load.sine;
  }
  for (Eigen::Index i = 0; i < n_; ++i) {
    rates_.row(i) /= o.masses[static_cast<std::size_t>(i)];
  }
  const std::ptrdiff_t slips = std::ssize(o.forward.sliding),
                       count = 1 + slips + std::ssize(o.backward.sliding);
  const auto pieces = std::make_shared<Piece[]>(static_cast<std::size_t>(count));
  add_pieces(1, o.forward, &pieces[1]);
  add_pieces(-1, o.backward, &pieces[1 + slips]);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    prepare(pieces[i]);
  }
  pieces_ = pieces;
  restart(phi, X);
}

template <int N, int L>
void SimulationOf<N, L>::restart(double phi, const State& X) {
  phi_ = std::abs(phi) > 4 ? std::atan2(std::sin(phi), std::cos(phi)) : phi;  // omega t is added to it
  periods_ = 0;
  t_ = age_ = hold_ = hold_length_ = 0;
  fresh_ = at_upper_ = upper_end_ = false;
  standstill_ = 0;
  spent_ = {};
  now_ = 0;
  w_.template head<states>(2 * n_) = X;
  w_(2 * n_) = 1;
  set_load();
  const double relative = V_ - w_(n_ + j_);
  if (relative == 0) {
    const double r = friction_at_rest();
    if (r >= forward_ || -r >= backward_) {
      leave_or_stick(r, nullptr);
    }
    age_ = 1;
    return;
  }
  now_ = first_piece(relative > 0 ? 1 : -1);
  while (std::abs(relative) > pieces_[now_].to) {
    ++now_;
  }
}

// The pieces of a side as u = force - slope x_j', from the given place on.
template <int N, int L>
void SimulationOf<N, L>::add_pieces(int side, const model::FrictionLaw<double>& law, Piece * place) const {
  const auto& all = law.sliding;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Piece& piece = place[i];
    piece.kind = side > 0 ? PhaseKind::slip : PhaseKind::overshoot;
    piece.number = static_cast<int>(i);
    piece.from = all[i].from;
    piece.to = i + 1 < all.size() ? all[i + 1].from : std::numeric_limits<double>::infinity();
    piece.force = side * (all[i].force - all[i].slope * all[i].from) + all[i].slope * V_;
    piece.slope = all[i].slope;
  }
}

// Of the motions without loads.
template <int N, int L>
double SimulationOf<N, L>::fastest(const Eigen::MatrixXd& rates) const {
  Eigen::MatrixXd drift = Eigen::MatrixXd::Zero(2 * n_, 2 * n_);
  drift.topRightCorner(n_, n_).setIdentity();
  drift.bottomRows(n_) = rates.leftCols(2 * n_);
  const double own = zeros::spectral_radius(drift);
  return L_ == 0 ? own : std::max(own, frequencies_.maxCoeff());
}

// The length of a step by the fastest of the phase's own motions and of the load. A step is linear: it is
// taken by each number alone.
template <int N, int L>
void SimulationOf<N, L>::prepare(Piece& piece) {
  piece.rates = rates_;
  piece.rates(j_, n_ + j_) -= piece.slope / m_;
  piece.rates(j_, 2 * n_) += piece.force / m_;
  double angle = fastest(piece.rates);
  if (piece.kind == PhaseKind::stick) {
    piece.rates.row(j_).setZero();
    const double held = fastest(piece.rates);
    angle = held > 0 ? held : angle;  // else nothing but the belt moves
  }
  piece.step = step_angle / (angle > 0 ? angle : 1);
  if (std::isfinite(Theta_)) {
    piece.step = Theta_ / std::ceil(Theta_ / piece.step);  // a period without an event ends with a whole step
  }
  const Eigen::Index D = w_.size();
  piece.flow.setZero(D, D);
  piece.watched.resize(order + 1, D);
  for (Eigen::Index i = 0; i < D; ++i) {
    term_ = Whole::Unit(D, i);
    for (std::size_t k = 0; k <= order; ++k) {
      piece.flow.col(i) += term_;
      piece.watched(static_cast<Eigen::Index>(k), i) =
          piece.kind == PhaseKind::stick ? -m_ * rates_.row(j_).dot(term_) : term_(n_ + j_);
      derive(piece, piece.step / static_cast<double>(k + 1), term_);
    }
  }
  piece.terms = units * piece.watched.row(0).cwiseAbs().transpose();
  piece.rest = piece.watched.bottomRows(order - 3).cwiseAbs().colwise().sum().transpose();
}

template <int N, int L>
std::ptrdiff_t SimulationOf<N, L>::first_piece(int side) const {
  std::ptrdiff_t i = 1;
  while (side < 0 && pieces_[i].kind == PhaseKind::slip) {
    ++i;
  }
  return i;
}

template <int N, int L>
double SimulationOf<N, L>::friction_at_rest() const {
  return -m_ * rates_.row(j_).dot(w_);
}

template <int N, int L>
double SimulationOf<N, L>::friction() const {
  return now_ == 0 ? friction_at_rest() : pieces_[now_].force - pieces_[now_].slope * w_(n_ + j_);
}

template <int N, int L>
void SimulationOf<N, L>::set_load() {
  for (Eigen::Index l = 0; l < L_; ++l) {
    const double phase = frequencies_(l) * t_ + frequencies_(l) / omega_ * phi_;
    // By a function of another unit: GCC 12 loses cosines and sines that it finds and stores as a pair.
    const auto [sine, cosine] = sin_cos(phase);
    w_(2 * n_ + 1 + 2 * l) = cosine;
    w_(2 * n_ + 2 + 2 * l) = sine;
  }
}

// Keeps the load's phase small and its cosine and sine exact.
template <int N, int L>
void SimulationOf<N, L>::normalise() {
  if (t_ >= Theta_) {
    const double whole = std::floor(t_ / Theta_);
    periods_ += static_cast<long>(whole);
    t_ = std::max(0.0, t_ - whole * Theta_);
  }
}

// The rate of the term of a Taylor polynomial, times this.
template <int N, int L>
inline void SimulationOf<N, L>::derive(const Piece& piece, double scale, Whole& w) {
  const auto& R = piece.rates;
  if constexpr (N == 2 && L == 1) {  // so that sums wait for as little as they can
    acceleration_ = (R.col(0) * w(0) + R.col(1) * w(1)) + (R.col(2) * w(2) + R.col(3) * w(3)) +
                    (R.col(4) * w(4) + (R.col(5) * w(5) + R.col(6) * w(6)));
  } else {
    multiply(R, w, acceleration_);
  }
  w.template head<N>(n_) = scale * w.template segment<N>(n_, n_);
  w.template segment<N>(n_, n_) = scale * acceleration_;
  w(2 * n_) = 0;
  for (Eigen::Index l = 0; l < L_; ++l) {
    const Eigen::Index c = 2 * n_ + 1 + 2 * l;
    const double turn = scale * frequencies_(l), cosine = w(c);
    w(c) = -turn * w(c + 1);
    w(c + 1) = turn * cosine;
  }
}

// For a part of a step.
template <int N, int L>
void SimulationOf<N, L>::go_on_for(double part) {
  const Piece& piece = pieces_[now_];
  passed(part);
  if (part == 1) {
    multiply(piece.flow, w_, term_);
    w_.swap(term_);
    return;
  }
  double left = 1;  // of the terms, as far as is known of them
  std::conditional_t<size == Eigen::Dynamic, Whole&, Whole> term = term_;  // no memory is asked for
  term = w_;
  for (std::size_t k = 1; k <= order && left > least_term; ++k) {
    const double ratio = part / static_cast<double>(k);
    derive(piece, ratio * piece.step, term);
    w_ += term;
    left *= ratio;
  }
}

template <int N, int L>
void SimulationOf<N, L>::passed(double part) {
  const double h = part * pieces_[now_].step;
  --steps_;
  t_ += h;
  left_ = left_ > h ? left_ - h : 0;
  age_ += h;
  spent_[static_cast<std::size_t>(phase())] += h;
}

template <int N, int L>
double SimulationOf<N, L>::advance(double duration, std::vector<Transition> * log, long most_steps) {
  require(duration >= 0 && std::isfinite(duration), "the duration", duration, "a finite number >= 0");
  left_ = duration;
  steps_ = most_steps;
  normalise();
  set_load();
  for (; goes_on(); --steps_) {
    while (goes_on()) {
      if (step() == Outcome::contact) {
        contact(log);
        break;
      }
    }
  }
  return left_;
}

// What is watched, from now on for a whole step.
template <int N, int L>
Cubic SimulationOf<N, L>::watched() const {
  const Piece& piece = pieces_[now_];
  Cubic f;
  for (Eigen::Index i = 0; i < w_.size(); ++i) {
    for (Eigen::Index k = 0; k < 4; ++k) {
      f.c[static_cast<std::size_t>(k)] += piece.watched(k, i) * w_(i);
    }
    f.rest += piece.rest(i) * std::abs(w_(i));
  }
  return f;
}

// The distances that are positive as long as the piece goes on.
template <int N, int L>
std::array<typename SimulationOf<N, L>::Guard, 2> SimulationOf<N, L>::guards() const {
  const Piece& piece = pieces_[now_];
  if (piece.kind == PhaseKind::stick) {
    return {Guard{-1, forward_, false}, Guard{1, backward_, false}};
  }
  const double side = piece.side();
  return {Guard{-side, side * V_ - piece.from, fresh_ && !at_upper_},
          Guard{side, piece.to - side * V_, fresh_ && at_upper_}};
}

// One step, or the part of it that comes before an event.
template <int N, int L>
typename SimulationOf<N, L>::Outcome SimulationOf<N, L>::step() {
  const Piece& piece = pieces_[now_];
  const double part = left_ / piece.step > whole_step ? 1.0 : left_ / piece.step;
  const double rounding = piece.terms.dot(w_.cwiseAbs());
  if (hold_ > 0 || part < 1) {
    return part_of_step(part, rounding);
  }
  const Cubic f = watched();
  for (const Guard& guard : guards()) {
    if (!std::isfinite(guard.offset)) {
      continue;
    }
    Cubic g = affine(f, guard.sign, guard.offset);
    const int zero_order = zeros(g, rounding, guard.begins, exit_slope_ * piece.step);
    const bool is_free = zero_order == 0
                             ? least(g, 1) > 0
                             : zero_order > 0 && !(positive_until(lower_bound(g, zero_order), 1, 0) < 1);
    if (!is_free) {
      return part_of_step(part, rounding);
    }
  }
  fresh_ = false;
  go_on_for(1);
  return Outcome::reached;
}

template <int N, int L>
typename SimulationOf<N, L>::Outcome SimulationOf<N, L>::part_of_step(double part, double rounding) {
  const Piece& piece = pieces_[now_];
  Eigen::Map<Eigen::Matrix<double, order + 1, 1>> terms(watched_.data());
  multiply(piece.watched, w_, terms);
  const double beyond = rest(watched_);
  std::array<bool, 2> comes{};
  if (hold_ > 0) {
    part = std::min(part, hold_ / piece.step);
    hold_ = 0;
  } else {
    const std::array<Guard, 2> all = guards();
    for (std::size_t i = 0; i < 2; ++i) {
      if (std::isfinite(all[i].offset)) {
        const auto [until, contact] = free_part(all[i], part, beyond, rounding);
        comes[0] = comes[0] && !(until < part);
        part = until;
        comes[i] = contact;
      }
    }
  }
  upper_end_ = comes[1];
  fresh_ = false;
  go_on_for(part);
  return comes[0] || comes[1] ? Outcome::contact : Outcome::reached;
}

// The part of the expanded step, at most the given one, on which the distance certainly has no zero, and
// whether it comes to one there.
template <int N, int L>
std::pair<double, bool> SimulationOf<N, L>::free_part(const Guard& guard, double part, double beyond,
                                                      double rounding) const {
  double from = 0;
  while (true) {
    Cubic g = affine(cubic_at(watched_, from, beyond), guard.sign, guard.offset);
    const int zero_order = zeros(g, rounding, guard.begins && from == 0, exit_slope_ * pieces_[now_].step);
    if (zero_order < 0) {
      return {from, true};
    }
    if (zero_order == 0 && least(g, part - from) > 0) {
      return {part, false};
    }
    const double free =
        positive_until(lower_bound(g, zero_order), part - from, zero_order == 0 ? rounding : 0);
    if (free >= part - from) {
      return {part, false};
    }
    from += free;
    if (zero_order == 0 && (free * pieces_[now_].step < instant || comes_to_zero(g, free, rounding))) {
      return {from, true};
    }
  }
}

template <int N, int L>
void SimulationOf<N, L>::begin(std::ptrdiff_t piece, double exit_slope) {
  now_ = piece;
  fresh_ = piece != 0;
  at_upper_ = false;
  exit_slope_ = exit_slope;
}

// The mass comes to an end of its piece.
template <int N, int L>
void SimulationOf<N, L>::contact(std::vector<Transition> * log) {
  const Piece& piece = pieces_[now_];
  if (piece.kind != PhaseKind::stick && (upper_end_ || piece.from > 0)) {
    return pass_end_of_piece(upper_end_, log);
  }
  w_(n_ + j_) = V_;
  const double r = friction_at_rest();
  if (piece.kind != PhaseKind::stick) {
    return leave_or_stick(r, log);
  }
  // The event is |r| = ur; what |r| exceeds it by is rounding, unless the motion starts there.
  const int side = forward_ - r < backward_ + r ? 1 : -1;
  leave_or_stick(side * std::max(side * r, bound(side)), log);
}

// The law is continuous there, so the next piece goes on with the same acceleration.
template <int N, int L>
void SimulationOf<N, L>::pass_end_of_piece(bool upper, std::vector<Transition> * log) {
  const Piece& before = pieces_[now_];
  const int side = before.side();
  w_(n_ + j_) = V_ - side * (upper ? before.to : before.from);
  const double r = friction_at_rest();
  const double rate = -side * (friction() - r) / m_;  // of the relative velocity
  standstill_ = age_ < instant ? standstill_ + 1 : 0;
  begin(upper ? now_ + 1 : now_ - 1, upper ? rate : -rate);
  at_upper_ = !upper;
  if (standstill_ >= most_at_once) {
    hold_ = shortest_hold;
  }
  if (log != nullptr) {
    log->push_back({time(), before.kind, before.kind, r, state(), before.number, pieces_[now_].number});
  }
  age_ = 0;
}

// Whether a mass at the belt's speed with |r| >= ur, r of this side, slips at all. The distance from the belt
// grows at the rate (|r| - friction of sliding)/m; when that is zero the derivatives of |r| decide.
template <int N, int L>
bool SimulationOf<N, L>::leaves(int side, double r) const {
  const Piece& piece = pieces_[first_piece(side)];
  const double excess = side * (r - (piece.force - piece.slope * V_));
  if (excess != 0) {
    return excess > 0;
  }
  const Eigen::Matrix<double, 4, 1> c = pieces_[0].watched.template topRows<4>() * w_;
  return side * c(1) > 0 || (c(1) == 0 && side * c(2) > 0);
}

// The mass has the speed of the belt, with the friction r: what the law makes of it.
template <int N, int L>
void SimulationOf<N, L>::leave_or_stick(double r, std::vector<Transition> * log) {
  const Piece& before = pieces_[now_];
  const int side = r > 0 ? 1 : -1;
  standstill_ = age_ < instant ? standstill_ + 1 : 0;
  const bool reaches = std::abs(r) >= bound(side);
  const bool slips = reaches && leaves(side, r) && standstill_ < most_at_once;
  if (slips) {
    const std::ptrdiff_t piece = first_piece(side);
    begin(piece, side * (r - (pieces_[piece].force - pieces_[piece].slope * V_)) / m_);
  } else if (before.kind != PhaseKind::stick) {
    begin(0, 0);
  }
  if (!slips && reaches) {
    hold_length_ = age_ <= 4 * hold_length_ ? 2 * hold_length_ : shortest_hold;
    hold_ = hold_length_;
  }
  if (log != nullptr && (slips || before.kind != PhaseKind::stick)) {
    log->push_back({time(), before.kind, phase(), r, state(), before.number, 0});
  }
  age_ = 0;
}

template class SimulationOf<2, 1>;
template class SimulationOf<Eigen::Dynamic, Eigen::Dynamic>;

Simulation::Simulation(const model::Parameters<double>& a, double ur, double phi, const Vector4<double>& X)
    : SimulationOf<2, 1>(model::friction_oscillator<double>(in_domain(a, ur, phi, X), ur), phi, X) {}

}  // namespace stickslip::numeric::simulation
