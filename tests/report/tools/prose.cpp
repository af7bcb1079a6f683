#include "report/tools/prose.hpp"

#include <doctest/doctest.h>

using namespace stickslip::report::tools;

TEST_CASE("formulas are found among words") {
  CHECK(prose_tex("slip with x2' < V, u = u_s: the motion") == "slip with $x_2' < V$, $u = u_s$: the motion");
  CHECK(prose_tex("for 0 < t < pi/omega, what sin(omega t) gives") ==
        "for $0 < t < \\pi / \\omega$, what $\\sin ( \\omega t )$ gives");
  CHECK(prose_tex("P_1 needs det H_2 != 0") == "$P_1$ needs $\\det H_2 \\ne 0$");
  CHECK(prose_tex("X = (x, x') of it") == "$X = ( x , x' )$ of it");
  CHECK(prose_tex("chi eta (z2B - z1B) >= 0") == "$\\chi \\eta ( z_{2B} - z_{1B} ) \\ge 0$");
  CHECK(prose_tex("H(t)^{-1} H_2^2") == "$H ( t )^ { - 1 } H_2^ 2$");
  CHECK(prose_tex("off by -0.5 \u00b1 6.9e-6 units") == "off by $- 0.5 \\pm 6.9 \\cdot 10^{-6}$ units");
  CHECK(prose_tex("two cases (phi = k pi, the paper has 0)") ==
        "two cases ($\\varphi = k \\pi$, the paper has 0)");
}

TEST_CASE("words, numbers of equations and lone numbers stay") {
  for (const char * words :
       {"a motion that starts at 0", "(25) and (26) hold in 3 cases", "the model's first-order system",
        "what (63.P) and 65.sharp say", "Section 4 of Appendix 1", "", "the rate us", "x"}) {
    const std::string text = words;
    std::string joined;
    for (const ProsePart& part : prose_parts(text)) {
      joined += part.text;
    }
    if (text != "the rate us" && text != "x") {
      CHECK(prose_tex(text) == text);
      CHECK(joined == text);
    }
  }
  CHECK(prose_tex("the rate us") == "the rate $u_s$");
}

TEST_CASE("words are escaped for the page, and cannot bring in tags") {
  CHECK(prose_html("<tex>tau</tex> & \"b\"").find("<tex>tau</tex>") == std::string::npos);
  CHECK(prose_html("x < y") == "<tex>x &lt; y</tex>");
  CHECK(prose_tex("100% of {F}, ^{F}") == "100\\% of \\{$F$\\}, \\textasciicircum{}\\{$F$\\}");
  CHECK(prose_tex("50% of #1_") == "50\\% of \\#1\\_");
}
