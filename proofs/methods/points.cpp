#include "proofs/methods/refutation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/roots.hpp"
#include "proofs/tactics/slopes.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using symbols::Statement;

namespace {

std::vector<Theorem> solved(Derivation& derivation, const Theorem& equation) {
  const Term gap = equation.conclusion().parts()[0] - equation.conclusion().parts()[1];
  const tactics::Letters letters({gap});
  const auto [above, below] = letters.fraction(gap);
  std::vector<Theorem> result;
  for (std::size_t k = 0; k < letters.terms().size(); ++k) {
    const Term& letter = letters.terms()[k];
    if (letter.kind() == kernel::Kind::pi || degree(above, k) != 1) {
      continue;
    }
    Polynomial without = coefficient(above, k, 0);
    without *= letters.ring().constant(-1);
    const Term slope = letters.term(coefficient(above, k, 1)), rest = letters.term(without);
    if (occurs(letter, slope) || occurs(letter, rest)) {
      continue;  // x in an equation with cos(x)
    }
    const Term by = letters.term(below) / slope;
    if (const auto solution = tactics::attempt([&] {
          return derivation.combination(equal(letter, rest / slope), {{equation, by, 1}});
        })) {
      result.push_back(*solution);
    }
  }
  return result;
}

// The numbers between which conditions say that it lies, nearly.
Bounds said_bounds(const std::vector<Formula>& conditions, const Variable& x) {
  Bounds result;
  for (const Formula& one : conditions) {
    if (one.kind() != kernel::Kind::less && one.kind() != kernel::Kind::at_most) {
      continue;
    }
    const bool is_lower = one.parts()[1] == Term(x);
    const Term& end = one.parts()[is_lower ? 0 : 1];
    constexpr long double fine = 1024, largest = 0x1p40L;
    if (!(is_lower || one.parts()[0] == Term(x)) || !end.variables().empty()) {
      continue;
    }
    Rational number;
    if (end.kind() == kernel::Kind::number) {
      number = end.value();
    } else if (const long double near = tactics::estimated(end, {}); std::abs(near) < largest) {
      number = Rational(Rational(std::lround(fine * near)) / std::lround(fine));
    } else {
      continue;
    }
    std::optional<Rational>& known = is_lower ? result.lower : result.upper;
    known = !known || (is_lower ? *known < number : *known > number) ? number : *known;
  }
  return result;
}

// Rational values for symbols, in the parameters' domain.
class Draw {
 public:
  // Of draw `k`: the first have the same small value for all that is not bounded; of the others half lie
  // where it is said to.
  [[nodiscard]] Rational value(const std::string& name, std::size_t k, const Bounds& said) {
    // Small ones, among which equations of low degree have solutions.
    static const std::array<Rational, 14> small{
        Rational(0),     Rational(1),    Rational(-1),    Rational(1, 2),  Rational(2),
        Rational(3, 5),  Rational(4, 5), Rational(-3, 5), Rational(5, 13), Rational(12, 13),
        Rational(-1, 2), Rational(3),    Rational(-2),    Rational(1, 3)};
    const auto any_small = [this] {
      return small[static_cast<std::size_t>(below(static_cast<int>(small.size())))];
    };
    const Bounds bounds = bounds_of(name);
    if (bounds.lower && bounds.upper) {
      return *bounds.lower + ratio(below(19) + 1, 20) * (*bounds.upper - *bounds.lower);
    }
    const Rational size = ratio(below(60) + 1, 1 + below(12));
    if (bounds.lower || bounds.upper) {
      constexpr std::size_t many = 100;
      const Rational other = k < many ? small[0] : any_small();
      if (k >= many && (bounds.lower ? other > *bounds.lower : other < *bounds.upper) && below(2) == 0) {
        return other;
      }
      return bounds.lower ? Rational(*bounds.lower + size) : Rational(*bounds.upper - size);
    }
    if (k < small.size()) {
      return small[k];
    }
    if (said.lower && said.upper && k % 2 == 0) {
      return *said.lower + ratio(below(499) + 1, 500) * (*said.upper - *said.lower);
    }
    return below(2) == 0 ? any_small() : below(2) == 0 ? size : Rational(-size);
  }

 private:
  [[nodiscard]] static Rational ratio(int above, int below) {
    Rational result(above, below);
    result.canonicalize();
    return result;
  }
  [[nodiscard]] int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  std::mt19937 random_{1};
};

constexpr double fault = 1e-9;

// Whether it holds nearly there, a < b by at least the margin; nothing where that cannot be said.
std::optional<bool> holds_nearly(const Formula& formula, const tactics::Point& values,
                                 double margin = fault) {
  const auto gap_above = [&](double least) {
    const long double gap = tactics::estimated(gap_of(formula), values);
    return std::isfinite(gap) ? std::optional(gap > least) : std::nullopt;
  };
  switch (formula.kind()) {
    case kernel::Kind::equal: {
      const Term difference = gap_of(formula);
      const Type& type = difference.type();
      for (int k = 0; k < type.rows * type.columns; ++k) {
        const Term one =
            type.is_scalar() ? difference : entry(difference, k / type.columns, k % type.columns);
        const long double gap = tactics::estimated(one, values);
        if (!(std::abs(gap) < fault)) {
          return std::isfinite(gap) ? std::optional(false) : std::nullopt;
        }
      }
      return true;
    }
    case kernel::Kind::less:
      return gap_above(margin);
    case kernel::Kind::at_most:
      return gap_above(-fault);
    case kernel::Kind::negation: {
      const auto inside = holds_nearly(formula.parts()[0], values, margin);
      return inside ? std::optional(!*inside) : std::nullopt;
    }
    case kernel::Kind::conjunction:
    case kernel::Kind::disjunction: {
      const bool one_decides = formula.kind() == kernel::Kind::disjunction;
      for (const Formula& part : formula.parts()) {
        const auto here = holds_nearly(part, values, margin);
        if (!here || *here == one_decides) {
          return here;
        }
      }
      return !one_decides;
    }
    default:
      return std::nullopt;
  }
}

// What is drawn and what follows from that.
struct Unknowns {
  Variables drawn;
  std::vector<Statement> values;    // "symbol = value"
  std::vector<Formula> conditions;  // with the values put in
  std::optional<Formula> failing;   // likewise
  // Of these, the roots, and what they are roots of; those within another first.
  std::vector<std::pair<Variable, Term>> roots = {};
};

// Whether it says of a root of what it is one.
bool is_of_root(Derivation& derivation, const Formula& equation) {
  const Term& square = equation.parts()[0];
  if (square.kind() != kernel::Kind::power || square.parts()[0].kind() != kernel::Kind::variable) {
    return false;
  }
  const Variable name{square.parts()[0].name()};
  const auto root = root_of(name);
  return root && equation == equal(power(name, 2), derivation.read(root->arguments().front()));
}

// Adds the values of the roots; whether they have some.
bool add_roots(tactics::Point& values, const std::vector<std::pair<Variable, Term>>& roots) {
  return std::ranges::all_of(roots, [&](const auto& root) {
    const long double value = tactics::nearly_root(tactics::estimated(root.second, values));
    return std::isfinite(value) && values.emplace(root.first, Rational(static_cast<double>(value))).second;
  });
}

// With each assumed equation solved in one of its ways, which `choice` counts; nothing where there are no
// more ways.
std::optional<Unknowns> unknowns(Derivation& derivation, const std::optional<Statement>& failing,
                                 std::size_t choice) {
  Unknowns result;
  Substitution given;
  Given taken;
  const auto take = [&](const Statement& value) {
    const bool is_new = taken.take(value);
    if (is_new) {
      result.values.push_back(value);
    }
    return is_new;
  };
  const auto solutions = solved_in_turn(derivation, choice, false);
  if (!solutions) {
    return std::nullopt;
  }
  for (const Theorem& one : *solutions) {
    const Term &letter = one.conclusion().parts()[0], &value = one.conclusion().parts()[1];
    given.emplace(Variable{letter.name()}, value);
    const auto stated = std::ranges::find_if(derivation.claim().assumptions, [&](const Assumption& assumed) {
      return is_substitution(assumed) && assumed.statement.left.name() == letter.name();
    });
    if (stated == derivation.claim().assumptions.end() || !take(stated->statement)) {
      take(symbols::equation(printed_term(letter), printed_term(value)));
    }
  }
  for (const Assumption& one : derivation.claim().assumptions) {
    if (is_substitution(one)) {
      take(one.statement);
    }
  }
  const auto put_in = [&](Term formula) {
    for (std::size_t k = 0; k < given.size(); ++k) {  // each value may speak of others
      formula = substitute(formula, given);
    }
    return formula;
  };
  for (const Formula& one : derivation.assumed()) {
    if (std::ranges::all_of(one.variables(), [](const Variable& x) { return x.type == real_number; })) {
      result.conditions.push_back(put_in(tactics::with_slopes(one)));
    }
  }
  const auto draw_all_of = [&](const Formula& formula) {
    result.drawn.insert(formula.variables().begin(), formula.variables().end());
  };
  if (failing) {
    result.failing = put_in(tactics::with_slopes(derivation.read(*failing)));
    draw_all_of(*result.failing);
  }
  std::ranges::for_each(result.conditions, draw_all_of);
  for (const auto& value : given) {
    draw_all_of(put_in(value.second));
  }
  for (const Theorem& one : parameters()) {
    const Formula condition = put_in(one.conclusion());
    if (std::ranges::includes(result.drawn, condition.variables(), Before{})) {
      result.conditions.push_back(condition);
    }
  }
  for (const Variable& one : result.drawn) {
    if (const auto root = root_of(one)) {
      result.roots.emplace_back(one, put_in(derivation.read(root->arguments().front())));
    }
  }
  std::ranges::sort(result.roots, {}, [](const auto& root) { return root.first.name.size(); });
  return result;
}

// Up to `most` scenes, drawn at random, the same on every run, at which all that the claim assumes of numbers
// holds nearly and `failing`, if it is given, does not. Assumed equations between numbers are solved for one
// of their symbols each where they are linear in one. None where `failing` speaks of motions. Where nothing
// is drawn there is one point: `in_doubt` takes it even where floating point cannot tell that it fails.
std::vector<Scene> scenes(Prover& prover, const Claim& claim, const std::optional<Statement>& failing,
                          std::size_t most, bool in_doubt) {
  constexpr std::size_t most_choices = 8;
  constexpr std::size_t draws = 1000;
  // An equation of analytic terms that holds at so many points in turn, whatever is assumed, holds at all.
  constexpr std::size_t most_agreeing = 40;
  Derivation derivation(prover, claim);
  std::vector<Scene> result;
  Draw draw;
  for (std::size_t choice = 0; choice < most_choices; ++choice) {
    const std::optional<Unknowns> open = unknowns(derivation, failing, choice);
    if (!open ||
        std::ranges::any_of(open->drawn, [](const Variable& one) { return one.type != real_number; })) {
      break;
    }
    const bool is_only_point =
        std::ranges::all_of(open->drawn, [](const Variable& one) { return root_of(one).has_value(); });
    std::map<Variable, Bounds, Before> said;
    for (const Variable& name : open->drawn) {
      said.emplace(name, said_bounds(open->conditions, name));
    }
    std::size_t agreeing = 0;
    for (std::size_t k = 0;
         k < (is_only_point ? 1 : draws) && result.size() < most && agreeing < most_agreeing; ++k) {
      tactics::Point values;
      Scene scene{.values = open->values};
      for (const Variable& name : open->drawn) {
        if (root_of(name)) {
          continue;
        }
        scene.point.push_back(
            {name.name, values.emplace(name, draw.value(name.name, k, said.at(name))).first->second});
      }
      if (!add_roots(values, open->roots)) {
        continue;
      }
      const auto holds = open->failing ? holds_nearly(*open->failing, values, 0) : std::optional(false);
      if (holds != std::optional(false) && !(is_only_point && in_doubt)) {
        agreeing += holds && open->failing->kind() == kernel::Kind::equal ? 1 : 0;
        continue;
      }
      agreeing = 0;
      if (std::ranges::all_of(open->conditions, [&](const Formula& one) {
            return holds_nearly(one, values) == std::optional(true);
          })) {
        result.push_back(std::move(scene));
      }
    }
  }
  return result;
}

// The first scene at which the kernel says so, with its theorem: all of `holding`, and not `failing`.
std::optional<std::pair<Scene, Theorem>> said_at_point(Prover& prover, const Claim& claim,
                                                       const std::vector<Statement>& holding,
                                                       const std::optional<Statement>& failing,
                                                       const std::optional<Statement>& doubted = {}) {
  constexpr std::size_t most_attempts = 12;
  const std::vector<Statement> failed = failing ? std::vector<Statement>{*failing} : std::vector<Statement>{};
  std::optional<std::pair<Scene, Theorem>> said;
  failure_of([&] {  // no floating point says where to look
    said = tactics::first_that_works(
        scenes(prover, claim, doubted ? doubted : failing, most_attempts, true),
        [&](const Scene& scene) { return std::pair(scene, refutation(prover, scene, holding, failed)); });
  });
  return said;
}

}  // namespace

std::optional<std::vector<Theorem>> solved_in_turn(Derivation& derivation, std::size_t choice,
                                                   bool any_letter) {
  std::vector<Theorem> result;
  for (const Formula& one : derivation.assumed()) {
    if (!is_equation_of_numbers(one) || (!any_letter && is_of_root(derivation, one))) {
      continue;
    }
    Theorem equation = Theorem::assume(one);
    for (const Theorem& before : result) {
      equation = tactics::by_rewriting(equation, before);
    }
    std::vector<Theorem> ways;
    const Term &left = equation.conclusion().parts()[0], &right = equation.conclusion().parts()[1];
    if (!any_letter && left.kind() == kernel::Kind::variable && !occurs(left, right)) {
      ways = {equation};
    } else {
      try {
        ways = solved(derivation, equation);
      } catch (const KernelError&) {  // it divides by what is zero
      }
    }
    if (!any_letter) {
      std::erase_if(ways, [](const Theorem& way) {
        return way.conclusion().parts()[0].kind() != kernel::Kind::variable;
      });
    }
    if (!ways.empty()) {
      result.push_back(ways[choice % ways.size()]);
      choice /= ways.size();
    }
  }
  return choice > 0 ? std::nullopt : std::optional(result);
}

std::vector<Statement> assumed_statements(const Claim& claim) {
  std::vector<Statement> result;
  for (const Assumption& one : claim.assumptions) {
    result.push_back(one.statement);
  }
  return result;
}

Claim with_hypotheses(const Claim& claim, const std::vector<Hypothesis>& hypotheses) {
  Claim result = claim;
  for (const Hypothesis& one : hypotheses) {
    result.assumptions.push_back({"hypothesis", {one.nonzero, 0, symbols::Relation::not_equal}});
  }
  return result;
}

std::optional<Outcome> refuted_at_point(Prover& prover, const Claim& claim, const Statement& printed,
                                        const std::optional<Statement>& where,
                                        const std::optional<Statement>& doubted) {
  const Claim alone = saying(claim, {printed});
  Claim there = alone;
  if (where) {
    there.assumptions.push_back({"where", *where});
  }
  const auto said = said_at_point(prover, there, assumed_statements(alone), printed, doubted);
  if (!said) {
    return std::nullopt;
  }
  Outcome outcome{.theorems = {said->second}, .by_kernel = true};
  outcome.route = "values with which all that is assumed holds and what is printed does not, in balls";
  outcome.verdict = Verdict::refuted(witness_of(doubted.value_or(printed), said->first));
  return outcome;
}

bool seems_to_fail(Prover& prover, const Claim& claim, const Statement& statement) {
  bool seems = false;
  failure_of([&] { seems = !scenes(prover, claim, statement, 1, false).empty(); });
  return seems;
}

std::optional<Theorem> obeying_point(Prover& prover, const Claim& claim,
                                     const std::vector<Hypothesis>& hypotheses) {
  const Claim all = with_hypotheses(claim, hypotheses);
  const auto said = said_at_point(prover, all, assumed_statements(all), std::nullopt);
  return said ? std::optional(said->second) : std::nullopt;
}

bool is_equation_of_numbers(const Formula& formula) {
  return formula.kind() == kernel::Kind::equal && formula.parts()[0].type().is_scalar();
}

}  // namespace stickslip::proofs::methods
