#include "numeric/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "model/saltation.hpp"

namespace stickslip::numeric::simulation {

using namespace motion;
using model::Vector4;

namespace {

// A step, in units of the inverse of the fastest frequency: long enough to be few, short enough for the
// polynomials to exclude events.
constexpr double step_angle = 1.05;
// Shorter than this, no time has passed.
constexpr double instant = 1e-15;
// So many transitions in one instant, and the mass is held.
constexpr int most_at_once = 32;
// The limits of the data: within them no product that is formed overflows (energies and discriminants
// square), and a step is far longer than an instant.
constexpr double greatest_length = 1e100;  // of states, V, us, ur and p
constexpr double greatest_frequency = 1e10;
// For how long a mass is held at first that neither slips nor has r turn back.
constexpr double shortest_hold = 1e-9;

PhaseKind kind_of(int side) {
  return side > 0 ? PhaseKind::slip : PhaseKind::overshoot;
}

int side_of(double r) {
  return r > 0 ? 1 : -1;
}

void require(bool holds, const char * name, double value, const char * range) {
  if (!holds) {
    throw DomainError(name, fmt::format("{}", value), range);
  }
}

void require_domain(const model::Parameters<double>& a, double ur, double phi, const Vector4<double>& X) {
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
}

// The lowest derivative of a function that is zero at a point decides whether it grows there: its order if it
// does, else 0.
int order_of_growth(const Expansion& g) {
  for (int k = 1; k < 4; ++k) {
    const double d = g.derivative[static_cast<std::size_t>(k)];
    if (d != 0) {
      return d > 0 ? k : 0;
    }
  }
  return 0;
}

// ur - side r.
Expansion room(const Expansion& r, double ur, int side) {
  Expansion g = r;
  for (double& d : g.derivative) {
    d *= -side;
  }
  g.derivative[0] += ur;
  return g;
}

}  // namespace

double friction_at_rest(const model::Parameters<double>& a, const Vector4<double>& X, double psi) {
  return a.chi * (X(1) - X(0)) - a.p / a.eta * std::cos(psi);
}

Simulation::Simulation(const model::Parameters<double>& a, double ur, double phi, const Vector4<double>& X)
    : a_((require_domain(a, ur, phi, X), a)),
      ur_(ur),
      phi_(std::abs(phi) > 4 ? std::atan2(std::sin(phi), std::cos(phi)) : phi),  // omega t is added to it
      Theta_(2 * std::acos(-1.0) / a.omega),
      slip_data_(a),
      slip_step_(slip_data_.step(step_angle / std::max(slip_data_.omega_j[1], a.omega))),
      stick_step_(a.omega, step_angle / std::max(1.0, a.omega)) {
  if (X(3) != a.V) {
    begin(X(3) < a.V ? PhaseKind::slip : PhaseKind::overshoot, X, 0);
    fresh_ = false;
    return;
  }
  kind_ = PhaseKind::stick;
  stick_.begin(a_, X, std::cos(phi), std::sin(phi));
  if (std::abs(friction_at_rest()) >= ur) {
    break_away(nullptr);
  }
  age_ = 1;
}

double Simulation::phase_of_load() const {
  return a_.omega * t_ + phi_;
}

Vector4<double> Simulation::state() const {
  return kind_ == PhaseKind::stick ? stick_.state(a_) : slip_.state(slip_data_);
}

double Simulation::friction_at_rest() const {
  return simulation::friction_at_rest(a_, state(), phase_of_load());
}

double Simulation::friction() const {
  return kind_ == PhaseKind::slip ? a_.us : (kind_ == PhaseKind::overshoot ? -a_.us : friction_at_rest());
}

// Keeps the load's phase small and its cosine and sine exact.
void Simulation::normalise() {
  if (t_ >= Theta_) {
    const double whole = std::floor(t_ / Theta_);
    periods_ += static_cast<long>(whole);
    t_ = std::max(0.0, t_ - whole * Theta_);
  }
}

void Simulation::passed(double h) {
  --steps_;
  t_ += h;
  left_ -= h;
  age_ += h;
  spent_[static_cast<std::size_t>(kind_)] += h;
}

double Simulation::advance(double duration, std::vector<Transition> * log, long most_steps) {
  if (!(duration >= 0) || !std::isfinite(duration)) {
    throw DomainError("the duration", fmt::format("{}", duration), "a finite number >= 0");
  }
  left_ = duration;
  steps_ = most_steps;
  normalise();
  const double c = std::cos(phase_of_load());
  const double s = std::sin(phase_of_load());
  kind_ == PhaseKind::stick ? stick_.set_load(c, s) : slip_.set_load(c, s);
  for (; goes_on(); --steps_) {
    if (kind_ == PhaseKind::stick) {
      if (stick() == Outcome::contact) {
        break_away(log);
      }
    } else if (slip() == Outcome::contact) {
      contact(log);
    }
  }
  return left_;
}

// The order of the zero with which the slip leaves the belt, or 0 when it meets it.
int Simulation::order_of_zero(Expansion& g) const {
  g.derivative[0] = 0;
  if (fresh_) {
    g.derivative[1] = exit_slope_;
    return order_of_growth(g);
  }
  return g.derivative[1] > 0 ? 1 : 0;
}

Simulation::Outcome Simulation::slip() {
  while (goes_on()) {
    Expansion g = slip_.distance(slip_data_, slip_step_.h);
    int order = 0;
    if (fresh_ || g.derivative[0] <= slip_.rounding(slip_data_)) {
      order = order_of_zero(g);
      fresh_ = false;
      if (order == 0) {
        return Outcome::contact;
      }
    }
    double h = std::min(slip_step_.h, left_);
    if (order != 0 || bounds(g, h)[0] <= 0) {
      h = positive_until(lower_bound(g, order), h);
    }
    slip_.advance(slip_data_, h == slip_step_.h ? slip_step_ : slip_data_.step(h));
    passed(h);
    if (h < instant && order == 0) {
      return Outcome::contact;
    }
  }
  return Outcome::reached;
}

Simulation::Outcome Simulation::stick() {
  while (goes_on()) {
    double h = std::min(stick_step_.h, left_);
    const Expansion r = stick_.friction(a_);
    if (hold_ > 0) {
      h = std::min(h, hold_);
      hold_ = 0;
    } else if (const auto [least, greatest] = bounds(r, h); std::max(-least, greatest) >= ur_) {
      for (const int side : {1, -1}) {
        Expansion g = room(r, ur_, side);
        int order = 0;
        if (g.derivative[0] <= stick_.rounding(a_)) {
          order = order_of_growth(g);
          if (order == 0) {
            return Outcome::contact;
          }
        }
        h = positive_until(lower_bound(g, order), h);
      }
    }
    stick_.advance(a_, h == stick_step_.h ? stick_step_ : StickStep(a_.omega, h));
    passed(h);
    if (h < instant && left_ > 0) {
      return Outcome::contact;
    }
  }
  return Outcome::reached;
}

// Whether a mass at the belt's speed with |r| >= ur, r of this side, slips at all. The distance from the belt
// grows at the rate eta (|r| - us); when that is zero, us = ur = |r|, the derivatives of |r| decide.
bool Simulation::leaves(const Vector4<double>& X, int side, double r) const {
  const double slope = -side * model::belt_acceleration<double>(a_.eta, side * a_.us, r);
  if (slope != 0) {
    return slope > 0;
  }
  const double psi = phase_of_load();
  const double rate = model::friction_rate<double>(a_, X, psi);
  const double second = a_.chi * (X(0) - a_.chi * X(1)) + a_.p * a_.omega * a_.omega / a_.eta * std::cos(psi);
  return side * rate > 0 || (rate == 0 && side * second > 0);
}

void Simulation::begin(PhaseKind kind, const Vector4<double>& X, double exit_slope) {
  kind_ = kind;
  const double c = std::cos(phase_of_load());
  const double s = std::sin(phase_of_load());
  if (kind == PhaseKind::stick) {
    stick_.begin(a_, X, c, s);
    return;
  }
  slip_.begin(slip_data_, kind == PhaseKind::slip ? 1 : -1, X, c, s);
  fresh_ = true;
  exit_slope_ = exit_slope;
}

// The mass has the speed of the belt: what (4) makes of it.
void Simulation::contact(std::vector<Transition> * log) {
  Vector4<double> X = state();
  X(3) = a_.V;
  const double r = simulation::friction_at_rest(a_, X, phase_of_load());
  leave_or_stick(X, r, log);
}

void Simulation::break_away(std::vector<Transition> * log) {
  const Vector4<double> X = stick_.state(a_);
  const double r = friction_at_rest();
  // The event is r = ±ur; what r exceeds it by is rounding, unless the motion starts there.
  leave_or_stick(X, side_of(r) * std::max(std::abs(r), ur_), log);
}

void Simulation::leave_or_stick(const Vector4<double>& X, double r, std::vector<Transition> * log) {
  const PhaseKind before = kind_;
  const int side = side_of(r);
  standstill_ = age_ < instant ? standstill_ + 1 : 0;
  const bool slips = std::abs(r) >= ur_ && leaves(X, side, r) && standstill_ < most_at_once;
  if (slips) {
    begin(kind_of(side), X, -side * model::belt_acceleration<double>(a_.eta, side * a_.us, r));
  } else if (before != PhaseKind::stick) {
    begin(PhaseKind::stick, X, 0);
  }
  if (!slips && std::abs(r) >= ur_) {
    hold_length_ = age_ <= 4 * hold_length_ ? 2 * hold_length_ : shortest_hold;
    hold_ = hold_length_;
  }
  if (log != nullptr && (slips || before != PhaseKind::stick)) {
    log->push_back({time(), before, kind_, r, X});
  }
  age_ = 0;
}

}  // namespace stickslip::numeric::simulation
