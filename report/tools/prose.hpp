// Sentences in which formulas stand as plain text, such as "x2' < V for 0 < t < tau".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stickslip::report::tools {

struct ProsePart {
  bool formula = false;
  std::string text;  // the words, or the LaTeX of the formula
};

// The sentence cut into words and formulas. A formula is a longest run of the paper's symbols, numbers and
// signs that contains a symbol, or two numbers with a sign between them; a number in parentheses is the
// number of an equation, and "a" is a word. Nothing is lost: words stay as they are.
[[nodiscard]] std::vector<ProsePart> prose_parts(std::string_view sentence);

// The sentence for a page: words escaped, formulas between <tex> and </tex>, or between dollars.
[[nodiscard]] std::string prose_html(std::string_view sentence);
[[nodiscard]] std::string prose_tex(std::string_view sentence);

}  // namespace stickslip::report::tools
