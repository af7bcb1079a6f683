#include "proofs/orbits/with_zero.hpp"

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/tactics.hpp"

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

// The unknowns as entries of one column.
struct Column {
  Variable Y;
  Substitution entries;

  explicit Column(const std::vector<Variable>& unknowns)
      : Y{"Y", real_matrix(static_cast<int>(unknowns.size()), 1)} {
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      entries.emplace(unknowns[i], entry(Y, static_cast<int>(i)));
    }
  }
  [[nodiscard]] Term system(const std::vector<Term>& terms) const {
    return substitute(matrix(Y.type.rows, 1, terms), entries);
  }
};

}  // namespace

Theorem exactly_one_zero(const std::vector<Variable>& unknowns, const std::vector<Term>& terms,
                         const Box& box, const Substitution& at_value) {
  const Column column(unknowns);
  return Theorem::one_zero(column.Y, substitute(column.system(terms), at_value), box);
}

Theorem with_zero(const Theorem& theorem, const std::vector<Variable>& unknowns,
                  const std::vector<Term>& terms, const Box& box, const Substitution& at_value) {
  const Column column(unknowns);
  const auto& [Y, entries] = column;
  const Term system = column.system(terms);  // with the letters of at_value; then at their values
  const Theorem existence = part(exactly_one_zero(unknowns, terms, box, at_value), 0);
  const Theorem found = Theorem::assume(all({inside(Y, box), equal(system, zero(Y.type))}));
  const Theorem of_column =
      settled_by(Theorem::instantiate(theorem, entries), [&](const Formula& one) -> std::optional<Theorem> {
        return !one.variables().contains(Y) ? std::nullopt
               : one.kind() == Kind::equal  ? std::optional(row(one, terms, part(found, 1), entries))
                                            : std::optional(Theorem::consequence({found}, one));
      });
  return Theorem::choose(existence, Y,
                         settled_by(Theorem::instantiate(of_column, at_value), [](const Formula& one) {
                           return one.variables().empty() ? std::optional(certainly(one)) : std::nullopt;
                         }));
}

Theorem of_orbit(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  std::vector<Formula> existences{orbit.conclusion()};
  std::vector<Variable> names;
  while (existences.back().kind() == Kind::exists) {
    names.push_back({existences.back().name(), existences.back().binds()});
    existences.push_back(opened(existences.back(), names.back()));
  }
  Theorem result = more(Theorem::assume(existences.back()));
  for (auto one = names.rbegin(); one != names.rend(); ++one) {
    if (result.conclusion().variables().contains(*one)) {
      result = Theorem::witness(result, kernel::exists(*one, result.conclusion()), *one);
    }
  }
  for (std::size_t i = names.size(); i-- > 0;) {
    result = Theorem::choose(i == 0 ? orbit : Theorem::assume(existences[i]), names[i], result);
  }
  return result;
}

Theorem orbit_with(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  return of_orbit(orbit, [&](const Theorem& body) { return tactics::both({body, more(body)}); });
}

}  // namespace stickslip::proofs::orbits
