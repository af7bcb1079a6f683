#include <algorithm>

#include "proofs/symbols/evaluate.hpp"

namespace stickslip::proofs::symbols {

template Value<Ball> evaluate(const Term&, const Lookup<Ball>&);

bool is_in_field(const Term& term) {
  const bool matrix = term.op() == Op::symbol && !term.shape().is_scalar() && term.name() != "I";
  const Symbol * symbol = symbol_table().find(term);
  using S = numeric::scalars::Series<Ball>;
  const auto& functions = detail::functions<S>();
  const auto& matrices = detail::matrices<S>();
  if (term.name() == "abs" ||
      (term.op() == Op::function && detail::formula_of<S>(functions, term.name()) == functions.end()) ||
      (matrix && !(symbol != nullptr && symbol->value) &&
       detail::formula_of<S>(matrices, term.name()) == matrices.end())) {
    return false;
  }
  return std::all_of(term.arguments().begin(), term.arguments().end(), is_in_field);
}

}  // namespace stickslip::proofs::symbols
