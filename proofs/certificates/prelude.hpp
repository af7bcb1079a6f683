// The files of prelude/, which are part of the program.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stickslip::proofs::certificates {

// Name and text, each after those that it imports.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prelude();

// rules.mk likewise: the rules of the Makefile beside certificates that are the same in all.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& make_rules();

}  // namespace stickslip::proofs::certificates
