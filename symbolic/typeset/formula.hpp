// A scalar expression laid out as a reader would write it: one fraction of sorted products. GiNaC's own order
// of operands differs from run to run; nothing here depends on it.
//
// The form. An expression is a rational function of its symbols, π and its functions (cos, sin, tan; others
// as they stand): numerator and denominator have no common factor and are factored over the integers, except
// that conjugate factors such as (a - b)(a + b) stay together as a² - b².
//   A sum without cos, sin, tan is expanded; its terms run through powers of π, then descending degree, then
//   the order of symbols of compare_names(). A sum with them is collected by products of cos, sin, tan,
//   highest degree first, by argument (fewest terms first), then cos, sin, tan; the coefficients are factored
//   in turn. Signs: a sum has at least as many positive terms as negative ones; with as many of both, a
//   number is positive, and else the first term: 1 - chi, omega1² - omega2². The first positive term is
//   written first. Products: integer, symbols, other functions, sums, then cos, sin, tan.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "core/rational.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::typeset {

struct Power;

// coefficient · Π powers; coefficient is an integer ≥ 0.
struct Product {
  mpz_class coefficient = 1;
  std::vector<Power> powers;

  [[nodiscard]] bool is_one() const;
};

// ± numerator / denominator.
struct Fraction {
  bool negative = false;
  Product numerator;
  Product denominator;
};

// At least two terms, except as the argument of a function.
using Sum = std::vector<Fraction>;

// π, a symbol, or a function of arguments laid out in turn. Arguments of cos, sin, tan are sums of terms that
// may have denominators, collected by frequency: ω(τ + τ₁) + φ.
struct Atom {
  enum class Kind { pi, symbol, function, trigonometric };
  Kind kind = Kind::symbol;
  std::string name;  // "pi", the symbol's, the function's, or "root" with the arguments radicand and degree
  std::vector<Sum> arguments;
};

// atom^exponent or, if sum is not empty, sum^exponent; exponent ≥ 1.
struct Power {
  Atom atom;
  Sum sum;
  int exponent = 1;
};

// A rational number times these above those.
[[nodiscard]] Fraction times(const Rational& factor, std::vector<Power> above, std::vector<Power> below = {});

// The canonical layout: equal for expressions that are equal as rational functions of the symbols (by name),
// π and the functions. Throws InternalError for floating or complex numbers, symbolic exponents and anything
// that is not a scalar.
[[nodiscard]] Fraction arrange(const GiNaC::ex& expression);

// A leading minus taken into the formula where this costs nothing: into a difference of the denominator
// without a number, then of the numerator, then 1 - x of the numerator (last ones first); else it stays in
// front.
[[nodiscard]] Fraction without_leading_minus(Fraction fraction);

// The order in which the parts of a formula are written (formula.hpp).

// π, symbols by compare_names(), functions by name, then arguments; cos, sin, tan by argument, then name.
[[nodiscard]] std::strong_ordering compare(const Atom& a, const Atom& b);

// Fewer terms first, then term by term, signs last.
[[nodiscard]] std::strong_ordering compare(const Sum& a, const Sum& b);

// π, symbols, functions; sums without cos, sin, tan; sums with them; cos, sin, tan. Exponents are not looked
// at.
[[nodiscard]] std::strong_ordering compare_bases(const Power& a, const Power& b);

}  // namespace stickslip::symbolic::typeset
