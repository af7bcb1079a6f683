// That a threshold is crossed: on a short part of a branch a quantity rises or falls strictly wherever it is
// not above zero, so it has one zero there at most, and passes it with a speed that is not zero.
#pragma once

#include <optional>
#include <string>

#include "numeric/branches/law.hpp"

namespace stickslip::numeric::branches {

// How a quantity goes along the part.
enum class Trend {
  above,    // positive all the way
  rising,   // with a positive derivative wherever it is not positive
  falling,  // with a negative one
  unknown,
};

// Of the margin of a condition. Along a phase the margin is the infimum over time of g(t) or of g(t)/t next
// to an end that g touches, and it rises if g does at each time at which it is not positive: then the set of
// parameters where the condition holds has one end. Times count from the end of the phase that is nearer.
[[nodiscard]] Trend trend_of(const motion::Requirement& requirement,
                             const motion::MotionOf<zeros::ParameterJet>& motion,
                             const std::optional<zeros::ParameterJet>& ur);

// Of the lesser of two quantities.
[[nodiscard]] Trend joined(Trend a, Trend b);

}  // namespace stickslip::numeric::branches
