#include "proofs/methods/automatic.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "proofs/checks/premises.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/symbols/parse.hpp"
#include "proofs/tactics/algebraic_numbers.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/roots.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using symbols::Statement;
using tactics::attempt, tactics::first_that_works;

namespace {

Theorem by_squares(Derivation& derivation, const Formula& formula);
bool speaks_of_roots(const Formula& formula);

// a ≠ b by the sign of a - b.
Theorem differs(Derivation& derivation, const Formula& formula) {
  const Formula& same = formula.parts()[0];
  const Term gap = same.parts()[1] == Term(0) ? same.parts()[0] : same.parts()[0] - same.parts()[1];
  const auto by_sign = first_that_works(std::array{false, true}, [&](bool turned) {
    const Term size = turned ? -gap : gap;
    const auto at_once = attempt([&] { return derivation.positive(size); });
    if (!at_once && !speaks_of_roots(formula)) {
      throw KernelError("its sign is not known");
    }
    const Formula order = less(same.parts()[turned ? 0 : 1], same.parts()[turned ? 1 : 0]);
    const Theorem positive =
        at_once ? *at_once
                : derivation.order(less(0, size), {kernel::Positive{{by_squares(derivation, order)}}});
    const Theorem nonzero = tactics::different(
        turned ? derivation.order(less(gap, 0), {kernel::Positive{{positive}}}) : positive);
    const Theorem zero = Theorem::combination(equal(gap, 0), {{Theorem::assume(same)}});
    return derivation.without_divisors(
        Theorem::consequence({Theorem::discharge(zero, same), nonzero}, formula));
  });
  if (!by_sign) {
    throw KernelError("the sign of the difference is not known");
  }
  return *by_sign;
}

// a ≤ b, where b - a is a square times what is positive.
Theorem by_product(Derivation& derivation, const Formula& formula) {
  return derivation.order(formula, {not_negative(derivation, gap_of(formula))});
}

// The first that works.
Theorem first_of(const std::vector<Theorem (*)(Derivation&, const Formula&)>& ways, Derivation& derivation,
                 const Formula& formula) {
  const std::vector tried(ways.begin(), ways.end() - 1);
  const auto found = first_that_works(tried, [&](const auto way) { return way(derivation, formula); });
  return found ? *found : ways.back()(derivation, formula);
}

// "symbol = value", as far as the symbols are variables, in whichever direction it is said.
std::vector<Theorem> given_values(Derivation& derivation) {
  const auto given = Given::in_both_directions(derivation.claim());
  std::vector<Theorem> result;
  for (const Assumption& one : derivation.claim().assumptions) {
    const auto value = given.value_in(one);
    if (value && derivation.read(value->left).kind() == kernel::Kind::variable) {
      const Theorem said = Theorem::assume(derivation.read(one.statement));
      result.push_back(given.takes(one) ? said : tactics::symmetric(said));
    }
  }
  return result;
}

// The root, and those of which its square speaks, as the claim assumes it, with the values put in that are
// given.
void enclose(Derivation& derivation, const Variable& variable, tactics::Roots& roots) {
  const auto root = root_of(variable);
  if (!root || roots.contains(variable)) {
    return;
  }
  Theorem square = Theorem::assume(equal(power(variable, 2), derivation.read(root->arguments().front())));
  const std::vector<Theorem> values = given_values(derivation);
  for (std::size_t k = 0; k < values.size(); ++k) {  // each may speak of others
    for (const Theorem& value : values) {
      square = tactics::by_rewriting(square, value);
    }
  }
  for (const Variable& one : square.conclusion().parts()[1].variables()) {
    enclose(derivation, one, roots);
  }
  roots.add(square, Theorem::assume(at_most(0, variable)));
}

// With the values that are given put in no variable is left, but for roots: in balls, or in the algebra of
// roots and of sines and cosines of parts of the circle; there also what is equal for all values of others.
Theorem at_values(Derivation& derivation, const Formula& formula) {
  for (const Theorem& value : given_values(derivation)) {
    const Term& symbol = value.conclusion().parts()[0];
    if (!occurs(symbol, formula)) {
      continue;
    }
    const Variable x{symbol.name()};
    const Theorem there = at_values(derivation, substitute(formula, {{x, value.conclusion().parts()[1]}}));
    const Variable place = fresh(real_number, {formula, value.conclusion()});
    return Theorem::replace(tactics::symmetric(value), place, substitute(formula, {{x, place}}), there);
  }
  tactics::Roots roots;
  for (const Variable& one : formula.variables()) {
    static_cast<void>(attempt([&] {  // a root of what has no value is as any other variable
      enclose(derivation, one, roots);
      return true;
    }));
  }
  if (const auto decided = attempt([&] { return tactics::certainly(formula, roots.known()); })) {
    return roots.without_ranges(*decided);
  }
  if (!is_equation_of_numbers(formula)) {
    throw KernelError("it is not decided by values");
  }
  return derivation.without_divisors(roots.without_ranges(tactics::equal_numbers(formula, roots.known())));
}

Theorem related(Derivation& derivation, const Formula& formula) {
  return derivation.related(formula);
}

Theorem what_follows(Derivation& derivation, const Formula& formula) {
  return derivation.follows(formula);
}

Theorem directly(Derivation& derivation, const Formula& formula) {
  if (formula.kind() == kernel::Kind::negation && is_equation_of_numbers(formula.parts()[0])) {
    return first_of({at_values, differs}, derivation, formula);
  }
  if (formula.kind() == kernel::Kind::at_most) {
    return first_of({by_product, at_values, what_follows}, derivation, formula);
  }
  if (formula.kind() == kernel::Kind::exists) {
    if (const auto identity = attempt([&] { return derivation.combination(formula); })) {
      return *identity;
    }
    return derivation.with_derivatives(formula,
                                       [&](const Formula& one) { return directly(derivation, one); });
  }
  if (formula.kind() == kernel::Kind::disjunction && formula.parts().size() == 2 &&
      formula.parts()[0].kind() == kernel::Kind::less) {  // of an absolute value
    const Term &a = formula.parts()[0].parts()[0], &b = formula.parts()[0].parts()[1];
    if (const auto first = attempt([&] { return directly(derivation, formula.parts()[0]); })) {
      return Theorem::consequence({*first}, formula);
    }
    const Formula else_here = at_most(b, a);
    const Theorem rest = derivation.supposing(else_here, [&] {
      const auto one = attempt([&] { return directly(derivation, formula.parts()[1]); });
      return one ? *one : first_of({by_squares, related}, derivation, formula.parts()[1]);
    });
    return Theorem::consequence({Theorem::discharge(rest, else_here), Theorem::trichotomy(a, b)}, formula);
  }
  if (formula.kind() == kernel::Kind::conjunction) {
    std::vector<Theorem> parts;
    for (const Formula& one : formula.parts()) {
      parts.push_back(directly(derivation, one));
    }
    return tactics::both(parts);
  }
  return formula.kind() == kernel::Kind::less ? first_of({at_values, what_follows}, derivation, formula)
                                              : derivation.follows(formula);
}

bool speaks_of_roots(const Formula& formula) {
  return std::ranges::any_of(formula.variables(),
                             [](const Variable& one) { return root_of(one).has_value(); });
}

// The polynomial with a in place of the square of the letter.
Term with_square(const Polynomial& polynomial, std::size_t letter, const Term& a,
                 const tactics::Letters& letters) {
  std::vector<Term> sum{0};
  for (int k = 0; k <= degree(polynomial, letter); ++k) {
    const Term part = letters.term(coefficient(polynomial, letter, k)) * power(a, k / 2);
    sum.push_back(k % 2 == 0 ? part : part * letters.terms()[letter]);
  }
  return kernel::sum(sum);
}

// a = b, where b has no squares of roots.
Theorem without_squares_of_roots(Derivation& derivation, const Term& a) {
  Term b = a;
  for (bool more = true; more;) {  // a root may stand within another
    more = false;
    const tactics::Letters letters({b});
    const auto [above, below] = letters.fraction(b);
    for (std::size_t k = 0; k < letters.terms().size() && !more; ++k) {
      const Term& letter = letters.terms()[k];
      const auto root =
          letter.kind() == kernel::Kind::variable ? root_of({letter.name(), letter.type()}) : std::nullopt;
      if (root && std::max(degree(above, k), degree(below, k)) > 1) {
        const Term square = derivation.read(root->arguments().front());
        b = with_square(above, k, square, letters) / with_square(below, k, square, letters);
        more = true;
      }
    }
  }
  return a == b ? Theorem::reflexive(a) : derivation.combined(equal(a, b));
}

// a < b or a ≤ b by the squares of both sides, and their signs.
Theorem order_by_squares(Derivation& derivation, const Formula& formula) {
  const Term &a = tactics::sides_of(formula)[0], &b = tactics::sides_of(formula)[1];
  const bool strict = formula.kind() == kernel::Kind::less;
  const auto relation = [&](const Term& x, const Term& y) { return strict ? less(x, y) : at_most(x, y); };
  const Theorem in_a = without_squares_of_roots(derivation, power(a, 2)),
                in_b = without_squares_of_roots(derivation, power(b, 2));
  const Theorem squares = Theorem::order(
      relation(power(a, 2), power(b, 2)),
      {kernel::Positive{
          {directly(derivation, relation(in_a.conclusion().parts()[1], in_b.conclusion().parts()[1]))}}},
      {{in_a, -1}, {in_b}});
  return derivation.without_divisors((strict ? tactics::below_by_squares : tactics::at_most_by_squares)(
      squares, directly(derivation, at_most(0, b)), a, b));
}

// Likewise, with what is negative in the numerator of b - a on the one side, and the rest on the other.
Theorem order_by_squares_of_parts(Derivation& derivation, const Formula& formula) {
  const Term gap = gap_of(formula);
  const tactics::Letters letters({gap});
  const auto [above, below] = letters.fraction(gap);
  std::vector<Monomial> negative, positive;
  for (const Monomial& one : monomials(above)) {
    (one.coefficient < 0 ? negative : positive).push_back(one);
    if (one.coefficient < 0) {
      negative.back().coefficient = -one.coefficient;
    }
  }
  const auto side = [&](const std::vector<Monomial>& terms) {
    return letters.term(polynomial(letters.ring(), terms));
  };
  const bool strict = formula.kind() == kernel::Kind::less;
  const Theorem divisor = directly(derivation, less(0, letters.term(below)));
  const Theorem order = order_by_squares(
      derivation, strict ? less(side(negative), side(positive)) : at_most(side(negative), side(positive)));
  return derivation.order(formula, {kernel::Positive{{tactics::inverse_is_positive(divisor), order}}});
}

// By the squares of both sides, and their signs.
Theorem by_squares(Derivation& derivation, const Formula& formula) {
  if (formula.kind() != kernel::Kind::equal) {
    return first_of({order_by_squares, order_by_squares_of_parts}, derivation, formula);
  }
  const Term &a = tactics::sides_of(formula)[0], &b = tactics::sides_of(formula)[1];
  const auto squared = [](const Term& x) { return power(x, 2); };
  const auto not_below = [&](const Term& x) { return directly(derivation, at_most(0, x)); };
  const Theorem same = derivation.combined(equal(squared(a), squared(b)));
  const auto at_most_other = [&](const Term& x, const Term& y, long factor) {
    return tactics::at_most_by_squares(Theorem::order(at_most(squared(x), squared(y)), {}, {{same, -factor}}),
                                       not_below(y), x, y);
  };
  return derivation.without_divisors(Theorem::consequence(
      {at_most_other(a, b, 1), at_most_other(b, a, -1), Theorem::trichotomy(a, b)}, formula));
}

// Each assumed equation solved in one of its ways, and put into what is to be shown; `choice` counts the
// ways. Throws KernelError where there are no more of them, and sets `exhausted`.
Theorem put_in(Derivation& derivation, const Formula& formula, std::size_t choice, bool& exhausted) {
  const auto solutions = solved_in_turn(derivation, choice, true);
  if (!solutions || solutions->empty()) {
    exhausted = true;
    throw KernelError("no equation is assumed that could be put in");
  }
  for (const Theorem& one : *solutions) {
    derivation.give(one);
  }
  return directly(derivation, formula);
}

// What a known claim says in these very words, under what is assumed here. Throws KernelError; `assumes_more`
// says then of a claim that says it under assumptions that are not made here.
Theorem known_to_say(Derivation& derivation, const Formula& formula, std::string& assumes_more) {
  for (const Claim * one : derivation.prover().before(derivation.claim().id)) {
    const Claim& claim = *one;
    for (std::size_t i = 0; i < claim.printed.size(); ++i) {
      try {
        if (!claim.prove || !(derivation.read(claim.printed[i]) == formula)) {
          continue;
        }
        const Theorem theorem = derivation.premise(from(claim.id), i);
        Outcome ignored;
        try {
          derivation.record(ignored, theorem);
          assumes_more.clear();
          return theorem;
        } catch (const KernelError&) {
          assumes_more =
              fmt::format("{} says it, and assumes what is not assumed here: stickslip check {} --explain",
                          claim.id, claim.id);
        }
      } catch (const KernelError&) {
        continue;
      } catch (const symbols::NoValue&) {
        continue;
      }
    }
  }
  throw KernelError(assumes_more.empty() ? "no claim says it" : assumes_more);
}

// What is divided by is looked at, too.
Outcome searched(const std::string& route, Prover& prover, const Claim& claim,
                 const std::function<Theorem(Derivation&, std::size_t)>& work) {
  return derived(route, prover, claim, [&](Derivation& derivation, std::size_t which) {
    derivation.look_for_signs();
    return work(derivation, which);
  });
}

// The methods, of a claim with one printed statement.
Outcome by_itself_alone(Prover& prover, const Claim& claim) {
  const bool is_equation = claim.printed.front().relation == symbols::Relation::equal;
  return searched(is_equation ? "both sides have the same normal form, for all values of the symbols"
                              : "the sign of the difference of both sides, for all values of the symbols",
                  prover, claim, [](Derivation& derivation, std::size_t which) {
                    derivation.hurry();
                    return directly(derivation, derivation.printed(which));
                  });
}

Outcome with_equations_put_in(Prover& prover, const Claim& claim) {
  constexpr std::size_t most_choices = 24;
  Outcome best;
  bool exhausted = false;
  for (std::size_t choice = 0; choice < most_choices && !exhausted; ++choice) {
    Outcome outcome = searched("with the equations that are assumed put in", prover, claim,
                               [&](Derivation& derivation, std::size_t which) {
                                 derivation.hurry();
                                 return put_in(derivation, derivation.printed(which), choice, exhausted);
                               });
    const bool proved = outcome.verdict.truth == Truth::proved;
    if (best.verdict.truth != Truth::proved ||
        (proved && outcome.hypotheses.size() < best.hypotheses.size())) {
      best = std::move(outcome);
    }
    if (best.verdict.truth == Truth::proved && best.hypotheses.empty()) {
      break;
    }
  }
  return best;
}

Outcome as_combination(Prover& prover, const Claim& claim) {
  return searched("a combination of the equations that are assumed", prover, claim,
                  [](Derivation& derivation, std::size_t which) {
                    return derivation.combined(derivation.printed(which));
                  });
}

// What takes long: for what has no counterexample nearby.
Outcome by_search(Prover& prover, const Claim& claim) {
  const Statement& printed = claim.printed.front();
  const bool is_equation = printed.relation == symbols::Relation::equal;
  if (seems_to_fail(prover, claim, printed)) {
    Outcome outcome;
    outcome.verdict = Verdict::undecided("it fails at a point, as far as floating point can tell");
    return outcome;
  }
  return searched(is_equation ? "what is known leaves no other value"
                              : "the sign of the difference of both sides, for all values of the symbols",
                  prover, claim, [](Derivation& derivation, std::size_t which) {
                    const Formula formula = derivation.printed(which);
                    try {
                      return is_equation_of_numbers(formula)
                                 ? first_of({at_values, related}, derivation, formula)
                                 : directly(derivation, formula);
                    } catch (const KernelError&) {
                      if (const auto found = attempt([&] { return by_squares(derivation, formula); })) {
                        return *found;
                      }
                      throw;
                    }
                  });
}

// With the assumed equations as rules, for matrices whose order matters.
Outcome rewritten(Prover& prover, const Claim& claim) {
  std::vector<Premise> premises;
  for (const Assumption& one : claim.assumptions) {
    if (one.statement.relation == symbols::Relation::equal && !one.statement.during &&
        !is_substitution(one)) {
      premises.push_back(assuming(one.id));
    }
  }
  Outcome outcome;
  outcome.verdict = Verdict::undecided("no rules are assumed");
  try {
    return premises.empty() ? outcome : by_rewriting(premises)(prover, claim);
  } catch (const Error& error) {  // what cannot be solved for its left side is no rule
    outcome.verdict = Verdict::undecided(error.what());
    return outcome;
  }
}

Outcome first_that_proves(Prover& prover, const Claim& claim) {
  std::optional<Outcome> first;
  for (const auto method : {by_itself_alone, with_equations_put_in, as_combination, rewritten, by_search}) {
    Outcome outcome = method(prover, claim);
    if (outcome.verdict.truth == Truth::proved) {
      return outcome;
    }
    first = first ? first : std::move(outcome);
  }
  std::string assumes_more;
  Outcome last =
      derived("a claim of the paper says it", prover, claim, [&](Derivation& derivation, std::size_t which) {
        return known_to_say(derivation, derivation.printed(which), assumes_more);
      });
  return last.verdict.truth == Truth::proved || !assumes_more.empty() ? last : *first;
}

// The statements at points drawn at random, where they are not proved; and where a hypothesis of the proof
// fails.
void look_for_point(Outcome& outcome, Prover& prover, const Claim& claim) {
  const bool proved = outcome.verdict.truth == Truth::proved;
  std::vector<std::optional<Statement>> places(proved ? 0 : 1);
  for (const Hypothesis& one : proved ? outcome.hypotheses : std::vector<Hypothesis>{}) {
    places.emplace_back(symbols::equation(one.nonzero, 0));
  }
  for (const std::optional<Statement>& place : places) {
    for (const Statement& printed : claim.printed) {
      if (const auto refuted = refuted_at_point(prover, claim, printed, place)) {
        outcome = *refuted;
        return;
      }
    }
  }
}

void add(Outcome& whole, const Outcome& part) {
  whole.hypotheses = joined(whole.hypotheses, part.hypotheses);
  whole.uses.insert(part.uses.begin(), part.uses.end());
  whole.assumed.insert(part.assumed.begin(), part.assumed.end());
  whole.theorems.insert(whole.theorems.end(), part.theorems.begin(), part.theorems.end());
  std::set<std::string> free(whole.free.begin(), whole.free.end());
  free.insert(part.free.begin(), part.free.end());
  whole.free.assign(free.begin(), free.end());
}

symbols::Names names_with(const std::vector<std::string>& further) {
  symbols::Names names = symbols::names_of(symbols::symbol_table());
  for (const std::string& name : further) {
    if (!symbols::is_name(name)) {
      throw UsageError(
          fmt::format("'{}' is no name for a symbol: a name is a letter of a to z or A to Z, then such "
                      "letters and digits, as alpha for α",
                      name));
    }
    const bool is_open = checks::stands_for_itself(symbols::scalar(name)) &&
                         std::ranges::none_of(parameters(), [&](const Theorem& one) {
                           return one.conclusion().variables().contains(Variable{name});
                         });
    if (const std::string other = looks_like(name, names); !other.empty()) {
      throw UsageError(fmt::format("'{}' is printed as '{}' is: take another name", name, other));
    }
    constexpr std::array words{"t", "pi", "I", "det", "for", "but"};
    if (std::ranges::count(words, name) > 0 || names.functions.contains(name) || !is_open ||
        names.quantities.emplace(name, symbols::Shape{}).first->second != symbols::Shape{}) {
      throw UsageError(
          fmt::format("'{}' has a meaning already: take another name for a symbol of your own", name));
    }
  }
  return names;
}

}  // namespace

Proof automatically() {
  return [](Prover& prover, const Claim& claim) {
    Outcome outcome;
    std::vector<std::string> routes;
    std::vector<Verdict> verdicts;
    for (const Statement& printed : claim.printed) {
      const Claim one = saying(claim, {printed});
      Outcome found = first_that_proves(prover, one);
      verdicts.push_back(found.verdict);
      if (std::ranges::find(routes, found.route) == routes.end()) {
        routes.push_back(found.route);
      }
      add(outcome, found);
    }
    outcome.verdict = all_of(verdicts);
    outcome.by_kernel = outcome.verdict.truth == Truth::proved;
    outcome.route = fmt::format("{}", fmt::join(routes, "; "));
    if (outcome.verdict.truth != Truth::proved) {
      outcome.theorems.clear();
    }
    look_for_point(outcome, prover, claim);
    return outcome;
  };
}

std::string looks_like(const std::string& name, const symbols::Names& known) {
  const auto look = symbolic::typeset::latex_name;
  if (name != "I" && look(name) == look("I")) {  // the unit matrix
    return "I";
  }
  for (const auto * names : {&known.quantities, &known.functions}) {
    for (const auto& [other, shape] : *names) {
      if (other != name && look(other) == look(name)) {
        return other;
      }
    }
  }
  return "";
}

Claim own_claim(const OwnStatement& own) {
  symbols::Names names = names_with(own.symbols);
  names.own_by = own.symbols_by;
  Claim claim{.id = own_id, .place = "own", .kind = Kind::step, .origin = Origin::auxiliary};
  claim.words = "a statement of your own";
  claim.printed = symbols::parse_statements(own.statement, names);
  for (const std::string& line : own.assumptions) {
    for (const Statement& one : symbols::parse_statements(line, names)) {
      claim.assumptions.push_back({fmt::format("assumption {}", claim.assumptions.size() + 1), one});
    }
  }
  claim.prove = automatically();
  claim.is_searched = true;
  return saying(claim, claim.printed);
}

}  // namespace stickslip::proofs::methods
