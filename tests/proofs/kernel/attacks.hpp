// What the attacks on the kernel speak of.
#pragma once

#include "tests/proofs/kernel/refuses.hpp"

namespace stickslip::proofs::kernel::attacks {

using paper::s, paper::t;
inline const Variable x{"x"}, y{"y"}, a{"a"}, b{"b"}, c{"c"};
inline const Variable f{"f", function_of_time()}, g{"g", function_of_time()};
inline const Variable M{"M", {Sort::real, 2, 2}}, v{"v", {Sort::real, 2, 1}};
inline const Formula falsity = any({});

[[nodiscard]] inline Theorem assume(const Formula& formula) {
  return Theorem::assume(formula);
}

}  // namespace stickslip::proofs::kernel::attacks
