#include "proofs/methods/reading.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <tuple>

#include "proofs/methods/assumptions.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/sample.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/tactics/model_terms.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using namespace tactics;
using symbols::NoValue;
using symbols::Op;

namespace {

const Variable time{"t"};

Term filled(const symbols::Shape& shape, const std::function<Term(int, int)>& entry_at) {
  if (shape.is_scalar()) {
    return entry_at(0, 0);
  }
  std::vector<Term> entries;
  for (int i = 0; i < shape.rows; ++i) {
    for (int j = 0; j < shape.columns; ++j) {
      entries.push_back(entry_at(i, j));
    }
  }
  return matrix(shape.rows, shape.columns, entries);
}

Term as_kernel_term(const symbols::Value<Symbolic>& value) {
  return value.size() == 1 ? value(0, 0).term : as_term(value);
}

// Of a matrix of literal entries, the entry itself.
Term entry_of(const Term& a, int row, int column) {
  if (a.kind() == kernel::Kind::matrix) {
    return a.parts()[static_cast<std::size_t>(row * a.type().columns + column)];
  }
  return a.type().is_scalar() ? a : entry(a, row, column);
}

// The blocks of a printed block matrix side by side.
Term joined_blocks(const symbols::Shape& shape, const std::vector<Term>& blocks) {
  std::vector<std::vector<Term>> rows(static_cast<std::size_t>(shape.rows));
  std::size_t top = 0;
  for (const Term& one : blocks) {
    if (static_cast<int>(rows[top].size()) == shape.columns) {
      top = static_cast<std::size_t>(std::ranges::find_if(rows, [](const auto& row) { return row.empty(); }) -
                                     rows.begin());
    }
    for (int i = 0; i < one.type().rows; ++i) {
      for (int j = 0; j < one.type().columns; ++j) {
        rows[top + static_cast<std::size_t>(i)].push_back(entry_of(one, i, j));
      }
    }
  }
  return filled(shape,
                [&](int i, int j) { return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; });
}

Term integer_power(const Term& base, const Rational& exponent) {
  const long n = exponent.get_num().get_si();
  const Term positive = n < 0 ? inverse(base) : base;
  if (base.type().is_scalar()) {
    return power(positive, std::labs(n));
  }
  Term product = identity(base.type().rows);
  for (long i = 0; i < std::labs(n); ++i) {
    product = i == 0 ? positive : product * positive;
  }
  return product;
}

// What a name stands for is the same in every statement: it is made once.
Term once(const std::string& name, const symbols::Shape& shape, bool of_time,
          const std::function<Term()>& make) {
  using Key = std::tuple<std::size_t, std::string, int, int, bool>;
  static thread_local std::map<Key, Term> made;
  const Key key{symbols::vocabulary_here().number(), name, shape.rows, shape.columns, of_time};
  const auto known = made.find(key);
  return known != made.end() ? known->second : made.emplace(key, make()).first->second;
}

// By vocabulary and name.
std::map<std::pair<std::size_t, std::string>, symbols::Term>& roots() {
  static thread_local std::map<std::pair<std::size_t, std::string>, symbols::Term> all;
  return all;
}

// A root is one number, at whatever time.
void check_no_root_changes(const Variables& variables) {
  for (const Variable& one : variables) {
    if (const auto root = root_of(one); root && depends_on(*root, "t")) {
      throw NoValue("a root that changes with the time has no reading here: " + text(*root));
    }
  }
}

symbols::Lookup<Symbolic> scalars_of(Reader& read) {
  return [&read](const std::string& name) { return Symbolic(read(symbols::scalar(name))); };
}

// The function of the time that this is a value of.
Term of_time(const Term& value) {
  check_no_root_changes(value.variables());
  return lambda(time, value);
}

}  // namespace

std::optional<symbols::Term> root_of(const Variable& variable) {
  const auto found = roots().find({symbols::vocabulary_here().number(), variable.name});
  return found != roots().end() ? std::optional(found->second) : std::nullopt;
}

Term Reader::scalar(const std::string& name) {
  return once(name, {}, false, [&]() -> Term {
    if (name == "pi") {
      return kernel::pi();
    }
    if (const auto meaning = symbols::abbreviated(symbols::scalar(name))) {
      return defined(name, (*this)(*meaning));
    }
    const std::optional<Symbolic> formula = symbols::derived<Symbolic>(name, scalars_of(*this));
    return formula ? defined(name, formula->term) : Variable{name};
  });
}

Term Reader::symbol(const symbols::Term& printed) {
  const symbols::Shape shape = printed.shape();
  if (printed.name() == "I") {
    return identity(shape.rows);
  }
  if (shape.is_scalar()) {
    return scalar(printed.name());
  }
  const symbols::Symbol * row = symbols::symbol_table().find(printed);
  const auto& known = symbols::detail::matrices<Symbolic>();
  const auto formula = symbols::detail::formula_of<Symbolic>(known, printed.name());
  if (!(row != nullptr && row->value) && formula == known.end()) {
    throw NoValue("the symbol " + printed.name() + " has no meaning in the model");
  }
  return once(printed.name(), shape, false, [&] {
    const Term body = row != nullptr && row->value ? (*this)(*row->value)
                                                   : as_kernel_term(formula->second(scalars_of(*this)));
    return body.variables().empty() ? body : defined(printed.name(), body);
  });
}

Term Reader::function(const symbols::Term& printed) {
  const std::string& name = printed.name();
  if (name == "sqrt") {
    const std::string shown = text(printed);
    roots().try_emplace({symbols::vocabulary_here().number(), shown}, printed);
    return Variable{shown};
  }
  const Term argument = (*this)(printed.arguments().front());
  if (name == "exp") {
    return exp(argument);
  }
  if (name == "cos" || name == "sin" || name == "tan") {
    return name == "cos" ? cos(argument) : name == "sin" ? sin(argument) : tan(argument);
  }
  const symbols::Symbol * row = symbols::symbol_table().find(printed);
  if (row != nullptr && row->is_motion) {
    return apply(Variable{name, function_of_time(printed.shape().rows, printed.shape().columns)}, argument);
  }
  if (row != nullptr && row->means) {
    return (*this)(substitute(*row->means, {{"t", printed.arguments().front()}}));
  }
  const auto& known = symbols::detail::functions<Symbolic>();
  const auto formula = symbols::detail::formula_of<Symbolic>(known, name);
  if (formula == known.end()) {
    throw NoValue("the function " + name + " has no meaning in the model");
  }
  const Term applied = once(name, printed.shape(), true, [&] {
    return defined(name, as_kernel_term(formula->second(scalars_of(*this), Symbolic(time))), {time});
  });
  return substitute(applied, {{time, argument}});
}

Term Reader::operator()(const symbols::Term& printed) {
  std::vector<Term> parts;
  if (printed.op() != Op::symbol && printed.op() != Op::function && printed.op() != Op::number) {
    for (const symbols::Term& argument : printed.arguments()) {
      parts.push_back((*this)(argument));
    }
  }
  switch (printed.op()) {
    case Op::number:
      return filled(printed.shape(), [&](int, int) { return Term(printed.number()); });
    case Op::symbol:
      return symbol(printed);
    case Op::function:
      return function(printed);
    case Op::sum: {
      std::vector<Term> summands;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!printed.arguments()[i].is_zero()) {
          summands.push_back(parts[i]);
        }
      }
      return summands.empty() ? parts.front() : sum(summands);
    }
    case Op::product: {
      Term product = parts.front();
      for (std::size_t i = 1; i < parts.size(); ++i) {
        product = product.type().is_scalar() || !parts[i].type().is_scalar() ? product * parts[i]
                                                                             : parts[i] * product;
      }
      return product;
    }
    case Op::quotient:
      return parts[0].type().is_scalar() ? parts[0] / parts[1] : inverse(parts[1]) * parts[0];
    case Op::power:
      return integer_power(parts[0], printed.number());
    case Op::negate:
      return -parts[0];
    case Op::block:
      return joined_blocks(printed.shape(), parts);
    case Op::determinant:
      return determinant(parts[0]);
    case Op::derivative: {
      check_no_root_changes(parts[0].variables());
      const auto known =
          std::ranges::find_if(rates_, [&](const auto& rate) { return rate.second == parts[0]; });
      if (known != rates_.end()) {
        return apply(known->first, time);
      }
      std::string name = "D" + std::to_string(rates_.size() + 1);
      while (std::ranges::count(symbols::symbol_table(), name, &symbols::Symbol::name) > 0) {
        name += "'";  // the statement may speak of a motion of that name
      }
      rates_.emplace_back(Variable{name, function_of_time(parts[0].type().rows, parts[0].type().columns)},
                          parts[0]);
      return apply(rates_.back().first, time);
    }
  }
  throw InternalError("a term of unknown kind");
}

namespace {

// D is the derivative of f, of the time t, at all times.
Formula rate(const Term& f, const Term& D) {
  return for_all(time, derivative(lambda(time, f), time, apply(D, time)));
}

bool is_call(const symbols::Term& term, const char * function) {
  return term.op() == Op::function && term.name() == function;
}

// The first application of the function within the term, but in a derivative, with none in its argument.
std::optional<symbols::Term> call_in(const symbols::Term& term, const char * function) {
  for (const symbols::Term& argument : term.arguments()) {
    const auto found = term.op() == Op::derivative ? std::nullopt : call_in(argument, function);
    if (found) {
      return found;
    }
  }
  return is_call(term, function) ? std::optional(term) : std::nullopt;
}

// Nothing is replaced in a derivative: what is so at one time need not be so at others.
symbols::Term with_value(const symbols::Term& term, const symbols::Term& part, const symbols::Term& value) {
  if (equal(term, part)) {
    return value;
  }
  if (term.op() == Op::derivative) {
    return term;
  }
  std::vector<symbols::Term> arguments;
  for (const symbols::Term& argument : term.arguments()) {
    arguments.push_back(with_value(argument, part, value));
  }
  return term.with_arguments(std::move(arguments));
}

symbols::Statement with_value(const symbols::Statement& statement, const symbols::Term& part,
                              const symbols::Term& value) {
  return {with_value(statement.left, part, value), with_value(statement.right, part, value),
          statement.relation};
}

}  // namespace

Formula Reader::without_absolute_value(const symbols::Statement& statement, const symbols::Term& absolute) {
  const symbols::Term& of = absolute.arguments().front();
  const Term inside = (*this)(of);
  return kernel::all({kernel::any({less(inside, 0), relation(with_value(statement, absolute, of))}),
                      kernel::any({less(0, inside), relation(with_value(statement, absolute, -of))})});
}

Formula Reader::relation(const symbols::Statement& statement) {
  using symbols::Relation;
  constexpr const char * absolute = "abs";
  const bool is_order = statement.relation != Relation::equal && statement.relation != Relation::not_equal;
  const symbols::Statement here = is_order ? with_less(statement) : statement;
  const symbols::Term &lower = here.left, &upper = here.right;
  const bool is_bounded = is_order && is_call(lower, absolute);
  const auto in_lower = call_in(is_bounded ? lower.arguments().front() : lower, absolute);
  if (const auto found = in_lower ? in_lower : call_in(upper, absolute)) {
    return without_absolute_value(here, *found);
  }
  const auto side = [this](const symbols::Term& one, const symbols::Term& other) {
    return one.is_zero() ? zero(real_matrix(other.shape().rows, other.shape().columns)) : (*this)(one);
  };
  if (!is_order) {
    const Term left = side(lower, upper), right = side(upper, lower);
    return statement.relation == Relation::equal ? equal(left, right) : differ(left, right);
  }
  const bool strict = here.relation == Relation::less;
  const auto below = [strict](const Term& a, const Term& b) { return strict ? less(a, b) : at_most(a, b); };
  if (is_bounded) {
    const Term inside = (*this)(lower.arguments().front()), bound = (*this)(upper);
    return kernel::all({below(-bound, inside), below(inside, bound)});
  }
  return below(side(lower, upper), side(upper, lower));
}

// At the time t, which the statement's derivative is taken at.
Formula Reader::at_one_time(const symbols::Statement& statement) {
  if (statement.left.op() != Op::derivative) {
    return relation(statement);
  }
  if (statement.relation != symbols::Relation::equal) {
    throw NoValue("a derivative is equal to something: " + text(statement));
  }
  const Term value = statement.right.is_zero()
                         ? zero(real_matrix(statement.left.shape().rows, statement.left.shape().columns))
                         : (*this)(statement.right);
  check_no_root_changes(value.variables());
  return derivative(of_time((*this)(statement.left.arguments().front())), time, value);
}

Formula Reader::with_signs(const symbols::Statement& statement) {
  const auto in_left = call_in(statement.left, "sign"),
             sign = in_left ? in_left : call_in(statement.right, "sign");
  if (!sign) {
    return at_one_time(statement);
  }
  const symbols::Term& of = sign->arguments().front();
  if (of.op() == Op::number) {  // of a sign, as its value is put in from within
    throw NoValue("a sign has no reading here: " + text(statement));
  }
  const auto where = [&](int value) {
    const Formula rest = with_signs(with_value(statement, *sign, value));
    const Formula here = value > 0 ? less(0, (*this)(of)) : less((*this)(of), 0);
    return kernel::all({here, rest});
  };
  return kernel::any({where(1), where(-1)});
}

Formula Reader::operator()(const symbols::Statement& statement) {
  rates_.clear();
  if (statement.during) {
    const Term from = (*this)(statement.during->from), to = (*this)(statement.during->to);
    symbols::Statement here = statement;
    here.during = std::nullopt;
    const bool almost = statement.during->almost;
    const Formula inside = between(from, time, to),
                  said = almost ? negation(with_signs(here)) : at_one_time(here),
                  then = almost ? finite(time, kernel::all({inside, said}))
                                : for_all(time, implies(inside, said));
    check_no_root_changes(then.variables());
    if (from.variables().contains(time) || to.variables().contains(time)) {
      throw NoValue("the ends of an interval depend on the time: " + text(statement));
    }
    if (!rates_.empty()) {
      throw NoValue("a derivative has no reading here: " + text(statement));
    }
    if (statement.left.op() != Op::derivative) {
      return then;
    }
    const Term f = of_time((*this)(statement.left.arguments().front()));
    return kernel::all({continuous(f, from, to), then});
  }
  Formula formula = relation(statement);
  for (auto one = rates_.rbegin(); one != rates_.rend(); ++one) {
    formula = exists(one->first, kernel::all({rate(one->second, one->first), formula}));
  }
  return formula;
}

namespace {

// "l < x" or "x < u", as theorems that suppose it.
struct Supposed {
  Domain theorems;
  Formulas formulas;
};

const Supposed& supposed() {
  static thread_local std::map<std::size_t, Supposed> known;  // by vocabulary
  const symbols::Vocabulary& vocabulary = symbols::vocabulary_here();
  const auto found = known.find(vocabulary.number());
  if (found != known.end()) {
    return found->second;
  }
  Supposed result;
  Reader read;
  for (const symbols::Statement& one : vocabulary.domain()) {
    result.formulas.insert(read(one));
    result.theorems.push_back(Theorem::assume(read(one)));
  }
  return known.emplace(vocabulary.number(), std::move(result)).first->second;
}

}  // namespace

const Domain& parameters() {
  return supposed().theorems;
}

const Formulas& domain_formulas() {
  return supposed().formulas;
}

std::vector<Formula> domain_of(const Variables& variables) {
  std::vector<Formula> result;
  for (const Theorem& one : parameters()) {
    if (std::ranges::includes(variables, one.conclusion().variables())) {
      result.push_back(one.conclusion());
    }
  }
  return result;
}

Bounds bounds_of(const std::string& parameter) {
  const Term x = Variable{parameter};
  Bounds result;
  for (const Formula& one : domain_formulas()) {
    const Term &lower = one.parts()[0], &upper = one.parts()[1];
    if (upper == x && lower.kind() == kernel::Kind::number) {
      result.lower = std::max(result.lower.value_or(lower.value()), lower.value());
    } else if (lower == x && upper.kind() == kernel::Kind::number) {
      result.upper = std::min(result.upper.value_or(upper.value()), upper.value());
    }
  }
  return result;
}

}  // namespace stickslip::proofs::methods
