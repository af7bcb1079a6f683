// How a derivation finds which definitions to open and which given values to put in, and what follows from
// what the claim assumes.
#include <algorithm>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/relations.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using namespace tactics;

Theorem Derivation::with_given(const Problem& problem, const std::set<std::string>& ids, const Rule& rule,
                               std::set<std::string>& used, int depth) {
  if (depth > 16) {
    throw KernelError("what is given goes in circles");
  }
  for (const Given& one : given_) {
    const auto has = [&](const Term& term) { return occurs(one.symbol(), term); };
    if (!(one.id.empty() || ids.contains(one.id)) || std::ranges::none_of(terms_of(problem), has)) {
      continue;
    }
    if (!one.id.empty()) {
      used.insert(one.id);
    }
    const Theorem& equation = one.equation;
    const bool is_variable = one.symbol().kind() == kernel::Kind::variable;
    const auto put_in = [&](const Term& term) {
      return is_variable ? substitute(term, {{{one.symbol().name(), one.symbol().type()}, one.value()}})
                         : replaced(term, one.symbol(), one.value());
    };
    Problem inner{put_in(problem.goal), {}, {}};
    for (const Multiple& multiple : problem.multiples) {
      inner.multiples.push_back({tactics::by_rewriting(multiple.equation, equation), put_in(multiple.left),
                                 put_in(multiple.right)});
    }
    for (const Positive& positive : problem.positives) {
      Positive changed{{}, positive.factor, put_in(positive.square)};
      for (const Theorem& inequality : positive.inequalities) {
        changed.inequalities.push_back(tactics::by_rewriting(inequality, equation));
      }
      inner.positives.push_back(changed);
    }
    const Theorem theorem = with_given(inner, ids, rule, used, depth + 1);
    const Variable place = fresh(one.symbol().type(), {problem.goal, one.symbol(), one.value()});
    return Theorem::replace(symmetric(equation), place, replaced(problem.goal, one.symbol(), place), theorem);
  }
  return rule(problem);
}

Theorem Derivation::with_fewest_given(const Problem& problem, const Rule& rule) {
  std::set<std::string> ids, used;
  try {
    return with_given(problem, ids, rule, used);
  } catch (const KernelError&) {
    for (const Given& one : given_) {
      ids.insert(one.id);
    }
  }
  Theorem theorem = with_given(problem, ids, rule, used);
  if (used.empty()) {
    throw KernelError("nothing is given that helps");
  }
  ids = used;
  for (const std::string& id : std::set<std::string>(used)) {
    ids.erase(id);
    try {
      if (!ids.empty()) {
        std::set<std::string> still;
        theorem = with_given(problem, ids, rule, still);
      } else {
        ids.insert(id);
      }
    } catch (const KernelError&) {
      ids.insert(id);
    }
  }
  return theorem;
}

// All that it is made of.
std::vector<Term> Derivation::terms_of(const Problem& problem) {
  std::vector<Term> all{problem.goal};
  for (const Multiple& multiple : problem.multiples) {
    all.insert(all.end(), {multiple.equation.conclusion(), multiple.left, multiple.right});
  }
  for (const Positive& positive : problem.positives) {
    all.push_back(positive.square);
    for (const Theorem& inequality : positive.inequalities) {
      all.push_back(inequality.conclusion());
    }
  }
  return all;
}

// What is to be zero for the rules order and combination: the difference of the sides, less what it is to be.
std::vector<Term> Derivation::residual(const Problem& problem) {
  const bool equation = problem.goal.kind() == kernel::Kind::equal;
  const std::vector<Term>& sides = tactics::sides_of(problem.goal);
  std::vector<Term> parts{sides[equation ? 0 : 1], -sides[equation ? 1 : 0]};
  for (const Multiple& multiple : problem.multiples) {
    parts.push_back(multiple.left * gap_of(multiple.equation.conclusion()) * multiple.right);
  }
  for (const Positive& positive : problem.positives) {
    Term product = Term(-positive.factor) * power(positive.square, 2);
    for (const Theorem& inequality : positive.inequalities) {
      product = product * gap_of(inequality.conclusion());
    }
    parts.push_back(product);
  }
  return parts;
}

Theorem Derivation::with_derivatives(const Formula& formula, const tactics::Shown& shown) {
  return tactics::there_are_slopes(
      formula, [this](const Theorem& slope) { return without_divisors(slope); }, shown);
}

Theorem Derivation::solved(const Problem& problem, bool is_order) {
  std::vector<Term> said = terms_of(problem);
  for (const Given& one : given_) {
    said.push_back(one.value());
  }
  const Openings open = openings(said);
  std::vector<Definitions> ladder{{}, open.names, open.with({})};
  for (const auto& entry : open.closed) {
    ladder.push_back(open.with({entry.first}));
  }
  ladder.push_back(open.all());
  ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
  for (const Definitions& unfolded : ladder) {
    try {
      const Rule rule = [&](const Problem& one) {
        if (one.goal.kind() == kernel::Kind::exists) {
          return with_derivatives(one.goal, [&](const Formula& equation) {
            return Theorem::combination(equation, {}, unfolded);
          });
        }
        if (!seems_zero(residual(one), unfolded)) {
          throw KernelError("it does not come out, not even nearly at a point");
        }
        return is_order ? Theorem::order(one.goal, one.positives, one.multiples, unfolded)
                        : Theorem::combination(one.goal, one.multiples, unfolded);
      };
      const Theorem theorem = without_divisors(with_fewest_given(problem, rule));
      for (const auto& [id, definitions] : open.closed) {
        if (std::ranges::includes(unfolded, definitions)) {
          uses_.insert(id);
        }
      }
      return theorem;
    } catch (const KernelError&) {
      if (unfolded == ladder.back()) {
        throw;
      }
    }
  }
  throw KernelError("nothing to open");
}

Theorem Derivation::combination(const Formula& equation, const std::vector<Multiple>& multiples) {
  return solved({equation, multiples, {}}, false);
}

Theorem Derivation::order(const Formula& inequality, const std::vector<Positive>& positives,
                          const std::vector<Multiple>& multiples) {
  return solved({inequality, multiples, positives}, true);
}

Theorem Derivation::positive(const Term& a) {
  const Definitions definitions = openings({a}).all();
  const Term opened = unfold(a, definitions);
  const auto in = [&](const Domain& domain) {
    return Theorem::convert(tactics::positive(opened, domain), less(0, a), definitions);
  };
  try {
    return in(domain_);
  } catch (const KernelError&) {
    const std::vector<Theorem> sines = positive_sines(opened);
    if (sines.empty()) {
      throw;
    }
    Domain with_sines = domain_;
    with_sines.insert(with_sines.end(), sines.begin(), sines.end());
    return in(with_sines);
  }
}

// ⊢ 0 < sin x for the sines in the term of which the assumptions say that 0 < x < pi.
std::vector<Theorem> Derivation::positive_sines(const Term& term) {
  std::set<Term> arguments;
  if (!looks_at_sines_ && !known_.empty()) {
    for (const Term& sine :
         parts_that(term, [](const Term& part) { return part.kind() == kernel::Kind::sine; })) {
      arguments.insert(sine.parts()[0]);
    }
  }
  const bool before = std::exchange(looks_at_sines_, true);  // an argument may have sines, too
  std::vector<Theorem> result;
  for (const Term& x : arguments) {
    if (const auto in_range = attempt([&] { return both({follows(less(0, x)), follows(less(x, pi()))}); })) {
      result.push_back(detach(Theorem::sine_is_positive(x), *in_range));
    }
  }
  looks_at_sines_ = before;
  return result;
}

// From what is known: as a sum of one or two of the inequalities, as a positive multiple of one, or as a
// positive product.
Theorem Derivation::follows(const Formula& formula) {
  if (formula.kind() == kernel::Kind::equal) {
    return combination(formula);
  }
  if (is_divisor(formula)) {
    throw KernelError("a divisor is not zero because that is assumed");
  }
  if (formula.kind() == kernel::Kind::conjunction) {
    std::vector<Theorem> parts;
    for (const Formula& one : formula.parts()) {
      parts.push_back(follows(one));
    }
    return both(parts);
  }
  if (!is_inequality(formula)) {
    throw KernelError("there is no way to derive " + to_string(formula));
  }
  std::vector<std::vector<Positive>> sums;
  if (formula.kind() == kernel::Kind::at_most) {
    sums.emplace_back();
  }
  for (std::size_t i = 0; i < known_.size(); ++i) {
    sums.push_back({Positive{{known_[i]}}});
    for (std::size_t j = 0; j < i; ++j) {
      sums.push_back({Positive{{known_[i]}}, Positive{{known_[j]}}});
    }
  }
  if (const auto theorem =
          first_that_works(sums, [&](const auto& positives) { return order(formula, positives); })) {
    return *theorem;
  }
  const Rule rule = [&](const Problem& one) {
    const auto as_square = attempt([&] {  // which may be zero
      return without_divisors(Theorem::order(one.goal, {not_negative(*this, gap_of(one.goal))}));
    });
    if (as_square) {
      return *as_square;
    }
    const auto as_multiple = first_that_works(one.positives, [&](const Positive& known) {
      const Theorem& inequality = known.inequalities[0];
      const Theorem factor = positive(quotient(gap_of(one.goal), gap_of(inequality.conclusion())));
      return without_divisors(Theorem::order(one.goal, {Positive{{factor, inequality}}}));
    });
    return as_multiple ? *as_multiple
                       : without_divisors(Theorem::order(one.goal, {Positive{{positive(gap_of(one.goal))}}}));
  };
  Problem problem{formula};
  for (const Theorem& known : known_) {
    problem.positives.push_back({{known}});
  }
  try {
    return with_fewest_given(problem, rule);
  } catch (const KernelError&) {
    if (const auto theorem = attempt([&] { return related(formula); })) {
      return *theorem;
    }
    throw;
  }
}

Theorem Derivation::related(const Formula& formula) {
  if (hurries_ || (!is_inequality(formula) && !is_equation_of_numbers(formula))) {
    throw KernelError("it is not looked for");
  }
  const Rule rule = [&](const Problem& one) {
    std::vector<Theorem> known;
    for (const Positive& positive : one.positives) {
      known.push_back(positive.inequalities[0]);
    }
    for (const Multiple& multiple : one.multiples) {
      known.push_back(multiple.equation);
    }
    const Definitions definitions = openings(terms_of(one)).all();
    for (Theorem& theorem : known) {
      theorem = Theorem::convert(theorem, unfold(theorem.conclusion(), definitions), definitions);
    }
    return without_divisors(
        Theorem::convert((is_inequality(one.goal) ? tactics::inequality : tactics::equation)(
                             unfold(one.goal, definitions), known),
                         one.goal, definitions));
  };
  Problem problem{formula};
  for (const Theorem& known : domain_) {
    if (is_inequality(known.conclusion())) {
      problem.positives.push_back({{known}});
    }
  }
  for (const Formula& one : assumed()) {
    const bool is_given = std::ranges::any_of(given_, [&](const Given& given) {
      return given.equation.conclusion() == one ||
             (!given.id.empty() && given.equation.hypotheses().contains(one));
    });
    if (is_equation_of_numbers(one) && !is_given) {
      problem.multiples.push_back({Theorem::assume(one)});
    }
  }
  if (const auto theorem = attempt([&] { return with_fewest_given(problem, rule); })) {
    return *theorem;
  }
  // a < b, where a ≤ b and it is assumed that they differ.
  const Theorem differs = without_divisors(Theorem::assume(differ(gap_of(formula), 0)));
  if (formula.kind() != kernel::Kind::less ||
      !std::ranges::includes(assumed(), differs.hypotheses(), Before{})) {
    throw KernelError("nothing known says it");
  }
  const Term &a = formula.parts()[0], &b = formula.parts()[1];
  const Theorem same = Theorem::combination(equal(gap_of(formula), 0), {{Theorem::assume(equal(a, b)), -1}});
  return Theorem::consequence(
      {related(at_most(a, b)), differs, Theorem::discharge(same, equal(a, b)), Theorem::trichotomy(a, b)},
      formula);
}

Theorem Derivation::combined(const Formula& equation) {
  if (equation.kind() == kernel::Kind::exists) {
    return with_derivatives(equation, [&](const Formula& one) { return combined(one); });
  }
  const auto difference = [](const Formula& one) { return one.parts()[0] - one.parts()[1]; };
  std::vector<Theorem> equations;
  std::vector<Formula> said{equation};
  for (const Formula& one : assumed()) {
    if (is_equation_of_numbers(one)) {
      equations.push_back(Theorem::assume(one));
      said.push_back(one);
    }
  }
  if (!is_equation_of_numbers(equation) || equations.empty()) {
    throw KernelError("there are no equations to be combined");
  }
  for (const Definitions& opened : {Definitions{}, openings(said).all()}) {
    std::vector<Term> given;
    for (const Theorem& one : equations) {
      given.push_back(unfold(difference(one.conclusion()), opened));
    }
    if (const auto factors = multipliers(unfold(difference(equation), opened), given)) {
      std::vector<Multiple> multiples;
      for (std::size_t k = 0; k < equations.size(); ++k) {
        if (!((*factors)[k] == Term(0))) {
          multiples.push_back({equations[k], (*factors)[k], 1});
        }
      }
      return combination(equation, multiples);
    }
  }
  throw KernelError("it is no combination of the assumed equations");
}

}  // namespace stickslip::proofs::methods
