// A slip as a state that is carried from one time to the next, in modal coordinates and double.
#pragma once

#include <array>
#include <cmath>

#include "model/parameters.hpp"
#include "model/response.hpp"
#include "numeric/simulation/first_zero.hpp"

namespace stickslip::numeric::simulation {

// What a slip over a given span does to the state.
struct SlipStep {
  double h = 0;
  std::array<model::ModalResponse<double>, 2> mode;
};

// What is fixed by the data of (2).
struct SlipData {
  double V = 0, omega = 0;
  std::array<double, 2> omega_j{}, lambda{};
  std::array<double, 2> P{};  // modal parts of the load
  std::array<double, 2> f{};  // modal parts of the friction force +us, times eta
  double det = 0;             // lambda2 - lambda1

  // (39), with lambda1 lambda2 = -eta for the one of the two that cancellation would spoil.
  explicit SlipData(const model::Parameters<double>& a) : V(a.V), omega(a.omega) {
    const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
    const bool soft = a.chi * a.eta < 1;
    omega_j = {m.omega1, m.omega2};
    lambda = {soft ? m.lambda1 : -a.eta / m.lambda2, soft ? -a.eta / m.lambda1 : m.lambda2};
    det = lambda[1] - lambda[0];
    P = {-a.p / det, a.p / det};
    f = {-a.eta * a.us / det, a.eta * a.us / det};
  }

  [[nodiscard]] SlipStep step(double h) const {
    return {h,
            {model::modal_response<double>(omega_j[0], omega, h),
             model::modal_response<double>(omega_j[1], omega, h)}};
  }
};

// Slip below the belt (side 1) or above it (side -1). X = (x1, x2, x1', x2'); (c, s) are cosine and sine of
// the load's phase.
class SlipPhase {
 public:
  void begin(const SlipData& d, int side, const model::Vector4<double>& X, double c, double s) {
    side_ = side;
    y_ = {(d.lambda[1] * X(0) - X(1)) / d.det, (X(1) - d.lambda[0] * X(0)) / d.det};
    v_ = {(d.lambda[1] * X(2) - X(3)) / d.det, (X(3) - d.lambda[0] * X(2)) / d.det};
    set_load(c, s);
  }
  void set_load(double c, double s) {
    c_ = c;
    s_ = s;
  }

  void advance(const SlipData& d, const SlipStep& step) {
    for (std::size_t j = 0; j < 2; ++j) {
      const model::ModalResponse<double>& m = step.mode[j];
      const double f = side_ * d.f[j];
      const double y = m.c * y_[j] + m.s * v_[j] + m.e * f + d.P[j] * (m.from_cos * c_ - m.from_sin * s_);
      v_[j] = m.c * v_[j] - m.stiff * y_[j] + m.s * f + d.P[j] * (m.cos_rate * c_ - m.sin_rate * s_);
      y_[j] = y;
    }
    const double turn_c = step.mode[0].load_cos;
    const double turn_s = step.mode[0].load_sin;
    const double c = turn_c * c_ - turn_s * s_;
    s_ = turn_c * s_ + turn_s * c_;
    c_ = c;
  }

  [[nodiscard]] model::Vector4<double> state(const SlipData& d) const {
    return {y_[0] + y_[1], d.lambda[0] * y_[0] + d.lambda[1] * y_[1], v_[0] + v_[1],
            d.lambda[0] * v_[0] + d.lambda[1] * v_[1]};
  }

  // Of the distance from the belt, side (V - x2'), for steps of at most h. The third derivative j of a mode
  // is driven too, j'' + omega_j² j = P omega³ sin(omega t + psi), so on the step
  // |j| <= |j(0)| + h |j'(0)| + |P| omega³ h²/2.
  [[nodiscard]] Expansion distance(const SlipData& d, double h) const {
    Expansion g;
    g.derivative[0] = side_ * d.V;
    const double w = d.omega;
    for (std::size_t j = 0; j < 2; ++j) {
      const double stiffness = d.omega_j[j] * d.omega_j[j];
      const double second = side_ * d.f[j] + d.P[j] * c_ - stiffness * y_[j];
      const double third = -stiffness * v_[j] - d.P[j] * w * s_;
      const double fourth = -stiffness * second - d.P[j] * w * w * c_;
      const double weight = side_ * d.lambda[j];
      g.derivative[0] -= weight * v_[j];
      g.derivative[1] -= weight * second;
      g.derivative[2] -= weight * third;
      g.derivative[3] -= weight * fourth;
      const double load = std::abs(d.P[j]) * w * w * w;
      const double largest = std::abs(third) + h * std::abs(fourth) + load * h * h / 2;
      g.bound += std::abs(weight) * (stiffness * largest + load);
    }
    return g;
  }

  // What rounding can do to the distance.
  [[nodiscard]] double rounding(const SlipData& d) const {
    constexpr double units = 8 * 0x1p-53;
    return units * (std::abs(d.V) + std::abs(d.lambda[0] * v_[0]) + std::abs(d.lambda[1] * v_[1]));
  }

  [[nodiscard]] int side() const { return side_; }

 private:
  int side_ = 1;
  std::array<double, 2> y_{}, v_{};
  double c_ = 1, s_ = 0;
};

}  // namespace stickslip::numeric::simulation
