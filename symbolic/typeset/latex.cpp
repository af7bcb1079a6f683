#include "symbolic/typeset/latex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "symbolic/typeset/formula.hpp"

namespace stickslip::symbolic::typeset {

using GiNaC::ex;

namespace {

enum class Style { latex, text };

// Where a fraction may be built up, in display size or in a matrix, and where it has a slash.
enum class Place { display, entry, inside };

bool is_sum(const Power& power) {
  return !power.sum.empty();
}

bool is_single(const Product& product) {
  return product.powers.size() + (product.coefficient == 1 ? 0 : 1) <= 1;
}

// Made of numbers and symbols only.
bool is_plain(const Product& product) {
  return std::all_of(product.powers.begin(), product.powers.end(), [](const Power& power) {
    return !is_sum(power) && (power.atom.kind == Atom::Kind::symbol || power.atom.kind == Atom::Kind::pi);
  });
}

// TeX reads \tau T, not \tauT; 2 t is written 2t.
std::string joined(const std::string& left, const std::string& right) {
  const bool after_number = left.find_first_not_of("0123456789") == std::string::npos;
  const bool letter = std::isalpha(static_cast<unsigned char>(right.front())) != 0;
  return left + (letter && !after_number ? " " : "") + right;
}

// One tree, two alphabets: where LaTeX and plain text differ, `latex_` is asked.
class Printer {
 public:
  explicit Printer(Style style) : latex_(style == Style::latex) {}

  [[nodiscard]] std::string fraction(const Fraction& f, Place place) const {
    return (f.negative ? "-" : "") + magnitude(f, place);
  }

 private:
  // Without the sign, which stands before it.
  [[nodiscard]] std::string magnitude(const Fraction& f, Place place) const {
    if (f.denominator.is_one()) {
      return f.negative ? product(f.numerator, place) : bare(f.numerator, place);
    }
    if (latex_ && place != Place::inside) {
      return fmt::format("\\{}{{{}}}{{{}}}", place == Place::entry ? "dfrac" : "frac",
                         bare(f.numerator, Place::inside), bare(f.denominator, Place::inside));
    }
    const std::string below = product(f.denominator, Place::inside);
    return product(f.numerator, Place::inside) + "/" + (is_single(f.denominator) ? below : "(" + below + ")");
  }

  // A product where a sum needs no parentheses.
  [[nodiscard]] std::string bare(const Product& p, Place place) const {
    const bool lone = p.coefficient == 1 && p.powers.size() == 1 && p.powers[0].exponent == 1;
    return lone && is_sum(p.powers[0]) ? sum(p.powers[0].sum, place) : product(p, place);
  }

  [[nodiscard]] std::string product(const Product& p, Place place) const {
    std::string result;
    if (p.coefficient != 1 || p.powers.empty()) {
      result = p.coefficient.get_str();
    }
    for (const Power& factor : p.powers) {
      const std::string next = power(factor, place);
      if (latex_ && !result.empty()) {
        result = joined(result, next);
      } else {
        result += (result.empty() ? "" : "*") + next;
      }
    }
    return result;
  }

  [[nodiscard]] std::string sum(const Sum& s, Place place) const {
    const std::string plus = latex_ ? "+" : " + ";
    const std::string minus = latex_ ? "-" : " - ";
    std::string result;
    for (const Fraction& term : s) {
      if (!result.empty()) {
        result += term.negative ? minus : plus;
      } else if (term.negative) {
        result += "-";
      }
      const bool whole = term.denominator.is_one();
      result += whole ? product(term.numerator, place) : magnitude(term, Place::inside);
    }
    return result;
  }

  [[nodiscard]] std::string exponent(int n) const {
    const std::string digits = std::to_string(n);
    return n == 1 ? "" : latex_ ? "^{" + digits + "}" : "^" + digits;
  }

  [[nodiscard]] std::string power(const Power& p, Place place) const {
    if (is_sum(p)) {
      return "(" + sum(p.sum, Place::inside) + ")" + exponent(p.exponent);
    }
    switch (p.atom.kind) {
      case Atom::Kind::pi:
      case Atom::Kind::symbol:
        return (latex_ ? latex_name(p.atom.name) : p.atom.name) + exponent(p.exponent);
      case Atom::Kind::trigonometric:
        return latex_ ? trigonometric(p, place) : call(p.atom) + exponent(p.exponent);
      case Atom::Kind::function:
        break;
    }
    return function(p, place);
  }

  // \cos\omega_1 t, \cos^{2}\omega_1 t, \cos\frac{\omega\tau}{2}, \cos(\omega t+\varphi).
  [[nodiscard]] std::string trigonometric(const Power& p, Place place) const {
    const std::string name = "\\" + p.atom.name + exponent(p.exponent);
    const Sum& argument = p.atom.arguments[0];
    const bool fits = argument[0].denominator.is_one() || place != Place::inside;
    if (argument.size() == 1 && fits && is_plain(argument[0].numerator) &&
        is_plain(argument[0].denominator)) {
      return joined(name, magnitude(argument[0], place));
    }
    return name + "(" + arguments(p.atom) + ")";
  }

  [[nodiscard]] std::string function(const Power& p, Place place) const {
    const Atom& atom = p.atom;
    if (atom.name == "root") {
      return root(p, place);
    }
    if (!latex_) {
      return call(atom) + exponent(p.exponent);
    }
    if (atom.name == "abs") {
      return "|" + arguments(atom) + "|" + exponent(p.exponent);
    }
    return "\\operatorname{" + atom.name + "}" + exponent(p.exponent) + "(" + arguments(atom) + ")";
  }

  [[nodiscard]] std::string root(const Power& p, Place place) const {
    const std::string degree = fraction(p.atom.arguments[1][0], Place::inside);
    if (!latex_) {
      const std::string radicand = fraction(p.atom.arguments[0][0], Place::inside);
      return (degree == "2" ? "sqrt(" + radicand : "root(" + radicand + ", " + degree) + ")" +
             exponent(p.exponent);
    }
    const std::string sign = "\\sqrt" + (degree == "2" ? "" : "[" + degree + "]") + "{" +
                             fraction(p.atom.arguments[0][0], place) + "}";
    return p.exponent == 1 ? sign : "(" + sign + ")" + exponent(p.exponent);
  }

  [[nodiscard]] std::string call(const Atom& atom) const { return atom.name + "(" + arguments(atom) + ")"; }

  [[nodiscard]] std::string arguments(const Atom& atom) const {
    std::string result;
    for (const Sum& argument : atom.arguments) {
      result += result.empty() ? "" : latex_ ? "," : ", ";
      result += argument.size() == 1 ? fraction(argument[0], Place::inside) : sum(argument, Place::inside);
    }
    return result;
  }

  bool latex_;
};

std::string print(const Fraction& fraction, Style style, Place place = Place::display) {
  return Printer(style).fraction(without_leading_minus(fraction), place);
}

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

// entries[i] = factor · rest[i], factor being what all nonzero entries have in common and signed so that the
// first nonzero rest is positive; factor is 1 unless at least two entries are nonzero and share a
// denominator.
struct Common {
  Fraction factor;
  std::vector<Fraction> rest;
};
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

}  // namespace

std::string latex(const ex& expression) {
  return print(arrange(expression), Style::latex);
}

std::string text(const ex& expression) {
  return print(arrange(expression), Style::text);
}

std::string latex(const std::vector<ex>& entries, std::size_t columns) {
  std::vector<Fraction> arranged;
  std::transform(entries.begin(), entries.end(), std::back_inserter(arranged), arrange);
  const Common common = take_common_factor(std::move(arranged));
  std::vector<std::string> printed;
  std::transform(common.rest.begin(), common.rest.end(), std::back_inserter(printed),
                 [](const Fraction& entry) { return print(entry, Style::latex, Place::entry); });
  const bool tall = std::any_of(printed.begin(), printed.end(), [](const std::string& entry) {
    return entry.find("\\dfrac") != std::string::npos;
  });
  std::string result = common.factor.denominator.is_one() ? "" : print(common.factor, Style::latex);
  result += "\\begin{pmatrix}\n";
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const bool ends_row = (i + 1) % columns == 0;
    const bool ends = i + 1 == printed.size();
    result += printed[i] + (ends ? "\n" : !ends_row ? " & " : tall ? " \\\\[8pt]\n" : " \\\\\n");
  }
  return result + "\\end{pmatrix}";
}

}  // namespace stickslip::symbolic::typeset
