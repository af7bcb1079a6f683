#include "proofs/methods/not_negative.hpp"

#include "proofs/tactics/letters.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

kernel::Positive not_negative(Derivation& derivation, const Term& a) {
  tactics::Letters letters;
  const auto [above, below] = letters.fraction(letters.expression(unfold(a, openings({a}).all())).normal());
  const tactics::Factored whole = tactics::factored((above * below).expand(), letters);
  Rational factor =
      symbolic::algebra::to_rational(GiNaC::ex_to<GiNaC::numeric>((above * below / whole.product).normal()));
  Term square = 1 / letters.term(below);
  std::vector<Theorem> inequalities;
  for (std::size_t k = 0; k < whole.factors.size(); ++k) {
    const Term base = letters.term(whole.factors[k]);
    if (whole.exponents[k] > 1) {
      square = square * power(base, whole.exponents[k] / 2);
    }
    if (whole.exponents[k] % 2 == 1) {
      try {
        inequalities.push_back(derivation.positive(base));
      } catch (const KernelError&) {
        inequalities.push_back(derivation.positive(-base));
        factor = -factor;
      }
    }
  }
  if (factor < 0) {
    throw KernelError("no sign is known of " + to_string(a));
  }
  return {inequalities, factor, square};
}

}  // namespace stickslip::proofs::methods
