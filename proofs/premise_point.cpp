#include "proofs/premise_point.hpp"

#include <algorithm>
#include <optional>

#include "proofs/abbreviations.hpp"
#include "proofs/deciding.hpp"
#include "symbolic/evaluate.hpp"

namespace stickslip::proofs {
namespace {

constexpr long bits = 256;

// The states first: they are solved for before what the friction does.
const std::vector<std::string>& unknowns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const char* where : {"C", "B", "0"}) {
      for (const char* what : {"z1", "z2", "zdot1", "zdot2"}) {
        result.push_back(std::string(what) + where);
      }
    }
    for (int i = 1; i <= 5; ++i) {
      result.push_back(coefficient('d', i).name());
    }
    result.insert(result.end(), {"xddot1", "xddot2", "V", "ur", "us", "u"});
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

// What makes the load fit a motion that closes, where equations in the states alone cannot: it closes after
// Theta (28), lags behind a slip of length tau (16), turns half way in each of two equal phases (67); or load
// and modes make whole turns in tau.
const std::vector<Replacements>& ways_to_close() {
  static const std::vector<Replacements> all = [] {
    const Term omega = scalar("omega"), tau = scalar("tau"), Theta = scalar("Theta");
    return std::vector<Replacements>{
        {},
        {{"omega", 2 * pi() / Theta}},
        {{"phi", (pi() - omega * tau) / 2}},
        {{"omega", pi() / tau}, {"tau1", tau}},
        {{"omega1", 2 * pi() / tau}, {"omega", 4 * pi() / tau}, {"omega2", 6 * pi() / tau}}};
  }();
  return all;
}

}  // namespace

// What the premises say, sorted by what it is good for.
struct Premises::Parts {
  std::map<std::string, Term> motions;  // the value at t of Z, X, …
  Replacements values;
  std::vector<Statement> equations, inequalities, left_out;
  std::vector<Hypothesis> hypotheses;
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

  void add_value(const Statement& statement) {
    const auto [known, fresh] = values.emplace(statement.left.name(), statement.right);
    if (!fresh && !equal(known->second, statement.right)) {
      equations.push_back(statement);
    }
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
      add_value(statement);
    } else {
      (equation ? equations : inequalities).push_back(statement);
    }
  }

  // Puts the motions in, and sorts out what has no value.
  void finish() {
    const auto evaluable = [](const Term& term) { return is_in_field(term) || term.name() == "abs"; };
    for (std::vector<Statement>* statements : {&equations, &inequalities}) {
      for (Statement& statement : *statements) {
        statement = with_motions(statement);
        if (!evaluable(statement.left) || !evaluable(statement.right)) {
          left_out.push_back(statement);
        }
      }
      std::erase_if(*statements,
                    [&](const Statement& s) { return !evaluable(s.left) || !evaluable(s.right); });
    }
  }

  // Whether the value of the term, with all values put in, changes with the symbol.
  [[nodiscard]] bool reaches(const Term& term, const std::string& name) const {
    return depends_on(term, name) || std::any_of(values.begin(), values.end(), [&](const auto& value) {
             return depends_on(term, value.first) && reaches(value.second, name);
           });
  }
  // The same with further values; nothing where a name has one already, or would be given by itself.
  [[nodiscard]] std::optional<Parts> with(const Replacements& further) const {
    Parts result = *this;
    for (const auto& [name, value] : further) {
      if (values.contains(name) || reaches(value, name)) {
        return std::nullopt;
      }
      result.values.emplace(name, value);
    }
    return result;
  }
};

Premises::Premises(Prover& prover, const Claim& claim, const Outcome& outcome) {
  Parts parts;
  for (const Assumption& assumption : claim.assumptions) {
    if (is_substitution(assumption) && !is_unknown(assumption.statement.left.name())) {
      parts.add_value(assumption.statement);
    } else {
      parts.add(assumption.statement);
    }
  }
  for (const std::string& used : outcome.uses) {
    const Record& premise = prover.prove(used);
    const Outcome& proved = premise.corrected ? *premise.corrected : premise.outcome;
    if (!proved.cross_check.identity) {
      for (const Statement& statement : proved_form(premise)) {
        parts.add(statement);
      }
    }
  }
  parts.finish();
  parts.hypotheses = outcome.hypotheses;
  parts_ = std::make_shared<const Parts>(std::move(parts));
}

bool Premises::all_evaluated() const {
  return parts_->left_out.empty();
}

namespace {

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
  Premises::Parts premises;
  ExactPoint numbers;
  std::map<std::string, Ball> solved;

  Point(Premises::Parts all, unsigned seed) : premises(std::move(all)), numbers(seed) {}

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
  // For a state of either sign, the others positive.
  [[nodiscard]] Rational any_sign(const std::string& name) const {
    const Rational value = numbers.symbol(name).value();
    return name.starts_with("z") ? Rational(value - numbers.symbol(name + " less").value()) : value;
  }
  // Left less right, entry by entry.
  [[nodiscard]] Column difference(const Statement& statement) const {
    const Value<Ball> d = value(statement.left, statement.right) - value(statement.right, statement.left);
    return {d.data(), d.data() + d.size()};
  }
  [[nodiscard]] Column residuals(const Column& u) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      solved.insert_or_assign(unknowns()[i], u[i]);
    }
    Column all;
    for (const Statement& statement : premises.equations) {
      const Column d = difference(statement);
      all.insert(all.end(), d.begin(), d.end());
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
      open[i] = Ball(any_sign(unknowns()[i]));
    }
    const Column left = residuals(solution(A, constant, open));
    return std::all_of(left.begin(), left.end(),
                       [](const Ball& x) { return x.contains_zero() && is_small(x); });
  }

  [[nodiscard]] bool holds(const Statement& statement) const {
    const Column d = difference(premises.with_motions(statement));
    return std::all_of(d.begin(), d.end(), [&](const Ball& x) {
      switch (statement.relation) {
        case Relation::equal:
          return x.contains_zero() && is_small(x);
        case Relation::not_equal:
          return x.is_nonzero();
        case Relation::less:
          return x.is_negative();
        case Relation::less_or_equal:
          return !x.is_positive() && is_small(x);
        case Relation::greater:
          return x.is_positive();
        case Relation::greater_or_equal:
          return !x.is_negative() && is_small(x);
      }
      return false;
    });
  }
  [[nodiscard]] bool fails(const Statement& statement) const {
    const bool strict = statement.relation == Relation::less || statement.relation == Relation::greater;
    if (strict && equal(statement.left, statement.right)) {
      return true;
    }
    const Column d = difference(premises.with_motions(statement));
    return std::any_of(d.begin(), d.end(), [&](const Ball& x) {
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
  [[nodiscard]] bool is_nonzero(const Hypothesis& hypothesis) const {
    Sample<Ball> at(premises.values, [this](const std::string& name) { return free(name); });
    symbolic::BallValues values;
    for (const GiNaC::ex& symbol : symbolic::symbols_of(hypothesis.nonzero)) {
      values[symbol] = at(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
    }
    return symbolic::evaluate(hypothesis.nonzero, values).is_nonzero();
  }
};

namespace {

enum class Found { point, no_solution, excluded };

}  // namespace

std::vector<PremisePoint> Premises::points(std::size_t wanted) const {
  const WorkingPrecision precision(bits);
  std::vector<PremisePoint> found;
  for (const Replacements& way : ways_to_close()) {
    const auto closed = parts_->with(way);
    if (!closed || !closed->consistent) {
      continue;
    }
    const auto attempt = [&](unsigned seed) {
      const auto point = std::make_shared<PremisePoint::Point>(*closed, seed);
      const auto holds = [&](const Statement& statement) { return point->holds(statement); };
      const auto nonzero = [&](const Hypothesis& hypothesis) { return point->is_nonzero(hypothesis); };
      try {
        if (!point->solve()) {
          return Found::no_solution;
        }
        if (!std::all_of(closed->inequalities.begin(), closed->inequalities.end(), holds) ||
            !std::all_of(closed->hypotheses.begin(), closed->hypotheses.end(), nonzero)) {
          return Found::excluded;
        }
      } catch (const NoValue&) {
        return Found::no_solution;
      }
      found.push_back(PremisePoint(point));
      return Found::point;
    };
    const std::size_t enough = found.size() + wanted;
    const auto draws = static_cast<unsigned>(50 * wanted);
    unsigned unsolved = 0;
    for (unsigned seed = 1; seed <= draws && found.size() < enough && unsolved < 3; ++seed) {
      unsolved += attempt(seed) == Found::no_solution ? 1 : 0;
    }
    if (way.empty() && !found.empty()) {
      break;
    }
  }
  return found;
}

bool PremisePoint::confirms(const Statement& statement) const {
  const WorkingPrecision precision(bits);
  return point_->holds(statement);
}

bool PremisePoint::contradicts(const Statement& statement) const {
  const WorkingPrecision precision(bits);
  return point_->fails(statement);
}

bool PremisePoint::evaluates(const Statement& statement) const {
  const WorkingPrecision precision(bits);
  const Column d = point_->difference(point_->premises.with_motions(statement));
  return std::all_of(d.begin(), d.end(), is_small);
}

}  // namespace stickslip::proofs
