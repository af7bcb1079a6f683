// Sentences with formulas in them, each between dollars and otherwise as one types it: "slip with $x2' < V$".
// Without the dollars, plain() of core/verdict.hpp, they are for terminals and data.
#pragma once

#include <string>
#include <string_view>

namespace stickslip::report::tools {

// The sentence for a page: words escaped, the LaTeX of formulas between <tex> and </tex>, or between dollars.
// What stands between the marks is symbols (symbolic/typeset/names.hpp), numbers, signs and brackets; outside
// them only a number with an exponent or a radius, such as 1.5 ± 2e-7, is set as a formula.
[[nodiscard]] std::string prose_html(std::string_view sentence);
[[nodiscard]] std::string prose_tex(std::string_view sentence);

// A list of data for pages and pictures: "χ=0.3, η=4, u_s=0.1" for "chi=0.3, eta=4, us=0.1".
[[nodiscard]] std::string in_greek(std::string list);

// With a capital.
[[nodiscard]] std::string capitalised(std::string words);

}  // namespace stickslip::report::tools
