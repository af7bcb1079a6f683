// model/appendix3.hpp says the same as the twenty coefficients (47)-(51) that are printed.
#include "model/appendix3.hpp"

#include <fmt/format.h>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

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

Proofs computed_coefficients() {
  return {{"51.formulas", [](Prover& prover, const Claim& claim) {
             return compared(
                 "the formulas that the program computes with and the printed ones have the same normal form",
                 prover, claim, computed);
           }}};
}

}  // namespace stickslip::proofs::pascal2012
