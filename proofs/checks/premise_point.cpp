#include "proofs/checks/premises.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "proofs/checks/with_unknowns.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/sample.hpp"

namespace stickslip::proofs::checks {

using namespace numeric::scalars;
using namespace methods;
using namespace symbols;

namespace {

constexpr long bits = 256;

// What makes the load fit a motion that closes, where equations in the states alone cannot: it closes after
// Theta (28), lags behind a slip of length tau (16), turns half way in each of two equal phases or is even
// about the middle of the first (67); load and modes make whole turns in tau; or the unit of time is that of
// (3).
const std::vector<Replacements>& ways_to_close() {
  static const std::vector<Replacements> all = [] {
    const Term omega = scalar("omega"), tau = scalar("tau"), Theta = scalar("Theta");
    const Term unit = scalar("m1") * power(scalar("Omega"), 2) - scalar("k2");
    return std::vector<Replacements>{
        {},
        {{"omega", 2 * pi() / Theta}},
        {{"phi", (pi() - omega * tau) / 2}},
        {{"omega", pi() / tau}, {"tau1", tau}},
        {{"omega", 2 * pi() / Theta}, {"phi", -(omega * tau / 2)}},
        {{"k1", unit}},
        {{"omega1", 2 * pi() / tau}, {"omega", 4 * pi() / tau}, {"omega2", 6 * pi() / tau}}};
  }();
  static const std::vector<Replacements> none{{}};
  return vocabulary_here().is_of_model() ? all : none;
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

// The inequalities between what is not solved for.
std::vector<Statement> without_unknowns(const Premises& premises) {
  std::vector<Statement> result;
  for (const Statement& one : premises.inequalities) {
    std::set<std::string> names = premises.reached(one.left);
    names.merge(premises.reached(one.right));
    if (std::ranges::none_of(solved_for(), [&](const std::string& name) { return names.contains(name); })) {
      result.push_back(one);
    }
  }
  return result;
}

}  // namespace

struct PremisePoint::Point {
  std::shared_ptr<const Premises> shared;
  const Premises& premises = *shared;
  ExactPoint numbers;
  std::map<std::string, Ball> solved;
  mutable std::optional<Sample<Ball>> scalars;  // all that follows from these

  Point(std::shared_ptr<const Premises> all, unsigned seed) : shared(std::move(all)), numbers(seed) {}
  Point(const Point&) = delete;
  Point& operator=(const Point&) = delete;

  [[nodiscard]] Ball free(const std::string& name) const {
    if (vocabulary_here().is_of_model() && (name == "omega1" || name == "omega2") &&
        premises.values.contains("chi")) {  // chi and eta are given
      const auto modes = model::modes<Ball>(lookup()("chi"), lookup()("eta"));
      return name == "omega1" ? modes.omega1 : modes.omega2;
    }
    const auto found = solved.find(name);
    return found != solved.end() ? found->second
           : name == "pi"        ? Ball::pi()
                                 : Ball(numbers.symbol(name).value());
  }
  [[nodiscard]] Lookup<Ball> lookup() const {
    if (!scalars) {
      scalars.emplace(premises.values, [this](const std::string& name) { return free(name); });
    }
    return scalars->lookup();
  }
  // For a state of either sign, the others positive.
  [[nodiscard]] Rational any_sign(const std::string& name) const {
    const Rational value = numbers.symbol(name).value();
    return name.starts_with("z") ? Rational(value - numbers.symbol(name + " less").value()) : value;
  }
  // Left less right, entry by entry.
  [[nodiscard]] Column difference(const Statement& statement) const {
    const Sides<Ball> here = both_sides<Ball>(statement, lookup());
    const Value<Ball> d = here.left - here.right;
    return {d.data(), d.data() + d.size()};
  }

  // Solves the equations; whether that came out.
  [[nodiscard]] bool solve() {
    const std::vector<std::string>& names = solved_for();
    Sample<WithUnknowns> scalars_here(premises.values, [&](const std::string& name) {
      const auto unknown = std::ranges::find(names, name);
      return unknown == names.end()
                 ? WithUnknowns(free(name))
                 : WithUnknowns::unknown(static_cast<std::size_t>(unknown - names.begin()));
    });
    std::vector<Column> A;
    Column constant;
    for (const Statement& one : premises.equations) {
      const Sides<WithUnknowns> here = both_sides<WithUnknowns>(one, scalars_here.lookup());
      const Value<WithUnknowns> difference = here.left - here.right;
      for (const WithUnknowns& entry : difference.reshaped()) {
        constant.push_back(entry.at_zero);
        A.emplace_back(names.size(), Ball(0));
        for (const auto& [unknown, value] : entry.at_one) {
          A.back()[unknown] = value - entry.at_zero;
        }
      }
    }
    Column open;
    for (const std::string& name : names) {
      open.emplace_back(any_sign(name));
    }
    const Column u = solution(A, constant, open);
    for (std::size_t i = 0; i < u.size(); ++i) {
      solved.insert_or_assign(names[i], u[i]);
    }
    scalars.reset();
    return std::ranges::all_of(premises.equations, [this](const Statement& one) {
      const Column left = difference(one);
      return std::ranges::all_of(left, [](const Ball& x) { return x.contains_zero() && is_small(x); });
    });
  }

  [[nodiscard]] bool holds(const Statement& statement) const {
    const Statement here = with_less(premises.with_motions(statement));
    return std::ranges::all_of(difference(here), [&](const Ball& x) {
      switch (here.relation) {
        case Relation::equal:
          return x.contains_zero() && is_small(x);
        case Relation::not_equal:
          return x.is_nonzero();
        case Relation::less:
          return x.is_negative();
        default:
          return !x.is_positive() && is_small(x);
      }
    });
  }
  [[nodiscard]] bool fails(const Statement& statement) const {
    if (with_less(statement).relation == Relation::less && equal(statement.left, statement.right)) {
      return true;
    }
    const Statement here = with_less(premises.with_motions(statement));
    return std::ranges::any_of(difference(here), [&](const Ball& x) {
      switch (here.relation) {
        case Relation::equal:
          return x.is_nonzero();
        case Relation::not_equal:
          return x.is_exact() && !x.is_nonzero();
        default:
          return x.is_positive();
      }
    });
  }
  [[nodiscard]] bool is_nonzero(const Hypothesis& hypothesis) const {
    return evaluate<Ball>(hypothesis.nonzero, lookup())(0, 0).is_nonzero();
  }
  [[nodiscard]] bool is_in_domain() const {
    return std::ranges::all_of(vocabulary_here().domain(),
                               [this](const Statement& one) { return holds(one); });
  }
  // Whether the inequalities hold, and no hypothesis vanishes.
  [[nodiscard]] bool is_admissible() const {
    return std::ranges::all_of(premises.inequalities,
                               [this](const Statement& statement) { return holds(statement); }) &&
           std::ranges::all_of(premises.hypotheses,
                               [this](const Hypothesis& hypothesis) { return is_nonzero(hypothesis); });
  }
};

std::vector<PremisePoint> premise_points(const Premises& premises, std::size_t wanted) {
  const auto draws = static_cast<unsigned>(50 * wanted);
  constexpr unsigned draws_without_solution = 3, draws_outside = 20;  // in a row: us may have to be 0
  const WorkingPrecision precision(bits);
  std::vector<PremisePoint> found;
  for (const Replacements& way : ways_to_close()) {
    const auto closed = premises.with(way);
    if (!closed || !closed->consistent) {
      continue;
    }
    const auto shared = std::make_shared<const Premises>(*closed);
    const std::vector<Statement> ranges = without_unknowns(*shared);
    const std::size_t enough = found.size() + wanted;
    unsigned unsolved = 0, outside = 0;
    for (unsigned seed = 1; seed <= draws && found.size() < enough && unsolved < draws_without_solution &&
                            outside < draws_outside;
         ++seed) {
      const auto point = std::make_shared<PremisePoint::Point>(shared, seed);
      if (!std::ranges::all_of(ranges, [&](const Statement& one) { return point->holds(one); })) {
        continue;
      }
      if (!point->solve()) {
        ++unsolved;
      } else if (!point->is_in_domain()) {
        ++outside;
      } else {
        outside = 0;
        if (point->is_admissible()) {
          found.push_back(PremisePoint(point));
        }
      }
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
  return std::ranges::all_of(d, is_small);
}

}  // namespace stickslip::proofs::checks
