// What the friction law (2), (4) demands of a motion, as data; and the parts of it that families share.
//
// Where it comes from. On a slip x2'' = eta (us - r), on an overshoot x2'' = eta (-us - r), on a stick u = r,
// with r of (4), and chi (x2 - x1) = chi (z2 - z1) + us. Hence, when a slip from below ends with z2' = V:
//   |r| < ur    it sticks                                            (14), (19): -ur < r < ur
//   r < -ur     u = -us, x2'' = eta (-us - r) > 0: it overshoots     (18), (26)
// and when an overshoot or a stick ends:
//   r > ur      u = us, x2'' = eta (us - r) < 0: it slips below      (25)
//   r = ur      reached from below at the end of a stick: it slips   (12)
// With eta r = chi eta (z2 - z1) + eta us - p cos(omega t + phi) these read as in the paper, in particular
//   (14), (19)  -eta (ur + us) < chi eta (z2C - z1C) - p cos(omega t_C + phi) < eta (ur - us).
// For the symmetric orbit the middle of (14) is -eta (ur - us), by (12), (13) and phi = (pi - omega tau)/2.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "numeric/motion/infimum.hpp"

namespace stickslip::numeric::motion {

// A signed distance, positive where the condition holds; written for the paper's own scaling, so a length.
enum class Quantity {
  below_belt,         // V - x2'
  above_belt,         // x2' - V
  below_ur,           // eta (ur - r)
  above_minus_ur,     // eta (ur + r)
  beyond_ur,          // eta (r - ur)
  beyond_minus_ur,    // eta (-ur - r)
  falls_behind,       // eta (r - us) = -x2''(0+), with the premise r = ur
  duration,           // of the phase
  slipping_friction,  // us
  friction_step,      // ur - us
};

// A quantity that is a function of time: a factor times x2', or times r, plus an offset.
template <class S>
struct Affine {
  bool of_speed = true;
  S factor, offset;
};

// That of these data. Throws InternalError for a quantity that is no function of time.
template <class S>
[[nodiscard]] Affine<S> affine_form(const model::Parameters<S>& a, const S& ur, Quantity quantity) {
  switch (quantity) {
    case Quantity::below_belt:
      return {true, S(-1), a.V};
    case Quantity::above_belt:
      return {true, S(1), S(-a.V)};
    case Quantity::below_ur:
      return {false, S(-a.eta), S(a.eta * ur)};
    case Quantity::above_minus_ur:
      return {false, a.eta, S(a.eta * ur)};
    case Quantity::beyond_ur:
      return {false, a.eta, S(-a.eta * ur)};
    case Quantity::beyond_minus_ur:
      return {false, S(-a.eta), S(-a.eta * ur)};
    case Quantity::falls_behind:
      return {false, a.eta, S(-a.eta * a.us)};
    default:
      throw InternalError("a quantity that is no function of time");
  }
}

// Whether it can be decided only when ur is known.
[[nodiscard]] bool needs_ur(Quantity quantity);

// One condition of a family, as data.
struct Requirement {
  std::string id;         // the paper's equation, or a word where it has no number
  std::string statement;  // in the paper's symbols
  Quantity quantity = Quantity::duration;
  std::size_t phase = 0;
  bool along = false;    // over the whole closed phase; else at its beginning
  Touches touches = {};  // where the distance is zero by construction: the premises z2' = V, r = ur
  bool strict = true;    // > 0; else >= 0
};

using Requirements = std::vector<Requirement>;

// Each phase lasts, 0 < us < ur: for phases whose durations have these names.
[[nodiscard]] Requirements sound_data(const std::vector<std::string>& durations);

// (12), and z2' < V during the slip, the first phase, that follows a stick.
[[nodiscard]] Requirements slip_after_stick();

// The speed against the belt's during the phase: id "slip" or "overshoot".
[[nodiscard]] Requirement slips(std::size_t phase, const std::string& statement);
[[nodiscard]] Requirement overshoots(std::size_t phase, const std::string& statement);

// (14), (19): the motion sticks when the phase begins, at the time of that name.
[[nodiscard]] Requirements sticks_at(const std::string& id, std::size_t phase, const std::string& time);

// One list after the other.
[[nodiscard]] Requirements joined(const std::vector<Requirements>& lists);

}  // namespace stickslip::numeric::motion
