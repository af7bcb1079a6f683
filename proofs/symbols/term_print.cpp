// Terms as LaTeX and as plain text: one walk over the tree, two vocabularies.
#include <fmt/format.h>

#include <array>

#include "proofs/symbols/term.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::proofs::symbols {
namespace {

enum class Style { latex, text };

// How tightly a piece of output holds together.
enum Binding { sum_binding, product_binding, atom_binding };

struct Piece {
  std::string text;
  Binding binding;
};

Piece print(const Term& term, Style style);

std::string parenthesised(const std::string& inside, Style style) {
  return style == Style::latex ? fmt::format("\\left({}\\right)", inside) : fmt::format("({})", inside);
}

// The term, in parentheses unless it binds at least that tightly.
std::string at_least(const Term& term, Binding binding, Style style) {
  const Piece piece = print(term, style);
  return piece.binding >= binding ? piece.text : parenthesised(piece.text, style);
}

std::string name_of(const std::string& name, Style style) {
  return style == Style::latex ? symbolic::typeset::latex_name(name) : name;
}

bool is_elementary(const Term& term) {
  return term.op() == Op::function && symbols::is_elementary(term.name());
}
// What is printed around its argument: |x|, and the root of x, to which exponents stand behind.
bool is_around(const Term& term) {
  return term.op() == Op::function && (term.name() == "abs" || term.name() == "sqrt");
}

// H_1(t), H_1^{2}(t), F'(t), \cos(\omega t): `decoration` stands between name and argument.
std::string application(const Term& function, const std::string& decoration, Style style) {
  const std::string argument = print(function.arguments().front(), style).text;
  if (is_around(function)) {
    const bool root = function.name() == "sqrt";
    const std::string shown = style == Style::latex
                                  ? (root ? "\\sqrt{" + argument + "}" : "\\left|" + argument + "\\right|")
                                  : (root ? "sqrt(" + argument + ")" : "|" + argument + "|");
    return shown + decoration;
  }
  const std::string name = style == Style::text        ? function.name()
                           : is_elementary(function)   ? "\\" + function.name()
                           : function.name() == "sign" ? "\\operatorname{sign}"
                                                       : name_of(function.name(), style);
  return fmt::format("{}{}({})", name, decoration, argument);
}

// Whether the term is printed with a minus sign in front: -x, -2, and x y where x is.
bool has_minus(const Term& term) {
  return term.op() == Op::negate || (term.op() == Op::number && term.number() < 0) ||
         (term.op() == Op::product && has_minus(term.arguments().front()));
}

Piece print_sum(const Term& sum, Style style) {
  std::string result;
  for (const Term& term : sum.arguments()) {
    // A sum inside a sum was printed in parentheses.
    const std::string shown =
        has_minus(term) ? print(term, style).text.substr(1) : at_least(term, product_binding, style);
    result += (result.empty() ? has_minus(term) ? "-" : "" : has_minus(term) ? " - " : " + ") + shown;
  }
  return {result, sum_binding};
}

// The sign of the first factor is that of the product.
Piece print_product(const Term& product, Style style) {
  std::string result;
  for (const Term& factor : product.arguments()) {
    const bool first = result.empty();
    if (first && has_minus(factor)) {
      result += print(factor, style).text;
      continue;
    }
    if (!first) {
      result += style == Style::latex ? " " : "*";
    }
    const bool tight = style == Style::text && factor.op() == Op::quotient && !first;
    result += at_least(factor, tight ? atom_binding : product_binding, style);
  }
  return {result, has_minus(product) ? sum_binding : product_binding};
}

Piece print_quotient(const Term& quotient, Style style) {
  const Term& above = quotient.arguments()[0];
  const Term& below = quotient.arguments()[1];
  if (style == Style::latex) {
    return {fmt::format("\\frac{{{}}}{{{}}}", print(above, style).text, print(below, style).text),
            atom_binding};
  }
  return {at_least(above, product_binding, style) + "/" + at_least(below, atom_binding, style),
          product_binding};
}

Piece print_power(const Term& power, Style style) {
  const Term& base = power.arguments().front();
  const std::string exponent = style == Style::latex ? fmt::format("^{{{}}}", power.number().get_str())
                                                     : "^" + power.number().get_str();
  const bool like_arccos = is_elementary(base) && !is_around(base) && power.number() < 0;
  if (base.op() == Op::function && !like_arccos) {
    return {application(base, exponent, style), atom_binding};
  }
  const bool simple = base.op() == Op::symbol || (base.op() == Op::number && !has_minus(base));
  const std::string inside = print(base, style).text;
  return {(simple ? inside : parenthesised(inside, style)) + exponent, atom_binding};
}

Piece print_derivative(const Term& term, Style style) {
  std::string primes;
  Term inside = term;
  while (inside.op() == Op::derivative) {
    primes += "'";
    inside = Term(inside.arguments().front());
  }
  if (inside.op() == Op::function && !is_around(inside) && equal(inside.arguments().front(), scalar("t"))) {
    return {application(inside, primes, style), atom_binding};
  }
  const bool once = primes.size() == 1;
  if (style == Style::text) {
    return {fmt::format("{}[{}]", once ? "d/dt" : "d^2/dt^2", print(inside, style).text), atom_binding};
  }
  return {fmt::format("{}\\left[{}\\right]", once ? "\\frac{d}{dt}" : "\\frac{d^{2}}{dt^{2}}",
                      print(inside, style).text),
          atom_binding};
}

// As a matrix, or between the bars of a determinant.
enum class Fence { matrix, determinant };

Piece print_block(const Term& matrix, Style style, Fence fence) {
  const auto rows = static_cast<std::size_t>(matrix.number().get_num().get_si());
  const auto per_row = matrix.arguments().size() / rows;
  std::string result;
  for (std::size_t i = 0; i < matrix.arguments().size(); ++i) {
    if (i > 0) {
      const bool new_row = i % per_row == 0;
      result += style == Style::latex ? (new_row ? " \\\\ " : " & ") : (new_row ? "; " : ", ");
    }
    result += print(matrix.arguments()[i], style).text;
  }
  const char * const environment = fence == Fence::matrix ? "pmatrix" : "vmatrix";
  return {style == Style::latex ? fmt::format("\\begin{{{0}}} {1} \\end{{{0}}}", environment, result)
                                : fmt::format("[{}]", result),
          atom_binding};
}

Piece print_determinant(const Term& matrix, Style style) {
  const bool latex = style == Style::latex;
  if (latex && matrix.op() == Op::block) {
    return print_block(matrix, style, Fence::determinant);
  }
  return {(latex ? "\\det" : "det") + parenthesised(print(matrix, style).text, style), atom_binding};
}

Piece print_number(const Term& term, Style style) {
  const Rational& value = term.number();
  if (style == Style::latex && value.get_den() != 1) {
    return {fmt::format("{}\\frac{{{}}}{{{}}}", value < 0 ? "-" : "",
                        mpz_class(abs(value.get_num())).get_str(), value.get_den().get_str()),
            value < 0 ? sum_binding : atom_binding};
  }
  return {value.get_str(), value < 0 ? sum_binding : value.get_den() == 1 ? atom_binding : product_binding};
}

Piece print(const Term& term, Style style) {
  switch (term.op()) {
    case Op::number:
      return print_number(term, style);
    case Op::symbol:
      return {name_of(term.name(), style), atom_binding};
    case Op::function:
      return {application(term, {}, style), atom_binding};
    case Op::sum:
      return print_sum(term, style);
    case Op::product:
      return print_product(term, style);
    case Op::quotient:
      return print_quotient(term, style);
    case Op::power:
      return print_power(term, style);
    case Op::negate:
      return {"-" + at_least(term.arguments().front(), product_binding, style), sum_binding};
    case Op::derivative:
      return print_derivative(term, style);
    case Op::block:
      return print_block(term, style, Fence::matrix);
    case Op::determinant:
      return print_determinant(term.arguments().front(), style);
  }
  return {{}, atom_binding};
}

std::string symbol_of(Relation relation, Style style) {
  constexpr std::array in_latex{"=", "\\neq", "<", "\\leq", ">", "\\geq"},
      in_text{"=", "!=", "<", "<=", ">", ">="};
  return (style == Style::latex ? in_latex : in_text).at(static_cast<std::size_t>(relation));
}

std::string print(const Statement& statement, Style style) {
  const std::string relation =
      fmt::format("{} {} {}", print(statement.left, style).text, symbol_of(statement.relation, style),
                  print(statement.right, style).text);
  if (!statement.during) {
    return relation;
  }
  const bool latex = style == Style::latex;
  const std::string from = print(statement.during->from, style).text,
                    to = print(statement.during->to, style).text;
  std::string result = fmt::format("{},{} {} < t < {}", relation, latex ? R"( \quad)" : "", from, to);
  if (statement.during->almost) {
    result += latex ? R"( \text{ but for finitely many } t)" : " but for finitely many t";
  }
  // What is differentiated is also continuous, with the ends.
  if (statement.left.op() == Op::derivative) {
    result += fmt::format(
        fmt::runtime(latex ? R"(, \text{{ continuous on }} [{}, {}])" : ", continuous on [{}, {}]"), from,
        to);
  }
  return result;
}

}  // namespace

std::string latex(const Term& term) {
  return print(term, Style::latex).text;
}
std::string latex(const Statement& statement) {
  return print(statement, Style::latex);
}
std::string text(const Term& term) {
  return print(term, Style::text).text;
}
std::string text(const Statement& statement) {
  return print(statement, Style::text);
}

}  // namespace stickslip::proofs::symbols
