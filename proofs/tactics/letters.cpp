#include "proofs/tactics/letters.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <set>
#include <utility>

#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;
using kernel::Term;

namespace {

// What a term is rational in; of an entry of a matrix that is written out, that entry.
template <class Visit>
void visit_parts(const Term& term, const Visit& visit) {
  if (term.kind() == Kind::entry) {
    const Term& whole = term.parts()[0];
    visit(whole.parts()[static_cast<std::size_t>(term.row() * whole.type().columns + term.column())]);
  } else {
    std::for_each(term.parts().begin(), term.parts().end(), visit);
  }
}

bool is_letter(const Term& term) {
  switch (term.kind()) {
    case Kind::number:
    case Kind::sum:
    case Kind::product:
    case Kind::power:
    case Kind::inverse:
      return false;
    case Kind::entry:
      return term.parts()[0].kind() != Kind::matrix;
    default:
      return true;
  }
}

// By their text first.
using ByText = std::set<std::pair<std::string, Term>>;

void collect(const Term& term, std::set<Term>& seen, ByText& letters) {
  if (!seen.insert(term).second) {
    return;
  }
  if (is_letter(term)) {
    letters.emplace(to_string(term), term);
  } else {
    visit_parts(term, [&](const Term& part) { collect(part, seen, letters); });
  }
}

}  // namespace

Letters::Letters(const std::vector<Term>& terms) {
  std::set<Term> seen;
  ByText letters;
  for (const Term& term : terms) {
    collect(term, seen, letters);
  }
  for (const auto& [name, letter] : letters) {
    places_.emplace(letter, terms_.size());
    terms_.push_back(letter);
  }
  ring_ = std::make_unique<Ring>(terms_.size(), 0);
}

Quotient Letters::quotient(const Term& term) const {
  const auto part = [&](std::size_t k) { return quotient(term.parts()[k]); };
  if (is_letter(term)) {
    return ring_->generator(places_.at(term));
  }
  switch (term.kind()) {
    case Kind::number:
      return ring_->number(term.value());
    case Kind::product:
      return part(0) * part(1);
    case Kind::inverse:
      return part(0).inverted();
    case Kind::power: {
      Quotient result = ring_->number(1);
      const Quotient base = part(0);
      const mpz_class exponent = term.value().get_num();
      for (std::size_t bit = mpz_sizeinbase(exponent.get_mpz_t(), 2); bit-- > 0;) {
        result = result * result;
        if (mpz_tstbit(exponent.get_mpz_t(), bit) != 0) {
          result = result * base;
        }
      }
      return result;
    }
    default: {
      Quotient sum = ring_->number(0);
      visit_parts(term, [&](const Term& one) { sum = sum + quotient(one); });
      return sum;
    }
  }
}

Fraction Letters::fraction(const Term& term) const {
  const Quotient whole = quotient(term);
  const Polynomial common = ring_->common_divisor(whole.numerator(), whole.denominator());
  Fraction result{stickslip::quotient(whole.numerator(), common),
                  stickslip::quotient(whole.denominator(), common)};
  const int sign = sgn(leading_coefficient(result.below));
  const Rational below = sign * take_content(result.below);
  result.below *= ring().constant(sign);
  if (!result.above.is_zero()) {
    const Rational factor = take_content(result.above) / below;
    result.above *= ring().constant(factor.get_num());
    result.below *= ring().constant(factor.get_den());
  }
  return result;
}

Term Letters::term(const Polynomial& polynomial) const {
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

Factored factored(const Polynomial& polynomial, const Letters& letters, std::size_t longest) {
  const auto length = fmpq_mpoly_length(polynomial.raw(), letters.ring().context());
  std::vector<std::pair<Polynomial, int>> found =
      length > static_cast<slong>(longest) ? std::vector<std::pair<Polynomial, int>>{{polynomial, 1}}
                                           : irreducible_factors(polynomial);
  for (auto& [base, exponent] : found) {
    take_content(base);
    base *= letters.ring().constant(sgn(leading_coefficient(base)));
  }
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return to_string(letters.term(a.first)) < to_string(letters.term(b.first));
  });
  Factored result{{}, {}, letters.ring().constant(1)};
  for (const auto& [base, exponent] : found) {
    result.factors.push_back(base);
    result.exponents.push_back(exponent);
    for (int k = 0; k < exponent; ++k) {
      result.product *= base;
    }
  }
  return result;
}

Term quotient(const Term& a, const Term& b) {
  const Letters letters({a, b});
  const auto [above, below] = letters.fraction(a / b);
  const Term numerator = letters.term(above), denominator = letters.term(below);
  return denominator == Term(1) ? numerator : numerator / denominator;
}

namespace {

constexpr std::size_t most_pairs = 200, longest = 400;

// A polynomial, and the multiples of the given ones whose sum it is.
struct Member {
  Polynomial value;
  std::vector<Polynomial> of;

  void add(const Polynomial& factor, const Member& other) {
    const auto add_to = [&](Polynomial& sum, Polynomial summand) {
      summand *= factor;
      sum += summand;
    };
    add_to(value, other.value);
    for (std::size_t k = 0; k < of.size(); ++k) {
      add_to(of[k], other.of[k]);
    }
  }
};

// The member less multiples of others such that none of their leading terms divides one of its own.
Member reduced(Member member, const std::vector<Member>& others) {
  const PolynomialRing& ring = member.value.ring();
  std::vector<Polynomial> quotients(others.size(), Polynomial(ring));
  std::vector<fmpq_mpoly_struct *> into, by;
  for (std::size_t k = 0; k < others.size(); ++k) {
    into.push_back(quotients[k].raw());
    by.push_back(const_cast<fmpq_mpoly_struct *>(others[k].value.raw()));  // FLINT reads it only
  }
  Polynomial rest(ring);
  fmpq_mpoly_divrem_ideal(into.data(), rest.raw(), member.value.raw(), by.data(),
                          static_cast<slong>(by.size()), ring.context());
  for (std::size_t k = 0; k < others.size(); ++k) {
    quotients[k] *= ring.constant(-1);
    member.add(quotients[k], others[k]);
  }
  return member;
}

// The combination of two in which their leading terms are gone.
Member without_leading_terms(const Member& a, const Member& b) {
  const PolynomialRing& ring = a.value.ring();
  const Monomial lead_a = monomials(a.value).front(), lead_b = monomials(b.value).front();
  Monomial to_a{{}, 1 / lead_a.coefficient}, to_b{{}, -1 / lead_b.coefficient};
  for (std::size_t i = 0; i < lead_a.degrees.size(); ++i) {
    const int both = std::max(lead_a.degrees[i], lead_b.degrees[i]);
    to_a.degrees.push_back(both - lead_a.degrees[i]);
    to_b.degrees.push_back(both - lead_b.degrees[i]);
  }
  Member result{Polynomial(ring), std::vector<Polynomial>(a.of.size(), Polynomial(ring))};
  result.add(polynomial(ring, {to_a}), a);
  result.add(polynomial(ring, {to_b}), b);
  return result;
}

// A combination of the basis that is the goal, or nothing; the basis is made complete (Buchberger) as far as
// the work goes.
std::optional<Member> expressed(const Member& goal, std::vector<Member> basis) {
  std::deque<std::pair<std::size_t, std::size_t>> pairs;
  const auto pair_with_others = [&](std::size_t k) {
    for (std::size_t other = 0; other < k; ++other) {
      pairs.emplace_back(other, k);
    }
  };
  for (std::size_t k = 0; k < basis.size(); ++k) {
    pair_with_others(k);
  }
  for (std::size_t work = 0; work < most_pairs; ++work) {
    const Member rest = reduced(goal, basis);
    if (rest.value.is_zero()) {
      return rest;
    }
    Member more = rest;
    do {
      if (pairs.empty()) {
        return std::nullopt;
      }
      const auto [first, second] = pairs.front();
      pairs.pop_front();
      more = reduced(without_leading_terms(basis[first], basis[second]), basis);
      ++work;
    } while (more.value.is_zero() && work < most_pairs);
    if (more.value.is_zero() ||
        fmpq_mpoly_length(more.value.raw(), more.value.ring().context()) > static_cast<slong>(longest)) {
      return std::nullopt;
    }
    basis.push_back(more);
    pair_with_others(basis.size() - 1);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Term>> multipliers(const Term& goal, const std::vector<Term>& given) {
  std::vector<Term> all{goal}, circles;
  all.insert(all.end(), given.begin(), given.end());
  const Letters in_them(all);
  for (const Term& letter : in_them.terms()) {
    if (letter.kind() == kernel::Kind::cosine) {
      circles.push_back(power(letter, 2) + power(kernel::sin(letter.parts()[0]), 2) - 1);
    }
  }
  all.insert(all.end(), circles.begin(), circles.end());
  const Letters letters(all);
  std::vector<Fraction> fractions;  // of the goal, then of what is given
  for (std::size_t k = 0; k <= given.size(); ++k) {
    fractions.push_back(letters.fraction(all[k]));
  }
  const PolynomialRing& ring = letters.ring();
  std::vector<Member> basis;
  const Member nothing{Polynomial(ring), std::vector<Polynomial>(given.size(), Polynomial(ring))};
  for (std::size_t k = 0; k < given.size(); ++k) {
    Member one = nothing;
    one.value = fractions[k + 1].above;
    one.of[k] = ring.constant(1);
    if (!one.value.is_zero()) {
      basis.push_back(one);
    }
  }
  for (const Term& circle : circles) {
    basis.push_back(nothing);
    basis.back().value = letters.fraction(circle).above;
  }
  Member wanted = nothing;
  wanted.value = fractions[0].above;
  const std::optional<Member> zero = expressed(wanted, basis);
  if (!zero) {
    return std::nullopt;
  }
  std::vector<Term> result;
  for (std::size_t k = 0; k < given.size(); ++k) {
    Polynomial factor = zero->of[k];
    factor *= ring.constant(-1);
    result.push_back(letters.term(factor) * letters.term(fractions[k + 1].below) /
                     letters.term(fractions[0].below));
  }
  return result;
}

}  // namespace stickslip::proofs::tactics
