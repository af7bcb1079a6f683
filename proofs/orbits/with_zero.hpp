// Unknowns that are known only as a zero of a system.
#pragma once

#include <functional>
#include <vector>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::orbits {

// ⊢ exactly one column of unknowns in the box lets the terms vanish, in which the variables of `at_value`
// have their values. Throws KernelError where Krawczyk's test does not prove it.
[[nodiscard]] kernel::Theorem exactly_one_zero(const std::vector<kernel::Variable>& unknowns,
                                               const std::vector<kernel::Term>& terms, const kernel::Box& box,
                                               const kernel::Substitution& at_value = {});

// The theorem less its hypotheses on the unknowns, which are their ranges l <= x, x <= u and that the terms
// vanish, equal(term, 0): by Krawczyk's test there are such unknowns. Its conclusion names none of them. In
// the system and in the theorem the variables of `at_value` get their values; hypotheses without variables
// go, where they hold. Throws KernelError where one of this is not so.
[[nodiscard]] kernel::Theorem with_zero(const kernel::Theorem& theorem,
                                        const std::vector<kernel::Variable>& unknowns,
                                        const std::vector<kernel::Term>& terms, const kernel::Box& box,
                                        const kernel::Substitution& at_value = {});

// What else is true of an orbit that a theorem says to exist.

// From ⊢ there are …: B, and B ⊢ C by `more`: ⊢ there are those of them that C speaks of: C.
[[nodiscard]] kernel::Theorem of_orbit(const kernel::Theorem& orbit,
                                       const std::function<kernel::Theorem(const kernel::Theorem&)>& more);

// From ⊢ there are …: B, and B ⊢ C by `more`: ⊢ there are …: B and C.
[[nodiscard]] kernel::Theorem orbit_with(const kernel::Theorem& orbit,
                                         const std::function<kernel::Theorem(const kernel::Theorem&)>& more);

}  // namespace stickslip::proofs::orbits
