#include "report/tools/prose.hpp"

#include <doctest/doctest.h>

using namespace stickslip::report::tools;

TEST_CASE("HTML: what is special becomes a reference, the rest stays") {
  CHECK(escape_html("a<b> & \"c\" 'd'") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  CHECK(escape_html("ω₁ ≠ é") == "ω₁ ≠ é");
  CHECK(escape_html("").empty());
  CHECK(escape_html("&amp;") == "&amp;amp;");
}

TEST_CASE("TeX: what is special is printed as it looks") {
  CHECK(escape_tex("50% of u_s & #1 {x} $5") == "50\\% of u\\_s \\& \\#1 \\{x\\} \\$5");
  CHECK(escape_tex("a\\b^c~d") == "a\\textbackslash{}b\\textasciicircum{}c\\textasciitilde{}d");
  CHECK(escape_tex("a<b>c|d") == "a$<$b$>$c$|$d");
  CHECK(escape_tex("").empty());
}

TEST_CASE("TeX: hyphens stay hyphens, which can be copied to a shell") {
  CHECK(escape_tex("audit --mutants") == "audit -{}-mutants");
  CHECK(escape_tex("---x") == "-{}-{}-x");
  CHECK(escape_tex("stick-slip - and") == "stick-slip - and");
}

TEST_CASE("TeX: mathematics and letters beyond ASCII") {
  CHECK(escape_tex("ω₁ ± 2²") == "$\\omega$$_{1}$ $\\pm$ 2$^{2}$");
  CHECK(escape_tex("Poincaré – “x”…") == "Poincaré -- ``x''\\ldots{}");
}

TEST_CASE("TeX: what LaTeX cannot read is named, never dropped") {
  CHECK(escape_tex("漢") == "[U+6F22]");
  CHECK(escape_tex("a\xff"
                   "b") == "a[U+FFFD]b");
  CHECK(escape_tex("\xc3") == "[U+FFFD]");
  CHECK(escape_tex(std::string_view("a\0b\x1b", 4)) == "a b ");
}
