// The unit of time of (3).
#pragma once

#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::pascal2012 {

// "3.Omega": Omega is one positive number; "3.rates": what a change of the unit of time makes of derivatives.
[[nodiscard]] std::vector<methods::Claim> unit_of_time();

}  // namespace stickslip::proofs::pascal2012
