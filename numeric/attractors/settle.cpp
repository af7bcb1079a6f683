#include "numeric/attractors/settle.hpp"

#include <cmath>
#include <numbers>

namespace stickslip::numeric::attractors {

using model::Vector4;
using motion::PhaseKind;
using simulation::Simulation;

namespace {

// Rounding is far below it, and what is slower than this is seen by the lack of events.
constexpr double certainly = 1 - 1e-9;

// That the motion has no event any more, if that is certain.
struct LastEvent {
  model::Parameters<double> a;
  double ur;
  model::Oscillator<double> oscillator;

  [[nodiscard]] bool slides(const FollowerOf<2, 1>::Simulation& simulation) const {
    const PhaseKind kind = simulation.phase();
    const bool slip = kind == PhaseKind::slip;
    if (kind == PhaseKind::stick || (slip ? a.V <= 0 : a.V >= 0)) {
      return false;
    }
    Vector4<double> Z = simulation.state();
    Z.head<2>() -= oscillator.d0;
    const model::Wave<double> speed = model::slip_waves<double>(oscillator, slip ? 1 : -1, 0.0, Z).zdot2;
    double sum = 0;
    for (int k = 0; k < speed.count; ++k) {
      const auto& h = speed.harmonics[static_cast<std::size_t>(k)];
      sum += std::hypot(h.a, h.b);
    }
    return sum < certainly * std::abs(a.V);
  }

  // On a stick x1 - chi x2 oscillates with a fixed amplitude, so r of (4) is at most what is compared.
  [[nodiscard]] bool sticks(const FollowerOf<2, 1>::Simulation& simulation) const {
    if (simulation.phase() != PhaseKind::stick || a.V != 0) {
      return false;
    }
    const Vector4<double> X = simulation.state();
    const double amplitude = std::hypot(X(0) - a.chi * X(1), X(2));
    const double most = a.chi * (1 - a.chi) * std::abs(X(1)) + a.chi * amplitude + a.p / a.eta;
    return most < certainly * ur;
  }

  std::optional<Kind> operator()(const FollowerOf<2, 1>::Simulation& simulation) const {
    return slides(simulation)   ? std::optional(Kind::slides)
           : sticks(simulation) ? std::optional(Kind::stuck)
                                : std::nullopt;
  }
};

}  // namespace

words::Guess word_guess(const Return& seen) {
  words::Guess guess{{}, seen.guess.periods};
  for (const machines::MachineGuess::Event& event : seen.guess.events) {
    guess.events.push_back({event.t, event.X(0), event.X(1), event.X(2), event.begins.kind});
  }
  return guess;
}

Vector4<double> at_phase_0(const simulation::Start& start) {
  const double turn = 2 * std::numbers::pi;
  const double phase = std::fmod(start.phi, turn);
  Simulation simulation(start.data, start.ur, phase, start.X);
  simulation.advance((phase > 0 ? turn - phase : -phase) / start.data.omega);
  return simulation.state();
}

Follower::Follower(const model::Parameters<double>& a, double ur, const Vector4<double>& X)
    : FollowerOf<2, 1>(model::friction_oscillator<double>(a, ur), simulation::Simulation(a, ur, 0, X), 1,
                       LastEvent{a, ur, model::oscillator<double>(a)}) {}

}  // namespace stickslip::numeric::attractors
