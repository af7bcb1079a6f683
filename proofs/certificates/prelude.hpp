// The files of prelude/, which are part of the program.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stickslip::proofs::certificates {

// Name and text, each after those that it imports.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prelude();

}  // namespace stickslip::proofs::certificates
