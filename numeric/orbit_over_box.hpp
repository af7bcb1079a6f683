// One orbit over a whole box of parameters, in as many parts of the box as that takes.
#pragma once

#include <string>

#include "numeric/families/family.hpp"

namespace stickslip::numeric {

struct OrbitOverBox {
  // Of "for each member of the box there is a closed motion, all of whose phases last, which changes with the
  // member without a jump, and is that near the candidate's at the middle".
  Verdict existence;
  std::string split;  // the parameter to split first, where something is undecided
  // Contains the values for all members, with what is decided for all of them; meaningless unless proved. A
  // margin contains the smallest distance of each member; where there are several parts there is no
  // violation.
  families::Orbit orbit;
  std::size_t parts = 1;  // that the box was divided into
};

// At the working precision of the moment. First the whole box; while the motion, a condition or the stability
// is not decided over it, it is halved in the parameter that the motion varies most with, and so are its
// parts, until all is decided, or what is open is known to hold for some members and not for others, or there
// would be more than `most_parts` parts, or parts that were halved more than twelve times. In each part
// exactly one closed motion lies in a box of the unknowns; at a point that both halves share, the middle of
// what was halved, that of the one is proved to be that of the other, and so it is wherever they meet.
[[nodiscard]] OrbitOverBox prove_over_box(const families::Family& family,
                                          const families::Candidate& candidate,
                                          const motion::Given<Ball>& box, std::size_t most_parts = 512);

}  // namespace stickslip::numeric
