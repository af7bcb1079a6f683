#include "proofs/kernel/normal_form.hpp"

#include <algorithm>

#include "proofs/kernel/entrywise.hpp"
#include "proofs/kernel/quotient.hpp"

namespace stickslip::proofs::kernel {
namespace {

constexpr long largest_multiple = 1000;

bool same_value(const Term& a, const Term& b) {
  if (a == b) {
    return true;
  }
  try {
    return a.type().is_numeric() && a.type() == b.type() && vanishes(a - b);
  } catch (const KernelError&) {
    return false;  // then they are two atoms
  }
}

bool same_atom(const Term& a, const Term& b) {
  if (a == b || a.kind() != b.kind() || a.kind() == Kind::variable) {
    return a == b;
  }
  if (a.kind() == Kind::apply) {
    return a.parts()[0] == b.parts()[0] && same_value(a.parts()[1], b.parts()[1]);
  }
  return a.definition() == b.definition() &&
         std::equal(a.parts().begin(), a.parts().end(), b.parts().begin(), same_value);
}

// cos, sin or exp of whole multiples of one phase, angle = monomial/denominator times the unit.
struct Phase {
  Quotient angle;
  Rational unit;
};
using Phases = std::vector<Phase>;

// The argument of a cos, sin or exp: quarter turns, and for each phase its rational coefficient.
struct Angle {
  Integer quarters = 0;
  std::vector<std::pair<std::size_t, Rational>> phases;
};
using Angles = std::map<Term, Angle, Before>;

// The atoms of a term, all cos and sin of it as circles, and all exp as powers of generators.
class Atoms {
 public:
  explicit Atoms(const Term& term) {
    scan(term);
    std::size_t count = 1;  // π
    for (const Term& atom : atoms_) {
      offsets_.push_back(count);
      count += static_cast<std::size_t>(atom.type().rows * atom.type().columns);
    }
    base_ = std::make_unique<Ring>(count, 0);
    Angles angles, exponents;  // none is known yet: the base ring has no circles
    Entrywise<Polynomials> entries({*this, *base_});
    for (const Term& argument : arguments_) {
      angles.emplace(argument, angle(entries(argument)[0], true, phases_));
    }
    for (const Term& argument : of_exponentials_) {
      exponents.emplace(argument, angle(entries(argument)[0], false, growths_));
    }
    angles_ = std::move(angles);
    exponents_ = std::move(exponents);
    first_growth_ = count;
    whole_ = std::make_unique<Ring>(count + growths_.size(), phases_.size());
  }

  // Row by row, over denominators that are products of divisors. They live as long as this object.
  [[nodiscard]] std::vector<Quotient> entries(const Term& term) const {
    return Entrywise<Polynomials>({*this, *whole_})(term);
  }

  // Whether it is never zero: a rational number times powers, of any sign, of π and of exponentials.
  [[nodiscard]] bool is_never_zero(const Term& term) const {
    const Quotient value = entries(term)[0];
    return !value.is_zero() && value.is_made_of([&](std::size_t k) { return k == 0 || k >= first_growth_; });
  }

 private:
  // cos and sin of one angle.
  struct Pair {
    Quotient c, s;
  };

  // Terms in one of the two rings, as Entrywise wants it.
  struct Polynomials {
    using Number = Quotient;
    const Atoms& atoms;
    const Ring& ring;

    [[nodiscard]] Quotient number(const Rational& value) const { return ring.number(value); }
    [[nodiscard]] Quotient pi() const { return ring.generator(0); }
    [[nodiscard]] static Quotient reciprocal(const Quotient& value) { return value.inverted(); }
    [[nodiscard]] Quotient cosine(const Term& argument, auto&) const {
      return atoms.circle(argument, ring).c;
    }
    [[nodiscard]] Quotient sine(const Term& argument, auto&) const { return atoms.circle(argument, ring).s; }
    [[nodiscard]] Quotient exponential(const Term& argument, auto&) const {
      return atoms.growth(argument, ring);
    }
    [[nodiscard]] std::vector<Quotient> atom(const Term& term, auto&) const {
      std::vector<Quotient> result;
      for (int k = 0; k < term.type().rows * term.type().columns; ++k) {
        result.push_back(
            ring.generator(atoms.offsets_[atoms.atom_of_.at(term)] + static_cast<std::size_t>(k)));
      }
      return result;
    }
  };

  void scan(const Term& term) {
    if (!seen_.insert(term).second) {
      return;
    }
    require(term.type().is_numeric() && term.kind() != Kind::bound,
            "a normal form is of numbers and matrices");
    if (term.kind() == Kind::variable || term.kind() == Kind::apply || term.kind() == Kind::defined) {
      const auto known =
          std::find_if(atoms_.begin(), atoms_.end(), [&](const Term& atom) { return same_atom(atom, term); });
      atom_of_.emplace(term, known - atoms_.begin());
      if (known == atoms_.end()) {
        atoms_.push_back(term);
      }
      return;
    }
    for (const Term& part : term.parts()) {
      scan(part);
    }
    if (term.kind() == Kind::cosine || term.kind() == Kind::sine) {
      arguments_.insert(term.parts()[0]);
    } else if (term.kind() == Kind::exponential) {
      of_exponentials_.insert(term.parts()[0]);
    }
  }

  [[nodiscard]] Angle angle(const Quotient& argument, bool has_quarters, Phases& phases) const {
    Angle result;
    for (const auto& [coefficient, monomial] : terms(argument)) {
      const Rational quarters = coefficient * 2;
      if (has_quarters && equal(monomial, base_->generator(0)) && quarters.get_den() == 1) {
        result.quarters += quarters.get_num();
        continue;
      }
      const auto known =
          std::find_if(phases.begin(), phases.end(),
                       [&, &angle = monomial](const Phase& phase) { return equal(phase.angle, angle); });
      result.phases.emplace_back(known - phases.begin(), coefficient);
      if (known == phases.end()) {
        phases.push_back({monomial, abs(coefficient)});
      } else {
        known->unit /= Rational(coefficient / known->unit).get_den();  // both are whole multiples
      }
    }
    return result;
  }

  [[nodiscard]] static Pair turned(const Pair& a, const Pair& b, const Ring& ring) {
    return {a.c * b.c + ring.number(-1) * (a.s * b.s), a.s * b.c + a.c * b.s};
  }

  [[nodiscard]] Pair circle(const Term& argument, const Ring& ring) const {
    const auto angle = angles_.find(argument);
    require(angle != angles_.end(), "a cos or sin stands within the argument of another, or of an exp");
    Pair result{ring.number(1), ring.number(0)};
    const Integer quarters = ((angle->second.quarters % 4) + 4) % 4;
    for (Integer i = 0; i < quarters; ++i) {
      result = turned(result, {ring.number(0), ring.number(1)}, ring);
    }
    for (const auto& [phase, coefficient] : angle->second.phases) {
      const long multiple = multiple_of(phases_[phase], coefficient);
      const Pair once{ring.cosine(phase), ring.number(multiple < 0 ? -1 : 1) * ring.sine(phase)};
      for (long i = std::abs(multiple); i > 0; --i) {
        result = turned(result, once, ring);
      }
    }
    return result;
  }

  [[nodiscard]] Quotient growth(const Term& argument, const Ring& ring) const {
    const auto exponent = exponents_.find(argument);
    require(exponent != exponents_.end(), "an exp stands within the argument of another, or of a cos or sin");
    Quotient result = ring.number(1);
    for (const auto& [phase, coefficient] : exponent->second.phases) {
      const long multiple = multiple_of(growths_[phase], coefficient);
      const Quotient unit = ring.generator(first_growth_ + phase),
                     once = multiple < 0 ? unit.inverted() : unit;
      for (long i = std::abs(multiple); i > 0; --i) {
        result = result * once;
      }
    }
    return result;
  }

  [[nodiscard]] static long multiple_of(const Phase& phase, const Rational& coefficient) {
    const Rational multiple = coefficient / phase.unit;
    require(multiple.get_den() == 1 && abs(multiple) <= largest_multiple,
            "a phase is taken more than 1000 times");
    return multiple.get_num().get_si();
  }

  Terms seen_;
  Terms arguments_, of_exponentials_;  // of cos and sin, and of exp
  std::vector<Term> atoms_;
  std::map<Term, std::size_t> atom_of_;
  std::vector<std::size_t> offsets_;    // of an atom's first generator
  std::unique_ptr<Ring> base_, whole_;  // without circles, for arguments; and with them
  std::size_t first_growth_ = 0;        // of the whole ring's generators
  Phases phases_, growths_;             // in the base ring
  Angles angles_, exponents_;
};

// Each part is looked at once.
bool has_exponential(const Term& term, Terms& seen) {
  return seen.insert(term).second &&
         (term.kind() == Kind::exponential ||
          std::ranges::any_of(term.parts(), [&](const Term& part) { return has_exponential(part, seen); }));
}

bool is_never_zero(const Term& term) {
  if (Terms seen; !term.variables().empty() && !has_exponential(term, seen)) {
    return false;
  }
  try {
    return Atoms(term).is_never_zero(term);
  } catch (const KernelError&) {
    return false;  // then it is listed
  }
}

void collect(const Term& term, Terms& seen, Formulas& found) {
  if (term.kind() == Kind::lambda || !seen.insert(term).second) {
    return;
  }
  for (const Term& part : term.parts()) {
    collect(part, seen, found);
  }
  if (term.kind() == Kind::inverse) {
    const Term& inverted = term.parts()[0];
    const Term divisor = inverted.type().is_scalar() ? inverted : determinant(inverted);
    if (!is_never_zero(divisor)) {
      found.insert(differ(divisor, 0));
    }
  }
}

}  // namespace

bool vanishes(const Term& term) {
  const Atoms atoms(term);
  const std::vector<Quotient> entries = atoms.entries(term);
  return std::all_of(entries.begin(), entries.end(), [](const Quotient& q) { return q.is_zero(); });
}

Formulas divisors(const Term& term) {
  Terms seen;
  Formulas found;
  collect(term, seen, found);
  return found;
}

}  // namespace stickslip::proofs::kernel
