// Formulas set: on pages when these are made, in documents, in columns.
#pragma once

#include <string>
#include <vector>

#include "report/tools/files.hpp"

namespace stickslip::report::tools {

// Formulas of HTML pages, set when the pages are made.

// Throws InputOutputError naming the program unless formulas can be set. Called before long work whose result
// is a page.
void require_katex();

// The pages with every <tex>LATEX</tex> and <tex-display>LATEX</tex-display>, the LaTeX escaped for HTML,
// replaced by KaTeX's HTML, MathML inside; and, as a further file, its style sheet katex.css with the fonts
// in it. One process for all. Throws InputOutputError when Node.js or KaTeX is missing or a formula is not
// understood.
[[nodiscard]] std::vector<File> with_formulas(const std::vector<File>& pages);

// LaTeX documents compiled.

// Whether there is TeX.
[[nodiscard]] bool can_compile();

// NAME.pdf from NAME.tex, which is among the files, with the pictures that it includes: without a date and
// the same for the same files. `problem` says in half a sentence why there is none: TeX is not there, or
// complains.
struct Compiled {
  std::vector<File> pdf;  // one file or none
  std::string problem;
};
[[nodiscard]] Compiled compile(const std::vector<File>& files, const std::string& name);

// Formulas displayed in columns as narrow as those of a journal.

// The LaTeX of a formula, as proofs/symbols prints it, between the commands of amsmath that display it: in
// one line if that is estimated to fit a column of 230 pt, else broken in front of signs and relations, at
// need of factors in brackets, that stand in no bracket themselves.
[[nodiscard]] std::string displayed(const std::string& latex);

}  // namespace stickslip::report::tools
