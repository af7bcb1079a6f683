#include "proofs/tactics/almost_always.hpp"

#include <algorithm>

namespace stickslip::proofs::tactics {

using namespace kernel;

Formula usual(const Formula& almost_always, const Term& t) {
  if (almost_always.kind() == Kind::finite) {
    const Formula exception = opened(almost_always, t);
    if (exception.kind() == Kind::conjunction && exception.parts().size() == 2 &&
        exception.parts()[1].kind() == Kind::negation) {
      return exception.parts()[1].parts()[0];
    }
  }
  throw KernelError("it does not say what holds at all times but finitely many: " + to_string(almost_always));
}

AlmostAlways read_as_almost_always(const Theorem& theorem) {
  if (theorem.conclusion().kind() == Kind::finite) {
    return {std::nullopt, theorem};
  }
  const std::vector<Term>& parts = theorem.conclusion().parts();
  if (theorem.conclusion().kind() != Kind::conjunction || parts.size() != 2 ||
      parts[0].kind() != Kind::continuous || parts[1].kind() != Kind::finite) {
    throw KernelError("it is not said of almost all times: " + to_string(theorem.conclusion()));
  }
  return {part(theorem, 0), part(theorem, 1)};
}

std::pair<Term, Term> interval(const Formula& few) {
  const Variable t = fresh(real_number, {few});
  if (few.kind() == Kind::finite && opened(few, t).kind() == Kind::conjunction) {
    const Formula inside = opened(few, t).parts().at(0);
    if (inside.kind() == Kind::conjunction && inside.parts().size() == 2 &&
        inside.parts()[0].kind() == Kind::less && inside.parts()[1].kind() == Kind::less) {
      const Term a = inside.parts()[0].parts()[0], b = inside.parts()[1].parts()[1];
      if (inside == between(a, t, b)) {
        return {a, b};
      }
    }
  }
  throw KernelError("it is not said of the times of an interval: " + to_string(few));
}

Theorem but_finitely_often(const std::vector<Theorem>& premises, const Term& a, const Term& b,
                           const Variable& t, const AtOneTime& derive) {
  const Formula inside = between(a, t, b);
  std::vector<Theorem> usually;
  for (const Theorem& premise : premises) {
    usually.push_back(Theorem::assume(usual(premise.conclusion(), t)));
  }
  const Theorem here = derive(Theorem::assume(inside), usually);
  Theorem implied = here;
  for (const Theorem& one : usually) {
    implied = Theorem::discharge(implied, one.conclusion());
  }
  implied = Theorem::discharge(implied, inside);
  Theorem exceptions = premises.front();
  for (std::size_t i = 1; i < premises.size(); ++i) {
    exceptions = Theorem::finite_union(exceptions, premises[i]);
  }
  const Formula exception = kernel::all({inside, negation(here.conclusion())});
  const Theorem part =
      Theorem::consequence({implied}, implies(exception, opened(exceptions.conclusion(), t)));
  return Theorem::finite_part(exceptions, Theorem::generalize(part, t));
}

namespace {

// finite t: c < t < d and not A(t), as c < t and t < d say with these bounds that t is in a longer interval
// of which that is known.
Theorem narrowed(const Theorem& longer, const Term& c, const Term& d, const Theorem& lower,
                 const Theorem& upper) {
  const Variable t = fresh(real_number, {longer.conclusion(), c, d});
  const Formula inside = between(c, t, d), usually = usual(longer.conclusion(), t),
                exception = opened(longer.conclusion(), t);
  const std::vector<Term>& ends = exception.parts()[0].parts();
  const Theorem here = Theorem::assume(inside);
  const Theorem wider = both({Theorem::order(ends.at(0), {Positive{{part(here, 0)}}, Positive{{lower}}}),
                              Theorem::order(ends.at(1), {Positive{{part(here, 1)}}, Positive{{upper}}})});
  const Theorem included = Theorem::consequence({Theorem::discharge(wider, inside)},
                                                implies(kernel::all({inside, negation(usually)}), exception));
  return Theorem::finite_part(longer, Theorem::generalize(included, t));
}

}  // namespace

Theorem but_finitely_often_within(const Theorem& premise, const Theorem& lower, const Theorem& upper) {
  return narrowed(premise, lower.conclusion().parts().at(1), upper.conclusion().parts().at(0), lower, upper);
}

Theorem but_finitely_often_later(const Theorem& premise, const Term& c, const Term& d, const Term& s,
                                 const Theorem& lower, const Theorem& upper) {
  return narrowed(Theorem::finite_shift(premise, s), c, d, lower, upper);
}

std::vector<std::vector<Formula>> alternatives(const Formula& formula) {
  if (formula.kind() == Kind::disjunction) {
    std::vector<std::vector<Formula>> all;
    for (const Formula& part : formula.parts()) {
      const auto more = alternatives(part);
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }
  if (formula.kind() != Kind::conjunction) {
    return {{formula}};
  }
  std::vector<std::vector<Formula>> all{{}};
  for (const Formula& part : formula.parts()) {
    std::vector<std::vector<Formula>> longer;
    for (const std::vector<Formula>& one : all) {
      for (const std::vector<Formula>& other : alternatives(part)) {
        longer.push_back(one);
        longer.back().insert(longer.back().end(), other.begin(), other.end());
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::optional<Theorem> absurd(const std::vector<Theorem>& literals) {
  std::vector<Theorem> known = literals;
  for (const Theorem& literal : literals) {
    const Formula& said = literal.conclusion();
    try {
      if (said.kind() == Kind::less) {
        known.push_back(Theorem::trichotomy(said.parts()[0], said.parts()[1]));
      } else if (said.kind() == Kind::equal && said.variables().empty() &&
                 said.parts()[0].type().is_scalar()) {
        known.push_back(Theorem::sign(negation(said)));
      }
    } catch (const KernelError&) {
      continue;  // 1 = 1
    }
  }
  return attempt([&] { return Theorem::consequence(known, any({})); });
}

Theorem by_cases(const std::vector<Theorem>& premises, const Formula& goal, const InCase& derive) {
  std::vector<Formula> formulas;
  for (const Theorem& premise : premises) {
    formulas.push_back(premise.conclusion());
  }
  std::vector<Theorem> known = premises;
  for (const std::vector<Formula>& one : alternatives(kernel::all(formulas))) {
    std::vector<Theorem> literals;
    std::ranges::transform(one, std::back_inserter(literals), Theorem::assume);
    const std::optional<Theorem> excluded = absurd(literals);
    Theorem implied = excluded ? *excluded : derive(literals);
    for (const Formula& literal : one) {
      implied = Theorem::discharge(implied, literal);
    }
    known.push_back(implied);
  }
  return Theorem::consequence(known, goal);
}

Formula does_not_grow(const Term& f, const Term& t) {
  const Variable v = fresh(real_number, {f, t});
  return exists(v, kernel::all({derivative(f, t, v), at_most(v, 0)}));
}

namespace {

// continuous(f, a, b), finite t: a < t < b and not does_not_grow(f, t) ⊢ a ≤ b ⇒ f(b) ≤ f(a), with variables.
const Variable f{"f", function_of_time()}, a{"a"}, b{"b"};

Theorem decreasing_in_general() {
  const Variable t{"t"}, v{"v"};
  const Term down = lambda(t, -apply(f, t));
  const Theorem rate = Theorem::assume(kernel::all({derivative(f, t, v), at_most(v, 0)}));
  const Theorem turned = Theorem::differentiate(down, t, {part(rate, 0)});
  const Term value = turned.conclusion().parts()[2];
  const Variable w = fresh(real_number, {down, t});
  const Formula grows = exists(w, kernel::all({derivative(down, t, w), at_most(0, w)}));
  const Theorem witnessed = Theorem::witness(
      both({turned, Theorem::order(at_most(0, value), {Positive{{part(rate, 1)}}})}), grows, value);
  const Formula falls = does_not_grow(f, t);
  const Theorem few = Theorem::assume(finite(t, kernel::all({between(a, t, b), negation(falls)})));
  const Theorem rarely =
      but_finitely_often({few}, a, b, t, [&](const Theorem&, const std::vector<Theorem>& usually) {
        return Theorem::choose(usually.front(), v, witnessed);
      });
  const Theorem smooth = Theorem::continuity(down, a, b, {Theorem::assume(continuous(f, a, b))});
  const Theorem grown = Theorem::monotone(smooth, rarely);
  const Formula lasts = at_most(a, b);
  const Theorem above = detach(grown, Theorem::assume(lasts));
  return Theorem::discharge(Theorem::order(at_most(apply(f, b), apply(f, a)), {Positive{{above}}}), lasts);
}

}  // namespace

Theorem decreases(const Theorem& continuity, const Theorem& never_grows, const Theorem& lasts) {
  static const Theorem general = decreasing_in_general();
  const Theorem here = Theorem::instantiate(general, {{f, continuity.conclusion().parts()[0]},
                                                      {a, continuity.conclusion().parts()[1]},
                                                      {b, continuity.conclusion().parts()[2]}});
  return detach(Theorem::cut(never_grows, Theorem::cut(continuity, here)), lasts);
}

Theorem never_changes(const Theorem& continuity, const Theorem& never_grows, const Theorem& returns) {
  const Term of = continuity.conclusion().parts().at(0), from = continuity.conclusion().parts().at(1),
             to = continuity.conclusion().parts().at(2);
  const Variable t = fresh(real_number, {continuity.conclusion(), never_grows.conclusion()});
  const Formula inside = within(from, t, to);
  const Theorem here = Theorem::assume(inside), after = part(here, 0), before = part(here, 1);
  const Theorem at_from = Theorem::order(at_most(from, from), {}),
                at_to = Theorem::order(at_most(to, to), {});
  const Theorem first = decreases(Theorem::continuous_within(continuity, at_from, before),
                                  but_finitely_often_within(never_grows, at_from, before), after);
  const Theorem second = decreases(Theorem::continuous_within(continuity, after, at_to),
                                   but_finitely_often_within(never_grows, after, at_to), before);
  const Theorem not_less = by_rewriting(second, returns);  // f(a) ≤ f(t)
  const Term now = apply(of, t), then = apply(of, from);
  const Theorem same =
      Theorem::consequence({first, not_less, Theorem::trichotomy(now, then)}, equal(now, then));
  return for_every(t, inside, same);
}

}  // namespace stickslip::proofs::tactics
