#include "report/tools/latex.hpp"

#include <doctest/doctest.h>

namespace stickslip::report::tools {
namespace {

Compiled compiled(const std::string& body) {
  return compile({{"a.tex", "\\documentclass{article}\n\\begin{document}\n\\makeatletter\n" + body +
                                "\\end{document}\n"}},
                 "a");
}

TEST_CASE("a document says on which page its end is, behind contents that fill pages of their own") {
  if (!can_compile()) {
    MESSAGE("there is no LaTeX here");
    return;
  }
  const Compiled result = compiled(
      "\\pdfcompresslevel=0 \\pdfobjcompresslevel=0\n"
      "\\pdfinfo{/Keywords (page \\ifx\\r@end\\undefined ?\\else\\expandafter\\@secondoftwo\\r@end\\fi)}\n"
      "\\tableofcontents\\newpage\n"
      "\\newcount\\n \\loop\\advance\\n1 \\section{S}\\ifnum\\n<200\\repeat\n"
      "\\newpage\\label{end}The end.\n");
  CHECK(result.problem.empty());
  REQUIRE(result.pdf.size() == 1);
  const std::string& pdf = result.pdf[0].content;
  const std::size_t said = pdf.find("/Keywords (page ");
  REQUIRE(said != std::string::npos);
  const std::string page = std::to_string(std::stoi("0" + pdf.substr(said + 16, 4)));
  CHECK(std::stoi(page) > 5);
  CHECK(pdf.find("/Count " + page + "\n") != std::string::npos);  // the last one
}

TEST_CASE("what LaTeX complains of, and what never settles, is said") {
  if (!can_compile()) {
    MESSAGE("there is no LaTeX here");
    return;
  }
  const Compiled wrong = compiled("\\nothingofthatname\n");
  CHECK(wrong.pdf.empty());
  CHECK(wrong.problem.find("Undefined control sequence") != std::string::npos);
  const Compiled restless = compiled("A\\write\\@auxout{\\@percentchar\\the\\pdfrandomseed}\n");
  CHECK(restless.pdf.empty());
  CHECK(restless.problem.find("settle") != std::string::npos);
}

}  // namespace
}  // namespace stickslip::report::tools
