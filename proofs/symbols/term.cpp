#include "proofs/symbols/term.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace stickslip::proofs::symbols {
namespace {

std::string to_string(const Shape& shape) {
  return fmt::format("{}x{}", shape.rows, shape.columns);
}

[[noreturn]] void misfit(const std::string& what, const Term& a, const Term& b) {
  throw InternalError(fmt::format("{} of a {} ({}) and a {} ({})", what, to_string(a.shape()), text(a),
                                  to_string(b.shape()), text(b)));
}

// Zero takes the shape of what it stands beside.
Shape common_shape(const std::string& what, const Term& a, const Term& b) {
  if (a.is_zero() || a.shape() == b.shape()) {
    return b.shape();
  }
  if (!b.is_zero()) {
    misfit(what, a, b);
  }
  return a.shape();
}

Shape sum_shape(const std::vector<Term>& terms) {
  Term first = terms.front();
  for (const Term& term : terms) {
    if (common_shape("sum", first, term) != first.shape()) {
      first = term;
    }
  }
  return first.shape();
}

Shape product_shape(const std::vector<Term>& factors) {
  Term first = factors.front();
  Shape shape = first.shape();
  for (auto it = factors.begin() + 1; it != factors.end(); ++it) {
    if (shape.is_scalar()) {
      shape = it->shape();
    } else if (!it->shape().is_scalar()) {
      if (shape.columns != it->shape().rows) {
        misfit("product", first, *it);
      }
      shape.columns = it->shape().columns;
    }
    first = *it;
  }
  return shape;
}

void require_square(const std::string& what, const Term& a) {
  if (a.shape().rows != a.shape().columns) {
    throw InternalError(fmt::format("{} of {}, which is {}", what, text(a), to_string(a.shape())));
  }
}

Shape block_shape(int block_rows, const std::vector<Term>& blocks) {
  const auto per_row = blocks.size() / static_cast<std::size_t>(block_rows);
  Shape total{0, 0};
  for (std::size_t row = 0; row < static_cast<std::size_t>(block_rows); ++row) {
    int columns = 0;
    for (std::size_t k = 0; k < per_row; ++k) {
      const Term& here = blocks[row * per_row + k];
      if (here.shape().rows != blocks[row * per_row].shape().rows ||
          here.shape().columns != blocks[k].shape().columns) {
        misfit("block matrix", blocks[row * per_row], here);
      }
      columns += here.shape().columns;
    }
    total.rows += blocks[row * per_row].shape().rows;
    total.columns = columns;
  }
  return total;
}

// Terms of a sum, products' factors: nested ones are joined, as they would print.
std::vector<Term> joined(Op op, const Term& a, const Term& b) {
  std::vector<Term> all = a.op() == op ? a.arguments() : std::vector<Term>{a};
  if (op == Op::product && b.op() == op) {
    all.insert(all.end(), b.arguments().begin(), b.arguments().end());
  } else {
    all.push_back(b);
  }
  return all;
}

Term make(Op op, Shape shape, std::vector<Term> arguments, const Rational& number = 0,
          std::string_view name = {}) {
  return Term(Term::Node{op, shape, std::string(name), number, std::move(arguments)});
}

}  // namespace

Term::Term(int value) : Term(Rational(value)) {}
Term::Term(const Rational& value) : Term(Node{Op::number, {}, {}, value, {}}) {}
Term::Term(Node node) : node_(std::make_shared<const Node>(std::move(node))) {}

Term Term::with_arguments(std::vector<Term> arguments) const {
  Shape shape = this->shape();
  switch (op()) {
    case Op::number:
    case Op::symbol:
      return *this;
    case Op::sum:
      shape = sum_shape(arguments);
      break;
    case Op::product:
      shape = product_shape(arguments);
      break;
    case Op::block:
      shape = block_shape(static_cast<int>(number().get_num().get_si()), arguments);
      break;
    case Op::quotient:
    case Op::negate:
    case Op::derivative:
    case Op::power:
      shape = arguments.front().shape();
      break;
    case Op::function:
    case Op::determinant:
      break;
  }
  return make(op(), shape, std::move(arguments), number(), name());
}

Term scalar(std::string_view name) {
  return make(Op::symbol, {}, {}, 0, name);
}
Term vector(std::string_view name, int rows) {
  return make(Op::symbol, {rows, 1}, {}, 0, name);
}
Term matrix(std::string_view name, int size) {
  return make(Op::symbol, {size, size}, {}, 0, name);
}
Term pi() {
  return scalar("pi");
}
Term zero(int rows, int columns) {
  return make(Op::number, {rows, columns}, {});
}
Term identity(int size) {
  return matrix("I", size);
}

Term Function::operator()(const Term& argument) const {
  return make(Op::function, shape, {argument}, 0, name);
}

Term cos(const Term& argument) {
  return Function{"cos", {}}(argument);
}
Term sin(const Term& argument) {
  return Function{"sin", {}}(argument);
}
Term tan(const Term& argument) {
  return Function{"tan", {}}(argument);
}
Term exp(const Term& argument) {
  return Function{"exp", {}}(argument);
}
Term sqrt(const Term& argument) {
  return Function{"sqrt", {}}(argument);
}

Term abs(const Term& argument) {
  return Function{"abs", {}}(argument);
}

Term sign(const Term& argument) {
  return Function{"sign", {}}(argument);
}

Term operator+(const Term& a, const Term& b) {
  std::vector<Term> terms = joined(Op::sum, a, b);
  const Shape shape = sum_shape(terms);
  return make(Op::sum, shape, std::move(terms));
}

Term operator-(const Term& a, const Term& b) {
  return a + (-b);
}

Term operator*(const Term& a, const Term& b) {
  std::vector<Term> factors = joined(Op::product, a, b);
  const Shape shape = product_shape(factors);
  return make(Op::product, shape, std::move(factors));
}

Term operator/(const Term& a, const Term& b) {
  if (!b.shape().is_scalar()) {
    misfit("quotient", a, b);
  }
  return make(Op::quotient, a.shape(), {a, b});
}

Term operator-(const Term& a) {
  return make(Op::negate, a.shape(), {a});
}

Term power(const Term& base, int exponent) {
  require_square("a power", base);
  return make(Op::power, base.shape(), {base}, exponent);
}

Term inverse(const Term& square) {
  return power(square, -1);
}

Term derivative(const Term& a) {
  return make(Op::derivative, a.shape(), {a});
}

Term determinant(const Term& square) {
  require_square("the determinant", square);
  return make(Op::determinant, {}, {square});
}

Term block(int block_rows, std::vector<Term> blocks) {
  const Shape shape = block_shape(block_rows, blocks);
  return make(Op::block, shape, std::move(blocks), block_rows);
}

Term column(std::vector<Term> entries) {
  const int rows = static_cast<int>(entries.size());
  return block(rows, std::move(entries));
}

Term substitute(const Term& term, const Replacements& replacements) {
  if (term.op() == Op::symbol) {
    const auto found = replacements.find(term.name());
    if (found == replacements.end()) {
      return term;
    }
    if (term.shape() != found->second.shape()) {
      misfit("substitution", term, found->second);
    }
    return found->second;
  }
  std::vector<Term> arguments;
  for (const Term& argument : term.arguments()) {
    arguments.push_back(substitute(argument, replacements));
  }
  return term.with_arguments(std::move(arguments));
}

Statement substitute(const Statement& statement, const Replacements& replacements) {
  Statement result = statement;
  Replacements within = replacements;
  if (statement.during) {
    result.during = Times{substitute(statement.during->from, replacements),
                          substitute(statement.during->to, replacements), statement.during->almost};
    within.erase("t");  // which is every time between
  }
  result.left = substitute(statement.left, within);
  result.right = substitute(statement.right, within);
  return result;
}

Statement with_less(Statement statement) {
  const bool strict = statement.relation == Relation::greater;
  if (strict || statement.relation == Relation::greater_or_equal) {
    std::swap(statement.left, statement.right);
    statement.relation = strict ? Relation::less : Relation::less_or_equal;
  }
  return statement;
}

bool equal(const Term& a, const Term& b) {
  return a.op() == b.op() && a.name() == b.name() && a.number() == b.number() && a.shape() == b.shape() &&
         std::equal(a.arguments().begin(), a.arguments().end(), b.arguments().begin(), b.arguments().end(),
                    [](const Term& x, const Term& y) { return equal(x, y); });
}

bool equal(const Statement& a, const Statement& b) {
  const bool same_times =
      a.during.has_value() == b.during.has_value() &&
      (!a.during || (a.during->almost == b.during->almost && equal(a.during->from, b.during->from) &&
                     equal(a.during->to, b.during->to)));
  return same_times && a.relation == b.relation && equal(a.left, b.left) && equal(a.right, b.right);
}

}  // namespace stickslip::proofs::symbols
