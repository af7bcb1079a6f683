#include "numeric/attractors/settle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/flows.hpp"

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

StartBox start_box(const model::Parameters<double>& a) {
  const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
  const model::Vector2<double> Q = model::Q<double>(a, m);
  const double d = a.us / (a.chi * (1 - a.chi));
  const auto is_resonant = [&](double omega_j) { return std::abs(omega_j - a.omega) < 1e-12 * omega_j; };
  const double forced =  // without a bound at resonance
      is_resonant(m.omega1) || is_resonant(m.omega2) ? 0 : std::abs(Q(1)) * a.omega;
  const double s = std::max({a.V, 1.2 * forced, 3 * a.us, 0.1});
  return {{a.chi * d, d, 0, a.V - s}, {2 * s, 3 * s, 1.5 * s, 1.5 * s}};
}

}  // namespace stickslip::numeric::attractors
