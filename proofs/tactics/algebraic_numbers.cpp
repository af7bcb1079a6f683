#include "proofs/tactics/algebraic_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace stickslip::proofs::tactics {

using namespace kernel;

namespace {

using Degrees = std::vector<int>;

// Of u = turns pi + rest. Nothing where u is no such sum.
struct Angle {
  Rational turns;
  Term rest;
};
std::optional<Angle> angle(const Term& u) {
  const Letters letters({u, pi()});
  const auto place =
      static_cast<std::size_t>(std::ranges::find(letters.terms(), pi()) - letters.terms().begin());
  const auto [above, below] = letters.fraction(u);
  const Polynomial turns = coefficient(above, place, 1);
  if (!is_constant(below) || degree(above, place) > 1 || !is_constant(turns)) {
    return std::nullopt;
  }
  const Polynomial by = letters.ring().constant(1 / leading_coefficient(below));
  Polynomial rest = coefficient(above, place, 0);
  rest *= by;
  return Angle{leading_coefficient(turns) * leading_coefficient(by), letters.term(rest)};
}

// Chebyshev's polynomial T or U of this degree, of the term.
Term chebyshev(bool second, long degree, const Term& x) {
  std::vector<mpz_class> before{1}, here{0, second ? 2 : 1};
  for (long k = 0; k < degree; ++k) {
    std::vector<mpz_class> next(here.size() + 1);
    for (std::size_t j = 0; j < here.size(); ++j) {
      next[j + 1] += 2 * here[j];
      next[j] -= j < before.size() ? before[j] : 0;
    }
    before = std::exchange(here, next);
  }
  std::vector<Term> parts{0};
  for (std::size_t j = 0; j < before.size(); ++j) {
    if (before[j] != 0) {
      const Term factor = Rational(before[j]);
      parts.push_back(j == 0 ? factor : factor * power(x, static_cast<long>(j)));
    }
  }
  return sum(parts);
}

// T(c) = 1, 0 or -1 for c = cos(pi/n), where T is Chebyshev's polynomial of the degree k with which k pi/n is
// a multiple of pi/2; and what of that is irreducible.
Theorem minimal_equation(const Term& c, long n) {
  const long k = n % 2 == 0 ? n / 2 : n;
  const Variable v{"v"};
  const Theorem multiple = Theorem::instantiate(
      Theorem::combination(equal(chebyshev(false, k, cos(v)), cos(Term(k) * v))), {{v, c.parts()[0]}});
  const auto irreducible = first_that_works(std::array{0, 1, -1}, [&](int value) {
    const Theorem zero = Theorem::combination(equal(multiple.conclusion().parts()[0], value), {{multiple}});
    const Letters letters({c});
    const Factored whole = factored(letters.fraction(gap_of(zero.conclusion())).above, letters);
    const auto found = first_that_works(whole.factors, [&](const Polynomial& factor) {
      return zero_factor(letters.term(factor), zero,
                         [](const Term& other) { return certainly(differ(other, 0)); });
    });
    return found ? *found : throw KernelError("no factor is known to be zero: " + to_string(c));
  });
  return irreducible ? *irreducible : throw KernelError("it is at no part of the circle: " + to_string(c));
}

// Equations of waves at rational multiples of pi, each with that wave: where they are 0, 1 or -1, that; of c
// = cos(pi/n) and s = sin(pi/n), where all others are at multiples of pi/n; of these by c and s.
std::vector<std::pair<Term, Theorem>> equations_of(const std::vector<Term>& letters) {
  constexpr long largest = 64, most_turns = 8;
  std::vector<std::pair<Term, Theorem>> result;
  mpz_class n = 1;
  std::map<Term, Rational> turns;
  for (const Term& letter : letters) {
    const auto at = is_wave(letter) ? angle(letter.parts()[0]) : std::nullopt;
    if (!at || !(at->rest == Term(0)) || abs(at->turns) > most_turns) {
      continue;
    }
    if (at->turns.get_den() <= 2) {
      const auto value = first_that_works(
          std::array{0, 1, -1}, [&](int number) { return Theorem::combination(equal(letter, number)); });
      result.emplace_back(letter, *value);
    } else if (const mpz_class both = lcm(n, at->turns.get_den()); both <= largest) {
      n = both;
      turns.emplace(letter, at->turns);
    }
  }
  if (turns.empty()) {
    return result;
  }
  const Term c = cos(pi() / Term(Rational(n))), s = sin(pi() / Term(Rational(n)));
  result.emplace_back(c, minimal_equation(c, n.get_si()));
  if (std::ranges::any_of(turns, [](const auto& one) { return one.first.kind() == Kind::sine; })) {
    result.emplace_back(s, Theorem::combination(equal(power(s, 2), 1 - power(c, 2))));
  }
  for (const auto& [wave, at] : turns) {
    if (!(wave == c) && !(wave == s)) {
      const Rational multiple = abs(at * n);
      const long k = multiple.get_num().get_si();
      const Term value = wave.kind() == Kind::cosine ? chebyshev(false, k, c)
                                                     : Term(sgn(at)) * s * chebyshev(true, k - 1, c);
      result.emplace_back(wave, Theorem::combination(equal(wave, value)));
    }
  }
  return result;
}

// With cos(u + r pi) and sin(u + r pi) by those of u and r pi.
Term with_parts_of_circle_apart(const Term& term) {
  Term result = term;
  const Letters letters({term});
  for (const Term& wave : letters.terms()) {
    const auto at = is_wave(wave) ? angle(wave.parts()[0]) : std::nullopt;
    if (at && at->turns != 0 && !(at->rest == Term(0))) {
      const Term r = Term(at->turns) * pi(), &u = at->rest;
      result = replaced(
          result, wave,
          wave.kind() == Kind::sine ? sin(u) * cos(r) + cos(u) * sin(r) : cos(u) * cos(r) - sin(u) * sin(r));
    }
  }
  return result;
}

// Whether the sides are nearly equal, where other letters have values that are made up.
bool seems_equal(const Formula& equation, const KnownRoots& roots) {
  constexpr long double nearly = 1e-9L;
  Point middle;
  for (const auto& [x, range] : roots.ranges) {
    middle[x] = (range.first + range.second) / 2;
  }
  const long double size = 1 + std::abs(estimated(equation.parts()[0], middle));
  return std::abs(estimated(gap_of(equation), middle)) <= nearly * size;
}

// Numbers of which each is a zero of a polynomial in itself and in those before.
class Algebra {
 public:
  // Of the letters of the term that are such numbers, and of those of which their squares speak.
  Algebra(const Term& term, const KnownRoots& roots) {
    std::vector<Term> all{term};
    for (auto one = roots.squares.rbegin(); one != roots.squares.rend(); ++one) {
      const std::vector<Term>& sides = one->conclusion().parts();
      const Term& x = sides[0].parts()[0];
      if (std::ranges::any_of(
              all, [&](const Term& part) { return part.variables().contains(Variable{x.name()}); })) {
        equations_.insert(equations_.begin(), {x, *one});
        all.push_back(gap_of(one->conclusion()));
      }
    }
    const auto of_waves = equations_of(Letters(all).terms());
    equations_.insert(equations_.begin(), of_waves.begin(), of_waves.end());
    for (const auto& [letter, equation] : equations_) {
      all.push_back(gap_of(equation.conclusion()));
    }
    letters_.emplace(all);
    constexpr long most_dimensions = 96;
    long dimensions = 1;
    for (const auto& [letter, equation] : equations_) {
      const auto place =
          static_cast<std::size_t>(std::ranges::find(letters_->terms(), letter) - letters_->terms().begin());
      const auto [value, below] = letters_->fraction(gap_of(equation.conclusion()));
      const int high = degree(value, place);
      const Polynomial lead = coefficient(value, place, high);
      bool is_number = is_constant(lead);  // and no root of what is none
      for (std::size_t k = 0; k < letters_->terms().size(); ++k) {
        is_number = is_number && (k == place || has(k) || degree(value, k) == 0);
      }
      if (!is_number) {
        continue;
      }
      dimensions *= high;
      if (dimensions > most_dimensions) {
        throw KernelError("its algebra is too large");
      }
      const Rational factor = 1 / leading_coefficient(lead);
      relations_.push_back(
          {equation, place, high, scaled(value, factor), -factor * leading_coefficient(below)});
    }
  }

  [[nodiscard]] const Letters& letters() const { return *letters_; }
  [[nodiscard]] bool has(std::size_t letter) const {
    return std::ranges::any_of(relations_, [&](const Relation& one) { return one.letter == letter; });
  }

  // The polynomial in its letters is zero.
  [[nodiscard]] Theorem zero(const Polynomial& g, const KnownRoots& roots) const {
    const Term value = letters_->term(g);
    const Variable G = fresh(real_number, {value, said()});
    const Theorem is_g = Theorem::assume(equal(G, value));
    std::vector<Theorem> powers{Theorem::reflexive(1)};
    std::vector<Polynomial> reduced{letters_->ring().constant(1)};
    Dependence dependence;
    std::optional<std::vector<Rational>> relation = dependence.of(reduced.back());
    while (!relation) {
      const auto k = static_cast<long>(powers.size());
      std::vector<Multiple> multiples{{powers.back(), G}, {is_g, letters_->term(reduced.back())}};
      const Polynomial next = modulo(product(reduced.back(), g), multiples);
      powers.push_back(Theorem::combination(equal(power(G, k), letters_->term(next)), multiples));
      reduced.push_back(next);
      relation = dependence.of(next);
    }
    return Theorem::cut(Theorem::reflexive(value),
                        Theorem::instantiate(by_powers(G, *relation, powers, value, roots), {{G, value}}));
  }

 private:
  struct Relation {
    Theorem equation;
    std::size_t letter;
    int degree;
    Polynomial value;  // monic in the letter
    Rational factor;   // of the equation's left less right side that is the value
  };

  // Rational combinations of polynomials.
  class Dependence {
   public:
    // The factors, the last of them 1, with which it and those given before add up to zero, if they do.
    std::optional<std::vector<Rational>> of(const Polynomial& next) {
      Row row;
      for (const Monomial& one : monomials(next)) {
        row.entries[one.degrees] = one.coefficient;
      }
      row.factors.assign(rows_.size() + 1, 0);
      row.factors.back() = 1;
      for (const Row& other : rows_) {
        const auto& [pivot, lead] = *other.entries.begin();
        const auto here = row.entries.find(pivot);
        if (here == row.entries.end()) {
          continue;
        }
        const Rational times = here->second / lead;
        for (const auto& [place, entry] : other.entries) {
          Rational& mine = row.entries[place];
          mine -= times * entry;
          if (mine == 0) {
            row.entries.erase(place);
          }
        }
        for (std::size_t k = 0; k < other.factors.size(); ++k) {
          row.factors[k] -= times * other.factors[k];
        }
      }
      if (row.entries.empty()) {
        return row.factors;
      }
      rows_.push_back(row);
      return std::nullopt;
    }

   private:
    struct Row {
      std::map<Degrees, Rational> entries;  // none is zero
      std::vector<Rational> factors;        // of those given
    };
    std::vector<Row> rows_;
  };

  [[nodiscard]] static Polynomial scaled(Polynomial value, const Rational& factor) {
    value *= value.ring().constant(factor);
    return value;
  }
  [[nodiscard]] static Polynomial product(Polynomial a, const Polynomial& b) {
    a *= b;
    return a;
  }
  [[nodiscard]] Term said() const {
    std::vector<Term> all{0};
    for (const Relation& one : relations_) {
      all.push_back(gap_of(one.equation.conclusion()));
    }
    return sum(all);
  }

  // What is left of it, with the multiples of equations of which that is less.
  [[nodiscard]] Polynomial modulo(Polynomial value, std::vector<Multiple>& multiples) const {
    for (auto one = relations_.rbegin(); one != relations_.rend(); ++one) {
      Polynomial factor(letters_->ring());
      for (int high = degree(value, one->letter); high >= one->degree; high = degree(value, one->letter)) {
        Polynomial part = coefficient(value, one->letter, high);
        for (int k = one->degree; k < high; ++k) {
          part *= letters_->ring().generator(one->letter);
        }
        factor += part;
        value += scaled(product(part, one->value), -1);
      }
      if (!factor.is_zero()) {
        multiples.push_back({one->equation, letters_->term(scaled(factor, one->factor))});
      }
    }
    return value;
  }

  // G = 0, from c_0 + c_1 G + … + c_n G^n = 0 and the value of G.
  [[nodiscard]] static Theorem by_powers(const Term& G, const std::vector<Rational>& factors,
                                         const std::vector<Theorem>& powers, const Term& value,
                                         const KnownRoots& roots) {
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(factors, [](const Rational& one) { return one != 0; }) - factors.begin());
    if (first == 0) {
      throw KernelError("it is not zero: " + to_string(value));
    }
    std::vector<Term> parts{0};
    std::vector<Multiple> multiples;
    for (std::size_t k = first; k < factors.size(); ++k) {
      if (factors[k] != 0) {
        parts.push_back(k == first ? Term(factors[k])
                                   : Term(factors[k]) * power(G, static_cast<long>(k - first)));
        multiples.push_back({powers[k], factors[k]});
      }
    }
    const Term rest = sum(parts);
    Term whole = rest;
    for (std::size_t k = 0; k < first; ++k) {
      whole = G * whole;
    }
    const Theorem differs = certainly(differ(substitute(rest, {{Variable{G.name()}, value}}), 0), roots);
    std::vector<Theorem> because{Theorem::combination(equal(whole, 0), multiples),
                                 Theorem::replace(symmetric(Theorem::assume(equal(G, value))),
                                                  Variable{G.name()}, differ(rest, 0), differs)};
    for (Term left = whole; !(left == rest); left = left.parts()[1]) {
      because.push_back(zero_product(G, left.parts()[1]));
    }
    return Theorem::consequence(because, equal(G, 0));
  }

  std::vector<std::pair<Term, Theorem>> equations_;
  std::optional<Letters> letters_;
  std::vector<Relation> relations_;
};

}  // namespace

Theorem zero_factor(const Term& f, const Theorem& known, const Differs& differs) {
  const Term gap = gap_of(known.conclusion());
  const Letters letters({f, gap});
  Polynomial wanted = letters.fraction(f).above;
  if (wanted.is_zero()) {
    throw KernelError("it is zero for all values");
  }
  take_content(wanted);
  Polynomial turned = wanted;
  turned *= letters.ring().constant(-1);
  Domain nonzero_ones;
  std::optional<Formula> differs_here;
  for (const Polynomial& factor : factored(letters.fraction(gap).above, letters).factors) {
    const Term one = letters.term(factor);
    if (factor == wanted || factor == turned) {
      differs_here = differ(one, 0);
    } else {
      nonzero_ones.push_back(differs(one));
    }
  }
  if (!differs_here) {
    throw KernelError("it is no factor of what is zero");
  }
  const Formula whole = differ(gap, 0);
  const Theorem nowhere = nonzero(Theorem::assume(whole), nonzero_ones);
  const Theorem zero = Theorem::combination(equal(gap, 0), {{known, -1}});
  const Formula& is_zero = differs_here->parts()[0];
  const Theorem result = Theorem::consequence({Theorem::discharge(nowhere, *differs_here), zero}, is_zero);
  return Theorem::combination(equal(f, 0), {{result, quotient(f, is_zero.parts()[0])}});
}

Theorem equal_numbers(const Formula& equation, const KnownRoots& roots) {
  if (!gap_of(equation).type().is_scalar() || !seems_equal(equation, roots)) {
    throw KernelError("it is not zero: " + to_string(gap_of(equation)));
  }
  const Term gap = with_parts_of_circle_apart(gap_of(equation));
  const Algebra algebra(gap, roots);
  const Letters& letters = algebra.letters();
  const auto [above, below] = letters.fraction(gap);
  std::map<Degrees, std::vector<Monomial>> coefficients;  // of monomials in what is no such number
  for (const Monomial& one : monomials(above)) {
    Monomial inside = one;
    Degrees outside = one.degrees;
    for (std::size_t k = 0; k < outside.size(); ++k) {
      (algebra.has(k) ? outside : inside.degrees)[k] = 0;
    }
    coefficients[outside].push_back(inside);
  }
  std::vector<Multiple> multiples;
  for (const auto& [degrees, terms] : coefficients) {
    const Term beside = letters.term(polynomial(letters.ring(), {{degrees, 1}}));
    multiples.push_back(
        {algebra.zero(polynomial(letters.ring(), terms), roots), -beside / letters.term(below)});
  }
  return Theorem::combination(equation, multiples);
}

}  // namespace stickslip::proofs::tactics
