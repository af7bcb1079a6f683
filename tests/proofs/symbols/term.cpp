#include "proofs/symbols/term.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

TEST_CASE("statements print in the order in which they stand") {
  const Statement identity = equation(power(H1(t), 2) - I2 - H2(t) * H3(t), 0);
  CHECK(text(identity) == "H1^2(t) - I - H2(t)*H3(t) = 0");
  CHECK(latex(identity) == "H_1^{2}(t) - I - H_2(t) H_3(t) = 0");
  CHECK(text(equation(Z(t), H(t) * (Z0 - F0) + F(t))) == "Z(t) = H(t)*(Z0 - F0) + F(t)");
  CHECK(text(equation(phi, (pi() - omega * tau) / 2)) == "phi = (pi - omega*tau)/2");
  CHECK(latex(equation(phi, (pi() - omega * tau) / 2)) == "\\varphi = \\frac{\\pi - \\omega \\tau}{2}");
  CHECK(text(equation(derivative(derivative(B2(t))), B3(t))) == "B2''(t) = B3(t)");
  CHECK(text(-(z10 - z20) * chi - (-chi)) == "-(z10 - z20)*chi - (-chi)");
  // The sign of the first factor is that of the product, and a minus sign subtracts.
  CHECK(text((-chi) * (ur + us) + 1) == "-chi*(ur + us) + 1");
  CHECK(text(1 + (-chi) * (ur + us)) == "1 - chi*(ur + us)");
  CHECK(latex((-chi) * (ur + us)) == "-\\chi \\left(u_r + u_s\\right)");
  CHECK(text(ur * ((-chi) * us)) == "ur*(-chi)*us");
  CHECK(text(ur - (-chi) * us) == "ur - (-chi*us)");
  CHECK(text(power(Term(-2), 2)) == "(-2)^2");
  CHECK(text(equation(Sigma, block(2, {1, chi, 0, 1}))) == "Sigma = [1, chi; 0, 1]");
  CHECK(text(Statement{ur, us, Relation::greater}) == "ur > us");
  CHECK(latex(determinant(H3(t))) == "\\det\\left(H_3(t)\\right)");
  CHECK(latex(determinant(block(2, {1, chi, 0, 1}))) ==
        "\\begin{vmatrix} 1 & \\chi \\\\ 0 & 1 \\end{vmatrix}");
  CHECK(text(determinant(block(2, {1, chi, 0, 1}))) == "det([1, chi; 0, 1])");
}

TEST_CASE("what is said of all times, or of almost all, says of which") {
  const Statement law = equation(derivative(X(t)), sign(V - t) * X(t));
  CHECK(text(during(0, tau, law)) == "X'(t) = sign(V - t)*X(t), 0 < t < tau, continuous on [0, tau]");
  CHECK(text(almost_always(0, tau, law)) ==
        "X'(t) = sign(V - t)*X(t), 0 < t < tau but for finitely many t, continuous on [0, tau]");
  CHECK(latex(almost_always(0, tau, law)) ==
        "X'(t) = \\operatorname{sign}(V - t) X(t), \\quad 0 < t < \\tau \\text{ but for finitely many } t, "
        "\\text{ continuous on } [0, \\tau]");
  CHECK(equal(almost_always(0, tau, law), almost_always(0, tau, law)));
  CHECK(!equal(almost_always(0, tau, law), during(0, tau, law)));
  CHECK(equal(substitute(almost_always(0, tau, law), {{"tau", T}, {"t", s}}), almost_always(0, T, law)));
}

TEST_CASE("formulas without meaning cannot be built") {
  CHECK_THROWS_AS((void)(H(t) + H1(t)), InternalError);
  CHECK_THROWS_AS((void)(H(t) * d0), InternalError);
  CHECK_THROWS_AS((void)(d0 * d0), InternalError);
  CHECK_THROWS_AS((void)power(d0, 2), InternalError);
  CHECK_THROWS_AS((void)(chi / d0), InternalError);
  CHECK_THROWS_AS((void)block(2, {H1(t), d0, d0, H1(t)}), InternalError);
  CHECK_THROWS_AS((void)substitute(H(t), {{"t", H1(t)}}), InternalError);
}

TEST_CASE("symbols are replaced all at once") {
  CHECK(text(substitute(H(t + s), {{"t", s}, {"s", -t}})) == "H(s - t)");
  CHECK(equal(substitute(H(t) * Z0, {{"tau", t}}), H(t) * Z0));
}
