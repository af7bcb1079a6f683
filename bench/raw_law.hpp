// The friction law as it stands, for peers: the phase says what the friction is, and events end phases.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/friction_oscillator.hpp"
#include "numeric/simulation/record.hpp"

namespace stickslip::bench {

using numeric::motion::PhaseKind;

// States are (x, x') of n masses, of which j rubs.
class RawLaw {
 public:
  RawLaw(std::size_t n, std::size_t j, double V, double forward, double backward)
      : n_(n), j_(j), V_(V), forward_(forward), backward_(backward) {}
  virtual ~RawLaw() = default;

  // The friction at rest, and the rates of the state in the phase.
  [[nodiscard]] virtual double r(double t, const double * x) const = 0;
  virtual void rate(double t, const double * x, double * d) const = 0;

  [[nodiscard]] std::size_t states() const { return 2 * n_; }
  [[nodiscard]] PhaseKind phase() const { return phase_; }
  // What is positive in the phase.
  [[nodiscard]] double distance(double t, const double * x) const {
    const double lag = V_ - x[n_ + j_];
    return phase_ == PhaseKind::stick ? std::min(forward_ - r(t, x), backward_ + r(t, x))
                                      : (phase_ == PhaseKind::slip ? lag : -lag);
  }
  // The phase that begins at t = 0, or where another one has ended.
  void begin(double * x) {
    const double lag = V_ - x[n_ + j_];
    lag == 0 ? enter(0, x, true) : void(phase_ = lag > 0 ? PhaseKind::slip : PhaseKind::overshoot);
  }
  void pass(double t, double * x) {
    x[n_ + j_] = V_;
    enter(t, x, phase_ != PhaseKind::stick);
  }

 private:
  void enter(double t, const double * x, bool may_stick) {
    const double at_rest = r(t, x);
    const bool sticks = may_stick && at_rest < forward_ && -at_rest < backward_;
    phase_ = sticks ? PhaseKind::stick : (at_rest > 0 ? PhaseKind::slip : PhaseKind::overshoot);
  }

  std::size_t n_, j_;
  double V_, forward_, backward_;
  PhaseKind phase_ = PhaseKind::slip;
};

// (2), (4).
class PaperLaw : public RawLaw {
 public:
  explicit PaperLaw(const numeric::simulation::Start& s)
      : RawLaw(2, 1, s.data.V, s.ur, s.ur), a_(s.data), phi_(s.phi) {}

  [[nodiscard]] double r(double t, const double * x) const override {
    return a_.chi * (x[1] - x[0]) - a_.p * std::cos(a_.omega * t + phi_) / a_.eta;
  }
  void rate(double t, const double * x, double * d) const override {
    d[0] = x[2];
    d[1] = x[3];
    d[2] = a_.chi * x[1] - x[0];
    const double us = phase() == PhaseKind::slip ? a_.us : -a_.us;
    d[3] = phase() == PhaseKind::stick ? 0 : a_.eta * (us - r(t, x));
  }

 private:
  model::Parameters<double> a_;
  double phi_;
};

// Of any oscillator, from load phase 0.
class MachineLaw : public RawLaw {
 public:
  explicit MachineLaw(const model::FrictionOscillator<double>& o)
      : RawLaw(o.size(), o.rubbing, o.V, o.forward.at_rest, o.backward.at_rest), o_(o) {}

  [[nodiscard]] double r(double t, const double * x) const override { return -force(o_.rubbing, t, x); }
  void rate(double t, const double * x, double * d) const override {
    const std::size_t n = o_.size();
    for (std::size_t i = 0; i < n; ++i) {
      d[i] = x[n + i];
      d[n + i] = i == o_.rubbing && phase() == PhaseKind::stick ? 0 : force(i, t, x) / o_.masses[i];
    }
    if (phase() != PhaseKind::stick) {
      d[n + o_.rubbing] += friction(o_.V - x[n + o_.rubbing]) / o_.masses[o_.rubbing];
    }
  }

 private:
  // Without friction.
  [[nodiscard]] double force(std::size_t i, double t, const double * x) const {
    const std::size_t n = o_.size();
    double sum = 0;
    for (const auto& load : o_.loads) {
      const double psi = load.k * o_.omega * t;
      sum += load.mass == i ? load.cosine * std::cos(psi) + load.sine * std::sin(psi) : 0;
    }
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < n; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      sum -= o_.stiffness(row, column) * x[k] + o_.damping(row, column) * x[n + k];
    }
    return sum;
  }
  [[nodiscard]] double friction(double relative) const {
    const int side = phase() == PhaseKind::slip ? 1 : -1;
    const auto& all = o_.law(side).sliding;
    std::size_t i = 0;
    while (i + 1 < all.size() && side * relative > all[i + 1].from) {
      ++i;
    }
    return side * (all[i].force + all[i].slope * (side * relative - all[i].from));
  }

  model::FrictionOscillator<double> o_;
};

}  // namespace stickslip::bench
