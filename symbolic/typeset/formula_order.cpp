#include "symbolic/typeset/formula_order.hpp"

#include <algorithm>

#include "symbolic/typeset/names.hpp"

namespace stickslip::symbolic::typeset {
namespace {

std::strong_ordering compare(const GiNaC::numeric& a, const GiNaC::numeric& b) {
  return a.compare(b) <=> 0;
}

std::strong_ordering compare(const Product& a, const Product& b) {
  const std::size_t size = std::min(a.powers.size(), b.powers.size());
  for (std::size_t i = 0; i < size; ++i) {
    if (const auto order = compare_bases(a.powers[i], b.powers[i]); std::is_neq(order)) {
      return order;
    }
    if (const auto order = b.powers[i].exponent <=> a.powers[i].exponent; std::is_neq(order)) {
      return order;
    }
  }
  const auto order = a.powers.size() <=> b.powers.size();
  return std::is_neq(order) ? order : compare(a.coefficient, b.coefficient);
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

std::strong_ordering compare_arguments(const Atom& a, const Atom& b) {
  return std::lexicographical_compare_three_way(a.arguments.begin(), a.arguments.end(), b.arguments.begin(),
                                                b.arguments.end(),
                                                [](const Sum& x, const Sum& y) { return compare(x, y); });
}

}  // namespace

std::strong_ordering compare(const Sum& a, const Sum& b) {
  if (const auto order = a.size() <=> b.size(); std::is_neq(order)) {
    return order;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (const auto order = compare(a[i], b[i]); std::is_neq(order)) {
      return order;
    }
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare(const Atom& a, const Atom& b) {
  if (const auto order = a.kind <=> b.kind; std::is_neq(order)) {
    return order;
  }
  if (a.kind == Atom::Kind::symbol) {
    return compare_names(a.name, b.name);
  }
  const auto by_name = a.name <=> b.name;
  const auto by_arguments = compare_arguments(a, b);
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
