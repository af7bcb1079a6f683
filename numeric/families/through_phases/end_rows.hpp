// The rows of the reduced closing equations near the ends of their domain.
#pragma once

#include "model/parameters.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::families {

// What is left of rows that vanish at an end of the domain, once the cube of the distance t is divided out.
// S(q) = sinc(√q) has -1/6 <= S'(q) <= -1/6 + q/60 for 0 <= q <= 1, and (x cos x - sin x)/x³ lies between
// -1/3 and -1/3 + x²/30 for 0 <= x <= 1. The enclosures hold only where applies() says so; t >= 0.
struct EndRows {
  model::Modes<Ball> m;
  Ball omega;
  Ball t;  // distance from the end, in time

  // All frequencies times t/2 are at most 1.
  [[nodiscard]] bool applies() const {
    return (abs((m.omega2 + Ball(1) + omega) * t / Ball(2)) - Ball(1)).is_negative();
  }
  // (w cos(w t/2) sin(omega_j t/2) - omega_j sin(w t/2) cos(omega_j t/2))/((omega_j² - w²) t³)
  // = (sinc a - sinc b)/(4 t²), a, b = (omega_j ∓ w) t/2.
  [[nodiscard]] Ball transfer(const Ball& omega_j, const Ball& w) const {
    const Ball b = (omega_j + w) * t / Ball(2);
    return -omega_j * w * bounded(-6, b * b / Ball(60)) / Ball(4);
  }
  // lambda_k P_j/t³, slips of total duration t and omega = 1/k, up to the sign (-1)^k common to both modes.
  // At T = t and omega_j = k omega it is -lambda_k P_j/t³ up to the sign (-1)^k.
  [[nodiscard]] Ball left(const Ball& omega_j, const Ball& lambda_k) const {
    return lambda_k * (omega_j * omega_j - Ball(1)) * transfer(omega_j, Ball(1));
  }
  // R_j/t³ at T = t and omega_j = k omega, up to the sign (-1)^k.
  [[nodiscard]] Ball cubic(const Ball& omega_j) const {
    const Ball x = omega_j * t / Ball(2);
    return omega_j * omega_j * omega_j / Ball(8) * bounded(-3, x * x / Ball(30));
  }

 private:
  [[nodiscard]] static Ball bounded(int reciprocal, const Ball& slack) {
    const Ball bound = Ball(1) / Ball(reciprocal);
    return Ball::hull(bound, bound + slack);
  }
};

}  // namespace stickslip::numeric::families
