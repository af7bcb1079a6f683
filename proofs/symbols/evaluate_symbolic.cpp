#include <algorithm>

#include "proofs/symbols/evaluate.hpp"

namespace stickslip::proofs::symbols {

template <>
Value<GiNaC::ex> evaluate(const Term& term, const Lookup<GiNaC::ex>& scalar) {
  return detail::value_of<GiNaC::ex>(term, scalar);
}

bool is_in_field(const Term& term) {
  const bool matrix = term.op() == Op::symbol && !term.shape().is_scalar() && term.name() != "I";
  const Symbol * symbol = symbol_table().find(term);
  const auto& functions = detail::functions<GiNaC::ex>();
  const auto& matrices = detail::matrices<GiNaC::ex>();
  if (term.name() == "abs" ||
      (term.op() == Op::function &&
       detail::formula_of<GiNaC::ex>(functions, term.name()) == functions.end()) ||
      (matrix && !(symbol != nullptr && symbol->value) &&
       detail::formula_of<GiNaC::ex>(matrices, term.name()) == matrices.end())) {
    return false;
  }
  return std::all_of(term.arguments().begin(), term.arguments().end(), is_in_field);
}

}  // namespace stickslip::proofs::symbols
