// The branch of a periodic motion of a machine between two values of a datum, at all values in between.
#pragma once

#include <functional>
#include <optional>

#include "numeric/branches/state.hpp"
#include "numeric/machines/machine_orbit.hpp"

namespace stickslip::numeric::machines {

// What the motion is, by what is proved of it.
[[nodiscard]] branches::State state_of(const MachineOrbit& orbit);

struct Joint {
  // Of "at each value between there is exactly one closed motion in a box that goes with the value, and these
  // form a curve from the one motion to the other".
  Verdict existence;
  // Of "and each of them is in that state".
  Verdict state;
};

// A motion at a value.
struct MotionAt {
  Rational value;
  MachineGuess guess;
};

// From a to b, in steps that are as long as proofs allow. `at`: the machine at a value of the datum; assumes
// that each of its numbers is a linear function of the value or a quotient of two, and that the loads'
// multiples change only with one frequency among several. Undecided where the numbers, or those at the
// value's inverse, are not linear, with smooth laws of friction, and where a step would be shorter than 2^-12
// of the way.
[[nodiscard]] Joint joint_between(const std::function<Machine(const Rational&)>& at, const MotionAt& a,
                                  const MotionAt& b, branches::State state);

}  // namespace stickslip::numeric::machines
