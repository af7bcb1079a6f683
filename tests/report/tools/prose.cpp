#include "report/tools/prose.hpp"

#include <doctest/doctest.h>

#include "core/verdict.hpp"

using namespace stickslip;
using namespace stickslip::report::tools;

TEST_CASE("what is marked is set as a formula") {
  CHECK(prose_tex("slip with $x2' < V$, $u = u_s$: the motion") ==
        "slip with $x_2' < V$, $u = u_s$: the motion");
  CHECK(prose_tex("for $0 < t < pi/omega$, what $sin(omega t)$ gives") ==
        "for $0 < t < \\pi / \\omega$, what $\\sin ( \\omega t )$ gives");
  CHECK(prose_tex("$P_1$ needs $det H_2 != 0$") == "$P_1$ needs $\\det H_2 \\ne 0$");
  CHECK(prose_tex("$chi eta (z2B - z1B) >= 0$") == "$\\chi \\eta ( z_{2B} - z_{1B} ) \\ge 0$");
  CHECK(prose_tex("$H(t)^{-1} H_2^2$") == "$H ( t )^ { - 1 } H_2^ 2$");
  CHECK(prose_tex("the $a$ of $(a, b)$ ($phi = k pi$, the paper has 0)") ==
        "the $a$ of $( a , b )$ ($\\varphi = k \\pi$, the paper has 0)");
  CHECK(prose_tex("$a sqrt((b + sqrt(c))/d) + e$") == "$a \\sqrt{( b + \\sqrt{c} ) / d} + e$");
  CHECK(prose_tex("$tau = 1.5 ± 2e-7$") == "$\\tau = 1.5 \\pm 2 \\cdot 10^{-7}$");
}

TEST_CASE("outside the marks only numbers with an exponent or a radius are") {
  for (const char * words :
       {"a motion that starts at 0", "(25) and (26) hold in 3 cases", "the model's first-order system",
        "what (63.P) and 65.sharp say", "Section 4 of Appendix 1", "", "x", "tau = 1.5"}) {
    CHECK(prose_tex(words) == words);
  }
  CHECK(prose_tex("off by -0.5 ± 6.9e-6 units") == "off by $- 0.5 \\pm 6.9 \\cdot 10^{-6}$ units");
  CHECK(prose_tex("agree to 2.1e-12, of 3") == "agree to $2.1 \\cdot 10^{-12}$, of 3");
}

TEST_CASE("words are escaped for the page, and cannot bring in tags") {
  CHECK(prose_html("<tex>tau</tex> & \"b\"").find("<tex>tau</tex>") == std::string::npos);
  CHECK(prose_html("$x < y$") == "<tex>x &lt; y</tex>");
  CHECK(prose_tex("100% of {F}, ^{$F$}") == "100\\% of \\{F\\}, \\textasciicircum{}\\{$F$\\}");
  CHECK(prose_tex("50% of #1_ and 3 $") == "50\\% of \\#1\\_ and 3 \\$");
}

TEST_CASE("without the marks a sentence is plain text") {
  CHECK(plain("$P_1$ needs $det H_2 != 0$") == "P_1 needs det H_2 != 0");
}
