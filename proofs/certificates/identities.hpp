// Identities of the kernel, and words about them for Coq.
#pragma once

#include <optional>
#include <string>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::certificates {

// a + (-1) b, also of numbers: as rdiffer and mdiffer of the prelude have it.
[[nodiscard]] kernel::Term difference(const kernel::Term& a, const kernel::Term& b);

// left = right by normal form, with these definitions looked into; nothing where the kernel does not see it.
[[nodiscard]] std::optional<kernel::Theorem> identity(const kernel::Term& left, const kernel::Term& right,
                                                      const kernel::Definitions& unfolded = {});

// In Coq, the zero of a combination of that type; whole numbers are written as numbers.
[[nodiscard]] std::string nothing(const kernel::Type& type);

// "H K chi": their names in Coq.
[[nodiscard]] std::string names_of(const kernel::Definitions& definitions);

}  // namespace stickslip::proofs::certificates
