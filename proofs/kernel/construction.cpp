#include <algorithm>

#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

Term make(Kind kind, std::vector<Term> parts) {
  return Node::make({.kind = kind, .parts = std::move(parts)});
}

Term binder(Kind kind, const Variable& variable, const Term& body) {
  return Node::make(
      {.kind = kind, .parts = {abstracted(body, variable)}, .name = variable.name, .binds = variable.type});
}

}  // namespace

Term::Term(const Variable& variable)
    : Term(Node::make({.kind = Kind::variable, .parts = {}, .name = variable.name, .binds = variable.type})) {
}
Term::Term(const Number& value) : Term(Node::make({.kind = Kind::number, .parts = {}, .value = value})) {}
Term::Term(int value) : Term(Number(value)) {}
Term::Term(long value) : Term(Number(value)) {}
Term::Term(const Rational& value) : Term(Number(value)) {}

Number::Number(Rational value) : value_(std::move(value)) {
  require(value_.get_den() != 0, "a number has no denominator 0");
  value_.canonicalize();
}

Type real_matrix(int rows, int columns) {
  const Type type{Sort::real, rows, columns};
  static_cast<void>(Term(Variable{"A", type}));  // checks the shape
  return type;
}

Type function_of_time(int rows, int columns) {
  const Type values = real_matrix(rows, columns);
  return {Sort::function, values.rows, values.columns};
}

Term pi() {
  return make(Kind::pi, {});
}
Term sum(const std::vector<Term>& parts) {
  return make(Kind::sum, parts);
}
Term operator+(const Term& a, const Term& b) {
  return sum({a, b});
}
Term operator-(const Term& a, const Term& b) {
  return a + -b;
}
Term operator-(const Term& a) {
  return a.kind() == Kind::number ? Term(Number(-a.value())) : Term(-1) * a;
}
Term operator*(const Term& a, const Term& b) {
  return make(Kind::product, {a, b});
}
Term operator/(const Term& a, const Term& b) {
  require(b.type().is_scalar(), "one divides by numbers only");
  return a * inverse(b);
}
Term power(const Term& base, long exponent) {
  return Node::make({.kind = Kind::power, .parts = {base}, .value = exponent});
}
Term inverse(const Term& a) {
  return make(Kind::inverse, {a});
}
Term cos(const Term& a) {
  return make(Kind::cosine, {a});
}
Term sin(const Term& a) {
  return make(Kind::sine, {a});
}
Term exp(const Term& a) {
  return make(Kind::exponential, {a});
}
Term tan(const Term& a) {
  return sin(a) / cos(a);
}
Term matrix(int rows, int columns, const std::vector<Term>& entries) {
  return Node::make({.kind = Kind::matrix, .parts = entries, .row = rows, .column = columns});
}
Term entry(const Term& a, int row, int column) {
  return Node::make({.kind = Kind::entry, .parts = {a}, .row = row, .column = column});
}

Term zero(const Type& type) {
  if (type.is_scalar()) {
    return 0;
  }
  return matrix(type.rows, type.columns,
                std::vector<Term>(static_cast<std::size_t>(type.rows * type.columns), 0));
}

Term identity(int rows) {
  std::vector<Term> entries;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      entries.emplace_back(i == j ? 1 : 0);
    }
  }
  return matrix(rows, rows, entries);
}

namespace {

// The entries of a square matrix.
std::vector<Term> entries_of(const Term& a) {
  const int n = a.type().rows;
  require(a.type().is_numeric() && a.type().columns == n, "only a square matrix has a determinant");
  std::vector<Term> entries = a.kind() == Kind::matrix ? a.parts() : std::vector<Term>{};
  for (int i = static_cast<int>(entries.size()); i < n * n; ++i) {
    entries.push_back(entry(a, i / n, i % n));
  }
  return entries;
}

// Of n rows of entries, without one row and one column.
std::vector<Term> minor(const std::vector<Term>& entries, std::size_t n, std::size_t row,
                        std::size_t column) {
  std::vector<Term> result;
  for (std::size_t i = 0; i < n * n; ++i) {
    if (i / n != row && i % n != column) {
      result.push_back(entries[i]);
    }
  }
  return result;
}

Term laplace(const std::vector<Term>& entries, std::size_t n) {
  if (n <= 1) {
    return n == 0 ? Term(1) : entries[0];
  }
  std::vector<Term> parts;
  for (std::size_t k = 0; k < n; ++k) {
    const Term part = entries[k] * laplace(minor(entries, n, 0, k), n - 1);
    parts.push_back(k % 2 == 0 ? part : -part);
  }
  return sum(parts);
}

}  // namespace

Term determinant(const Term& a) {
  return laplace(entries_of(a), static_cast<std::size_t>(a.type().rows));
}

Term adjugate(const Term& a) {
  const std::vector<Term> entries = entries_of(a);
  const auto n = static_cast<std::size_t>(a.type().rows);
  std::vector<Term> cofactors;
  for (std::size_t i = 0; i < n * n; ++i) {
    const Term one = laplace(minor(entries, n, i % n, i / n), n - 1);
    cofactors.push_back((i / n + i % n) % 2 == 0 ? one : -one);
  }
  return matrix(a.type().rows, a.type().rows, cofactors);
}

Term lambda(const Variable& variable, const Term& body) {
  return binder(Kind::lambda, variable, body);
}
Term apply(const Term& function, const Term& time) {
  return make(Kind::apply, {function, time});
}

Formula equal(const Term& a, const Term& b) {
  return make(Kind::equal, {a, b});
}
Formula differ(const Term& a, const Term& b) {
  return negation(equal(a, b));
}
Formula less(const Term& a, const Term& b) {
  return make(Kind::less, {a, b});
}
Formula at_most(const Term& a, const Term& b) {
  return make(Kind::at_most, {a, b});
}
Formula all(const std::vector<Formula>& parts) {
  return make(Kind::conjunction, parts);
}
Formula any(const std::vector<Formula>& parts) {
  return make(Kind::disjunction, parts);
}
Formula negation(const Formula& a) {
  return make(Kind::negation, {a});
}
Formula implies(const Formula& a, const Formula& b) {
  return make(Kind::implication, {a, b});
}
Formula for_all(const Variable& variable, const Formula& body) {
  return binder(Kind::for_all, variable, body);
}
Formula exists(const Variable& variable, const Formula& body) {
  return binder(Kind::exists, variable, body);
}
Formula derivative(const Term& function, const Term& point, const Term& value) {
  return make(Kind::derivative, {function, point, value});
}
Formula continuous(const Term& function, const Term& a, const Term& b) {
  return make(Kind::continuous, {function, a, b});
}
Formula finite(const Variable& variable, const Formula& body) {
  return binder(Kind::finite, variable, body);
}
Formula inside_unit_circle(const Term& coefficients) {
  return make(Kind::inside_unit_circle, {coefficients});
}
Formula between(const Term& a, const Term& t, const Term& b) {
  return all({less(a, t), less(t, b)});
}
Formula within(const Term& a, const Term& t, const Term& b) {
  return all({at_most(a, t), at_most(t, b)});
}

Definition::Definition(const std::string& name, const std::vector<Variable>& parameters, const Term& body)
    : data_(std::make_shared<const Data>(Data{name, parameters, body})) {
  require(!name.empty(), "a definition has a name");
  require(body.is_closed() && body.type().sort != Sort::function,
          "a definition stands for no function of time");
  std::set<std::string> names;
  for (const Variable& parameter : parameters) {
    static_cast<void>(Term(parameter));
    require(names.insert(parameter.name).second, "two parameters of a definition have one name");
  }
  for (const Variable& free : body.variables()) {
    require(std::find(parameters.begin(), parameters.end(), free) != parameters.end(),
            "a definition has a free variable that is no parameter");
  }
}

Term Definition::operator()(const std::vector<Term>& arguments) const {
  return Node::make({.kind = Kind::defined, .parts = arguments, .definition = *this});
}

Term Definition::unfolded(const std::vector<Term>& arguments) const {
  static_cast<void>((*this)(arguments));  // checks them
  Substitution substitution;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    substitution.emplace(parameters()[i], arguments[i]);
  }
  return substitute(body(), substitution);
}

std::strong_ordering operator<=>(const Definition& a, const Definition& b) {
  return a.data_ == b.data_ ? std::strong_ordering::equal : *a.data_ <=> *b.data_;
}

}  // namespace stickslip::proofs::kernel
