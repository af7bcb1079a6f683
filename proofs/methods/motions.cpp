#include "proofs/methods/motions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <string>

#include "core/error.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/tactics/almost_always.hpp"

namespace stickslip::proofs::methods {

using namespace tactics;
using kernel::KernelError;

namespace {

using kernel::Formulas;
using Terms = std::vector<kernel::Term>;
using Theorems = std::vector<Theorem>;

// A time of which no theorem and none of their hypotheses speaks.
Variable moment(const Theorems& theorems, Terms also) {
  for (const Theorem& theorem : theorems) {
    also.push_back(theorem.conclusion());
    also.insert(also.end(), theorem.hypotheses().begin(), theorem.hypotheses().end());
  }
  return fresh(kernel::real_number, also);
}

// A literal of what is to be shown, from those that hold.
Theorem literal(Derivation& derivation, const Formula& goal, const Theorems& known) {
  const auto same = std::ranges::find(known, goal, &Theorem::conclusion);
  if (same != known.end()) {
    return *same;
  }
  if (goal.kind() == kernel::Kind::equal) {
    return derivation.combination(goal);
  }
  if (goal.kind() == kernel::Kind::derivative) {
    Theorems rates;
    std::ranges::copy_if(known, std::back_inserter(rates), [](const Theorem& one) {
      return one.conclusion().kind() == kernel::Kind::derivative;
    });
    const Theorem slope = Theorem::differentiate(goal.parts()[0], goal.parts()[1], rates);
    const kernel::Term value = slope.conclusion().parts()[2];
    return derivation.without_divisors(
        tactics::by_rewriting(slope, derivation.combination(equal(value, goal.parts()[2]))));
  }
  for (const Theorem& one : known) {
    const auto theorem = one.conclusion().kind() == kernel::Kind::less
                             ? attempt([&] { return derivation.order(goal, {kernel::Positive{{one}}}); })
                             : std::nullopt;
    if (theorem) {
      return *theorem;
    }
  }
  throw KernelError("not known in this case: " + to_string(goal));
}

// What is to be shown, or that the case cannot be.
Theorem in_case(Derivation& derivation, const Formula& goal, const Theorems& known) {
  if (const auto excluded = absurd(known)) {
    return *excluded;
  }
  std::string why;
  for (const std::vector<Formula>& alternative : alternatives(goal)) {
    Theorems assumed = known;
    std::ranges::transform(alternative, std::back_inserter(assumed), Theorem::assume);
    if (absurd(assumed)) {
      continue;
    }
    try {
      Theorems parts;
      for (const Formula& one : alternative) {
        parts.push_back(literal(derivation, one, known));
      }
      return Theorem::consequence(parts, goal);
    } catch (const KernelError& error) {
      why = error.what();
    }
  }
  throw KernelError("no alternative holds in a case: " + why);
}

// The premise at t + later, where t is between the ends.
Theorem moved(Derivation& derivation, const Theorem& few, const kernel::Term& from, const kernel::Term& to,
              const kernel::Term& later) {
  const auto [a, b] = interval(few.conclusion());
  return but_finitely_often_later(few, from, to, later, derivation.follows(at_most(a, from + later)),
                                  derivation.follows(at_most(to + later, b)));
}

// for all t: from ≤ t ≤ to ⇒ a ≤ t + later ≤ b.
Theorem stays_inside(Derivation& derivation, const Theorem& continuity, const kernel::Term& from,
                     const kernel::Term& to, const kernel::Term& later) {
  const kernel::Term a = continuity.conclusion().parts()[1], b = continuity.conclusion().parts()[2];
  const Theorem lower = derivation.follows(at_most(a, from + later)),
                upper = derivation.follows(at_most(to + later, b));
  const Variable t = moment({lower, upper}, {});
  const Formula inside = within(from, t, to);
  const Theorem here = Theorem::assume(inside);
  const kernel::Term then = kernel::Term(t) + later;
  return for_every(
      t, inside,
      both({Theorem::order(at_most(a, then), {kernel::Positive{{part(here, 0)}}, kernel::Positive{{lower}}}),
            Theorem::order(at_most(then, b),
                           {kernel::Positive{{part(here, 1)}}, kernel::Positive{{upper}}})}));
}

}  // namespace

Proof by_differential_equation(ClosedForm solution) {
  const auto derive = [solution = std::move(solution)](Derivation& derivation, std::size_t which) {
    const Variable time{"t"};
    const auto at_time = [&](const symbols::Term& term) {
      return kernel::lambda(time, derivation.read(term));
    };
    const Theorem phase = derivation.premise(assuming(solution.phase));
    const Motion motion{part(phase, 0), part(phase, 1)};
    const kernel::Term from = motion.continuity.conclusion().parts()[1], flow = at_time(solution.flow),
                       forced = at_time(solution.forced);
    const Formula printed = derivation.printed(which);
    const kernel::Term z = kernel::lambda(time, printed.parts()[0]);
    const Theorem general = tactics::by_differential_equation(
        motion, z, flow, forced, time, {}, derivation.open({flow, forced, phase.conclusion(), z}),
        parameters());
    const Theorem here = Theorem::specialize(general, time);
    std::vector<kernel::Multiple> because{{detach(here, derivation.follows(here.conclusion().parts()[0]))}};
    if (!solution.initial.empty()) {
      because.push_back(
          {derivation.premise(assuming(solution.initial)), apply(flow, kernel::Term(time) - from)});
    }
    return derivation.combination(printed, because);
  };
  return by_kernel("the flow, run backwards along the motion, gives what does not change", derive);
}

Proof by_mean_value(MeanValue step) {
  const auto derive = [step = std::move(step)](Derivation& derivation, std::size_t which) {
    const Variable time{"t"}, between_ends{"c"};
    const Theorem phase = derivation.premise(assuming(step.phase)),
                  bound = derivation.premise(assuming(step.slope)),
                  lasts = derivation.premise(assuming(step.lasts));
    const kernel::Term X = part(phase, 0).conclusion().parts()[0], a = part(phase, 0).conclusion().parts()[1],
                       b = part(phase, 0).conclusion().parts()[2], row = derivation.read(step.row);
    const kernel::Term f = kernel::lambda(time, row * apply(X, time));
    // The slope as the left side of the bound has it.
    const Formula inside = between(a, time, b);
    const Theorem rate = at(part(phase, 1), time, Theorem::assume(inside));
    const Theorem slope = Theorem::differentiate(f, time, {rate});
    const kernel::Term speed = at(bound, time, Theorem::assume(inside)).conclusion().parts()[0];
    const Theorem same = derivation.combination(equal(slope.conclusion().parts()[2], speed));
    const Theorem order = derivation.follows(less(a, b));
    const Theorem mean =
        Theorem::mean_value(Theorem::continuity(f, a, b, {part(phase, 0)}),
                            for_every(time, inside, tactics::by_rewriting(slope, same)), order);
    const Theorem there = Theorem::assume(opened(mean.conclusion(), between_ends));
    const Theorem bounded = at(bound, between_ends, part(there, 0));
    return Theorem::choose(mean, between_ends,
                           derivation.order(derivation.printed(which), {kernel::Positive{{bounded, order}}},
                                            {{part(there, 1), -1},
                                             {derivation.premise(assuming(step.ends)), row},
                                             {derivation.premise(assuming(step.begins)), -row}}));
  };
  return by_kernel("mean value theorem", derive);
}

Proof by_chain_rule(const std::vector<Premise>& premises, const std::optional<symbols::Term>& later) {
  const auto derive = [premises, later](Derivation& derivation, std::size_t which) {
    const AlmostAlways goal = read_as_almost_always(Theorem::assume(derivation.printed(which)));
    const auto [from, to] = interval(goal.few.conclusion());
    Theorems few, continuities;
    for (const Premise& premise : premises) {
      const AlmostAlways one = read_as_almost_always(derivation.premise(premise));
      few.push_back(later ? moved(derivation, one.few, from, to, derivation.read(*later)) : one.few);
      if (one.continuity) {
        continuities.push_back(*one.continuity);
      }
      if (one.continuity && later) {
        continuities.push_back(stays_inside(derivation, *one.continuity, from, to, derivation.read(*later)));
      }
    }
    const Variable t = moment(few, {goal.few.conclusion(), from, to});
    const Formula usually = usual(goal.few.conclusion(), t);
    const Theorem rarely = but_finitely_often(few, from, to, t, [&](const Theorem&, const Theorems& known) {
      return by_cases(known, usually,
                      [&](const Theorems& literals) { return in_case(derivation, usually, literals); });
    });
    if (!goal.continuity) {
      return rarely;
    }
    const Theorem smooth =
        Theorem::continuity(goal.continuity->conclusion().parts()[0], from, to, continuities);
    return both({derivation.without_divisors(smooth), rarely});
  };
  return by_kernel("the chain rule, in each case of signs that is left", derive);
}

namespace {

// f(b) = f(a) by equations X(b) = X(a).
Theorem returned(Derivation& derivation, const kernel::Term& f, const kernel::Term& a, const kernel::Term& b,
                 const std::vector<std::string>& returns) {
  Theorem same = Theorem::reflexive(apply(f, b));
  for (const std::string& id : returns) {
    const Theorem equation = derivation.premise(assuming(id));
    const Terms& sides = same.conclusion().parts();
    const Variable place =
        fresh(equation.conclusion().parts()[0].type(), {same.conclusion(), equation.conclusion()});
    same = Theorem::replace(
        equation, place, equal(sides[0], replaced(sides[1], equation.conclusion().parts()[0], place)), same);
  }
  if (!(same.conclusion() == equal(apply(f, b), apply(f, a)))) {
    throw KernelError("it is not known to return");
  }
  return same;
}

// E' by the premise `rate`, which is zero or, in each case of its signs, at most minus the weight times the
// sum of |a_i|: so E does not grow.
class Decrease {
 public:
  Decrease(Derivation& derivation, const Premise& rate, const symbols::Term& weight, const Formula& goal)
      : derivation_(derivation),
        rate_(read_as_almost_always(derivation.premise(rate))),
        weight_(derivation.positive(derivation.read(weight))),
        t_(moment({rate_.few}, {goal})) {
    if (!rate_.continuity) {
      throw KernelError("the premise is of no rate");
    }
  }

  [[nodiscard]] const Theorem& continuity() const { return *rate_.continuity; }
  [[nodiscard]] const Theorem& rate() const { return rate_.few; }
  [[nodiscard]] const kernel::Term& E() const { return continuity().conclusion().parts()[0]; }
  [[nodiscard]] std::pair<kernel::Term, kernel::Term> ends() const {
    return interval(rate_.few.conclusion());
  }
  // A time that stands in nothing else.
  [[nodiscard]] const Variable& time() const { return t_; }

  // In a case, whose last literal is derivative(E, t, r): r = 0 or r < 0.
  [[nodiscard]] Theorem sign_of(const Theorems& literals) const {
    const kernel::Term r = literals.back().conclusion().parts()[2];
    if (const auto zero = attempt([&] { return derivation_.combination(equal(r, 0)); })) {
      return *zero;
    }
    std::vector<kernel::Positive> parts;
    for (const Theorem& one : literals) {
      if (one.conclusion().kind() == kernel::Kind::less) {
        parts.push_back({{weight_, one}});
      }
    }
    return derivation_.order(less(r, 0), parts);
  }

  // finite t: a < t < b and not does_not_grow(E, t).
  [[nodiscard]] Theorem never_grows() const {
    const auto [a, b] = ends();
    const Formula falls = does_not_grow(E(), t_);
    return but_finitely_often({rate_.few}, a, b, t_, [&](const Theorem&, const Theorems& known) {
      return by_cases(known, falls, [&](const Theorems& literals) {
        const kernel::Term r = literals.back().conclusion().parts()[2];
        const Theorem not_positive =
            Theorem::consequence({sign_of(literals), Theorem::trichotomy(r, 0)}, at_most(r, 0));
        return Theorem::witness(both({literals.back(), not_positive}), falls, r);
      });
    });
  }

 private:
  Derivation& derivation_;
  AlmostAlways rate_;
  Theorem weight_;
  Variable t_;
};

}  // namespace

Proof by_decrease(const Premise& rate, const symbols::Term& weight) {
  const auto derive = [=](Derivation& derivation, std::size_t which) {
    const Formula goal = derivation.printed(which);
    const Decrease decrease(derivation, rate, weight, goal);
    const auto [a, b] = decrease.ends();
    const Theorem less_at_last =
        decreases(decrease.continuity(), derivation.without_divisors(decrease.never_grows()),
                  derivation.follows(at_most(a, b)));
    return derivation.order(goal, {kernel::Positive{{less_at_last}}});
  };
  return by_kernel("what never increases, and is continuous, is not larger at the end", derive);
}

Proof by_periodic_decrease(PeriodicDecrease step) {
  const auto derive = [step = std::move(step)](Derivation& derivation, std::size_t which) {
    const Formula goal = derivation.printed(which);
    const Decrease decrease(derivation, step.rate, step.weight, goal);
    const kernel::Term a = decrease.ends().first, b = decrease.ends().second;
    const kernel::Term E = decrease.E();
    const Variable& t = decrease.time();
    const Theorem kept = never_changes(decrease.continuity(), decrease.never_grows(),
                                       returned(derivation, E, a, b, step.returns));
    // So the rate is zero, where there is one.
    const kernel::Term start = apply(E, a);
    return derivation.without_divisors(
        but_finitely_often({decrease.rate()}, a, b, t, [&](const Theorem& inside, const Theorems& known) {
          const Variable s = moment({kept, inside}, {t});
          const Formula between_ends = between(a, s, b);
          const Theorem then = Theorem::assume(between_ends);
          const Theorem in_range = both({Theorem::order(at_most(a, s), {kernel::Positive{{part(then, 0)}}}),
                                         Theorem::order(at_most(s, b), {kernel::Positive{{part(then, 1)}}})});
          const Theorem same = symmetric(at(kept, s, in_range));
          const Theorem flat =
              Theorem::same_derivative(Theorem::differentiate(kernel::lambda(s, start), t),
                                       for_every(s, between_ends, same), part(inside, 0), part(inside, 1));
          const Formula usually = usual(goal, t);
          return by_cases(known, usually, [&](const Theorems& literals) {
            Theorems all = literals;
            all.push_back(Theorem::unique_derivative(literals.back(), flat));
            all.push_back(decrease.sign_of(literals));
            return in_case(derivation, usually, all);
          });
        }));
  };
  return by_kernel(
      "a continuous function that never increases and returns does not change, so its rate of change is zero",
      derive);
}

namespace {

// Whether a sum of such equations, each taken once or not, with a sign, is the formula.
std::optional<Theorem> sum_of(const Formula& formula, const Theorems& equations) {
  std::vector<std::vector<kernel::Multiple>> sums{{}};
  for (const Theorem& equation : equations) {
    const auto count = sums.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const int sign : {1, -1}) {
        sums.push_back(sums[i]);
        sums.back().push_back({equation, sign});
      }
    }
  }
  return first_that_works(sums, [&](const auto& sum) { return Theorem::combination(formula, sum); });
}

// What is assumed of almost all times of an interval, of one within.
std::optional<Theorem> of_shorter(Derivation& derivation, const Formula& formula, const Formula& assumed) {
  try {
    const AlmostAlways known = read_as_almost_always(Theorem::assume(assumed)),
                       wanted = read_as_almost_always(Theorem::assume(formula));
    if (!known.continuity || !wanted.continuity ||
        !(known.continuity->conclusion().parts()[0] == wanted.continuity->conclusion().parts()[0])) {
      return std::nullopt;
    }
    const auto [a, b] = interval(known.few.conclusion());
    const auto [c, d] = interval(wanted.few.conclusion());
    const Theorem lower = derivation.follows(at_most(a, c)), upper = derivation.follows(at_most(d, b));
    const Theorem all = both({Theorem::continuous_within(*known.continuity, lower, upper),
                              but_finitely_often_within(known.few, lower, upper)});
    return all.conclusion() == formula ? std::optional(all) : std::nullopt;
  } catch (const KernelError&) {
    return std::nullopt;
  }
}

// The theorem less what it supposes and the claim does not, as far as that is found.
Theorem supplied_with(Derivation& derivation, const Theorem& theorem, const Formulas& assumed,
                      const Theorems& supplied) {
  Theorems equations;
  for (const Formula& one : assumed) {
    if (one.kind() == kernel::Kind::equal) {
      equations.push_back(Theorem::assume(one));
    }
  }
  return derivation.settled(settled_by(theorem, [&](const Formula& one) -> std::optional<Theorem> {
    const auto said = std::ranges::find(supplied, one, &Theorem::conclusion);
    if (said != supplied.end()) {
      return *said;
    }
    if (assumed.contains(one)) {
      return std::nullopt;
    }
    if (one.kind() == kernel::Kind::equal) {
      Theorems alike;
      std::ranges::copy_if(equations, std::back_inserter(alike), [&](const Theorem& e) {
        return e.conclusion().parts()[0].type() == one.parts()[0].type();
      });
      return sum_of(one, alike);
    }
    std::optional<Theorem> lemma;
    for (const Formula& longer : assumed) {
      lemma = lemma ? lemma : of_shorter(derivation, one, longer);
    }
    return lemma;
  }));
}

}  // namespace

Proof by_instances(std::vector<Instance> instances) {
  const auto derive = [instances = std::move(instances)](Derivation& derivation, std::size_t which) {
    const Variable time{"t"};
    const Formulas assumed = derivation.assumed();
    std::vector<kernel::Multiple> sum;
    for (const Instance& one : instances) {
      kernel::Substitution functions;
      for (const auto& [name, value] : one.functions) {
        const kernel::Term at_time = derivation.read(value);
        functions.emplace(
            Variable{name, kernel::function_of_time(at_time.type().rows, at_time.type().columns)},
            lambda(time, at_time));
      }
      Theorems supplied;
      for (const Premise& premise : one.supplied) {
        supplied.push_back(supplied_with(derivation, derivation.premise(premise), assumed, {}));
      }
      const Theorem here = Theorem::instantiate(derivation.premise(one.premise), functions);
      sum.push_back({supplied_with(derivation, here, assumed, supplied), derivation.read(one.left)});
    }
    return derivation.combination(derivation.printed(which), sum);
  };
  return by_kernel("a sum of the premises, of these motions and times", derive);
}

using namespace numeric;
using namespace numeric::motion;

namespace {

// How far the orbit is from what is printed. In double: it picks an orbit and proves nothing.
double distance(const Orbit& orbit, const std::vector<PrintedResult>& printed) {
  double largest = 0;
  for (const PrintedResult& result : printed) {
    for (const NamedBall& value : orbit.values) {
      if (value.name == result.name) {
        const double proved = value.value.approximate();
        const double wanted = result.value.value.get_d();
        const double difference = result.sign_lost ? std::abs(proved) - std::abs(wanted) : proved - wanted;
        largest = std::max(largest, std::abs(difference) / std::max(std::abs(wanted), 1e-3));
      }
    }
  }
  return largest;
}

}  // namespace

OrbitQuestion question_of(const Example& example, int digits) {
  const ExactParameters& a = example.data;
  OrbitQuestion q{example.family, {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}}, {}, {}, digits};
  if (example.phi) {
    q.phi = Range{*example.phi};
  }
  if (example.ur) {
    q.ur = Range{*example.ur};
  }
  return q;
}

const ExampleOrbits& orbits_of(const Example& example) {
  constexpr int digits = 30;
  static std::mutex one_at_a_time;
  static std::map<std::string, ExampleOrbits> known;
  const std::lock_guard lock(one_at_a_time);
  const auto found = known.find(example.name);
  return found != known.end()
             ? found->second
             : known.emplace(example.name, ExampleOrbits{example, list_orbits(question_of(example, digits))})
                   .first->second;
}

std::optional<std::size_t> printed_orbit(const ExampleOrbits& orbits) {
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t i = 0; i < orbits.list.orbits.size(); ++i) {
    const double d = distance(orbits.list.orbits[i], orbits.example.results);
    if (!nearest || d < least) {
      nearest = i;
      least = d;
    }
  }
  return nearest;
}

const Orbit& printed_orbit(const Example& example) {
  const ExampleOrbits& orbits = orbits_of(example);
  const std::optional<std::size_t> nearest = printed_orbit(orbits);
  if (!nearest) {
    throw InternalError("there is no orbit at the data of " + example.figure);
  }
  return orbits.list.orbits[*nearest];
}

}  // namespace stickslip::proofs::methods
