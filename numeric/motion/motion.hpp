// A piecewise motion as data: slip, overshoot and stick phases one after the other, in balls.
//
// Time is dimensionless (3) and counted from the start of the first phase; z = x - d0, V and the friction
// forces are lengths.
#pragma once

#include <string>
#include <vector>

#include "core/ball.hpp"
#include "core/sinc.hpp"
#include "model/waves.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::motion {

enum class PhaseKind {
  slip,       // x2' < V, u = us: (5)
  overshoot,  // x2' > V, u = -us: (8)
  stick,      // x2' = V: (10)
};

[[nodiscard]] std::string to_string(PhaseKind kind);

// Over balls, or over jets for derivatives by the parameters.
template <class S>
struct PhaseOf {
  PhaseKind kind = PhaseKind::slip;
  S start;              // time at which it begins
  S duration;           // >= 0
  S load;               // the load's phase omega t + phi when it begins
  model::Vector4<S> Z;  // (z, z') when it begins
};

template <class S>
struct MotionOf {
  model::Oscillator<S> oscillator;
  std::vector<PhaseOf<S>> phases;
};

using Phase = PhaseOf<Ball>;
using Motion = MotionOf<Ball>;

// A kind of phase and how long it lasts.
template <class S>
struct LegOf {
  PhaseKind kind = PhaseKind::slip;
  S duration;
};
using Leg = LegOf<Ball>;

// Z at the time t after a phase with that state and load phase began.
template <class S>
[[nodiscard]] model::Vector4<S> flow(const model::Oscillator<S>& o, PhaseKind kind, const S& load,
                                     const model::Vector4<S>& Z, const S& t) {
  if (kind == PhaseKind::stick) {
    return model::stick_flow<S>(o.data.chi, Z, t);
  }
  return kind == PhaseKind::slip ? model::slip_flow<S>(o.modes, o.Q, o.data.omega, load, Z, t)
                                 : model::overshoot_flow<S>(o.modes, o.Q, o.d0, o.data.omega, load, Z, t);
}

// Compiled once.
extern template model::Vector4<Ball> flow<Ball>(const model::Oscillator<Ball>&, PhaseKind, const Ball&,
                                                const model::Vector4<Ball>&, const Ball&);
extern template model::Vector4<double> flow<double>(const model::Oscillator<double>&, PhaseKind,
                                                    const double&, const model::Vector4<double>&,
                                                    const double&);

// The motion that starts at Z0 with the load's phase phi and goes through the legs in their order, each from
// the state where the one before ends. Whether it obeys the friction law and whether it closes is not looked
// at.
template <class S>
[[nodiscard]] MotionOf<S> compose_motion(const model::Oscillator<S>& oscillator, const S& phi,
                                         const model::Vector4<S>& Z0, const std::vector<LegOf<S>>& legs) {
  MotionOf<S> motion{oscillator, {}};
  motion.phases.reserve(legs.size());
  S start(0);
  model::Vector4<S> Z = Z0;
  for (const LegOf<S>& leg : legs) {
    const S load = oscillator.data.omega * start + phi;
    motion.phases.push_back({leg.kind, start, leg.duration, load, Z});
    if (motion.phases.size() < legs.size()) {
      Z = flow<S>(oscillator, leg.kind, load, Z, leg.duration);
      start += leg.duration;
    }
  }
  return motion;
}
[[nodiscard]] Motion compose(const model::Oscillator<Ball>& oscillator, const Ball& phi,
                             const model::Vector4<Ball>& Z0, const std::vector<Leg>& legs);

// A phase as functions of the time since it began.
template <class S>
[[nodiscard]] model::PhaseWaves<S> waves_of(const model::Oscillator<S>& o, const PhaseOf<S>& phase) {
  if (phase.kind == PhaseKind::stick) {
    return model::stick_waves<S>(o, phase.load, phase.Z);
  }
  return model::slip_waves<S>(o, phase.kind == PhaseKind::slip ? 1 : -1, phase.load, phase.Z);
}

// Z at the time t after phase k began, by the flow of that phase, also for t outside its duration.
[[nodiscard]] model::Vector4<Ball> state(const Motion& motion, std::size_t k, const Ball& t);

// The friction at rest r of (4) at the time t after phase k began.
[[nodiscard]] Ball friction(const Motion& motion, std::size_t k, const Ball& t);

// The same coordinates as functions of the time since phase k began.
[[nodiscard]] model::PhaseWaves<Ball> waves(const Motion& motion, std::size_t k);

// The sum of all durations: the period, if the motion closes.
[[nodiscard]] Ball period(const Motion& motion);

// The midpoints: a proposal, and what pictures are drawn from.
[[nodiscard]] MotionOf<double> in_double(const Motion& motion);

// Where phase k ends minus where the next one begins, one vector per phase; after the last phase comes the
// first. An orbit has zero in all of them, and a ball that excludes zero proves that the motion is none.
[[nodiscard]] std::vector<model::Vector4<Ball>> gaps(const Motion& motion);
// The same from waves of all phases that are known already.
[[nodiscard]] std::vector<model::Vector4<Ball>> gaps(const Motion& motion,
                                                     const std::vector<model::PhaseWaves<Ball>>& all_waves);
[[nodiscard]] std::vector<model::PhaseWaves<Ball>> all_waves(const Motion& motion);

// Two motions through the same phases put together, number by number.

// f makes a Ball of an A and a Ball; so does this of whatever consists of such.
template <class F>
struct Zip {
  F f;

  template <class A, int N>
  [[nodiscard]] Eigen::Matrix<Ball, N, 1> operator()(const Eigen::Matrix<A, N, 1>& a,
                                                     const Eigen::Matrix<Ball, N, 1>& b) const {
    Eigen::Matrix<Ball, N, 1> result;
    for (int i = 0; i < N; ++i) {
      result(i) = f(a(i), b(i));
    }
    return result;
  }
  template <class A>
  [[nodiscard]] model::Wave<Ball> operator()(const model::Wave<A>& a, const model::Wave<Ball>& b) const {
    model::Wave<Ball> w;
    w.constant = f(a.constant, b.constant);
    w.slope = f(a.slope, b.slope);
    for (std::size_t k = 0; k < static_cast<std::size_t>(a.count); ++k) {
      const model::Harmonic<A>& h = a.harmonics[k];
      const model::Harmonic<Ball>& g = b.harmonics[k];
      w.add(f(h.nu, g.nu), f(h.a, g.a), f(h.b, g.b));
    }
    return w;
  }
  template <class A>
  [[nodiscard]] model::PhaseWaves<Ball> operator()(const model::PhaseWaves<A>& a,
                                                   const model::PhaseWaves<Ball>& b) const {
    const Zip& zip = *this;
    return {zip(a.z1, b.z1), zip(a.z2, b.z2), zip(a.zdot2, b.zdot2), zip(a.r, b.r)};
  }
  template <class A>
  [[nodiscard]] Motion operator()(const MotionOf<A>& a, const Motion& b) const {
    Motion motion{oscillator(a.oscillator, b.oscillator), {}};
    for (std::size_t k = 0; k < b.phases.size(); ++k) {
      const PhaseOf<A>& g = a.phases[k];
      const Phase& h = b.phases[k];
      motion.phases.push_back(
          {g.kind, f(g.start, h.start), f(g.duration, h.duration), f(g.load, h.load), (*this)(g.Z, h.Z)});
    }
    return motion;
  }

 private:
  template <class A>
  [[nodiscard]] model::Oscillator<Ball> oscillator(const model::Oscillator<A>& a,
                                                   const model::Oscillator<Ball>& b) const {
    const auto& [m, n] = std::tie(a.modes, b.modes);
    const auto& [d, e] = std::tie(a.data, b.data);
    return {{f(d.chi, e.chi), f(d.eta, e.eta), f(d.us, e.us), f(d.V, e.V), f(d.omega, e.omega), f(d.p, e.p)},
            {f(m.omega1, n.omega1), f(m.omega2, n.omega2), f(m.lambda1, n.lambda1), f(m.lambda2, n.lambda2)},
            (*this)(a.Q, b.Q),
            (*this)(a.d0, b.d0)};
  }
};

}  // namespace stickslip::numeric::motion
