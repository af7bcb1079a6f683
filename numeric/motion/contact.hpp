// How little it takes to leave a stable orbit: a disturbance that moves the motion by more than the distance
// at which it passes a violation of the friction law may lead to other phases, and the multipliers say
// nothing of these.
#pragma once

#include "numeric/motion/conditions.hpp"

namespace stickslip::numeric::motion {

struct Contact {
  std::string condition;  // the id of the one that is nearest to a violation
  Ball margin;            // contains the smallest margin of all; a length, as all margins
  Ball at;                // when it has that margin
};

// Of the conditions along the motion, durations and data left out. Nothing unless all of them are proved,
// with margins, and there are some.
[[nodiscard]] std::optional<Contact> contact_of(const std::vector<Condition>& conditions);

}  // namespace stickslip::numeric::motion
