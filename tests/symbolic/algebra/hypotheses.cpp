#include "symbolic/algebra/hypotheses.hpp"

#include <doctest/doctest.h>

#include "symbolic/algebra/normal_form.hpp"
#include "symbolic/algebra/signs.hpp"
#include "symbolic/typeset/latex.hpp"
#include "tests/symbolic/algebra/letters.hpp"

using namespace stickslip::symbolic::algebra;
using namespace stickslip::symbolic::algebra::letters;
using namespace stickslip::symbolic::typeset;
using GiNaC::ex;
using GiNaC::pow;

namespace {

std::vector<std::string> texts(const std::vector<ex>& factors) {
  std::vector<std::string> result;
  for (const ex& factor : factors) {
    result.push_back(text(factor));
  }
  return result;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("what cannot vanish for 0 < omega1 < 1 < omega2 is discharged") {
  for (const ex& e : {chi, ex(1 - chi), eta, l1, l2, ex(l1 - l2), ex(w1 * w1 - w2 * w2), ex(1 - w1),
                      ex(1 - w2 * w2), ex(w1 + w2 - 1), ex(w * w + w1 * w1), w, symbol("us"), ex(-3)}) {
    CAPTURE(text(e));
    CHECK(vanishing_factors(e).empty());
  }
}

TEST_CASE("what can vanish there is not, factor by factor") {
  CHECK(texts(vanishing_factors(w * w - w1 * w1)).size() == 1);
  CHECK(texts(vanishing_factors(w - 1)).size() == 1);
  CHECK(texts(vanishing_factors(V)) == Texts{"V"});
  CHECK(texts(vanishing_factors(w1 + w2 - 2)).size() == 1);
  CHECK(texts(vanishing_factors(GiNaC::sin(w1 * t) * chi)) == Texts{"sin(omega1*t)"});
  CHECK(texts(vanishing_factors(V * (w - w1) * (w - w2) * (w + w1))).size() == 3);
}

TEST_CASE("denominators are found wherever they stand") {
  CHECK(texts(hypotheses_of({1 + V / (3 + 1 / (w - 1))})).size() == 2);  // w - 1, and 3w - 2
  CHECK(texts(hypotheses_of({GiNaC::tan(w1 * t)})) == Texts{"cos(omega1*t)"});
  CHECK(hypotheses_of({w1 / chi + 1 / w2}).empty());
}

TEST_CASE("division by zero is not a hypothesis") {
  CHECK_THROWS_AS((void)hypotheses_of({1 / (chi * eta - w1 * w1 - w2 * w2 + 1)}), OutsideField);
}

TEST_CASE("pi is a positive number beside which polynomials still factor") {
  CHECK(texts(vanishing_factors((GiNaC::Pi - t) * (GiNaC::Pi + w) * V)) == Texts{"V", "pi - t"});
}

TEST_CASE("where nothing is left that could vanish, zero vanishes and nothing else does") {
  const GiNaC::ex a = symbol("omega");
  CHECK(vanishes_with(a - a, a - a));
  CHECK_FALSE(vanishes_with(a, a - a));
  CHECK(vanishes_with(a - a, a));
}
