// Printed formulas as ordered trees.
//
// A statement of the paper is kept as it stands there: the order of terms and factors, the signs and the
// names are the paper's. LaTeX prints this very tree, evaluation substitutes the model's matrices, rewriting
// reads it as a noncommutative polynomial. (A computer-algebra expression would reorder and merge at once,
// and with it lose what was printed and the places at which a misprint can sit.)
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/rational.hpp"

namespace stickslip::proofs::symbols {

// A name has no meaning, as a motion Z(t) has none by itself; or what has one has no value, or no print.
struct NoValue : InternalError {
  using InternalError::InternalError;
};

struct Shape {
  int rows = 1;
  int columns = 1;
  friend bool operator==(const Shape&, const Shape&) = default;
  [[nodiscard]] bool is_scalar() const { return rows == 1 && columns == 1; }
};

enum class Op {
  number,      // a rational number
  symbol,      // a name: scalar, vector or matrix
  function,    // a named function of scalar arguments: H_1(t), cos(omega t)
  sum,         // of its arguments, in order; a negate() among them prints as a minus sign
  product,     // of its arguments, in order
  quotient,    // scalar or matrix over scalar
  power,       // the argument to a whole exponent (stored in number); -1 of a matrix is its inverse
  negate,      //
  derivative,  // d/dt of the argument, t the symbol of that name
  block,       // a matrix of blocks, rows of equal length (their count is stored in number)
  determinant,
};

// Immutable; copies share the tree. Every constructor below checks shapes and throws InternalError when they
// do not fit, so that a formula without meaning cannot be built.
class Term {
 public:
  Term(int value);  // NOLINT: 0, 1, 2 in a formula
  explicit Term(const Rational& value);

  [[nodiscard]] Op op() const { return node_->op; }
  [[nodiscard]] Shape shape() const { return node_->shape; }
  [[nodiscard]] const std::string& name() const { return node_->name; }   // of a symbol or function
  [[nodiscard]] const Rational& number() const { return node_->number; }  // see Op
  [[nodiscard]] const std::vector<Term>& arguments() const { return node_->arguments; }
  [[nodiscard]] bool is_zero() const { return op() == Op::number && number() == 0; }

  // The same node over other arguments; shapes are checked again.
  [[nodiscard]] Term with_arguments(std::vector<Term> arguments) const;

  struct Node {
    Op op = Op::number;
    Shape shape;
    std::string name;
    Rational number;
    std::vector<Term> arguments;
  };
  explicit Term(Node node);

 private:
  std::shared_ptr<const Node> node_;
};

[[nodiscard]] Term scalar(std::string_view name);
[[nodiscard]] Term vector(std::string_view name, int rows);
[[nodiscard]] Term matrix(std::string_view name, int size);
[[nodiscard]] Term pi();
// The zero matrix or vector of that shape (a plain 0 takes the shape of what it stands beside, except in
// blocks).
[[nodiscard]] Term zero(int rows, int columns);
// I of the given size.
[[nodiscard]] Term identity(int size);

// A named function of one scalar, with values of the given shape: Function{"H1", {2, 2}}(t).
struct Function {
  std::string_view name;  // of a literal, or of what outlives this
  Shape shape;
  [[nodiscard]] Term operator()(const Term& argument) const;
};

// What every paper has, and nothing else may be called.
inline constexpr std::array elementary_functions{"cos", "sin", "tan", "exp", "sqrt"};
[[nodiscard]] inline bool is_elementary(std::string_view name) {
  return std::ranges::find(elementary_functions, name) != elementary_functions.end();
}
[[nodiscard]] Term cos(const Term& argument);
[[nodiscard]] Term sin(const Term& argument);
[[nodiscard]] Term tan(const Term& argument);
[[nodiscard]] Term exp(const Term& argument);
// The number that is not negative and whose square is the argument.
[[nodiscard]] Term sqrt(const Term& argument);
// |argument|: printed and evaluated in balls, but the kernel has no term for it.
[[nodiscard]] Term abs(const Term& argument);
// 1 or -1, the sign of the argument; only for times at which that is not 0.
[[nodiscard]] Term sign(const Term& argument);

[[nodiscard]] Term operator+(const Term& a, const Term& b);
[[nodiscard]] Term operator-(const Term& a, const Term& b);
[[nodiscard]] Term operator*(const Term& a, const Term& b);
[[nodiscard]] Term operator/(const Term& a, const Term& b);
[[nodiscard]] Term operator-(const Term& a);
[[nodiscard]] Term power(const Term& base, int exponent);
[[nodiscard]] Term inverse(const Term& square);
[[nodiscard]] Term derivative(const Term& a);
[[nodiscard]] Term determinant(const Term& square);
// Blocks row by row: block(2, {H1(t), H2(t), H3(t), H1(t)}) is [[H1, H2], [H3, H1]].
[[nodiscard]] Term block(int block_rows, std::vector<Term> blocks);
// a above b.
[[nodiscard]] Term column(std::vector<Term> entries);

// Symbols replaced, all at once.
using Replacements = std::map<std::string, Term>;
[[nodiscard]] Term substitute(const Term& term, const Replacements& replacements);

[[nodiscard]] bool equal(const Term& a, const Term& b);

enum class Relation { equal, not_equal, less, less_or_equal, greater, greater_or_equal };

// From one time to another, at all times between or at all but finitely many.
struct Times {
  Term from, to;
  bool almost = false;
};

// "left relation right", as printed; of a motion, at all times t between, perhaps but for finitely many.
struct Statement {
  Term left = 0;
  Term right = 0;
  Relation relation = Relation::equal;
  std::optional<Times> during = {};
};

[[nodiscard]] inline Statement equation(const Term& left, const Term& right) {
  return {left, right, Relation::equal};
}
[[nodiscard]] inline Statement during(const Term& from, const Term& to, Statement statement) {
  statement.during = Times{from, to};
  return statement;
}
[[nodiscard]] inline Statement almost_always(const Term& from, const Term& to, Statement statement) {
  statement.during = Times{from, to, true};
  return statement;
}
[[nodiscard]] Statement substitute(const Statement& statement, const Replacements& replacements);
// b < a for a > b, b <= a for a >= b; any other as it is.
[[nodiscard]] Statement with_less(Statement statement);
[[nodiscard]] bool equal(const Statement& a, const Statement& b);

// As LaTeX, and as one line of plain text for a terminal.
[[nodiscard]] std::string latex(const Term& term);
[[nodiscard]] std::string latex(const Statement& statement);
[[nodiscard]] std::string text(const Term& term);
[[nodiscard]] std::string text(const Statement& statement);

}  // namespace stickslip::proofs::symbols
