// Decimals as balls.
#pragma once

#include "core/ball.hpp"
#include "core/decimal.hpp"

namespace stickslip {

// Contains the number of the text.
[[nodiscard]] inline Ball exact(const char * text) {
  return Ball(parse_rational(text));
}

}  // namespace stickslip
