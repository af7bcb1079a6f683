// Variables, and ranges of them, for the tests of this folder.
#pragma once

#include "proofs/orbits/enclosed_matrix.hpp"

namespace stickslip::proofs::orbits::letters {

inline const kernel::Variable a{"a"}, s{"s"}, t{"t"}, x{"x"}, y{"y"};

// 1, nearly.
[[nodiscard]] inline Ranges about_one(const kernel::Variable& of) {
  return {{of, {Rational(999, 1000), Rational(1001, 1000)}}};
}

}  // namespace stickslip::proofs::orbits::letters
