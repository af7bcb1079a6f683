#include "proofs/orbits/by_parts.hpp"

#include <fmt/format.h>

#include <optional>

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

constexpr int places = 40;

// A definition applied that stands in no other.
std::optional<Term> definition_in(const Term& term) {
  if (term.kind() == Kind::defined) {
    return term;
  }
  for (const Term& part : term.parts()) {
    if (const auto found = definition_in(part)) {
      return found;
    }
  }
  return std::nullopt;
}

class Parts {
 public:
  explicit Parts(const Ranges& ranges) : ranges_(ranges) {}

  Theorem sign(const Formula& relation) {
    Definitions opened;
    const Formula here = lettered(relation, opened);
    return Theorem::convert(settled(Theorem::sign(here, ranges_in(here, ranges_), matrix_bits), letters_),
                            relation, opened);
  }

  Known bounds(const Term& number) {
    Definitions opened;
    return bounds_of(number, lettered(number, opened), opened);
  }

 private:
  // With a letter for each number that a definition stands for; those of matrices are looked into.
  Term lettered(Term term, Definitions& opened) {
    while (const auto applied = definition_in(term)) {
      if (applied->type().is_scalar()) {
        term = replaced(term, *applied, letter(*applied));
      } else {
        opened.insert(applied->definition());
        term = unfold(term, {applied->definition()});
      }
    }
    return term;
  }

  Term letter(const Term& lettered_application) {
    const Term applied = substitute(lettered_application, values_);
    if (const auto known = names_.find(applied); known != names_.end()) {
      return known->second;
    }
    Definitions opened{applied.definition()};
    const Term body = lettered(applied.definition().unfolded(applied.parts()), opened);
    const Known known = bounds_of(applied, body, opened);
    const Variable name{fmt::format("part {}", names_.size() + 1)};
    letters_.emplace(name, known);
    ranges_.emplace(name, known.range);
    names_.emplace(applied, name);
    values_.emplace(name, applied);
    return name;
  }

  // Of a number, in letters once these definitions are opened.
  [[nodiscard]] Known bounds_of(const Term& number, const Term& in_letters, const Definitions& opened) const {
    const Known one = bounded(in_letters, ranges_, places);
    const auto said = [&](const Formula& inequality, const Theorem& theorem) {
      return Theorem::convert(settled(theorem, letters_), inequality, opened);
    };
    return {number, one.range, said(at_most(one.range.first, number), one.lower),
            said(at_most(number, one.range.second), one.upper)};
  }

  Ranges ranges_;  // of the variables, and of the letters
  Letters letters_;
  std::map<Term, Variable> names_;
  Substitution values_;  // of the letters
};

}  // namespace

Theorem sign_by_parts(const Formula& relation, const Ranges& ranges) {
  return Parts(ranges).sign(relation);
}

Known bounded_by_parts(const Term& number, const Ranges& ranges) {
  return Parts(ranges).bounds(number);
}

Theorem for_all_in(const Theorem& theorem, const std::vector<Variable>& variables, const Ranges& ranges) {
  Theorem result = theorem;
  for (auto x = variables.rbegin(); x != variables.rend(); ++x) {
    const auto& [lower, upper] = ranges.at(*x);
    const Formula here = within(lower, *x, upper);
    for (std::size_t side : {0, 1}) {
      result = Theorem::cut(part(Theorem::assume(here), side), result);
    }
    result = for_every(*x, here, result);
  }
  return result;
}

}  // namespace stickslip::proofs::orbits
