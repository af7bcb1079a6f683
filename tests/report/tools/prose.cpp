#include "report/tools/prose.hpp"

#include <doctest/doctest.h>

#include "core/verdict.hpp"
#include "report/tools/latex.hpp"

using namespace stickslip;
using namespace stickslip::report::tools;

TEST_CASE("data of pages and pictures have the paper's letters") {
  CHECK(in_greek("chi=0.5, eta = 3.8, us=0.02, ur=0.1, V=1, omega=0.6, p=1, phi=0") ==
        "χ=0.5, η = 3.8, u_s=0.02, u_r=0.1, V=1, ω=0.6, p=1, φ=0");
  CHECK(in_greek("theta=1, beta = 2, thus=3") == "theta=1, beta = 2, thus=3");
}

TEST_CASE("three points go on") {
  CHECK(prose_tex("$tau = 7.74668...$") == "$\\tau = 7.74668 \\dots$");
}

TEST_CASE("a formula is displayed in lines that fit a narrow column") {
  CHECK(displayed("a = b") == "\\begin{gather*}\na = b\n\\end{gather*}");
  const std::string wide = displayed(
      "\\frac{a + b}{c} + \\left(a_1 + a_2 + a_3 + a_4 + a_5\\right) + \\left(b_1 + b_2 + b_3 + b_4 + "
      "b_5\\right) "
      "= 0");
  CHECK(wide.starts_with("\\begin{multline*}\n\\frac{a + b}{c} + \\left(a_1"));
  CHECK(wide.find(" \\\\\n{} + \\left(b_1 + b_2 + b_3 + b_4 + b_5\\right)") != std::string::npos);
  // Factors only where nothing else helps.
  const std::string product =
      displayed("p > \\left(a_1 + a_2 + a_3 + a_4 + a_5\\right) \\left(b_1 + b_2 + b_3 + b_4 + b_5\\right)");
  CHECK(product.find(" \\\\\n{} \\cdot \\left(b_1") != std::string::npos);
}

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
