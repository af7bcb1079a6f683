#include "proofs/premise_point.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "proofs/abbreviations.hpp"
#include "proofs/deciding.hpp"

namespace stickslip::proofs {
namespace {

constexpr long bits = 256;

// The states first: they are solved for before belt speed and friction.
const std::vector<std::string>& unknowns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const char* where : {"C", "B", "0"}) {
      for (const char* what : {"z1", "z2", "zdot1", "zdot2"}) {
        result.push_back(std::string(what) + where);
      }
    }
    result.insert(result.end(), {"V", "ur", "us"});
    return result;
  }();
  return names;
}

bool is_unknown(const std::string& name) {
  return std::find(unknowns().begin(), unknowns().end(), name) != unknowns().end();
}

// A name whose value may be put in: no unknown, nothing that the model's formulas are made of or give.
bool is_name(const Term& term) {
  static const std::vector<std::string> parameters{"omega", "omega1", "omega2", "p"};
  const std::string& name = term.name();
  const Lookup<Ball> one = [](const std::string&) { return Ball(1); };
  return term.op() == Op::symbol && term.shape().is_scalar() && !is_unknown(name) && !abbreviated(name) &&
         std::find(parameters.begin(), parameters.end(), name) == parameters.end() &&
         !derived<Ball>(name, one);
}

// Whether it is made of what has a value and of the motion Z.
bool in_terms_of_Z(const Term& term) {
  return (term.op() == Op::function && term.name() == "Z") || is_in_field(term) ||
         (!term.arguments().empty() && term.op() != Op::function &&
          std::all_of(term.arguments().begin(), term.arguments().end(), in_terms_of_Z));
}

// What the premises say, sorted by what it is good for.
struct Premises {
  std::map<std::string, Term> motions;  // the value at t of Z, X, …
  Replacements values;
  std::vector<Statement> equations, inequalities;
  bool consistent = true;

  // The term with the motions put in.
  [[nodiscard]] Term with_motions(const Term& term) const {
    std::vector<Term> arguments;
    for (const Term& argument : term.arguments()) {
      arguments.push_back(with_motions(argument));
    }
    const auto motion = term.op() == Op::function ? motions.find(term.name()) : motions.end();
    if (motion != motions.end()) {
      return substitute(with_motions(motion->second), {{"t", arguments.front()}});
    }
    return arguments.empty() ? term : term.with_arguments(std::move(arguments));
  }
  [[nodiscard]] Statement with_motions(const Statement& statement) const {
    return {with_motions(statement.left), with_motions(statement.right), statement.relation};
  }

  void add(const Statement& statement) {
    const Term& left = statement.left;
    const bool equation = statement.relation == Relation::equal;
    const bool of_time = left.op() == Op::function && left.arguments().front().op() == Op::symbol &&
                         left.arguments().front().name() == "t" && !is_in_field(left) &&
                         (left.name() == "Z" ? is_in_field(statement.right) : in_terms_of_Z(statement.right));
    if (equation && of_time) {
      const auto [known, fresh] = motions.emplace(left.name(), statement.right);
      consistent = consistent && (fresh || equal(known->second, statement.right));
    } else if (equation && is_name(left)) {
      values.emplace(left.name(), statement.right);
    } else {
      (equation ? equations : inequalities).push_back(statement);
    }
  }
};

Premises premises_of(Prover& prover, const Record& record) {
  Premises result;
  for (const Assumption& assumption : record.claim.assumptions) {
    const bool is_value = is_substitution(assumption) && !is_unknown(assumption.statement.left.name());
    if (is_value) {
      result.values.emplace(assumption.statement.left.name(), assumption.statement.right);
    } else {
      result.add(assumption.statement);
    }
  }
  const Outcome& outcome = record.corrected ? *record.corrected : record.outcome;
  for (const std::string& used : outcome.uses) {
    const Record& premise = prover.prove(used);
    const Outcome& proved = premise.corrected ? *premise.corrected : premise.outcome;
    if (!proved.cross_check.identity) {
      for (const Statement& statement : proved_form(premise)) {
        result.add(statement);
      }
    }
  }
  const auto evaluable = [](const Term& term) { return is_in_field(term) || term.name() == "abs"; };
  for (std::vector<Statement>* statements : {&result.equations, &result.inequalities}) {
    for (Statement& statement : *statements) {
      statement = result.with_motions(statement);
    }
    std::erase_if(*statements, [&](const Statement& s) { return !evaluable(s.left) || !evaluable(s.right); });
  }
  return result;
}

using Column = std::vector<Ball>;

Ball size_of(const Ball& x) {
  return abs(x.midpoint());
}

// A solution of A u + constant = 0 by elimination, the unknowns that it leaves open from `open`.
Column solution(std::vector<Column> A, Column constant, const Column& open) {
  const std::size_t rows = constant.size(), columns = open.size();
  std::vector<std::size_t> pivot_of(columns, rows);
  std::size_t next = 0;
  for (std::size_t column = 0; column < columns && next < rows; ++column) {
    std::size_t best = next;
    for (std::size_t row = next; row < rows; ++row) {
      best = (size_of(A[row][column]) - size_of(A[best][column])).is_positive() ? row : best;
    }
    if (!A[best][column].is_nonzero()) {
      continue;
    }
    std::swap(A[best], A[next]);
    std::swap(constant[best], constant[next]);
    for (std::size_t row = 0; row < rows; ++row) {
      if (row == next) {
        continue;
      }
      const Ball factor = A[row][column] / A[next][column];
      for (std::size_t k = 0; k < columns; ++k) {
        A[row][k] -= factor * A[next][k];
      }
      A[row][column] = Ball(0);
      constant[row] -= factor * constant[next];
    }
    pivot_of[column] = next++;
  }
  Column u = open;
  for (std::size_t column = 0; column < columns; ++column) {
    if (pivot_of[column] == rows) {
      continue;
    }
    Ball value = constant[pivot_of[column]];
    for (std::size_t k = 0; k < columns; ++k) {
      if (pivot_of[k] == rows) {
        value += A[pivot_of[column]][k] * open[k];
      }
    }
    u[column] = -value / A[pivot_of[column]][column];
  }
  return u;
}

bool is_small(const Ball& x) {
  return x.is_finite() && (x.radius() * Ball(1L << 40) - Ball(1) - abs(x)).is_negative();
}

}  // namespace

struct PremisePoint::Point {
  Premises premises;
  ExactPoint numbers;
  std::map<std::string, Ball> solved;

  Point(Premises all, unsigned seed) : premises(std::move(all)), numbers(seed) {}

  [[nodiscard]] Ball free(const std::string& name) const {
    const auto found = solved.find(name);
    return found != solved.end() ? found->second
           : name == "pi"        ? Ball::pi()
                                 : Ball(numbers.symbol(name).value());
  }
  [[nodiscard]] Value<Ball> value(const Term& side, const Term& other) const {
    if (side.is_zero()) {
      return Value<Ball>::Constant(other.shape().rows, other.shape().columns, Ball(0));
    }
    Sample<Ball> at(premises.values, [this](const std::string& name) { return free(name); });
    return evaluate<Ball>(side, at.lookup());
  }
  [[nodiscard]] Value<Ball> difference(const Statement& statement) const {
    return value(statement.left, statement.right) - value(statement.right, statement.left);
  }
  [[nodiscard]] Column residuals(const Column& u) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      solved.insert_or_assign(unknowns()[i], u[i]);
    }
    Column all;
    for (const Statement& statement : premises.equations) {
      const Value<Ball> d = difference(statement);
      all.insert(all.end(), d.data(), d.data() + d.size());
    }
    return all;
  }

  // Solves the equations; whether that came out.
  [[nodiscard]] bool solve() {
    Column open(unknowns().size(), Ball(0));
    const Column constant = residuals(open);
    std::vector<Column> A(constant.size(), open);
    for (std::size_t i = 0; i < open.size(); ++i) {
      Column unit(open.size(), Ball(0));
      unit[i] = Ball(1);
      const Column value = residuals(unit);
      for (std::size_t row = 0; row < constant.size(); ++row) {
        A[row][i] = value[row] - constant[row];
      }
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      open[i] = Ball(numbers.symbol(unknowns()[i]).value());
    }
    const Column left = residuals(solution(A, constant, open));
    return std::all_of(left.begin(), left.end(),
                       [](const Ball& x) { return x.contains_zero() && is_small(x); });
  }

  [[nodiscard]] bool fails(const Statement& statement) const {
    const Value<Ball> d = difference(premises.with_motions(statement));
    return std::any_of(d.data(), d.data() + d.size(), [&](const Ball& x) {
      switch (statement.relation) {
        case Relation::equal:
          return x.is_nonzero();
        case Relation::not_equal:
          return x.is_exact() && !x.is_nonzero();
        case Relation::less:
        case Relation::less_or_equal:
          return x.is_positive();
        case Relation::greater:
        case Relation::greater_or_equal:
          return x.is_negative();
      }
      return false;
    });
  }
};

std::optional<PremisePoint> PremisePoint::find(Prover& prover, const Record& record, unsigned seed) {
  const WorkingPrecision precision(bits);
  auto point = std::make_shared<Point>(premises_of(prover, record), seed);
  const PremisePoint result(point);
  const auto fails = [&](const Statement& statement) { return point->fails(statement); };
  try {
    const bool stands =
        point->premises.consistent && point->solve() &&
        std::none_of(point->premises.inequalities.begin(), point->premises.inequalities.end(), fails);
    const std::vector<Statement>& printed = proved_form(record);
    if (!stands || std::any_of(printed.begin(), printed.end(), fails) ||
        !std::all_of(printed.begin(), printed.end(),
                     [&](const Statement& statement) { return result.evaluates(statement); })) {
      return std::nullopt;
    }
  } catch (const InternalError&) {  // something has no value
    return std::nullopt;
  }
  return result;
}

bool PremisePoint::contradicts(const Statement& statement) const {
  const WorkingPrecision precision(bits);
  return point_->fails(statement);
}

bool PremisePoint::evaluates(const Statement& statement) const {
  const WorkingPrecision precision(bits);
  const Value<Ball> d = point_->difference(point_->premises.with_motions(statement));
  return std::all_of(d.data(), d.data() + d.size(), is_small);
}

}  // namespace stickslip::proofs
