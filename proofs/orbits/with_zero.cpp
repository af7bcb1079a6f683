#include "proofs/orbits/with_zero.hpp"

#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// The equation in the entries of the unknown column, from the whole system.
Theorem row(const Formula& equation, const std::vector<Term>& terms, const Theorem& vanishes,
            const Substitution& entries) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (equation == equal(substitute(terms[i], entries), 0)) {
      std::vector<Term> unit(terms.size(), 0);
      unit[i] = 1;
      return Theorem::combination(equation, {{vanishes, matrix(1, static_cast<int>(unit.size()), unit)}});
    }
  }
  throw KernelError("this is none of the equations: " + to_string(equation));
}

}  // namespace

Theorem with_zero(const Theorem& theorem, const std::vector<Variable>& unknowns,
                  const std::vector<Term>& terms, const Box& box, const Substitution& at_value) {
  const auto n = static_cast<int>(box.size());
  const Variable Y{"Y", real_matrix(n, 1)};
  Substitution entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace(unknowns.at(static_cast<std::size_t>(i)), entry(Y, i));
  }
  // With the letters of at_value; then at their values.
  const Term system = substitute(matrix(n, 1, terms), entries);
  const Theorem existence = part(Theorem::one_zero(Y, substitute(system, at_value), box), 0);
  const Theorem found = Theorem::assume(all({inside(Y, box), equal(system, zero(Y.type))}));
  Theorem result = Theorem::instantiate(theorem, entries);
  const Formulas hypotheses = result.hypotheses();
  for (const Formula& one : hypotheses) {
    if (one.variables().contains(Y)) {
      result = Theorem::cut(one.kind() == Kind::equal ? row(one, terms, part(found, 1), entries)
                                                      : Theorem::consequence({found}, one),
                            result);
    }
  }
  result = Theorem::instantiate(result, at_value);
  const Formulas values = result.hypotheses();
  for (const Formula& one : values) {
    if (one.variables().empty()) {
      result = Theorem::cut(certainly(one), result);
    }
  }
  return Theorem::choose(existence, Y, result);
}

}  // namespace stickslip::proofs::orbits
