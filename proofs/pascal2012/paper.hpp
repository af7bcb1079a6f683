// The paper, section by section: M. Pascal, New limit cycles of dry friction oscillators under harmonic load,
// Nonlinear Dynamics 70 (2012) 1435-1443.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

// The claims as text (text/claims_file.hpp), section by section, which is a part of the program: the names of
// the files and what stands in them.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& claims_text();

[[nodiscard]] const methods::Bibliography& bibliography();

// The paper, made once: its claims are read.
[[nodiscard]] const methods::Paper& paper();

}  // namespace stickslip::proofs::pascal2012
