// The equations that the proofs of orbits solve in place of the paper's, and that they say the same:
// "residual of the paper's closing condition = M · residual of the reduced equation" and back. Where a
// difference quotient such as sin(x)/x stands in a formula, x ≠ 0 appears among the hypotheses; both sides
// being continuous, the identity holds at x = 0 too.
#include <fmt/format.h>

#include "model/appendix3.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/reduction.hpp"
#include "proofs/tactics/model_terms.hpp"

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

// model/appendix3.hpp says the same as the twenty coefficients (47)-(51) that are printed.

std::vector<Equal> computed(Derivation& derivation) {
  using tactics::Symbolic;
  const auto s = [](const char * name) { return Symbolic(kernel::Variable{name}); };
  const auto letters = model::appendix3_letters<Symbolic>(
      s("chi"), {s("omega1"), s("omega2"), s("lambda1"), s("lambda2")}, {s("q1"), s("q2")},
      {s("d01"), s("d02")}, s("omega"), s("V"), s("phi"), s("tau"), s("tau1"), s("T"));
  const auto k = model::appendix3<Symbolic>(letters, model::Reading::printed);
  std::vector<Equal> result;
  for (const auto& [letter, column] : {std::pair('a', k.a), {'b', k.b}, {'c', k.c}, {'d', k.d}}) {
    for (std::size_t i = 0; i < column.size(); ++i) {
      const Claim& claim = derivation.prover().claim(fmt::format("{}.{}", 47 + i, letter));
      result.push_back({column[i].term, derivation.read(claim.printed.front().right)});
    }
  }
  return result;
}

}  // namespace

Proofs reduced() {
  Proofs result{{"7.modal", reduction::reduced(modal_forms)}};
  for (Proofs some : {of_symmetric(), of_overshooting(), of_nonsticking()}) {
    result.merge(some);
  }
  return result;
}

Proofs computed_coefficients() {
  return {{"51.formulas", [](Prover& prover, const Claim& claim) {
             return compared(
                 "the formulas that the program computes with and the printed ones have the same normal form",
                 prover, claim, computed);
           }}};
}

}  // namespace stickslip::proofs::pascal2012
