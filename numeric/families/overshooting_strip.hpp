// The overshooting family over an interval of one parameter, see strip.hpp.
#pragma once

#include "numeric/families/strip.hpp"

namespace stickslip::numeric::families {

// Takes (s, w) of overshooting.hpp; one strip.
[[nodiscard]] std::vector<Strip> overshooting_strips(const StripQuestion& q);

}  // namespace stickslip::numeric::families
