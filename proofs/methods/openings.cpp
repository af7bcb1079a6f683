#include "proofs/methods/openings.hpp"

#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

Definitions Openings::all() const {
  Definitions result = names;
  result.insert(formulas.begin(), formulas.end());
  for (const auto& entry : closed) {
    result.insert(entry.second.begin(), entry.second.end());
  }
  return result;
}

Definitions Openings::in_parameters() const {
  Openings less = *this;
  less.closed.erase(coefficients);
  return less.all();
}

Definitions Openings::with(const std::set<std::string>& ids) const {
  Definitions result = names;
  result.insert(formulas.begin(), formulas.end());
  for (const auto& entry : closed) {
    if (ids.contains(entry.first)) {
      result.insert(entry.second.begin(), entry.second.end());
    }
  }
  return result;
}

namespace {

void add(Openings& openings, const Definition& definition) {
  const kernel::Type& type = definition.body().type();
  const symbols::Symbol * row = nullptr;
  for (const symbols::Symbol& one : symbols::symbol_table()) {
    if (one.name == definition.name() && one.shape == symbols::Shape{type.rows, type.columns}) {
      row = &one;
      break;
    }
  }
  if (row != nullptr && row->value) {
    openings.names.insert(definition);
  } else if (!type.is_scalar()) {
    openings.formulas.insert(definition);
  } else {
    const std::string id = row == nullptr             ? ""
                           : row->means               ? Openings::coefficients
                           : !row->formula_in.empty() ? row->formula_in
                                                      : "39";
    openings.closed[id.empty() ? "39" : id].insert(definition);
  }
}

void collect(const Term& term, std::set<Term>& seen, Definitions& found) {
  if (!seen.insert(term).second) {
    return;
  }
  if (term.kind() == kernel::Kind::defined && found.insert(term.definition()).second) {
    collect(term.definition().body(), seen, found);
  }
  for (const Term& part : term.parts()) {
    collect(part, seen, found);
  }
}

}  // namespace

Openings openings(const std::vector<Formula>& formulas) {
  std::set<Term> seen;
  Definitions found;
  for (const Formula& formula : formulas) {
    collect(formula, seen, found);
  }
  Openings result;
  for (const Definition& definition : found) {
    add(result, definition);
  }
  return result;
}

}  // namespace stickslip::proofs::methods
