// What becomes of one claim among others.
#pragma once

#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::methods {

// Of the claim with this id, when it and all that it uses are proved.
[[nodiscard]] inline Status status(const std::vector<Claim>& claims, const std::string& id) {
  return audit(claims, {id}).records.front().status;
}

}  // namespace stickslip::proofs::methods
