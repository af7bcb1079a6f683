// An audit that says how far it is.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

// Called before each claim: its id, how many are done, how many there are.
using Progress = std::function<void(const std::string& id, std::size_t done, std::size_t all)>;

// The audit of claim.hpp; after an interruption the records made before it.
[[nodiscard]] Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids,
                          const Progress& progress);

}  // namespace stickslip::proofs::methods
