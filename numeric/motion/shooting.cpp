#include "numeric/motion/shooting.hpp"

namespace stickslip::numeric::motion {

Closing closing_of(const Shooting& f) {
  return f;
}

}  // namespace stickslip::numeric::motion
