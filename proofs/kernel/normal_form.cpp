#include "proofs/kernel/normal_form.hpp"

#include <algorithm>

#include "proofs/kernel/quotient.hpp"

namespace stickslip::proofs::kernel {
namespace {

constexpr long largest_multiple = 1000;

bool same_value(const Term& a, const Term& b) {
  if (a == b) {
    return true;
  }
  const bool comparable = a.type().is_numeric() && b.type().is_numeric() && a.type().rows == b.type().rows &&
                          a.type().columns == b.type().columns;
  try {
    return comparable && vanishes(a - b);
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

// cos and sin of a multiple of one phase, angle = monomial/denominator times 1/lcm.
struct Phase {
  Quotient angle;
  Integer lcm = 1;
};

// The argument of a cos or sin: quarter turns, and for each phase its rational coefficient.
struct Angle {
  Integer quarters = 0;
  std::vector<std::pair<std::size_t, Rational>> phases;
};

class Converter {
 public:
  explicit Converter(const Term& term) {
    scan(term);
    std::size_t count = 1;  // π
    for (const Term& atom : atoms_) {
      offsets_.push_back(count);
      count += static_cast<std::size_t>(atom.type().rows * atom.type().columns);
    }
    if (!arguments_.empty()) {
      base_ = std::make_unique<Ring>(count, 0);
      ring_ = base_.get();
      std::map<Term, Angle> angles;  // none is known yet: the base ring has no circles
      for (const Term& argument : arguments_) {
        angles.emplace(argument, angle(entries(argument)[0]));
      }
      angles_ = std::move(angles);
      known_.clear();
    }
    whole_ = std::make_unique<Ring>(count, phases_.size());
    ring_ = whole_.get();
  }

  // Row by row, over denominators that are products of divisors.
  Entries entries(const Term& term) {
    const auto found = known_.find(term);
    return found != known_.end() ? found->second : known_.emplace(term, computed(term)).first->second;
  }

 private:
  void scan(const Term& term) {
    if (!seen_.insert(term).second) {
      return;
    }
    if (!term.type().is_numeric() || term.kind() == Kind::bound) {
      throw KernelError("a normal form is of numbers and matrices");
    }
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
    }
  }

  Angle angle(const Quotient& argument) {
    Angle result;
    for (const auto& [coefficient, monomial] : terms(argument)) {
      const Rational quarters = coefficient * 2;
      if (equal(monomial, ring_->generator(0)) && quarters.get_den() == 1) {
        result.quarters += quarters.get_num();
        continue;
      }
      const auto known = std::find_if(phases_.begin(), phases_.end(),
                                      [&](const Phase& phase) { return equal(phase.angle, monomial); });
      result.phases.emplace_back(known - phases_.begin(), coefficient);
      if (known == phases_.end()) {
        phases_.push_back({monomial, coefficient.get_den()});
      } else {
        mpz_lcm(known->lcm.get_mpz_t(), known->lcm.get_mpz_t(), coefficient.get_den_mpz_t());
      }
    }
    return result;
  }

  struct Pair {
    Quotient c, s;
  };

  [[nodiscard]] Pair turned(const Pair& a, const Pair& b) const {
    const Quotient minus = ring_->number(-1);
    return {a.c * b.c + minus * (a.s * b.s), a.s * b.c + a.c * b.s};
  }

  [[nodiscard]] Pair circle(const Angle& angle) const {
    Pair result{ring_->number(1), ring_->number(0)};
    const Integer quarters = ((angle.quarters % 4) + 4) % 4;
    for (Integer i = 0; i < quarters; ++i) {
      result = turned(result, {ring_->number(0), ring_->number(1)});
    }
    for (const auto& [phase, coefficient] : angle.phases) {
      const Rational multiple = coefficient * phases_[phase].lcm;
      if (multiple.get_den() != 1 || abs(multiple) > largest_multiple) {
        throw KernelError("a phase is taken more than 1000 times");
      }
      const Quotient sign = ring_->number(sgn(multiple));
      const Pair once{ring_->cosine(phase), sign * ring_->sine(phase)};
      for (long i = std::abs(multiple.get_num().get_si()); i > 0; --i) {
        result = turned(result, once);
      }
    }
    return result;
  }

  Entries computed(const Term& term) {
    const std::vector<Term>& parts = term.parts();
    switch (term.kind()) {
      case Kind::number:
        return {ring_->number(term.value())};
      case Kind::pi:
        return {ring_->generator(0)};
      case Kind::sum: {
        Entries total = entries(parts[0]);
        for (std::size_t k = 1; k < parts.size(); ++k) {
          const Entries next = entries(parts[k]);
          std::transform(total.begin(), total.end(), next.begin(), total.begin(), std::plus<>());
        }
        return total;
      }
      case Kind::product:
        return product(entries(parts[0]), parts[0].type(), entries(parts[1]), parts[1].type(), *ring_);
      case Kind::power: {
        Entries result{ring_->number(1)};
        for (Integer i = 0; i < term.value().get_num(); ++i) {
          result[0] = result[0] * entries(parts[0])[0];
        }
        return result;
      }
      case Kind::inverse:
        return inverse_of(entries(parts[0]), parts[0].type().rows, *ring_);
      case Kind::cosine:
      case Kind::sine: {
        const auto found = angles_.find(parts[0]);
        if (found == angles_.end()) {
          throw KernelError("a cos or sin stands within the argument of another");
        }
        const Pair pair = circle(found->second);
        return {term.kind() == Kind::cosine ? pair.c : pair.s};
      }
      case Kind::matrix: {
        Entries result;
        for (const Term& part : parts) {
          result.push_back(entries(part)[0]);
        }
        return result;
      }
      case Kind::entry: {
        const auto place = static_cast<std::size_t>(term.row() * parts[0].type().columns + term.column());
        return {entries(parts[0])[place]};
      }
      default: {  // an atom
        Entries result;
        const auto count = static_cast<std::size_t>(term.type().rows * term.type().columns);
        for (std::size_t k = 0; k < count; ++k) {
          result.push_back(ring_->generator(offsets_[atom_of_.at(term)] + k));
        }
        return result;
      }
    }
  }

  std::set<Term> seen_;
  std::set<Term> arguments_;  // of cos and sin
  std::vector<Term> atoms_;
  std::map<Term, std::size_t> atom_of_;
  std::vector<std::size_t> offsets_;  // of an atom's first generator
  std::unique_ptr<Ring> base_, whole_;
  const Ring* ring_ = nullptr;
  std::vector<Phase> phases_;  // in the base ring
  std::map<Term, Angle> angles_;
  std::map<Term, Entries> known_;
};

bool is_nonzero_constant(const Term& term) {
  if (!term.variables().empty()) {
    return false;
  }
  try {
    return Converter(term).entries(term)[0].is_multiple_of_power(0);
  } catch (const KernelError&) {
    return false;  // then it is listed
  }
}

void collect(const Term& term, std::set<Term>& seen, std::set<Formula>& found) {
  if (term.kind() == Kind::lambda || !seen.insert(term).second) {
    return;
  }
  for (const Term& part : term.parts()) {
    collect(part, seen, found);
  }
  if (term.kind() == Kind::inverse) {
    const Term& inverted = term.parts()[0];
    const Term divisor = inverted.type().is_scalar() ? inverted : determinant(inverted);
    if (!is_nonzero_constant(divisor)) {
      found.insert(differ(divisor, 0));
    }
  }
}

}  // namespace

bool vanishes(const Term& term) {
  Converter converter(term);
  const Entries entries = converter.entries(term);
  return std::all_of(entries.begin(), entries.end(), [](const Quotient& q) { return q.is_zero(); });
}

std::set<Formula> divisors(const Term& term) {
  std::set<Term> seen;
  std::set<Formula> found;
  collect(term, seen, found);
  return found;
}

}  // namespace stickslip::proofs::kernel
