// The paper's statements, each line of it in our own words, with the claims that state it: statements.txt.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

// The file, which is a part of the program: its name and its text.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& statements_text();

// All of them, in the paper's order. Throws InternalError if a line of the file is none.
[[nodiscard]] const std::vector<methods::PrintedStatement>& printed_statements();

// Whether one of them names the claim as stating it.
[[nodiscard]] bool is_stated(const std::string& claim);

}  // namespace stickslip::proofs::pascal2012
