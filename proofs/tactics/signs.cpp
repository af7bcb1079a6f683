#include <algorithm>
#include <optional>

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/signs.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

namespace {

using namespace kernel;

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
  try {
    return Theorem::order(sign > 0 ? less(0, term) : less(term, 0), positives);
  } catch (const KernelError&) {
    return std::nullopt;
  }
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

}  // namespace

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

}  // namespace stickslip::proofs::tactics
