// Formulas of HTML pages, set when the pages are made.
#pragma once

#include <vector>

#include "report/tools/files.hpp"

namespace stickslip::report::tools {

// Throws InputOutputError naming the program unless formulas can be set. Called before long work whose result
// is a page.
void require_katex();

// The pages with every <tex>LATEX</tex> and <tex-display>LATEX</tex-display>, the LaTeX escaped for HTML,
// replaced by KaTeX's HTML, MathML inside; and, as a further file, its style sheet katex.css with the fonts
// in it. One process for all. Throws InputOutputError when Node.js or KaTeX is missing or a formula is not
// understood.
[[nodiscard]] std::vector<File> with_formulas(const std::vector<File>& pages);

}  // namespace stickslip::report::tools
