// The equations that the proofs of orbits solve in place of the paper's, and that they say the same:
// "residual of the paper's closing condition = M · residual of the reduced equation" and back. Where a
// difference quotient such as sin(x)/x stands in a formula, x ≠ 0 appears among the hypotheses; both sides
// being continuous, the identity holds at x = 0 too.
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/reduction.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

using namespace reduction;

std::vector<Equal> modal_forms(Flows& flows) {
  const model::Parameters<Symbolic> a{symbol("chi"), symbol("eta"),   symbol("us"),
                                      symbol("V"),   symbol("omega"), symbol("p")};
  flows.used.merge(std::set<std::string>{"6.d0", "7"});
  return {same(model::Q<Symbolic>(a, modes()), load()), same(model::d0<Symbolic>(a.chi, a.us), rest())};
}

}  // namespace

Proofs reduced() {
  Proofs result{{"7.modal", reduction::reduced(modal_forms)}};
  for (Proofs some : {of_symmetric(), of_overshooting(), of_nonsticking()}) {
    result.merge(some);
  }
  return result;
}

}  // namespace stickslip::proofs::pascal2012
