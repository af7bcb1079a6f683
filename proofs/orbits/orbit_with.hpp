// What else is true of an orbit that a theorem says to exist.
#pragma once

#include <functional>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::orbits {

// From ⊢ there are …: B, and B ⊢ C by `more`: ⊢ there are those of them that C speaks of: C.
[[nodiscard]] kernel::Theorem of_orbit(const kernel::Theorem& orbit,
                                       const std::function<kernel::Theorem(const kernel::Theorem&)>& more);

// From ⊢ there are …: B, and B ⊢ C by `more`: ⊢ there are …: B and C.
[[nodiscard]] kernel::Theorem orbit_with(const kernel::Theorem& orbit,
                                         const std::function<kernel::Theorem(const kernel::Theorem&)>& more);

}  // namespace stickslip::proofs::orbits
