#include "proofs/methods/not_negative.hpp"

#include "proofs/tactics/letters.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

kernel::Positive not_negative(Derivation& derivation, const Term& a) {
  const Term opened = unfold(a, openings({a}).all());
  const tactics::Letters letters({opened});
  const auto [above, below] = letters.fraction(opened);
  Polynomial product = above;
  product *= below;
  const tactics::Factored whole = tactics::factored(product, letters);
  Rational factor = leading_coefficient(product) / leading_coefficient(whole.product);
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
