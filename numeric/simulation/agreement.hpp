// Whether following the friction law reproduces a proved orbit.
#pragma once

#include <functional>
#include <string>

#include "numeric/orbits.hpp"
#include "numeric/simulation/record.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::simulation {

// One of the ways to follow a motion for a duration.
using Follow = std::function<Run(const Start&, double)>;

// In closed form.
[[nodiscard]] Run follow(const Start& start, double duration);

// One period, begun in the middle of the orbit's first phase, against the proved balls.
struct Agreement {
  std::string difference;  // empty when the events are those of the orbit in their order
  double time_error = 0;   // no event is farther from the proved one; meaningless with a difference
  double closure = 0;      // no component of the state is farther from where it was
};

// The middle of the first phase, rounded to double; ur is the orbit's, or for orbits that allow a range of
// it, the middle of us and the largest.
[[nodiscard]] Start start_of(const Orbit& orbit);

[[nodiscard]] Agreement agreement(const Orbit& orbit, const Follow& way);

}  // namespace stickslip::numeric::simulation
