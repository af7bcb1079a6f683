// What the domain says of a polynomial: its sign, and which divisors that leaves.
#include <algorithm>
#include <map>
#include <optional>

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

namespace {

using namespace kernel;

// f ≠ 0: because the domain gives f a sign, or says so, or says it of a sine or cosine that vanishes with f;
// else {f ≠ 0} ⊢ f ≠ 0.
Theorem factor_differs(const Polynomial& factor, const Letters& letters, const Domain& domain);

struct Bounds {
  std::optional<Theorem> lower, upper;  // l < x, x < u
  [[nodiscard]] Rational from() const { return lower->conclusion().parts()[0].value(); }
  [[nodiscard]] Rational to() const { return upper->conclusion().parts()[1].value(); }
};

Bounds bounds_of(const Term& x, const Domain& domain) {
  Bounds bounds;
  if (x == pi()) {
    bounds.lower = Theorem::sign(less(0, pi()));
    return bounds;
  }
  if (x.kind() == Kind::exponential) {
    bounds.lower = exponential_is_positive(x.parts()[0]);
  }
  for (const Theorem& known : domain) {
    if (known.conclusion().kind() != Kind::less) {
      continue;
    }
    const std::vector<Term>& ends = known.conclusion().parts();
    if (ends[1] == x && ends[0].kind() == Kind::number) {
      bounds.lower = known;
    }
    if (ends[0] == x && ends[1].kind() == Kind::number) {
      bounds.upper = known;
    }
  }
  return bounds;
}

// The sign of a polynomial by its expansion in the distances p from the bounds: x = l + p, x = u - p, or
// between both x = (l + u p)/(1 + p), p = (x - l)/(u - x).
std::optional<Theorem> signed_by_bounds(const Polynomial& factor, const Letters& letters,
                                        const Domain& domain) {
  const PolynomialRing& ring = letters.ring();
  std::vector<Bounds> bounds;
  std::vector<int> degrees;
  std::vector<Polynomial> moved, below;  // x as a quotient of polynomials in p
  for (std::size_t i = 0; i < letters.terms().size(); ++i) {
    bounds.push_back(bounds_of(letters.terms()[i], domain));
    degrees.push_back(degree(factor, i));
    const Bounds& ends = bounds[i];
    if (degrees[i] > 0 && !ends.lower && !ends.upper) {
      return std::nullopt;
    }
    Polynomial above = ring.generator(i), one = ring.constant(1);
    if (degrees[i] > 0) {
      above *= ring.constant(!ends.upper ? Rational(1) : ends.lower ? ends.to() : Rational(-1));
      above += ring.constant(ends.lower ? ends.from() : ends.to());
      if (ends.lower && ends.upper) {
        one += ring.generator(i);
      }
    }
    moved.push_back(above);
    below.push_back(one);
  }
  Polynomial expansion(ring);
  for (const Monomial& monomial : monomials(factor)) {
    Polynomial product = ring.constant(monomial.coefficient);
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      for (int k = 0; k < degrees[i]; ++k) {
        product *= k < monomial.degrees[i] ? moved[i] : below[i];
      }
    }
    expansion += product;
  }
  std::vector<Positive> positives;
  int sign = 0;
  for (const Monomial& monomial : monomials(expansion)) {
    const int here = sgn(monomial.coefficient);
    if (sign != 0 && here != sign) {
      return std::nullopt;
    }
    sign = here;
    Positive positive{{}, abs(monomial.coefficient)};
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const Bounds& ends = bounds[i];
      const int near = monomial.degrees[i];
      if (degrees[i] == 0) {
        continue;
      }
      const std::size_t far = ends.lower && ends.upper ? static_cast<std::size_t>(degrees[i] - near) : 0;
      const Theorem& first = ends.lower ? *ends.lower : *ends.upper;
      positive.inequalities.insert(positive.inequalities.end(), static_cast<std::size_t>(near), first);
      if (ends.lower && ends.upper) {
        positive.inequalities.insert(positive.inequalities.end(), far, *ends.upper);
        for (int k = 0; k < degrees[i]; ++k) {
          positive.factor = positive.factor.value() / (ends.to() - ends.from());
        }
      }
    }
    positives.push_back(positive);
  }
  const Term term = letters.term(factor);
  return attempt([&] { return Theorem::order(sign > 0 ? less(0, term) : less(term, 0), positives); });
}

// a = b·f by normal form, where that is so nearly enough to be tried.
std::optional<Theorem> vanishes_as_multiple(const Term& a, const Term& b, const Theorem& f_is_zero) {
  const Term f = f_is_zero.conclusion().parts()[0];
  if (!seems_zero({a, -(b * f)}, {})) {
    return std::nullopt;
  }
  return Theorem::combination(equal(a, 0), {{f_is_zero, b}});
}

// a = 0 at the zero of f that is linear in a variable.
std::optional<Theorem> vanishes_at_root(const Term& a, const Variable& x, const Theorem& f_is_zero) {
  const Term& f = f_is_zero.conclusion().parts()[0];
  const Letters letters({f, x});
  const auto place =
      static_cast<std::size_t>(std::ranges::find(letters.terms(), Term(x)) - letters.terms().begin());
  const auto [above, below] = letters.fraction(f);
  const Polynomial slope = coefficient(above, place, 1);
  if (degree(above, place) != 1 || !is_constant(slope) || !is_constant(below)) {
    return std::nullopt;
  }
  Polynomial rest = coefficient(above, place, 0);
  rest *= letters.ring().constant(-1 / leading_coefficient(slope));
  const Term root = letters.term(rest);
  if (root.variables().contains(x)) {
    return std::nullopt;
  }
  const Term there = substitute(a, {{x, root}});
  if (!seems_zero({there}, {})) {
    return std::nullopt;
  }
  const Theorem is_root = Theorem::combination(
      equal(x, root), {{f_is_zero, Term(Rational(leading_coefficient(below) / leading_coefficient(slope)))}});
  const Variable at = fresh(x.type, {a, root});
  return Theorem::replace(symmetric(is_root), at, equal(substitute(a, {{x, at}}), 0),
                          Theorem::combination(equal(there, 0)));
}

// ⊢ 0 < s for factors s whose product is f^k up to sign.
std::vector<Theorem> positive_factors(const Polynomial& factor, int exponent, const Letters& letters,
                                      const Domain& domain) {
  const Term f = letters.term(factor);
  if (const auto sign = signed_by_bounds(factor, letters, domain)) {
    const Theorem one =
        sign->conclusion().parts()[0] == Term(0) ? *sign : Theorem::order(less(0, -f), {Positive{{*sign}}});
    return std::vector<Theorem>(static_cast<std::size_t>(exponent), one);
  }
  if (exponent % 2 != 0) {
    throw KernelError("no sign is known of " + to_string(f));
  }
  const auto square_if = [&](const Formula& sign) {
    return Theorem::discharge(
        Theorem::order(less(0, f * f), {Positive{{Theorem::assume(sign), Theorem::assume(sign)}}}), sign);
  };
  const Theorem square =
      Theorem::consequence({square_if(less(0, f)), square_if(less(f, 0)), Theorem::trichotomy(f, 0),
                            factor_differs(factor, letters, domain)},
                           less(0, f * f));
  return std::vector<Theorem>(static_cast<std::size_t>(exponent / 2), square);
}

Theorem factor_differs(const Polynomial& factor, const Letters& letters, const Domain& domain) {
  if (const std::optional<Theorem> sign = signed_by_bounds(factor, letters, domain)) {
    return different(*sign);
  }
  const Term f = letters.term(factor);
  const Formula wanted = differ(f, 0);
  for (const Theorem& known : domain) {
    if (known.conclusion() == wanted && !known.hypotheses().contains(wanted)) {
      return known;
    }
  }
  for (const Theorem& known : domain) {
    const bool of_use = is_divisor(known.conclusion()) && !known.hypotheses().contains(wanted);
    if (const auto theorem = of_use ? differs_too(f, known) : std::nullopt) {
      return *theorem;
    }
  }
  return Theorem::assume(wanted);
}

}  // namespace

bool is_divisor(const Formula& hypothesis) {
  return hypothesis.kind() == Kind::negation && hypothesis.parts()[0].kind() == Kind::equal &&
         hypothesis.parts()[0].parts()[0].type().is_scalar() && hypothesis.parts()[0].parts()[1] == Term(0);
}

std::optional<Theorem> differs_too(const Term& f, const Theorem& known) {
  const Term a = known.conclusion().parts().at(0).parts().at(0);
  if (a.kind() != Kind::cosine && a.kind() != Kind::sine) {
    return std::nullopt;
  }
  const Formula zero = equal(f, 0);
  const Theorem f_is_zero = Theorem::assume(zero);
  const auto follows = [&](const std::optional<Theorem>& a_is_zero) {
    return Theorem::consequence({Theorem::discharge(*a_is_zero, zero), known}, negation(zero));
  };
  try {
    if (f.kind() == Kind::cosine || f.kind() == Kind::sine) {
      const Term u = f.parts()[0], other = f.kind() == Kind::cosine ? sin(u) : cos(u);
      for (const Term& factor : {Term(1), Term(-1), 2 * other}) {
        if (const auto multiple = vanishes_as_multiple(a, factor, f_is_zero)) {
          return follows(multiple);
        }
      }
    }
    for (const Variable& x : f.variables()) {
      const auto at_root = x.type == real_number ? vanishes_at_root(a, x, f_is_zero) : std::nullopt;
      if (at_root) {
        return follows(at_root);
      }
    }
  } catch (const KernelError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

Theorem inverse_is_positive(const Theorem& positive) {
  const Term s = positive.conclusion().parts().at(1), x = inverse(s);
  const Formula wrong = at_most(x, 0);
  const Theorem absurd = Theorem::cut(
      different(positive), Theorem::order(at_most(1, 0), {Positive{{positive, Theorem::assume(wrong)}}}));
  return Theorem::consequence({Theorem::discharge(absurd, wrong), Theorem::trichotomy(x, 0),
                               Theorem::sign(less(0, 1)), Theorem::trichotomy(1, 0)},
                              less(0, x));
}

Theorem exponential_is_positive(const Term& x) {
  static thread_local const Theorem lemma = [] {  // a square, and not 0: times exp(-v) it is 1
    const Variable v{"v"};
    const Formula zero = equal(exp(v), 0);
    const Theorem square = Theorem::order(at_most(0, exp(v)), {Positive{{}, 1, exp(v / 2)}});
    const Theorem absurd = Theorem::combination(equal(1, 0), {{Theorem::assume(zero), exp(-v)}});
    const Theorem different_from_0 = Theorem::consequence(
        {Theorem::discharge(absurd, zero), different(Theorem::sign(less(0, 1)))}, negation(zero));
    return Theorem::consequence({square, different_from_0, Theorem::trichotomy(exp(v), 0)}, less(0, exp(v)));
  }();
  return Theorem::instantiate(lemma, {{Variable{"v"}, x}});
}

Theorem positive(const Term& a, const Domain& domain) {
  const Letters letters({a});
  const auto [top, bottom] = letters.fraction(a);
  if (top.is_zero()) {
    throw KernelError("0 is not positive");
  }
  Positive product{{}};
  Polynomial built_top = top, built_bottom = bottom;  // a over what is built
  for (const int place : {0, 1}) {
    const Factored all = factored(place == 0 ? top : bottom, letters);
    for (std::size_t i = 0; i < all.factors.size(); ++i) {
      for (const Theorem& one : positive_factors(all.factors[i], all.exponents[i], letters, domain)) {
        product.inequalities.push_back(place == 0 ? one : inverse_is_positive(one));
        (place == 0 ? built_bottom : built_top) *= letters.fraction(one.conclusion().parts()[1]).above;
      }
    }
  }
  product.factor = leading_coefficient(built_top) / leading_coefficient(built_bottom);
  return nonzero(Theorem::order(less(0, a), {product}), domain);
}

// ---- Hypotheses d ≠ 0 less what the domain implies.

namespace {

bool has_sine(const Term& term) {
  return is_wave(term) || std::any_of(term.parts().begin(), term.parts().end(), has_sine);
}

// ⊢ d ≠ 0 where d m = 1 by normal form, as for a determinant with cos² + sin².
std::optional<Theorem> is_invertible(const Term& divisor, const Term& multiplier) {
  return attempt([&] {
    const Formula zero = equal(divisor, 0);
    const Theorem absurd =
        Theorem::discharge(Theorem::combination(equal(1, 0), {{Theorem::assume(zero), multiplier}}), zero);
    return Theorem::consequence({absurd, different(Theorem::sign(less(0, 1)))}, negation(zero));
  });
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
    if (const auto lemma = attempt([&] { return certainly(differ(divisor, 0)); })) {
      return lemma;
    }  // it is zero, or too close to it
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
    if (const auto zero_too = attempt([&] {
          return Theorem::combination(equal(d, 0), {{Theorem::assume(zero), multiplier}});
        })) {
      result.push_back(Theorem::discharge(*zero_too, zero));
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
