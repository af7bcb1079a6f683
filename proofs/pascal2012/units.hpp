// The quantities of (3), and the unit of time.
#pragma once

#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::pascal2012 {

// "3.exist": there are frequencies and a unit of time for all masses and stiffnesses.
[[nodiscard]] methods::Claim quantities_of_3();

// "3.Omega": Omega is one positive number; "3.rates": what a change of the unit of time makes of derivatives.
[[nodiscard]] std::vector<methods::Claim> unit_of_time();

}  // namespace stickslip::proofs::pascal2012
