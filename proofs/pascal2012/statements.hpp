// The paper's statements, each line of it in our own words, with the claims that state it. What counts as one
// statement: a numbered equation with all its parts; a part of another kind, or with an argument of its own;
// a sentence between equations; a printed number. What is said twice counts twice.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

[[nodiscard]] std::vector<methods::PrintedStatement> statements_of_model();   // title to Section 3
[[nodiscard]] std::vector<methods::PrintedStatement> statements_of_orbits();  // Sections 4 and 5
[[nodiscard]] std::vector<methods::PrintedStatement> statements_of_nonsticking_orbits();  // Sections 6 and 7
[[nodiscard]] std::vector<methods::PrintedStatement> statements_of_appendices();          // Appendices 1 to 5

// All of them, in the paper's order.
[[nodiscard]] const std::vector<methods::PrintedStatement>& printed_statements();

// Whether one of them names the claim as stating it.
[[nodiscard]] bool is_stated(const std::string& claim);

}  // namespace stickslip::proofs::pascal2012
