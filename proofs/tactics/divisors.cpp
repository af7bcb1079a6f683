// Hypotheses d ≠ 0 less what the domain implies.
#include <algorithm>
#include <map>
#include <optional>

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/signs.hpp"

namespace stickslip::proofs::tactics {
namespace {

using namespace kernel;

bool has_sine(const Term& term) {
  return term.kind() == Kind::cosine || term.kind() == Kind::sine ||
         std::any_of(term.parts().begin(), term.parts().end(), has_sine);
}

// ⊢ d ≠ 0 where d m = 1 by normal form, as for a determinant with cos² + sin².
std::optional<Theorem> is_invertible(const Term& divisor, const Term& multiplier) {
  try {
    const Formula zero = equal(divisor, 0);
    const Theorem absurd =
        Theorem::discharge(Theorem::combination(equal(1, 0), {{Theorem::assume(zero), multiplier}}), zero);
    return Theorem::consequence({absurd, different(Theorem::sign(less(0, 1)))}, negation(zero));
  } catch (const KernelError&) {
    return std::nullopt;
  }
}

// {factors that may vanish ≠ 0} ⊢ d ≠ 0; nothing if that is d itself again.
std::optional<Theorem> divisor_differs(const Term& divisor, const Domain& domain) {
  if (has_sine(divisor)) {  // cos² + sin², or the cosine of a multiple of pi
    for (const int unit : {1, -1}) {
      if (const auto lemma = seems_zero({divisor, -unit}, {}) ? is_invertible(divisor, unit) : std::nullopt) {
        return lemma;
      }
    }
  }
  if (divisor.variables().empty()) {  // 1 - cos(3*pi)
    try {
      return certainly(differ(divisor, 0));
    } catch (const KernelError&) {  // it is zero, or too close to it
    }
  }
  const Letters letters({divisor});
  const auto [top, bottom] = letters.fraction(divisor);
  if (top.is_zero()) {
    return std::nullopt;
  }
  const Factored numerator = factored(top, letters);
  if (numerator.factors.empty()) {
    return is_invertible(divisor, letters.term(bottom) / leading_coefficient(top));
  }
  // d = 0 ⇒ Π factors = 0 ⇒ one of them is.
  Term product = letters.term(numerator.factors[0]);
  std::vector<Theorem> premises{factor_differs(numerator.factors[0], letters, domain)};
  if (premises[0].conclusion() == differ(divisor, 0)) {
    return premises[0].hypotheses().contains(premises[0].conclusion()) ? std::nullopt
                                                                       : std::optional(premises[0]);
  }
  for (std::size_t i = 0; i < numerator.factors.size(); ++i) {
    const Term factor = letters.term(numerator.factors[i]);
    if (i > 0) {
      premises.push_back(factor_differs(numerator.factors[i], letters, domain));
    }
    for (int k = i == 0 ? 1 : 0; k < numerator.exponents[i]; ++k) {
      premises.push_back(zero_product(product, factor));
      product = product * factor;
    }
  }
  const Rational ratio = leading_coefficient(numerator.product) / leading_coefficient(top);
  const Formula zero = equal(divisor, 0);
  const Theorem product_zero =
      Theorem::combination(equal(product, 0), {{Theorem::assume(zero), ratio * letters.term(bottom)}});
  premises.push_back(Theorem::discharge(product_zero, zero));
  return Theorem::consequence(premises, differ(divisor, 0));
}

// Whether it may say something of d: bounds by numbers of what stands in it, or a ≠ 0 of an a that has a
// variable in common with it.
bool is_of_use(const Theorem& known, const Term& d) {
  const Formula& said = known.conclusion();
  const auto in_d = [&](const Variable& x) { return d.variables().contains(x); };
  if (is_divisor(said)) {
    return said.variables().empty() || std::any_of(said.variables().begin(), said.variables().end(), in_d);
  }
  return said.kind() == Kind::less &&
         std::any_of(said.parts().begin(), said.parts().end(),
                     [](const Term& end) { return end.kind() == Kind::number; }) &&
         std::all_of(said.variables().begin(), said.variables().end(), in_d);
}

// Theorems as what they say, under which hypotheses.
struct BySequents {
  using Question = std::pair<Term, Domain>;
  bool operator()(const Question& a, const Question& b) const {
    const auto before = [](const Theorem& x, const Theorem& y) {
      const auto order = x.conclusion() <=> y.conclusion();
      return order != 0 ? order < 0 : x.hypotheses() < y.hypotheses();
    };
    return a.first == b.first ? std::lexicographical_compare(a.second.begin(), a.second.end(),
                                                             b.second.begin(), b.second.end(), before)
                              : a.first < b.first;
  }
};

// divisor_differs, remembered: claims ask for the same divisors under the same bounds.
const std::optional<Theorem>& known_to_differ(const Term& divisor, const Domain& domain) {
  static thread_local std::map<BySequents::Question, std::optional<Theorem>, BySequents> known;
  BySequents::Question question{divisor, {}};
  std::copy_if(domain.begin(), domain.end(), std::back_inserter(question.second),
               [&](const Theorem& one) { return is_of_use(one, divisor); });
  const auto found = known.find(question);
  if (found != known.end()) {
    return found->second;
  }
  const auto lemma = divisor_differs(divisor, question.second);
  return known.emplace(std::move(question), lemma).first->second;
}

// The divisors' lemmas, each with what it rests on discharged as far as it goes.
class Lemmas {
 public:
  Lemmas(const Domain& domain, const kernel::Formulas& kept) : domain_(domain), kept_(kept) {
    std::copy_if(domain.begin(), domain.end(), std::back_inserter(bounds_),
                 [](const Theorem& one) { return one.conclusion().kind() == Kind::less; });
  }

  const std::optional<Theorem>& operator()(const Formula& divisor) {
    if (const auto known = lemmas_.find(divisor); known != lemmas_.end()) {
      return known->second;
    }
    under_way_.insert(divisor);
    const Term& d = divisor.parts()[0].parts()[0];
    std::optional<Theorem> lemma = known_to_differ(d, domain_);
    const auto turns_in_circle = [&](const Formula& one) { return under_way_.contains(one); };
    if (lemma && std::any_of(lemma->hypotheses().begin(), lemma->hypotheses().end(), turns_in_circle)) {
      lemma = known_to_differ(d, bounds_);
    }
    if (lemma) {
      const Formulas hypotheses = lemma->hypotheses();
      for (const Formula& one : hypotheses) {
        if (is_divisor(one) && !turns_in_circle(one) && !kept_.contains(one)) {
          if (const std::optional<Theorem>& inner = (*this)(one)) {
            lemma = Theorem::cut(*inner, *lemma);
          }
        }
      }
    }
    under_way_.erase(divisor);
    return lemmas_.emplace(divisor, lemma).first->second;
  }

 private:
  const Domain& domain_;
  const kernel::Formulas& kept_;
  Domain bounds_;
  std::map<Formula, std::optional<Theorem>> lemmas_;
  Formulas under_way_;
};

// ⊢ f = 0 ⇒ d = 0 for the irreducible factors f of d, as far as they are found.
std::vector<Theorem> zeros_by_factors(const Term& d) {
  const Letters letters({d});
  const auto [top, bottom] = letters.fraction(d);
  std::vector<Theorem> result;
  for (const Polynomial& factor :
       top.is_zero() ? std::vector<Polynomial>{} : factored(top, letters, 64).factors) {
    const Formula zero = equal(letters.term(factor), 0);
    const Term multiplier = letters.term(stickslip::quotient(top, factor)) / letters.term(bottom);
    try {
      const Theorem zero_too = Theorem::combination(equal(d, 0), {{Theorem::assume(zero), multiplier}});
      result.push_back(Theorem::discharge(zero_too, zero));
    } catch (const KernelError&) {
      continue;
    }
  }
  return result;
}

}  // namespace

Theorem nonzero(const Theorem& theorem, const Domain& domain, const kernel::Formulas& kept) {
  Lemmas lemmas(domain, kept);
  Theorem result = theorem;
  for (const Formula& one : Formulas(theorem.hypotheses())) {
    if (const std::optional<Theorem> lemma =
            is_divisor(one) && !kept.contains(one) ? lemmas(one) : std::nullopt) {
      result = Theorem::cut(*lemma, result);
    }
  }
  return result;
}

bool implies_nonzero(const Term& d, const Term& f, Domain domain) {
  const Letters letters({f});
  const Factored factors = factored(letters.fraction(f).above, letters);
  const Theorem known = Theorem::assume(differ(d, 0));
  domain.push_back(known);
  for (const Theorem& factor : factors_differ(known)) {
    domain.push_back(factor);
  }
  return std::ranges::all_of(factors.factors, [&](const Polynomial& factor) {
    const Formula wanted = differ(letters.term(factor), 0);
    return wanted == known.conclusion() ||
           !nonzero(Theorem::assume(wanted), domain, {known.conclusion()}).hypotheses().contains(wanted);
  });
}

std::vector<Theorem> factors_differ(const Theorem& differs) {
  static thread_local std::map<Term, std::vector<Theorem>> known;
  const Term d = differs.conclusion().parts().at(0).parts().at(0);
  auto zeros = known.find(d);
  if (zeros == known.end()) {
    zeros = known.emplace(d, zeros_by_factors(d)).first;
  }
  std::vector<Theorem> result;
  for (const Theorem& zero : zeros->second) {
    result.push_back(Theorem::consequence({zero, differs}, negation(zero.conclusion().parts().at(0))));
  }
  return result;
}

}  // namespace stickslip::proofs::tactics
