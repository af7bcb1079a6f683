// Random damped machines of one to five masses: their periodic motions are proved, and Boost.Odeint agrees on
// the raw friction law, phase by phase.
#include <doctest/doctest.h>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "numeric/machines/attractors/settle.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;

namespace {

class RandomMachines {
 public:
  explicit RandomMachines(bool smooth) : smooth_(smooth) {}

  Machine next(int n) {
    Machine machine;
    auto& o = machine.oscillator;
    o.stiffness = model::MatrixX<Rational>::Constant(n, n, Rational(0));
    o.damping = o.stiffness;
    for (int i = 0; i < n; ++i) {
      o.masses.push_back(number(30, 200));
      spring(o.stiffness, i, number(100, 900));
      spring(o.damping, i, number(2, 30));
    }
    o.rubbing = static_cast<std::size_t>(n - 1);
    o.V = number(20, 120);
    o.forward = law();
    o.backward = random_() % 2 == 0 ? o.forward : law();
    if (random_() % 4 != 0) {
      o.omega = number(60, 250);
      o.loads.push_back({random_() % static_cast<std::size_t>(n), 1, number(20, 150), Rational(0)});
      if (random_() % 3 == 0) {
        o.loads.push_back({0, 2, number(5, 50), number(5, 50)});
      }
    }
    return machine;
  }

  Eigen::VectorXd start(int n) {
    Eigen::VectorXd X(2 * n);
    for (Eigen::Index i = 0; i < X.size(); ++i) {
      X(i) = number(0, 200).get_d() - 1;
    }
    return X;
  }

 private:
  // In hundredths.
  Rational number(int from, int to) {
    Rational value(from + static_cast<int>(random_() % static_cast<unsigned>(to - from)), 100);
    value.canonicalize();
    return value;
  }

  static void spring(model::MatrixX<Rational>& A, int i, const Rational& k) {
    A(i, i) += k;
    if (i > 0) {
      A(i - 1, i - 1) += k;
      A(i - 1, i) -= k;
      A(i, i - 1) -= k;
    }
  }

  // Falls in one to three pieces, and stays there; or smoothly, sometimes from the friction at rest.
  model::FrictionLaw<Rational> law() {
    if (smooth_) {
      const Rational last = number(20, 60), first = last + number(20, 80);
      return smooth_law(random_() % 3 == 0 ? first : Rational(first + number(10, 40)),
                        {random_() % 2 == 0 ? model::Fall::exponential : model::Fall::hyperbolic, first, last,
                         number(20, 150), random_() % 2 == 0 ? number(0, 20) : Rational(0)});
    }
    const std::size_t pieces = 1 + random_() % 3;
    Rational force = number(40, 90), from = 0;
    model::FrictionLaw<Rational> law{Rational(force + number(10, 80)), {}};
    for (std::size_t i = 0; i < pieces; ++i) {
      const bool last = i + 1 == pieces;
      const Rational slope = last ? Rational(0) : Rational(-number(5, 15));
      law.sliding.push_back({from, force, slope});
      if (!last) {
        const Rational length = number(30, 90);
        from += length;
        force += slope * length;
      }
    }
    return law;
  }

  bool smooth_;
  std::mt19937_64 random_{2026};
};

using State = std::vector<double>;

// The raw law: friction by the relative velocity alone, and r while it sticks.
struct RawLaw {
  const model::FrictionOscillator<double>& o;
  bool sticks;
  double phase;  // of the load at t = 0
  int side;      // where the relative velocity is 0

  [[nodiscard]] double friction(double relative) const {
    const bool forward = relative > 0 || (relative == 0 && side > 0);
    const auto& law = forward ? o.forward : o.backward;
    double force = law.sliding.front().force;
    if (law.smooth) {
      force = law.smooth->force(std::abs(relative));
      return forward ? force : -force;
    }
    for (const auto& piece : law.sliding) {
      if (std::abs(relative) >= piece.from) {
        force = piece.force + piece.slope * (std::abs(relative) - piece.from);
      }
    }
    return forward ? force : -force;
  }

  void operator()(const State& w, State& rate, double t) const {
    const std::size_t n = o.size();
    for (std::size_t i = 0; i < n; ++i) {
      double force = 0;
      for (const auto& load : o.loads) {
        const double psi = load.k * (o.omega * t + phase);
        force += load.mass == i ? load.cosine * std::cos(psi) + load.sine * std::sin(psi) : 0;
      }
      for (std::size_t k = 0; k < n; ++k) {
        const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(k);
        force -= o.stiffness(a, b) * w[k] + o.damping(a, b) * w[n + k];
      }
      if (i == o.rubbing) {
        force = sticks ? 0 : force + friction(o.V - w[n + i]);
      }
      rate[i] = w[n + i];
      rate[n + i] = force / o.masses[i];
    }
  }
};

// How far the raw law's motion over the phase is from where the next phase begins.
double gap(const model::FrictionOscillator<double>& o, const MachineOrbit& orbit, std::size_t k) {
  namespace odeint = boost::numeric::odeint;
  const MachinePhase& phase = orbit.phases[k];
  const MachinePhase& next = orbit.phases[(k + 1) % orbit.phases.size()];
  State w;
  for (Eigen::Index i = 0; i < phase.state.size(); ++i) {
    w.push_back(phase.state(i).approximate());
  }
  const double load = orbit.load.approximate() + o.omega * phase.start.approximate();
  const RawLaw law{o, phase.piece.kind == motion::PhaseKind::stick, load, phase.piece.side()};
  odeint::integrate_adaptive(odeint::make_controlled(1e-12, 1e-12, odeint::runge_kutta_dopri5<State>()), law,
                             w, 0.0, phase.duration.approximate(), 1e-3);
  double largest = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    largest = std::max(largest, std::abs(w[i] - next.state(static_cast<Eigen::Index>(i)).approximate()));
  }
  return largest;
}

// Of so many machines, of which so many at least have periodic motions.
void check_random_machines(bool smooth, int rounds, int least) {
  RandomMachines random(smooth);
  int periodic = 0, proved = 0, stable = 0;
  std::vector<int> of_size(6);
  constexpr std::size_t longest = 60;  // phases: proofs of hundreds take a minute
  for (int round = 0; round < rounds; ++round) {
    const int n = 1 + round % 5;
    CAPTURE(round);
    const Machine machine = random.next(n);
    const Settled found = settle(machine, random.start(n), 3000);
    if (found.kind != attractors::Kind::periodic || found.guess.events.size() > longest) {
      continue;
    }
    ++periodic;
    ++of_size[static_cast<std::size_t>(n)];
    const MachineOrbit orbit = prove_machine_orbit(machine, found.guess);
    if (orbit.existence.truth != Truth::proved || orbit.admissible.truth != Truth::proved) {
      MESSAGE("not proved: ", word_of(orbit.pieces), ", ", orbit.existence.reason, ", ",
              orbit.admissible.reason);
      continue;
    }
    ++proved;
    REQUIRE(orbit.stability);
    // A simulation settles on nothing else.
    CHECK(orbit.stability->kind != motion::StabilityKind::unstable);
    stable += orbit.stability->kind == motion::StabilityKind::stable ? 1 : 0;
    const auto o = oscillator_as<double>(machine);
    double largest = 0;
    for (std::size_t k = 0; k < orbit.phases.size(); ++k) {
      largest = std::max(largest, gap(o, orbit, k));
    }
    CHECK(largest < 1e-8);
  }
  MESSAGE("periodic ", periodic, ", proved ", proved, ", stable ", stable);
  CHECK(periodic >= least);
  CHECK(proved * 10 >= periodic * 9);
  for (std::size_t n = 1; n <= 5; ++n) {
    CHECK(of_size[n] >= least / 10);
  }
}

}  // namespace

TEST_CASE("random damped machines: periodic motions are proved, and the raw law agrees") {
  check_random_machines(false, 80, 40);
}

TEST_CASE("random machines on smooth laws of friction: proved, not only near them, and the raw law agrees") {
  const char * const asked = std::getenv("STICKSLIP_SMOOTH_MACHINES");
  const int rounds = asked == nullptr ? 6 : std::stoi(asked);
  check_random_machines(true, rounds, rounds / 10);
}
