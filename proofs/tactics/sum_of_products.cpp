#include "proofs/tactics/sum_of_products.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/linear_program.hpp"

namespace stickslip::proofs::tactics {

namespace {

using namespace kernel;
using kernel::Kind;
using Degrees = std::vector<int>;

int sum_of(const Degrees& degrees) {
  return std::accumulate(degrees.begin(), degrees.end(), 0);
}

int degree_of(const Polynomial& value) {  // 0 of 0
  const slong degree = fmpq_mpoly_total_degree_si(value.raw(), value.ring().context());
  return std::max(0, static_cast<int>(degree));
}

Polynomial times(Polynomial a, const Polynomial& b) {
  a *= b;
  return a;
}

// cos(u)² + sin(u)² - 1 of every u of which one of these is the sine or cosine.
std::vector<Term> circles_of(const std::vector<Term>& letters) {
  Terms arguments;
  for (const Term& one : letters) {
    if (is_wave(one)) {
      arguments.insert(one.parts()[0]);
    }
  }
  std::vector<Term> result;
  for (const Term& u : arguments) {
    result.push_back(power(cos(u), 2) + power(sin(u), 2) - 1);
  }
  return result;
}

std::vector<Term> with_circles(std::vector<Term> terms) {
  const Letters letters(terms);
  const std::vector<Term> circles = circles_of(letters.terms());
  terms.insert(terms.end(), circles.begin(), circles.end());
  return terms;
}

std::vector<Term> gaps(const Formula& goal, const std::vector<Theorem>& known) {
  std::vector<Term> result{gap_of(goal)};
  for (const Theorem& one : known) {
    result.push_back(gap_of(one.conclusion()));
  }
  return result;
}

class SumOfProducts {
 public:
  SumOfProducts(const Formula& goal, const std::vector<Theorem>& known, long& work)
      : goal_(goal), work_(work), letters_(with_circles(gaps(goal, known))), wanted_(letters_.ring()) {
    for (const Term& circle : circles_of(letters_.terms())) {
      circles_.push_back(letters_.fraction(circle).above);
    }
    const auto wanted = value_of(gap_of(goal));
    if (!wanted) {
      throw KernelError("it divides by variables");
    }
    wanted_ = *wanted;
    for (const Theorem& one : known) {
      if (const auto value = value_of(gap_of(one.conclusion()))) {
        (one.conclusion().kind() == Kind::equal ? equations_ : facts_).emplace_back(one, *value);
      }
    }
  }

  Theorem of_degree(int degree) {
    degree_ = degree;
    summands_.clear();
    add_products({{}}, letters_.ring().constant(1), true, 0);
    add_squares_of_facts();
    add_multiples();
    add_squares();
    add_completed_squares();
    return solved();
  }
  [[nodiscard]] int least_degree() const { return std::max(1, degree_of(wanted_)); }

 private:
  struct Summand {
    std::vector<Monomial> value;
    std::optional<Positive> product;        // or
    std::optional<Multiple> multiple = {};  // of an equation
    bool is_strict = false;
  };

  // In the letters, with as few squares of cosines (of sines) as can be; nothing of what divides by letters.
  [[nodiscard]] std::optional<Polynomial> value_of(const Term& term) const {
    auto [above, below] = letters_.fraction(term);
    above *= letters_.ring().constant(1 / leading_coefficient(below));
    return is_constant(below) ? std::optional(on_circles(above)) : std::nullopt;
  }
  [[nodiscard]] Polynomial on_circles(const Polynomial& value) const {
    return circles_.empty() ? value : remainder(value, circles_);
  }
  [[nodiscard]] std::vector<Monomial> terms_of(const Polynomial& value) const {
    return monomials(on_circles(value));
  }
  [[nodiscard]] Polynomial monomial(const Degrees& degrees) const {
    return polynomial(letters_.ring(), {{degrees, 1}});
  }

  // The product, and those with further facts from this one on.
  void add_products(const Positive& product, const Polynomial& value, bool is_strict, std::size_t first) {
    constexpr std::size_t most_factors = 3;
    summands_.push_back({terms_of(value), product, {}, is_strict});
    for (std::size_t k = first; k < facts_.size() && product.inequalities.size() < most_factors; ++k) {
      const auto& [fact, factor] = facts_[k];
      const Polynomial longer = times(value, factor);
      if (degree_of(longer) <= degree_ && summands_.size() < most_summands) {
        Positive larger = product;
        larger.inequalities.push_back(fact);
        add_products(larger, longer, is_strict && fact.conclusion().kind() == Kind::less, k);
      }
    }
  }

  // Squares of what is known, and of products of two: these are not zero either.
  void add_squares_of_facts() {
    for (std::size_t i = 0; i < facts_.size(); ++i) {
      for (std::size_t j = i; j < facts_.size(); ++j) {
        const auto& [one, a] = facts_[i];
        const auto& [other, b] = facts_[j];
        const bool is_strict =
            one.conclusion().kind() == Kind::less && other.conclusion().kind() == Kind::less;
        const Polynomial square = times(times(a, b), times(a, b));
        if (is_strict && degree_of(square) <= degree_ && summands_.size() < most_summands) {
          summands_.push_back({terms_of(square), Positive{{one, one, other, other}}, {}, true});
        }
      }
    }
  }

  void add_multiples() {
    for (const auto& [equation, value] : equations_) {
      for (const Degrees& degrees : monomials_up_to(degree_ - degree_of(value), 1)) {
        for (const int sign : {1, -1}) {
          if (summands_.size() > most_summands) {
            return;
          }
          const Polynomial factor = times(monomial(degrees), letters_.ring().constant(sign));
          summands_.push_back(
              {terms_of(times(value, factor)), {}, Multiple{equation, -letters_.term(factor)}});
        }
      }
    }
  }

  // In the letters of what is wanted and of equations, for 0 < 0 of facts, to at most the degrees that they
  // have there over this.
  [[nodiscard]] std::vector<Degrees> monomials_up_to(int most, int over) const {
    std::vector<Degrees> result(most < 0 ? 0 : 1, Degrees(letters_.terms().size()));
    for (std::size_t v = 0; v < letters_.terms().size(); ++v) {
      int highest = std::max(degree(wanted_, v), occurs_with_partner(v) ? 1 : 0);
      for (const auto& equation : equations_) {
        highest = std::max(highest, degree(equation.second, v));
      }
      for (std::size_t k = 0; k < facts_.size() && wanted_.is_zero(); ++k) {
        highest = std::max(highest, degree(facts_[k].second, v));
      }
      const std::size_t before = result.size();
      for (std::size_t k = 0; k < before; ++k) {
        for (int power = 1; power <= (highest + over - 1) / over; ++power) {
          Degrees more = result[k];
          more[v] = power;
          if (sum_of(more) <= most) {
            result.push_back(more);
          }
          if (result.size() > most_monomials) {
            throw KernelError("too many monomials");
          }
        }
      }
    }
    return result;
  }
  // A sine beside whose cosine's square there is something, or the other way.
  [[nodiscard]] bool occurs_with_partner(std::size_t v) const {
    return std::ranges::any_of(circles_, [&](const Polynomial& circle) {
      bool met = false;
      for (std::size_t w = 0; w < letters_.terms().size() && degree(circle, v) > 0; ++w) {
        met = met || (degree(circle, w) > 0 && degree(wanted_, w) > 0);
      }
      return met;
    });
  }

  // Squares, and known inequalities times squares: of monomials, and of sums and differences of two with
  // whose product something is to be cancelled.
  void add_squares() {
    std::set<Degrees> met;
    const auto meet = [&](const std::vector<Monomial>& terms) {
      for (const Monomial& one : terms) {
        met.insert(one.degrees);
      }
    };
    meet(monomials(wanted_));
    for (const Summand& one : summands_) {
      meet(one.value);
    }
    for (const Degrees& base : monomials_up_to(degree_ / 2, 2)) {
      meet(terms_of(times(monomial(base), monomial(base))));
    }
    add_squares({{}}, letters_.ring().constant(1), met);
    for (const auto& [fact, value] : facts_) {
      add_squares({{fact}}, value, met);
    }
  }

  void add_squares(Positive product, const Polynomial& value, const std::set<Degrees>& met) {
    const auto add = [&](const Polynomial& base) {
      product.square = letters_.term(base);
      summands_.push_back({terms_of(times(times(base, base), value)), product});
    };
    const auto bases = monomials_up_to((degree_ - degree_of(value)) / 2, 2);
    for (std::size_t i = 0; i < bases.size() && summands_.size() < most_summands; ++i) {
      add(monomial(bases[i]));
      for (std::size_t j = 0; j < i; ++j) {
        const auto mixed = terms_of(times(times(monomial(bases[i]), monomial(bases[j])), value));
        if (std::ranges::none_of(mixed, [&](const Monomial& one) { return met.contains(one.degrees); })) {
          continue;
        }
        for (const Rational& ratio : ratios(bases[i], bases[j])) {
          for (const int sign : {1, -1}) {
            add(polynomial(letters_.ring(), {{bases[i], 1}, {bases[j], sign * ratio}}));
          }
        }
      }
    }
  }

  // The squares that complete those of the letters one after the other, in what is wanted, and in that with
  // the circles added that turn its constant, or half of it, into squares of sines and cosines.
  void add_completed_squares() {
    add_completed_squares(wanted_);
    Rational constant = 0;
    for (const Monomial& one : monomials(wanted_)) {
      constant = sum_of(one.degrees) == 0 ? one.coefficient : constant;
    }
    for (const Polynomial& circle : circles_) {
      for (const Rational& factor : {constant, Rational(constant / 2)}) {
        if (constant > 0) {
          Polynomial larger = wanted_;
          larger += times(circle, letters_.ring().constant(factor));
          add_completed_squares(larger);
        }
      }
    }
  }

  void add_completed_squares(Polynomial rest) {
    for (std::size_t v = 0; v < letters_.terms().size(); ++v) {
      const Polynomial pivot = coefficient(rest, v, 2);
      const Rational size = leading_coefficient(pivot);
      if (degree(rest, v) == 2 && is_constant(pivot) && size > 0) {
        Polynomial base = times(coefficient(rest, v, 1), letters_.ring().constant(1 / (2 * size)));
        base += letters_.ring().generator(v);
        const Polynomial square = times(base, base);
        summands_.push_back({terms_of(square), Positive{{}, 1, letters_.term(base)}});
        rest += times(square, letters_.ring().constant(-size));
      }
    }
  }

  // 1, and fractions on both sides of the root of the quotient of what stands beside the squares of both.
  [[nodiscard]] std::vector<Rational> ratios(const Degrees& a, const Degrees& b) const {
    const auto beside_square = [&](const Degrees& base) {
      Polynomial rest = wanted_;
      for (std::size_t v = 0; v < base.size(); ++v) {
        rest = coefficient(rest, v, 2 * base[v]);
      }
      return leading_coefficient(rest);
    };
    const Rational above = beside_square(b), below = beside_square(a);
    std::vector<Rational> result{1};
    if (above > 0 && below > 0 && above != below) {
      constexpr int finest = 8;  // denominators
      Rational low = 0, high = 1 + above / below;
      for (int q = 1; q <= finest; ++q) {
        const Rational square = above * q * q / below;
        const mpz_class p = sqrt(mpz_class(square.get_num() / square.get_den()));
        low = std::max<Rational>(low, Rational(p) / q);
        high = std::min<Rational>(high, Rational(p * p == square ? p : mpz_class(p + 1)) / q);
      }
      if (low > 0) {
        result.push_back(low);
      }
      result.push_back(high);
    }
    return result;
  }

  Theorem solved() {
    const std::vector<const Summand *> used = able_to_take_part();
    std::map<Degrees, std::size_t> rows;
    const auto number = [&](const std::vector<Monomial>& terms) {
      for (const Monomial& one : terms) {
        rows.emplace(one.degrees, rows.size());
      }
    };
    number(monomials(wanted_));
    for (const Summand * one : used) {
      number(one->value);
    }
    const auto dense = [&](const std::vector<Monomial>& terms) {
      Column result(rows.size());
      for (const Monomial& one : terms) {
        result[rows.at(one.degrees)] = one.coefficient;
      }
      return result;
    };
    std::vector<Column> columns;
    std::set<std::size_t> strict;
    for (const Summand * one : used) {
      if (goal_.kind() == Kind::less && one->is_strict) {
        strict.insert(columns.size());
      }
      columns.push_back(dense(one->value));
      if (wanted_.is_zero()) {  // of the multiples of one solution that whose strict summands add up to 1
        columns.back().emplace_back(one->is_strict ? 1 : 0);
      }
    }
    Column right = dense(monomials(wanted_));
    if (wanted_.is_zero()) {
      right.emplace_back(1);
    }
    work_ -= static_cast<long>(summands_.size() * rows.size());
    const bool may_be = goal_.kind() != Kind::less || !strict.empty();
    const auto factors = may_be ? nonnegative_solution(columns, right, strict) : std::nullopt;
    if (!factors) {
      throw KernelError("it is no sum of products of this degree");
    }
    std::vector<Positive> positives;
    std::vector<Multiple> multiples;
    for (std::size_t k = 0; k < used.size(); ++k) {
      const Rational& factor = (*factors)[k];
      if (factor > 0 && used[k]->product) {
        positives.push_back(*used[k]->product);
        positives.back().factor = factor;
      } else if (factor > 0) {
        multiples.push_back({used[k]->multiple->equation, Term(factor) * used[k]->multiple->left});
      }
    }
    return Theorem::order(goal_, positives, multiples);
  }

  // Those of the summands with no monomial that no other takes away again.
  [[nodiscard]] std::vector<const Summand *> able_to_take_part() const {
    std::vector<const Summand *> used;
    for (const Summand& one : summands_) {
      used.push_back(&one);
    }
    for (bool changed = true; changed;) {
      std::set<std::pair<Degrees, bool>> met;  // and whether with a positive coefficient
      for (const Monomial& one : monomials(wanted_)) {
        met.emplace(one.degrees, one.coefficient < 0);
      }
      for (const Summand * summand : used) {
        for (const Monomial& one : summand->value) {
          met.emplace(one.degrees, one.coefficient > 0);
        }
      }
      changed = std::erase_if(used, [&](const Summand * summand) {
                  return std::ranges::any_of(summand->value, [&](const Monomial& one) {
                    return !met.contains({one.degrees, one.coefficient < 0});
                  });
                }) > 0;
    }
    return used;
  }

  static constexpr std::size_t most_summands = 500, most_monomials = 100;

  Formula goal_;
  long& work_;
  Letters letters_;
  std::vector<Polynomial> circles_;
  Polynomial wanted_;
  std::vector<std::pair<Theorem, Polynomial>> facts_, equations_;
  std::vector<Summand> summands_;
  int degree_ = 0;
};

}  // namespace

Theorem sum_of_products(const Formula& inequality, const std::vector<Theorem>& known, long& work) {
  SumOfProducts sum(inequality, known, work);
  constexpr int most = 20, most_with_more = 6;
  const int least = sum.least_degree(),
            last = std::max(std::min(least, most), std::min(least + 2, most_with_more));
  for (int degree = least; degree <= last; ++degree) {
    if (const auto theorem = attempt([&] { return sum.of_degree(degree); })) {
      return *theorem;
    }
  }
  throw KernelError("it is no sum of products of what is known");
}

}  // namespace stickslip::proofs::tactics
