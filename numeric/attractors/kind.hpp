// The kinds of motion that a simulation settles on.
#pragma once

#include <string>

namespace stickslip::numeric::attractors {

enum class Kind {
  periodic,        // after n periods of the load, with events in each n of them
  quasi_periodic,  // does not return, and neighbours do not leave it exponentially
  irregular,       // neighbours leave it exponentially
  slides,          // never touches the belt's speed again
  stuck,           // stays on a belt that does not move
  grows,           // beyond all bounds, proved
  unsettled,       // within the periods that were allowed
};

// "periodic", "quasi-periodic", "irregular", "slides", "stuck", "grows without bound",
// "unsettled".
[[nodiscard]] std::string to_string(Kind kind);

}  // namespace stickslip::numeric::attractors
