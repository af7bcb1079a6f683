// What can be said: terms with sorts and shapes, binders locally nameless, equality by structure.
//
// Sorts: real matrices r×c (a number is 1×1), functions of time R → R^{r×c}, and formulas. Every function is
// total: an inverse that does not exist is some matrix that nobody knows anything about, so that a term
// always means something and only rules need conditions.
//
// A Term is immutable and well-formed: each constructor here checks sorts and shapes and throws KernelError.
// Names matter for free variables only, together with their type; what a binder binds is an index. Nothing is
// ever compared or looked up by printed text.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proofs/kernel/number.hpp"

namespace stickslip::proofs::kernel {

// Something divides by what is zero.
struct ZeroDivisor : KernelError {
  using KernelError::KernelError;
};

enum class Sort { real, function, formula };

struct Type {
  Sort sort = Sort::real;
  int rows = 1;  // of a matrix, or of a function's value
  int columns = 1;

  friend auto operator<=>(const Type&, const Type&) = default;
  [[nodiscard]] bool is_numeric() const { return sort == Sort::real; }
  [[nodiscard]] bool is_scalar() const { return is_numeric() && rows == 1 && columns == 1; }
};
inline constexpr Type real_number{};
inline constexpr Type truth_value{Sort::formula, 1, 1};
// Throw KernelError unless 1 <= rows, columns <= 64.
[[nodiscard]] Type real_matrix(int rows, int columns);
[[nodiscard]] Type function_of_time(int rows = 1, int columns = 1);

// A variable is its name and its type together.
struct Variable {
  std::string name;
  Type type = real_number;

  friend auto operator<=>(const Variable&, const Variable&) = default;
};
class Term;
class Definition;
// The order of sets and maps in the kernel: compiled with it, where nobody else's std::less reaches.
struct Before {
  bool operator()(const Variable& a, const Variable& b) const;
  bool operator()(const Term& a, const Term& b) const;
  bool operator()(const Definition& a, const Definition& b) const;
};
using Variables = std::set<Variable, Before>;

// clang-format off
enum class Kind {
  variable, bound, number, pi, sum, product, power, inverse, cosine, sine, matrix, entry, defined,  // numeric
  lambda, apply,
  equal, less, at_most, conjunction, disjunction, negation, implication, for_all, exists,  // formulas
  derivative, continuous, finite, inside_unit_circle,
  exponential,  // numeric; last, for the order of terms rests on the numbers of the others
};
// clang-format on

struct Node;

class Term {
 public:
  Term(const Variable& variable);  // NOLINT: throws KernelError for the type of formulas
  Term(const Number& value);       // NOLINT: numbers are terms
  Term(int value);                 // NOLINT
  Term(long value);                // NOLINT
  Term(const Rational& value);     // NOLINT
  Term(double) = delete;
  Term(bool) = delete;
  Term(const Term&) = default;  // and no moves: there is no Term without meaning
  Term& operator=(const Term&) = default;

  [[nodiscard]] Kind kind() const;
  [[nodiscard]] const Type& type() const;
  [[nodiscard]] const std::vector<Term>& parts() const;
  [[nodiscard]] const std::string& name() const;  // of a variable; of a binder only a hint for printing
  [[nodiscard]] const Rational& value() const;    // of a number; the exponent of a power; an index
  [[nodiscard]] int row() const;                  // of an entry, from 0
  [[nodiscard]] int column() const;
  [[nodiscard]] const Type& binds() const;             // what a binder binds
  [[nodiscard]] const Definition& definition() const;  // throws KernelError unless the kind is `defined`
  [[nodiscard]] const Variables& variables() const;    // the free ones
  // Whether it is no part of a binder's body cut out with its index: rules and binders refuse those.
  [[nodiscard]] bool is_closed() const;

  friend std::strong_ordering operator<=>(const Term& a, const Term& b);
  friend bool operator==(const Term& a, const Term& b) { return (a <=> b) == 0; }

 private:
  friend struct Node;
  explicit Term(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};
using Formula = Term;  // of type truth_value
using Terms = std::set<Term, Before>;
using Formulas = Terms;
using Substitution = std::map<Variable, Term, Before>;

// A name for a term or a formula in parameters: closed, so that nothing hides in it. What it means is part of
// it: two definitions are the same if name, parameters and body are. There is no table of definitions.
class Definition {
 public:
  // Throws KernelError if a name stands twice among the parameters, if the body has another free variable, or
  // if it is a function of time.
  Definition(const std::string& name, const std::vector<Variable>& parameters, const Term& body);
  Definition(const Definition&) = default;
  Definition& operator=(const Definition&) = default;
  [[nodiscard]] const std::string& name() const { return data_->name; }
  [[nodiscard]] const std::vector<Variable>& parameters() const { return data_->parameters; }
  [[nodiscard]] const Term& body() const { return data_->body; }
  // The definition applied; throws KernelError unless number and types of the arguments are the parameters'.
  [[nodiscard]] Term operator()(const std::vector<Term>& arguments) const;
  // Its body with the arguments for the parameters.
  [[nodiscard]] Term unfolded(const std::vector<Term>& arguments) const;
  friend std::strong_ordering operator<=>(const Definition& a, const Definition& b);
  friend bool operator==(const Definition& a, const Definition& b) { return (a <=> b) == 0; }

 private:
  struct Data {
    std::string name;
    std::vector<Variable> parameters;
    Term body;
    friend std::strong_ordering operator<=>(const Data& a, const Data& b) = default;
  };
  std::shared_ptr<const Data> data_;
};
using Definitions = std::set<Definition, Before>;

// What a term is made of: for the kernel's files only. It is complete here, so that nobody else can say what
// a Node is, and make() takes nothing on trust.
struct Node {
  Kind kind = Kind::number;
  std::vector<Term> parts;
  std::string name = {};             // of a variable; of a binder a hint
  std::optional<Number> value = {};  // of a number; exponent of a power; index of what is bound
  int row = 0;                       // of an entry; rows of a matrix
  int column = 0;
  Type binds = {};  // of a binder; the type of a variable and of what is bound
  std::optional<Definition> definition = {};

  // Computed by make():
  Type type = {};
  std::uint64_t hash = 0;
  long loose = 0;                    // no index in it reaches further than this many binders outside
  long depth = 1;                    // of the tree
  bool applies_definitions = false;  // it or a part of it
  std::shared_ptr<const Variables> variables = {};

  // The only way to a Term: checks sorts and shapes and throws KernelError; applies a lambda that is applied,
  // and takes λt. f(t) for f, so that equal functions look alike.
  [[nodiscard]] static Term make(Node node);
  [[nodiscard]] static const Node& of(const Term& term) { return *term.node_; }
  [[nodiscard]] static bool is_same(const Term& a, const Term& b) { return a.node_ == b.node_; }
};

// Terms. All throw KernelError when sorts or shapes do not fit.
[[nodiscard]] Term pi();
[[nodiscard]] Term sum(const std::vector<Term>& parts);  // at least one, of one shape
[[nodiscard]] Term operator+(const Term& a, const Term& b);
[[nodiscard]] Term operator-(const Term& a, const Term& b);  // a + (-1) b
[[nodiscard]] Term operator-(const Term& a);
[[nodiscard]] Term operator*(const Term& a, const Term& b);  // of matrices, or a number times anything
[[nodiscard]] Term operator/(const Term& a, const Term& b);  // a · inverse(b), b a number
[[nodiscard]] Term power(const Term& base, long exponent);   // of a number; 0 <= exponent <= 1000
[[nodiscard]] Term inverse(const Term& a);                   // of a square matrix of at most 4 rows
[[nodiscard]] Term cos(const Term& a);
[[nodiscard]] Term sin(const Term& a);
[[nodiscard]] Term exp(const Term& a);
[[nodiscard]] Term tan(const Term& a);                                               // sin(a)/cos(a)
[[nodiscard]] Term matrix(int rows, int columns, const std::vector<Term>& entries);  // row by row
[[nodiscard]] Term entry(const Term& a, int row, int column = 0);                    // from 0
[[nodiscard]] Term zero(const Type& type);  // 0, or a matrix of zeros
[[nodiscard]] Term identity(int rows);
[[nodiscard]] Term determinant(const Term& a);  // by Laplace's expansion in its entries
[[nodiscard]] Term adjugate(const Term& a);     // the determinant times the inverse, by cofactors
// λ variable. body: a function of time; the variable is a number. apply(λ…, t) is the body at t.
[[nodiscard]] Term lambda(const Variable& variable, const Term& body);
[[nodiscard]] Term apply(const Term& function, const Term& time);

// Formulas.
[[nodiscard]] Formula equal(const Term& a, const Term& b);   // of one shape
[[nodiscard]] Formula differ(const Term& a, const Term& b);  // not equal
[[nodiscard]] Formula less(const Term& a, const Term& b);    // of numbers
[[nodiscard]] Formula at_most(const Term& a, const Term& b);
[[nodiscard]] Formula all(const std::vector<Formula>& parts);  // of none: true
[[nodiscard]] Formula any(const std::vector<Formula>& parts);  // of none: false
[[nodiscard]] Formula negation(const Formula& a);
[[nodiscard]] Formula implies(const Formula& a, const Formula& b);
[[nodiscard]] Formula for_all(const Variable& variable, const Formula& body);
[[nodiscard]] Formula exists(const Variable& variable, const Formula& body);
// The function has a derivative at the point, and that is the value.
[[nodiscard]] Formula derivative(const Term& function, const Term& point, const Term& value);
// The function's restriction to the closed interval [a, b] is continuous (if a > b there is nothing to say).
[[nodiscard]] Formula continuous(const Term& function, const Term& a, const Term& b);
// The set of numbers for which the body holds is finite.
[[nodiscard]] Formula finite(const Variable& variable, const Formula& body);
// Every complex zero of c0 + c1 z + … + cn z^n lies inside the unit circle; the coefficients as a column.
[[nodiscard]] Formula inside_unit_circle(const Term& coefficients);
// a < t < b, a ≤ t ≤ b.
[[nodiscard]] Formula between(const Term& a, const Term& t, const Term& b);
[[nodiscard]] Formula within(const Term& a, const Term& t, const Term& b);

// Variables replaced at once, everywhere; nothing is captured. Throws KernelError if a value is not of its
// variable's type.
[[nodiscard]] Term substitute(const Term& term, const Substitution& substitution);
// Every occurrence of a part, which is no binder's variable, replaced by a term of its type.
[[nodiscard]] Term replaced(const Term& term, const Term& part, const Term& by);
// The body of a lambda, for_all, exists or finite with the argument for what is bound.
[[nodiscard]] Term opened(const Term& binder, const Term& argument);
// A variable whose name is free in none of the terms.
[[nodiscard]] Variable fresh(const Type& type, const std::vector<Term>& avoid);
// Every application of one of these definitions replaced by its body, under binders too, until none is left.
[[nodiscard]] Term unfold(const Term& term, const Definitions& definitions);

}  // namespace stickslip::proofs::kernel
