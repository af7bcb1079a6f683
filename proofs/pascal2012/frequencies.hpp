// The frequencies (39) as parameters in place of chi and eta.
#pragma once

#include <functional>

#include "proofs/orbits/along.hpp"

namespace stickslip::proofs::pascal2012 {

// For all values of the other variables: all hypotheses that are not of omega1 and omega2 alone imply what it
// says.
[[nodiscard]] kernel::Theorem closed_but_frequencies(kernel::Theorem theorem);

// For numbers at the data of an example, of which omega1 and omega2 are not rational: from ranges of these
// two, which are the hypotheses of what `more` makes, and that chi and eta have these values, ⊢ C, to ⊢ there
// are 0 < omega1 < 1 < omega2 at which chi and eta have these values, and C. Throws KernelError outside 0 <
// chi < 1, 0 < eta.
[[nodiscard]] kernel::Theorem at_frequencies(
    const Rational& chi, const Rational& eta,
    const std::function<kernel::Theorem(const orbits::Ranges& ranges)>& more);

}  // namespace stickslip::proofs::pascal2012
