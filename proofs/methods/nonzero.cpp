#include <ginac/ginac.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "proofs/methods/tactics.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::proofs::methods {
namespace {

using namespace kernel;
using GiNaC::ex;

// Terms as rational functions of what is not rational in them, and back. Floats and names play no role; what
// GiNaC does is a proposal.
class Letters {
 public:
  ex expression(const Term& term) {
    const std::vector<Term>& parts = term.parts();
    switch (term.kind()) {
      case Kind::number:
        return symbolic::algebra::to_ex(term.value());
      case Kind::sum: {
        ex total = 0;
        for (const Term& one : parts) {
          total += expression(one);
        }
        return total;
      }
      case Kind::product:
        return expression(parts[0]) * expression(parts[1]);
      case Kind::power:
        return pow(expression(parts[0]), symbolic::algebra::to_ex(term.value()));
      case Kind::inverse:
        return 1 / expression(parts[0]);
      case Kind::entry:
        if (parts[0].kind() == Kind::matrix) {
          return expression(
              parts[0]
                  .parts()[static_cast<std::size_t>(term.row() * parts[0].type().columns + term.column())]);
        }
        return letter(term);
      default:
        return letter(term);
    }
  }

  struct Monomial {
    std::vector<int> degrees;  // of the letters
    Rational coefficient;
  };

  // Sorted, the highest first.
  [[nodiscard]] std::vector<Monomial> monomials(const ex& polynomial) const {
    const ex expanded = polynomial.expand();
    std::vector<Monomial> result;
    const auto add = [&](const ex& term) {
      Monomial monomial{{}, 0};
      ex rest = term;
      for (const GiNaC::symbol& symbol : symbols_) {
        monomial.degrees.push_back(rest.degree(symbol));
        rest = rest.lcoeff(symbol);
      }
      monomial.coefficient = symbolic::algebra::to_rational(GiNaC::ex_to<GiNaC::numeric>(rest));
      result.push_back(monomial);
    };
    if (GiNaC::is_a<GiNaC::add>(expanded)) {
      std::for_each(expanded.begin(), expanded.end(), add);
    } else if (!expanded.is_zero()) {
      add(expanded);
    }
    std::sort(result.begin(), result.end(),
              [](const Monomial& a, const Monomial& b) { return a.degrees > b.degrees; });
    return result;
  }

  [[nodiscard]] Term term(const ex& polynomial) const {
    std::vector<Term> parts;
    for (const Monomial& monomial : monomials(polynomial)) {
      std::optional<Term> product;
      if (abs(monomial.coefficient) != 1) {
        product = Term(monomial.coefficient);
      }
      for (std::size_t i = 0; i < terms_.size(); ++i) {
        if (monomial.degrees[i] > 0) {
          const Term factor = monomial.degrees[i] == 1 ? terms_[i] : power(terms_[i], monomial.degrees[i]);
          product = product ? *product * factor : factor;
        }
      }
      const bool negative = monomial.coefficient == -1;
      parts.push_back(!product ? Term(monomial.coefficient) : negative ? -*product : *product);
    }
    return parts.empty() ? Term(0) : parts.size() == 1 ? parts[0] : sum(parts);
  }

  // Puts the letters into an order that does not depend on where they stood.
  void sort() {
    std::vector<std::size_t> order(terms_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return to_string(terms_[a]) < to_string(terms_[b]); });
    std::vector<Term> terms;
    std::vector<GiNaC::symbol> symbols;
    for (const std::size_t i : order) {
      terms.push_back(terms_[i]);
      symbols.push_back(symbols_[i]);
    }
    terms_ = terms;
    symbols_ = symbols;
  }

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  [[nodiscard]] const std::vector<GiNaC::symbol>& symbols() const { return symbols_; }

 private:
  ex letter(const Term& term) {
    const auto known = std::find(terms_.begin(), terms_.end(), term);
    const auto index = static_cast<std::size_t>(known - terms_.begin());
    if (known == terms_.end()) {
      terms_.push_back(term);
      symbols_.emplace_back();
    }
    return symbols_[index];
  }

  std::vector<Term> terms_;
  std::vector<GiNaC::symbol> symbols_;
};

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
std::optional<Theorem> signed_by_bounds(const ex& factor, const Letters& letters, const Domain& domain) {
  std::vector<Bounds> bounds;
  std::vector<int> degrees;
  GiNaC::exmap moved;
  for (std::size_t i = 0; i < letters.terms().size(); ++i) {
    const GiNaC::symbol& x = letters.symbols()[i];
    bounds.push_back(bounds_of(letters.terms()[i], domain));
    degrees.push_back(factor.degree(x));
    if (degrees[i] == 0) {
      continue;
    }
    const Bounds& ends = bounds[i];
    if (!ends.lower && !ends.upper) {
      return std::nullopt;
    }
    const ex from = ends.lower ? symbolic::algebra::to_ex(ends.from()) : ex(0);
    const ex to = ends.upper ? symbolic::algebra::to_ex(ends.to()) : ex(0);
    moved[x] = ends.lower && ends.upper ? (from + to * x) / (1 + x) : ends.lower ? from + x : to - x;
  }
  const ex expansion = factor.subs(moved, GiNaC::subs_options::no_pattern).numer();
  std::vector<Positive> positives;
  int sign = 0;
  for (const Letters::Monomial& monomial : letters.monomials(expansion)) {
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
          positive.factor /= ends.to() - ends.from();
        }
      }
    }
    positives.push_back(positive);
  }
  const Term term = letters.term(factor);
  try {  // numer() may have dropped a factor: then the rule says so
    return Theorem::order(sign > 0 ? less(0, term) : less(term, 0), positives);
  } catch (const KernelError&) {
    return std::nullopt;
  }
}

Theorem factor_differs(const ex& factor, const Letters& letters, const Domain& domain) {
  const Formula wanted = differ(letters.term(factor), 0);
  for (const Theorem& known : domain) {
    if (known.conclusion() == wanted) {
      return known;
    }
  }
  const std::optional<Theorem> sign = signed_by_bounds(factor, letters, domain);
  return sign ? different(*sign) : Theorem::assume(wanted);
}

struct Factored {
  std::vector<ex> factors;  // each once, in an order and a sign of its own
  ex product = 1;           // of all with their exponents, as monomials
  std::vector<int> exponents;
};

Factored factored(const ex& numerator, const Letters& letters) {
  const ex whole = GiNaC::factor(numerator);
  std::vector<std::pair<ex, int>> found;
  for (const ex& part : GiNaC::is_a<GiNaC::mul>(whole) ? whole : ex(GiNaC::lst{whole})) {
    const bool is_power = GiNaC::is_a<GiNaC::power>(part);
    const ex base = is_power ? part.op(0) : part;
    if (!GiNaC::is_a<GiNaC::numeric>(base)) {
      const bool negative = letters.monomials(base).front().coefficient < 0;
      found.emplace_back(negative ? ex(-base).expand() : base.expand(),
                         is_power ? GiNaC::ex_to<GiNaC::numeric>(part.op(1)).to_int() : 1);
    }
  }
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return to_string(letters.term(a.first)) < to_string(letters.term(b.first));
  });
  Factored result;
  for (const auto& [base, exponent] : found) {
    result.factors.push_back(base);
    result.exponents.push_back(exponent);
    result.product *= pow(base, exponent);
  }
  return result;
}

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
  if (has_sine(divisor)) {
    if (const auto one = is_invertible(divisor, 1)) {
      return one;
    }
  }
  Letters letters;
  const ex parts = letters.expression(divisor).normal().numer_denom();
  letters.sort();
  if (parts.op(0).is_zero()) {
    return std::nullopt;
  }
  const Factored numerator = factored(parts.op(0), letters);
  if (numerator.factors.empty()) {
    return is_invertible(divisor, letters.term((parts.op(1) / parts.op(0)).expand()));
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
      premises.push_back(Theorem::zero_product(product, factor));
      product = product * factor;
    }
  }
  const ex ratio = (numerator.product / parts.op(0)).normal() * parts.op(1);
  const Formula zero = equal(divisor, 0);
  const Theorem product_zero =
      Theorem::combination(equal(product, 0), {{Theorem::assume(zero), letters.term(ratio)}});
  premises.push_back(Theorem::discharge(product_zero, zero));
  return Theorem::consequence(premises, differ(divisor, 0));
}

bool is_divisor(const Formula& hypothesis) {
  return hypothesis.kind() == Kind::negation && hypothesis.parts()[0].kind() == Kind::equal &&
         hypothesis.parts()[0].parts()[0].type().is_scalar() && hypothesis.parts()[0].parts()[1] == Term(0);
}

}  // namespace

Theorem nonzero(const Theorem& theorem, const Domain& domain) {
  Theorem result = theorem;
  std::map<Formula, std::optional<Theorem>> lemmas;  // a lemma may bring in again what was discharged before
  for (int cuts = 0; cuts < 1000; ++cuts) {
    const Formulas& hypotheses = result.hypotheses();
    const auto next = std::find_if(hypotheses.begin(), hypotheses.end(), [&](const Formula& one) {
      if (!is_divisor(one)) {
        return false;
      }
      const auto known = lemmas.find(one);
      return (known != lemmas.end()
                  ? known
                  : lemmas.emplace(one, divisor_differs(one.parts()[0].parts()[0], domain)).first)
          ->second.has_value();
    });
    if (next == hypotheses.end()) {
      break;
    }
    result = Theorem::cut(*lemmas.at(*next), result);
  }
  return result;
}

}  // namespace stickslip::proofs::methods
