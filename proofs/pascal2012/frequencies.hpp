// The frequencies (39) as parameters in place of chi and eta.
#pragma once

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::pascal2012 {

// "39.frequencies": there are frequencies for all chi and eta.
[[nodiscard]] methods::Claim frequencies_exist();

}  // namespace stickslip::proofs::pascal2012
