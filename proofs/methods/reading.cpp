#include "proofs/methods/reading.hpp"

#include <algorithm>

#include "proofs/methods/model_terms.hpp"
#include "proofs/methods/tactics.hpp"
#include "proofs/symbols/derived.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/table.hpp"
#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/hypotheses.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using symbols::NoValue;
using symbols::Op;

// Among the functions of time that are formulas of the model.
inline Symbolic absolute_value(const Symbolic&) {
  throw NoValue("an absolute value has no reading");
}

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
      top = static_cast<std::size_t>(
          std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.empty(); }) - rows.begin());
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
  if (n < 0 && base.type().rows > 2) {
    throw NoValue("the inverse of so large a matrix by its cofactors takes the kernel too long");
  }
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

}  // namespace

Term Reader::define(const std::string& name, const std::vector<Variable>& first, const Term& body,
                    Definitions& among) {
  std::vector<Variable> parameters = first;
  for (const Variable& variable : body.variables()) {
    if (std::find(parameters.begin(), parameters.end(), variable) == parameters.end()) {
      parameters.push_back(variable);
    }
  }
  const Definition definition(name, parameters, body);
  among.insert(definition);
  return definition({parameters.begin(), parameters.end()});
}

Term Reader::scalar(const std::string& name) {
  if (const auto known = scalars_.find(name); known != scalars_.end()) {
    return known->second;
  }
  const symbols::Lookup<Symbolic> lookup = [this](const std::string& other) {
    return Symbolic(scalar(other));
  };
  const symbols::Symbol * row = symbols::symbol_table().find(symbols::scalar(name));
  Term term = Variable{name};
  if (name == "pi") {
    term = kernel::pi();
  } else if (row != nullptr && row->value) {
    term = define(name, {}, (*this)(*row->value), open_);
  } else if (const std::optional<Symbolic> formula = symbols::derived<Symbolic>(name, lookup)) {
    term = define(name, {}, formula->term,
                  closed_[row != nullptr && !row->formula_in.empty() ? row->formula_in : "39"]);
  }
  scalars_.emplace(name, term);
  return term;
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
  const symbols::Lookup<Symbolic> lookup = [this](const std::string& name) { return Symbolic(scalar(name)); };
  const auto& known = symbols::detail::matrices<Symbolic>();
  const auto formula = known.find(printed.name());
  if (!(row != nullptr && row->value) && formula == known.end()) {
    throw NoValue("the symbol " + printed.name() + " has no meaning in the model");
  }
  const Term body =
      row != nullptr && row->value ? (*this)(*row->value) : as_kernel_term(formula->second(lookup));
  return body.variables().empty() ? body : define(printed.name(), {}, body, open_);
}

Term Reader::function(const symbols::Term& printed) {
  const Term argument = (*this)(printed.arguments().front());
  const std::string& name = printed.name();
  if (name == "cos" || name == "sin" || name == "tan") {
    return name == "cos" ? cos(argument) : name == "sin" ? sin(argument) : tan(argument);
  }
  const auto& known = symbols::detail::functions<Symbolic>();
  const auto formula = known.find(name);
  if (formula == known.end()) {
    throw NoValue("the function " + name + " has no meaning in the model");
  }
  const symbols::Lookup<Symbolic> lookup = [this](const std::string& other) {
    return Symbolic(scalar(other));
  };
  const Term applied = define(name, {time}, as_kernel_term(formula->second(lookup, Symbolic(time))), open_);
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
      const auto known = std::find_if(rates_.begin(), rates_.end(),
                                      [&](const auto& rate) { return rate.second == parts[0]; });
      if (known != rates_.end()) {
        return apply(known->first, time);
      }
      rates_.emplace_back(Variable{"D" + std::to_string(rates_.size() + 1),
                                   function_of_time(parts[0].type().rows, parts[0].type().columns)},
                          parts[0]);
      return apply(rates_.back().first, time);
    }
  }
  throw InternalError("a term of unknown kind");
}

Definitions Reader::all() const {
  Definitions result = open_;
  for (const auto& entry : closed_) {
    result.insert(entry.second.begin(), entry.second.end());
  }
  return result;
}

namespace {

Formula relation(const Term& left, const Term& right, symbols::Relation relation) {
  switch (relation) {
    case symbols::Relation::equal:
      return equal(left, right);
    case symbols::Relation::not_equal:
      return differ(left, right);
    case symbols::Relation::less:
      return less(left, right);
    case symbols::Relation::less_or_equal:
      return at_most(left, right);
    case symbols::Relation::greater:
      return less(right, left);
    case symbols::Relation::greater_or_equal:
      return at_most(right, left);
  }
  throw InternalError("a relation of unknown kind");
}

// D is the derivative of f, of the time t, at all times.
Formula rate(const Term& f, const Term& D) {
  return for_all(time, derivative(lambda(time, f), time, apply(D, time)));
}

}  // namespace

Formula Reader::operator()(const symbols::Statement& statement) {
  rates_.clear();
  const auto side = [this](const symbols::Term& one, const symbols::Term& other) {
    return one.is_zero() ? filled(other.shape(), [](int, int) { return Term(0); }) : (*this)(one);
  };
  const Term left = side(statement.left, statement.right), right = side(statement.right, statement.left);
  Formula formula = relation(left, right, statement.relation);
  for (auto one = rates_.rbegin(); one != rates_.rend(); ++one) {
    formula = exists(one->first, kernel::all({rate(one->second, one->first), formula}));
  }
  return formula;
}

const Domain& parameters() {
  static const Domain domain = [] {
    const Variable omega1{"omega1"}, omega2{"omega2"};
    return Domain{above(0, omega1),         below(omega1, 1),
                  above(1, omega2),         above(0, Variable{"omega"}),
                  above(0, Variable{"us"}), above(0, Variable{"ur"})};
  }();
  return domain;
}

namespace {

// The factors of kernel terms, in GiNaC, where they are compared with what else must not vanish.
GiNaC::ex expression(const Term& term) {
  const std::vector<Term>& parts = term.parts();
  switch (term.kind()) {
    case kernel::Kind::number:
      return symbolic::algebra::to_ex(term.value());
    case kernel::Kind::pi:
      return GiNaC::Pi;
    case kernel::Kind::variable:
      return symbolic::algebra::symbol(term.name());
    case kernel::Kind::sum: {
      GiNaC::ex total = 0;
      for (const Term& one : parts) {
        total += expression(one);
      }
      return total;
    }
    case kernel::Kind::product:
      return expression(parts[0]) * expression(parts[1]);
    case kernel::Kind::power:
      return pow(expression(parts[0]), symbolic::algebra::to_ex(term.value()));
    case kernel::Kind::inverse:
      return 1 / expression(parts[0]);
    case kernel::Kind::cosine:
      return GiNaC::cos(expression(parts[0]));
    case kernel::Kind::sine:
      return GiNaC::sin(expression(parts[0]));
    case kernel::Kind::defined:
      return expression(term.definition().unfolded(parts));
    case kernel::Kind::matrix:
      if (parts.size() == 1) {
        return expression(parts[0]);
      }
      break;
    case kernel::Kind::entry:
      if (parts[0].kind() == kernel::Kind::matrix) {
        return expression(entry_of(parts[0], term.row(), term.column()));
      }
      break;
    default:
      break;
  }
  throw KernelError("a divisor is no expression: " + to_string(term));
}

bool is_nonzero_hypothesis(const Formula& formula) {
  return formula.kind() == kernel::Kind::negation && formula.parts()[0].kind() == kernel::Kind::equal;
}

// The hypotheses d ≠ 0 with all definitions opened, less what the parameters imply.
Theorem in_parameters(Theorem theorem, const Definitions& definitions) {
  const Formulas hypotheses = theorem.hypotheses();
  for (const Formula& one : hypotheses) {
    const Formula opened = unfold(one, definitions);
    if (is_nonzero_hypothesis(one) && !(opened == one)) {
      theorem = Theorem::cut(Theorem::convert(Theorem::assume(opened), one, definitions), theorem);
    }
  }
  return nonzero(theorem, parameters());
}

class IdentityProof {
 public:
  IdentityProof(const symbols::Statement& statement, const std::vector<Assumption>& assumptions,
                const std::set<std::string>& open)
      : open_(open) {
    if (statement.relation != symbols::Relation::equal) {
      throw KernelError("no equation");
    }
    formula_ = read_(statement);
    for (const Assumption& one : assumptions) {
      const symbols::Statement& given = one.statement;
      if (given.relation != symbols::Relation::equal || given.left.op() != Op::symbol ||
          !given.left.shape().is_scalar()) {
        continue;
      }
      const Term symbol = read_(given.left);
      if (symbol.kind() == kernel::Kind::variable) {
        given_.push_back({one.id, {symbol.name(), symbol.type()}, read_(given.right)});
      }
    }
  }

  // With as few of the given values as it takes.
  Identity prove() {
    Theorem theorem = attempt();
    for (const std::string& id : std::set<std::string>(assumed_)) {
      const std::vector<Given> before = given_;
      const std::set<std::string> assumed = assumed_;
      std::erase_if(given_, [&](const Given& one) { return one.id == id; });
      try {
        theorem = attempt();
      } catch (const KernelError&) {
        given_ = before;
        assumed_ = assumed;
      }
    }
    Identity identity{theorem, assumed_, {}};
    Formulas expected;
    for (const Theorem& one : parameters()) {
      expected.insert(one.hypotheses().begin(), one.hypotheses().end());
    }
    for (const Given& one : given_) {
      expected.insert(equal(one.symbol, one.value));
    }
    for (const Formula& one : theorem.hypotheses()) {
      if (expected.contains(one)) {
        continue;
      }
      if (!is_nonzero_hypothesis(one)) {
        throw KernelError("a hypothesis of another kind: " + to_string(one));
      }
      const auto factors = symbolic::algebra::vanishing_factors(expression(one.parts()[0].parts()[0]));
      if (factors.empty()) {
        throw KernelError("not discharged: " + to_string(one));
      }
      identity.nonzero.insert(identity.nonzero.end(), factors.begin(), factors.end());
    }
    return identity;
  }

 private:
  struct Given {
    std::string id;
    Variable symbol;
    Term value;
  };

  Theorem attempt() {
    assumed_.clear();
    return in_parameters(from_given(formula_, 0), read_.all());
  }

  // The formula, with what is given put in, proved; and from that the formula itself.
  Theorem from_given(const Formula& formula, int depth) {
    if (depth > 16) {
      throw KernelError("what is given goes in circles");
    }
    for (const Given& one : given_) {
      if (!formula.variables().contains(one.symbol)) {
        continue;
      }
      assumed_.insert(one.id);
      const Theorem inner = from_given(substitute(formula, {{one.symbol, one.value}}), depth + 1);
      const Theorem equation = Theorem::assume(equal(one.symbol, one.value));
      const Variable place = fresh(one.symbol.type, {formula, one.value});
      return Theorem::replace(symmetric(equation), place, substitute(formula, {{one.symbol, place}}), inner);
    }
    return closed_form(formula);
  }

  Theorem closed_form(const Formula& formula) {
    if (formula.kind() == kernel::Kind::exists) {
      const Variable D = fresh(formula.binds(), {formula});
      const Formula open = opened(formula, D);
      const Term f = opened(open.parts()[0], time).parts()[0];
      const Theorem slope = Theorem::differentiate(f, time);
      const Theorem at_all_times = Theorem::generalize(slope, time);
      const Term value = lambda(time, slope.conclusion().parts()[2]);
      const Theorem rest = closed_form(substitute(open.parts()[1], {{D, value}}));
      return Theorem::witness(both({at_all_times, rest}), formula, value);
    }
    Definitions definitions = read_.open();
    for (const auto& [id, closed] : read_.closed()) {
      if (open_.contains(id)) {
        definitions.insert(closed.begin(), closed.end());
      }
    }
    return Theorem::combination(formula, {}, definitions);
  }

  Reader read_;
  Formula formula_ = kernel::all({});
  std::vector<Given> given_;
  std::set<std::string> assumed_, open_;
};

}  // namespace

Identity prove_identity(const symbols::Statement& statement, const std::vector<Assumption>& assumptions,
                        const std::set<std::string>& open) {
  return IdentityProof(statement, assumptions, open).prove();
}

}  // namespace stickslip::proofs::methods
