// A stick as a state that is carried from one time to the next, in double.
#pragma once

#include <cmath>

#include "model/parameters.hpp"
#include "numeric/simulation/first_zero.hpp"

namespace stickslip::numeric::simulation {

// What a stick over a given span does to the state.
struct StickStep {
  double h = 0;
  double c = 1, s = 0;                // of h
  double load_cos = 1, load_sin = 0;  // of omega h

  StickStep(double omega, double span)
      : h(span),
        c(std::cos(span)),
        s(std::sin(span)),
        load_cos(std::cos(omega * span)),
        load_sin(std::sin(omega * span)) {}
};

// (9): x2 moves with the belt and w = x1 - chi x2 obeys w'' + w = 0.
class StickPhase {
 public:
  void begin(const model::Parameters<double>& a, const model::Vector4<double>& X, double c, double s) {
    x2_ = X(1);
    w_ = X(0) - a.chi * X(1);
    rate_ = X(2) - a.chi * a.V;
    set_load(c, s);
  }
  void set_load(double c, double s) {
    c_ = c;
    s_ = s;
  }

  void advance(const model::Parameters<double>& a, const StickStep& step) {
    x2_ += a.V * step.h;
    const double w = step.c * w_ + step.s * rate_;
    rate_ = step.c * rate_ - step.s * w_;
    w_ = w;
    const double c = step.load_cos * c_ - step.load_sin * s_;
    s_ = step.load_cos * s_ + step.load_sin * c_;
    c_ = c;
  }

  [[nodiscard]] model::Vector4<double> state(const model::Parameters<double>& a) const {
    return {w_ + a.chi * x2_, x2_, rate_ + a.chi * a.V, a.V};
  }

  // Of the friction at rest r of (4), r = chi (1 - chi) x2 - chi w - (p/eta) cos(omega t + phi).
  [[nodiscard]] Expansion friction(const model::Parameters<double>& a) const {
    const double load = a.p / a.eta;
    const double w2 = a.omega * a.omega;
    const double stiffness = a.chi * (1 - a.chi);
    Expansion r;
    r.derivative = {stiffness * x2_ - a.chi * w_ - load * c_,
                    stiffness * a.V - a.chi * rate_ + load * a.omega * s_, a.chi * w_ + load * w2 * c_,
                    a.chi * rate_ - load * w2 * a.omega * s_};
    r.bound = a.chi * (std::abs(w_) + std::abs(rate_)) + load * w2 * w2;
    return r;
  }

  // What rounding can do to r.
  [[nodiscard]] double rounding(const model::Parameters<double>& a) const {
    constexpr double units = 4 * 0x1p-53;
    return units * (a.chi * (std::abs(x2_) + std::abs(w_)) + a.p / a.eta);
  }

 private:
  double x2_ = 0, w_ = 0, rate_ = 0, c_ = 1, s_ = 0;
};

}  // namespace stickslip::numeric::simulation
