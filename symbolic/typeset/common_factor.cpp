#include <algorithm>

#include "symbolic/typeset/formula.hpp"

namespace stickslip::symbolic::typeset {

namespace {

bool is_zero(const Fraction& fraction) {
  return fraction.numerator.coefficient == 0;
}

std::vector<Power>::iterator find_base(std::vector<Power>& powers, const Power& wanted) {
  return std::find_if(powers.begin(), powers.end(),
                      [&](const Power& power) { return std::is_eq(compare_bases(power, wanted)); });
}

// The greatest common divisor as far as the factors show it.
Product common(Product a, Product b) {
  Product result{gcd(a.coefficient, b.coefficient), {}};
  for (Power& power : a.powers) {
    const auto partner = find_base(b.powers, power);
    if (partner != b.powers.end()) {
      power.exponent = std::min(power.exponent, partner->exponent);
      result.powers.push_back(std::move(power));
    }
  }
  return result;
}

// Assumes that the divisor's factors are among those of the product.
void divide(Product& product, const Product& divisor) {
  product.coefficient /= divisor.coefficient;
  for (const Power& power : divisor.powers) {
    const auto found = find_base(product.powers, power);
    found->exponent -= power.exponent;
    if (found->exponent == 0) {
      product.powers.erase(found);
    }
  }
}

}  // namespace

Common take_common_factor(std::vector<Fraction> entries) {
  Fraction factor;
  const auto first = std::find_if_not(entries.begin(), entries.end(), is_zero);
  if (std::count_if(entries.begin(), entries.end(), is_zero) + 2 <= std::ssize(entries)) {
    factor = *first;
    factor.negative = false;
    for (const Fraction& entry : entries) {
      if (!is_zero(entry)) {
        factor.numerator = common(std::move(factor.numerator), entry.numerator);
        factor.denominator = common(std::move(factor.denominator), entry.denominator);
      }
    }
  }
  if (factor.denominator.is_one()) {
    return {{}, std::move(entries)};
  }
  factor.negative = first->negative;
  for (Fraction& entry : entries) {
    if (!is_zero(entry)) {
      divide(entry.numerator, factor.numerator);
      divide(entry.denominator, factor.denominator);
      entry.negative = (entry.negative != factor.negative);
    }
  }
  return {std::move(factor), std::move(entries)};
}

}  // namespace stickslip::symbolic::typeset
