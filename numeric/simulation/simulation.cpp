#include "numeric/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/sinc.hpp"
#include "numeric/zeros/dense.hpp"

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

int side_of(double r) {
  return r > 0 ? 1 : -1;
}

void require(bool holds, const char * name, double value, const char * range) {
  if (!holds) {
    throw DomainError(name, fmt::format("{}", value), range);
  }
}

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
    const int order = order_of_growth(g);
    return order == 0 ? -1 : order;
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

// sign f + offset.
inline Cubic affine(const Cubic& f, double sign, double offset) {
  return {{sign * f.c[0] + offset, sign * f.c[1], sign * f.c[2], sign * f.c[3]}, f.rest};
}

}  // namespace

double friction_at_rest(const model::Parameters<double>& a, const Vector4<double>& X, double psi) {
  return a.chi * (X(1) - X(0)) - a.p / a.eta * std::cos(psi);
}

template <int N, int L>
SimulationOf<N, L>::SimulationOf(const model::FrictionOscillator<double>& o, double phi, const State& X)
    : A_(-o.stiffness),
      B_(-o.damping),
      is_damped_(!o.damping.isZero(0)),
      constant_(Vector::Zero(static_cast<Eigen::Index>(o.size()))),
      n_(static_cast<Eigen::Index>(o.size())),
      j_(static_cast<Eigen::Index>(o.rubbing)),
      m_(o.masses[o.rubbing]),
      V_(o.V),
      forward_(o.forward.at_rest),
      backward_(o.backward.at_rest),
      omega_(o.omega),
      Theta_(o.is_autonomous() ? std::numeric_limits<double>::infinity() : 2 * std::numbers::pi / o.omega) {
  for (Eigen::Index i = 0; i < n_; ++i) {
    A_.row(i) /= o.masses[static_cast<std::size_t>(i)];
    B_.row(i) /= o.masses[static_cast<std::size_t>(i)];
  }
  std::vector<double> frequencies;
  for (const model::HarmonicForce<double>& load : o.loads) {
    const double frequency = load.k * omega_;
    if (load.k != 0 && std::find(frequencies.begin(), frequencies.end(), frequency) == frequencies.end()) {
      frequencies.push_back(frequency);
    }
  }
  L_ = static_cast<Eigen::Index>(frequencies.size());
  frequencies_ = Eigen::Map<const Eigen::VectorXd>(frequencies.data(), L_);
  drive_.setZero(n_, 2 * L_);
  for (const model::HarmonicForce<double>& load : o.loads) {
    const double m = o.masses[load.mass];
    const auto i = static_cast<Eigen::Index>(load.mass);
    if (load.k == 0) {
      constant_(i) += load.cosine / m;
      continue;
    }
    const auto l =
        2 * static_cast<Eigen::Index>(std::find(frequencies.begin(), frequencies.end(), load.k * omega_) -
                                      frequencies.begin());
    drive_(i, l) += load.cosine / m;
    drive_(i, l + 1) += load.sine / m;
  }
  pieces_.resize(1 + o.forward.sliding.size() + o.backward.sliding.size());
  add_pieces(1, o.forward, 1);
  add_pieces(-1, o.backward, 1 + o.forward.sliding.size());
  rub_ = Vector::Unit(n_, j_) / m_;
  free_ = Vector::Ones(n_) - Vector::Unit(n_, j_);
  for (Piece& piece : pieces_) {
    prepare(piece);
  }
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
void SimulationOf<N, L>::add_pieces(int side, const model::FrictionLaw<double>& law, std::size_t place) {
  const auto& all = law.sliding;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Piece& piece = pieces_[place + i];
    piece.kind = side > 0 ? PhaseKind::slip : PhaseKind::overshoot;
    piece.number = static_cast<int>(i);
    piece.from = all[i].from;
    piece.to = i + 1 < all.size() ? all[i + 1].from : std::numeric_limits<double>::infinity();
    piece.force = side * (all[i].force - all[i].slope * all[i].from) + all[i].slope * V_;
    piece.slope = all[i].slope;
  }
}

// The length of a step by the fastest of the phase's own motions and of the load. A step is linear: it is
// taken by each number alone.
template <int N, int L>
void SimulationOf<N, L>::prepare(Piece& piece) {
  Eigen::MatrixXd drift = Eigen::MatrixXd::Zero(2 * n_, 2 * n_);
  drift.topRightCorner(n_, n_).setIdentity();
  drift.bottomLeftCorner(n_, n_) = A_;
  drift.bottomRightCorner(n_, n_) = B_;
  drift(n_ + j_, n_ + j_) -= piece.slope / m_;
  const auto fastest_of = [&] {
    const double own = zeros::spectral_radius(drift);
    return L_ == 0 ? own : std::max(own, frequencies_.maxCoeff());
  };
  double fastest = fastest_of();
  if (piece.kind == PhaseKind::stick) {
    drift.row(n_ + j_).setZero();
    const double held = fastest_of();
    fastest = held > 0 ? held : fastest;  // else nothing but the belt moves
  }
  piece.step = step_angle / (fastest > 0 ? fastest : 1);
  if (std::isfinite(Theta_)) {
    piece.step = Theta_ / std::ceil(Theta_ / piece.step);  // a period without an event ends with a whole step
  }
  for (std::size_t k = 0; k < order; ++k) {
    piece.scales[k] = piece.step / static_cast<double>(k + 1);
  }
  const Eigen::Index D = 2 * n_ + 1 + 2 * L_;
  piece.flow.resize(D, D);
  piece.watched.resize(4, D);
  piece.rest.resize(D);
  piece.terms.resize(D);
  for (Eigen::Index i = 0; i < D; ++i) {
    w_ = Whole::Unit(D, i);
    expand(piece);
    piece.flow.col(i) = at(1);
    for (Eigen::Index k = 0; k < 4; ++k) {
      piece.watched(k, i) = watched_[static_cast<std::size_t>(k)];
    }
    piece.terms(i) = units * std::abs(watched_[0]);
    piece.rest(i) = 0;
    for (std::size_t k = 4; k <= order; ++k) {
      piece.rest(i) += std::abs(watched_[k]);
    }
  }
}

template <int N, int L>
std::size_t SimulationOf<N, L>::first_piece(int side) const {
  std::size_t i = 1;
  while (side < 0 && pieces_[i].kind == PhaseKind::slip) {
    ++i;
  }
  return i;
}

template <int N, int L>
double SimulationOf<N, L>::friction_at_rest() const {
  return -m_ * (A_.row(j_).dot(w_.template head<N>(n_)) + B_.row(j_).dot(w_.template segment<N>(n_, n_)) +
                constant_(j_) + drive_.row(j_).dot(w_.template segment<pairs>(2 * n_ + 1, 2 * L_)));
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

// The Taylor polynomials of a step, in parts of it. Number by number: what is in vectors waits for memory.
template <int N, int L>
void SimulationOf<N, L>::expand(const Piece& piece) {
  const bool sticks = piece.kind == PhaseKind::stick;
  const bool is_damped = is_damped_ || piece.slope != 0;
  Vector x = w_.template head<N>(n_);
  Vector v = w_.template segment<N>(n_, n_);
  Vector a = v;
  Loads c = w_.template segment<pairs>(2 * n_ + 1, 2 * L_);
  X_[0] = x;
  Y_[0] = v;
  loads_[0] = c;
  const double one = w_(2 * n_);
  for (std::size_t k = 0; k <= order; ++k) {
    if constexpr (N == 2 && L == 1) {
      a = (A_.col(0) * x(0) + A_.col(1) * x(1)) + (drive_.col(0) * c(0) + drive_.col(1) * c(1));
    } else {
      a.noalias() = A_ * x;
      a.noalias() += drive_ * c;
    }
    if (is_damped) {
      a.noalias() += B_ * v;
    }
    if (k == 0) {
      a += one * constant_;
    }
    watched_[k] = sticks ? -m_ * a(j_) : v(j_);
    if (k == order) {
      return;
    }
    if (sticks) {
      a = a.cwiseProduct(free_);
    } else if (k == 0 || piece.slope != 0) {
      a += rub_ * ((k == 0 ? one * piece.force : 0) - piece.slope * v(j_));
    }
    const double scale = piece.scales[k];
    x = scale * v;
    v = scale * a;
    for (Eigen::Index l = 0; l < L_; ++l) {
      const double turn = scale * frequencies_(l);
      const double cosine = c(2 * l);
      c(2 * l) = -turn * c(2 * l + 1);
      c(2 * l + 1) = turn * cosine;
    }
    X_[k + 1] = x;
    Y_[k + 1] = v;
    loads_[k + 1] = c;
  }
}

// After a part of the step that was expanded.
template <int N, int L>
typename SimulationOf<N, L>::Whole SimulationOf<N, L>::at(double part) const {
  Vector x = X_[order];
  Vector v = Y_[order];
  Loads c = loads_[order];
  for (std::size_t k = order; k-- > 0;) {
    x = x * part + X_[k];
    v = v * part + Y_[k];
    c = c * part + loads_[k];
  }
  Whole w = w_;
  w.template head<N>(n_) = x;
  w.template segment<N>(n_, n_) = v;
  w.template segment<pairs>(2 * n_ + 1, 2 * L_) = c;
  return w;
}

template <int N, int L>
void SimulationOf<N, L>::passed(double part, const Whole& w) {
  w_ = w;
  const double h = part * pieces_[now_].step;
  --steps_;
  t_ += h;
  left_ = left_ > h ? left_ - h : 0;
  age_ += h;
  spent_[static_cast<std::size_t>(phase())] += h;
}

template <int N, int L>
double SimulationOf<N, L>::advance(double duration, std::vector<Transition> * log, long most_steps) {
  if (!(duration >= 0) || !std::isfinite(duration)) {
    throw DomainError("the duration", fmt::format("{}", duration), "a finite number >= 0");
  }
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
    const int order = zeros(g, rounding, guard.begins, exit_slope_ * piece.step);
    const bool is_free =
        order == 0 ? bounds(g, 1)[0] > 0 : order > 0 && !(positive_until(lower_bound(g, order), 1) < 1);
    if (!is_free) {
      return part_of_step(part, rounding);
    }
  }
  fresh_ = false;
  passed(1, piece.flow * w_);
  return Outcome::reached;
}

template <int N, int L>
typename SimulationOf<N, L>::Outcome SimulationOf<N, L>::part_of_step(double part, double rounding) {
  const Piece& piece = pieces_[now_];
  expand(piece);
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
  passed(part, at(part));
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
    const int order = zeros(g, rounding, guard.begins && from == 0, exit_slope_ * pieces_[now_].step);
    if (order < 0) {
      return {from, true};
    }
    if (order == 0 && bounds(g, part - from)[0] > 0) {
      return {part, false};
    }
    const double free = positive_until(lower_bound(g, order), part - from);
    if (free >= part - from) {
      return {part, false};
    }
    from += free;
    if (order == 0 && free * pieces_[now_].step < instant) {
      return {from, true};
    }
  }
}

template <int N, int L>
void SimulationOf<N, L>::begin(std::size_t piece, double exit_slope) {
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
  const Eigen::Matrix<double, 4, 1> c = pieces_.front().watched * w_;
  return side * c(1) > 0 || (c(1) == 0 && side * c(2) > 0);
}

// The mass has the speed of the belt, with the friction r: what the law makes of it.
template <int N, int L>
void SimulationOf<N, L>::leave_or_stick(double r, std::vector<Transition> * log) {
  const Piece& before = pieces_[now_];
  const int side = side_of(r);
  standstill_ = age_ < instant ? standstill_ + 1 : 0;
  const bool reaches = std::abs(r) >= bound(side);
  const bool slips = reaches && leaves(side, r) && standstill_ < most_at_once;
  if (slips) {
    const std::size_t piece = first_piece(side);
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
    : SimulationOf<2, 1>(model::friction_oscillator<double>(in_domain(a, ur, phi, X), ur), phi, X),
      a_(a),
      ur_(ur) {}

}  // namespace stickslip::numeric::simulation
