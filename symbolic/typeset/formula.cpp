#include "symbolic/typeset/formula.hpp"

#include <algorithm>

#include "symbolic/typeset/names.hpp"
#include "symbolic/typeset/polynomial.hpp"

namespace stickslip::symbolic::typeset {

using GiNaC::ex;

bool Product::is_one() const {
  return coefficient == 1 && powers.empty();
}

namespace {

struct Signed {
  Rational unit;  // of any sign
  std::vector<Power> powers;
};

Signed factored(const Polynomial& polynomial, const Alphabet& alphabet);

void negate(Sum& sum) {
  for (Fraction& term : sum) {
    term.negative = !term.negative;
  }
}

void put_positive_first(Sum& sum) {
  const auto positive = std::find_if(sum.begin(), sum.end(), [](const Fraction& t) { return !t.negative; });
  if (positive != sum.end()) {
    std::rotate(sum.begin(), positive, positive + 1);
  }
}

bool is_lone_sum(const Product& product) {
  return product.coefficient == 1 && product.powers.size() == 1 && !product.powers[0].sum.empty() &&
         product.powers[0].exponent == 1;
}

std::vector<Fraction>::difference_type negative_terms(const Sum& sum) {
  return std::count_if(sum.begin(), sum.end(), [](const Fraction& term) { return term.negative; });
}

// The number among the terms, if there is one.
const Fraction * find_number(const Sum& sum) {
  const auto number =
      std::find_if(sum.begin(), sum.end(), [](const Fraction& t) { return t.numerator.powers.empty(); });
  return number == sum.end() ? nullptr : &*number;
}

bool is_balanced(const Sum& sum) {
  return 2 * negative_terms(sum) == std::ssize(sum);
}

// x^n of the one quantity that exceeds 1: omega2² - 1 is positive, but 1 - chi, 1 - omega1².
bool is_large(const Fraction& term) {
  const std::vector<Power>& powers = term.numerator.powers;
  return powers.size() == 1 && powers[0].sum.empty() && exceeds_one(powers[0].atom.name);
}

bool is_better_negated(const Sum& sum) {
  if (!is_balanced(sum)) {
    return 2 * negative_terms(sum) > std::ssize(sum);
  }
  const Fraction * number = find_number(sum);
  if (number == nullptr) {
    return sum[0].negative;
  }
  return number->negative != (sum.size() == 2 && is_large(sum[0]));
}

// The terms in their order, first term first whatever its sign.
Sum terms(const Polynomial& polynomial, const Alphabet& alphabet) {
  Sum result;
  for (const auto& [degrees, coefficient] : collect_trigonometric(polynomial, alphabet)) {
    const bool constant = std::all_of(degrees.begin(), degrees.end(), [](int d) { return d == 0; });
    if (constant && coefficient.size() == polynomial.size()) {  // no cos, sin, tan at all
      for (const Monomial& term : polynomial) {
        result.push_back(to_fraction(term, alphabet));
      }
      return result;
    }
    Signed product = factored(coefficient, alphabet);
    const Fraction waves = to_fraction({degrees, 1}, alphabet);
    product.powers.insert(product.powers.end(), waves.numerator.powers.begin(), waves.numerator.powers.end());
    Fraction term = times(product.unit, std::move(product.powers));
    if (constant && is_lone_sum(term.numerator)) {
      Sum last = std::move(term.numerator.powers[0].sum);
      if (term.negative) {
        negate(last);
      }
      result.insert(result.end(), last.begin(), last.end());
    } else {
      result.push_back(std::move(term));
    }
  }
  return result;
}

Signed factored(const Polynomial& polynomial, const Alphabet& alphabet) {
  const Factors factors = factorise(polynomial, alphabet);
  Signed result{factors.unit, to_fraction({factors.monomial, 1}, alphabet).numerator.powers};
  for (const auto& [factor, exponent] : factors.sums) {
    Sum sum = terms(factor, alphabet);
    if (is_better_negated(sum)) {
      negate(sum);
      result.unit *= exponent % 2 == 0 ? 1 : -1;
    }
    put_positive_first(sum);
    result.powers.push_back({{}, std::move(sum), exponent});
  }
  std::sort(result.powers.begin(), result.powers.end(),
            [](const Power& a, const Power& b) { return std::is_lt(compare_bases(a, b)); });
  return result;
}

bool can_turn(const Power& power, bool with_number) {
  return !power.sum.empty() && power.exponent % 2 != 0 && is_balanced(power.sum) &&
         (find_number(power.sum) != nullptr) == with_number;
}

// Turns the last difference of that sort round; false if there is none.
bool turn_last(Product& product, bool with_number) {
  const auto found = std::find_if(product.powers.rbegin(), product.powers.rend(),
                                  [&](const Power& power) { return can_turn(power, with_number); });
  if (found == product.powers.rend()) {
    return false;
  }
  negate(found->sum);
  put_positive_first(found->sum);
  return true;
}

}  // namespace

Fraction times(const Rational& factor, std::vector<Power> above, std::vector<Power> below) {
  return {factor < 0, {abs(factor.get_num()), std::move(above)}, {factor.get_den(), std::move(below)}};
}

Fraction arrange(const ex& expression) {
  const auto [rational, alphabet] = rationalize(expression);
  const ex parts = rational.normal().numer_denom();
  const Polynomial numerator = to_polynomial(parts.op(0), alphabet);
  if (numerator.empty()) {
    return {false, {0, {}}, {}};
  }
  Signed above = factored(numerator, alphabet);
  Signed below = factored(to_polynomial(parts.op(1), alphabet), alphabet);
  return times(above.unit / below.unit, std::move(above.powers), std::move(below.powers));
}

Fraction without_leading_minus(Fraction fraction) {
  if (!fraction.negative) {
    return fraction;
  }
  Product& above = fraction.numerator;
  Product& below = fraction.denominator;
  const bool whole = below.coefficient == 1 && below.powers.empty();
  if (turn_last(below, false) || turn_last(above, false) || turn_last(above, true)) {
    fraction.negative = false;
  } else if (whole && is_lone_sum(above)) {
    negate(above.powers[0].sum);
    put_positive_first(above.powers[0].sum);
    fraction.negative = false;
  }
  return fraction;
}

namespace {

template <class Parts, class Compare>
std::strong_ordering one_by_one(const Parts& a, const Parts& b, const Compare& compare) {
  return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end(), compare);
}

std::strong_ordering compare(const Product& a, const Product& b) {
  const auto order = one_by_one(a.powers, b.powers, [](const Power& x, const Power& y) {
    const auto bases = compare_bases(x, y);
    return std::is_neq(bases) ? bases : y.exponent <=> x.exponent;
  });
  return std::is_neq(order) ? order : cmp(a.coefficient, b.coefficient) <=> 0;
}

std::strong_ordering compare(const Fraction& a, const Fraction& b) {
  if (const auto order = compare(a.numerator, b.numerator); std::is_neq(order)) {
    return order;
  }
  const auto order = compare(a.denominator, b.denominator);
  return std::is_neq(order) ? order : a.negative <=> b.negative;
}

bool is_trigonometric(const Power& power) {
  if (power.sum.empty()) {
    return power.atom.kind == Atom::Kind::trigonometric;
  }
  return std::any_of(power.sum.begin(), power.sum.end(), [](const Fraction& term) {
    const auto& powers = term.numerator.powers;
    return std::any_of(powers.begin(), powers.end(), is_trigonometric);
  });
}

int place(const Power& power) {
  const bool trigonometric = is_trigonometric(power);
  if (power.sum.empty()) {
    return trigonometric ? 3 : 0;
  }
  return trigonometric ? 2 : 1;
}

}  // namespace

std::strong_ordering compare(const Sum& a, const Sum& b) {
  const auto order = a.size() <=> b.size();
  return std::is_neq(order)
             ? order
             : one_by_one(a, b, [](const Fraction& x, const Fraction& y) { return compare(x, y); });
}

std::strong_ordering compare(const Atom& a, const Atom& b) {
  if (const auto order = a.kind <=> b.kind; std::is_neq(order)) {
    return order;
  }
  if (a.kind == Atom::Kind::symbol) {
    return compare_names(a.name, b.name);
  }
  const auto by_name = a.name <=> b.name;
  const auto by_arguments =
      one_by_one(a.arguments, b.arguments, [](const Sum& x, const Sum& y) { return compare(x, y); });
  if (a.kind == Atom::Kind::trigonometric) {
    return std::is_neq(by_arguments) ? by_arguments : by_name;
  }
  return std::is_neq(by_name) ? by_name : by_arguments;
}

std::strong_ordering compare_bases(const Power& a, const Power& b) {
  if (const auto order = place(a) <=> place(b); std::is_neq(order)) {
    return order;
  }
  return a.sum.empty() ? compare(a.atom, b.atom) : compare(a.sum, b.sum);
}

}  // namespace stickslip::symbolic::typeset
