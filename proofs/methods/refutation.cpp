#include "proofs/methods/refutation.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/roots.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using namespace tactics;

namespace {

namespace paper = symbols::vocabulary;

const Variable time_variable{"t"};

// The values as a claim's assumptions: as far as they are of variables, for what has a formula in the model
// has no other value.
Claim claim_of(const Scene& scene) {
  Claim claim{.id = "refutation"};
  Reader read;
  for (const symbols::Statement& value : scene.values) {
    if (read(value.left).kind() == kernel::Kind::variable) {
      claim.assumptions.push_back({"value", value});
    }
  }
  return claim;
}

bool is_motion(const symbols::Term& term) {
  const symbols::Symbol * row =
      term.op() == symbols::Op::function ? symbols::symbol_table().find(term) : nullptr;
  return row != nullptr && row->is_motion;
}

// "M' = … at all times between", of a motion M; of the oscillator, X.
bool is_of_a_phase(const symbols::Statement& statement) {
  if (!statement.during || statement.during->almost || statement.left.op() != symbols::Op::derivative) {
    return false;
  }
  const symbols::Term& motion = statement.left.arguments().front();
  return symbols::vocabulary_here().is_of_model()
             ? equal(motion, paper::X(paper::t))
             : is_motion(motion) && equal(motion.arguments().front(), paper::t);
}

// The motion of which the formula of a phase speaks.
Variable motion_of(const Formula& phase) {
  const Term& motion = phase.parts().at(0).parts().at(0);
  if (motion.kind() != kernel::Kind::variable) {
    throw KernelError("it is of no motion: " + to_string(phase));
  }
  return {motion.name(), motion.type()};
}

// The closed forms as functions of time, with states in them as `held` says, or 0.
std::vector<Term> closed_forms(Derivation& derivation, const std::vector<symbols::Statement>& forms,
                               const Variable& motion, const std::vector<Formula>& held) {
  const auto is_state = [&](const Term& term) {
    return term.kind() == kernel::Kind::apply && term.parts()[0] == Term(motion);
  };
  std::vector<Term> result;
  for (const symbols::Statement& form : forms) {
    if (!is_motion(form.left) || form.left.name() != motion.name) {
      continue;
    }
    Term term = derivation.read(form.right);
    for (const Formula& one : held) {
      if (one.kind() == kernel::Kind::equal && is_state(one.parts()[0]) &&
          !occurs(Term(motion), one.parts()[1])) {
        term = replaced(term, one.parts()[0], one.parts()[1]);
      }
    }
    for (const Term& state : parts_that(term, is_state)) {
      term = replaced(term, state, zero(state.type()));
    }
    result.push_back(kernel::lambda(time_variable, term));
  }
  return result;
}

// The state in which the phase is said to begin: Z(a) = state, the first that is said.
symbols::Term start_of(const symbols::Statement& phase, const std::vector<symbols::Statement>& holding) {
  for (const symbols::Statement& one : holding) {
    if (one.relation == symbols::Relation::equal && !one.during && one.left.op() == symbols::Op::function &&
        one.left.name() == "Z" && equal(one.left.arguments().front(), phase.during->from) &&
        is_in_field(one.right) && !depends_on(one.right, "t")) {
      return one.right;
    }
  }
  return symbols::zero(4, 1);
}

// The motions from this state that may obey the phase's equation, as functions of time: by the flow of the
// slip under each friction or none, with the load or without it, or by that of the stick.
std::vector<Term> candidates(Derivation& derivation, const symbols::Statement& phase,
                             const symbols::Term& start) {
  using symbols::Term;
  const Term& from = phase.during->from;
  const Term rest = 2 * paper::delta0, still = symbols::zero(4, 1);
  const auto forced = [](const Term& time, const Term& shift) { return paper::F(time) - shift; };
  const auto motion = [&](const symbols::Function& flow, const Term& now, const Term& first) {
    return kernel::lambda(time_variable,
                          derivation.read(flow(paper::t - from) * (start - first) + now + paper::delta0));
  };
  return {motion(paper::H, paper::F(paper::t), paper::F(from)),
          motion(paper::H, forced(paper::t, rest), forced(from, rest)), motion(paper::H, still, still),
          motion(paper::H, -rest, -rest), motion(paper::Gamma, still, still)};
}

// The formula is "X is continuous on [a, b], and X' = v at each time between", with a function for X.
Theorem obeys(Derivation& derivation, const Formula& formula) {
  const Formula &smooth = formula.parts().at(0), &always = formula.parts().at(1);
  const Variable t = fresh(real_number, {formula});
  const Formula here = opened(always, t);
  const Formula &inside = here.parts()[0], &rate = here.parts()[1];
  const Theorem slope = Theorem::differentiate(rate.parts()[0], t);
  const Theorem value = derivation.combination(equal(slope.conclusion().parts()[2], rate.parts()[2]));
  const Variable place = fresh(rate.parts()[2].type(), {formula, slope.conclusion()});
  const Theorem moves = derivation.without_divisors(
      Theorem::replace(value, place, derivative(rate.parts()[0], t, place), slope));
  const Theorem continuous = derivation.without_divisors(
      Theorem::continuity(smooth.parts()[0], smooth.parts()[1], smooth.parts()[2]));
  return both({continuous, for_every(t, inside, moves)});
}

// Where nothing is said: in the domain, of the oscillator with the friction at rest above the other.
Rational any_value(const std::string& name, const Rational& state) {
  if (symbols::vocabulary_here().is_of_model()) {
    return name.starts_with("z") ? state
           : name == "omega1"    ? Rational(1, 2)
                                 : Rational(name == "omega2" || name == "ur" ? 2 : 1);
  }
  const Bounds bounds = bounds_of(name);
  return bounds.lower && bounds.upper ? Rational((*bounds.lower + *bounds.upper) / 2)
         : bounds.upper               ? Rational(*bounds.upper - 1 - state)
                                      : Rational(bounds.lower.value_or(0) + 1 + state);
}

// X is one function before the time c, and another from then on: terms without variables, as a, c and e are.
class Joined {
 public:
  // a < c, c < e, before(c) = after(c).
  Joined(const Term& before, const Term& after, const Term& a, const Term& c, const Term& e,
         const Theorem& meet)
      : X_{"X", before.type()},
        pieces_{Piece{before, a, c}, Piece{after, c, e}},
        exists_(Theorem::piecewise(before, after, c)),
        said_(Theorem::assume(opened(exists_.conclusion(), X_))),
        agrees_{before_agrees(meet), after_agrees()} {}

  // The theorem, which rests on what X is, without that: X is bound in it.
  [[nodiscard]] Theorem closed(const Theorem& theorem) const { return Theorem::choose(exists_, X_, theorem); }

  // function(time) = X(time), at a time from a to e.
  [[nodiscard]] Theorem at_time(const Term& time, std::size_t k) const {
    return at(agrees_[k], time, certainly(within(pieces_[k].from, time, pieces_[k].to)));
  }
  [[nodiscard]] std::size_t piece_at(const Term& time) const {
    return attempt([&] { return certainly(less(time, pieces_[0].to)); }) ? 0 : 1;
  }
  // "X is continuous on [from, to], and X' = v at each time between", from the same of the function.
  [[nodiscard]] Theorem moves(std::size_t k, const Formula& phase, const Theorem& of_function) const {
    const Piece& piece = pieces_[k];
    const Variable t = fresh(real_number, {phase});
    const auto same = [&](const Term& time, const Theorem& during) {
      return at(agrees_[k], time,
                both({Theorem::order(at_most(piece.from, time), {Positive{{part(during, 0)}}}),
                      Theorem::order(at_most(time, piece.to), {Positive{{part(during, 1)}}})}));
    };
    const Formula during = between(piece.from, t, piece.to);
    const Theorem here = Theorem::assume(during), equal_here = same(t, here);
    const Theorem slope = Theorem::same_derivative(
        at(part(of_function, 1), t, here), for_every(t, during, equal_here), part(here, 0), part(here, 1));
    const Formula goal = opened(phase.parts()[1], t).parts()[1];
    return both({Theorem::same_continuity(part(of_function, 0), agrees_[k]),
                 for_every(t, during, with_X(equal_here, t, goal, slope))});
  }
  // The formula, in which X(time) stands, from the same with the function's value there.
  [[nodiscard]] Theorem with_X(const Theorem& equation, const Term& time, const Formula& goal,
                               const Theorem& theorem) const {
    const Variable place{"place", real_matrix(X_.type.rows, X_.type.columns)};
    return Theorem::replace(equation, place, replaced(goal, apply(X_, time), place), theorem);
  }

 private:
  struct Piece {
    Term function, from, to;
  };
  // For all t: a <= t <= c ⇒ before(t) = X(t).
  [[nodiscard]] Theorem before_agrees(const Theorem& meet) const {
    const auto& [before, a, c] = pieces_[0];
    const Variable t = fresh(real_number, {exists_.conclusion()}), place{"place"};
    const Formula during = within(a, t, c), goal = equal(apply(before, t), apply(X_, t));
    const Theorem here = Theorem::assume(during);
    const auto from_now = detach(part(Theorem::specialize(said_, c), 1), certainly(at_most(c, c)));
    const Theorem there =
        Theorem::combination(equal(apply(before, c), apply(X_, c)), {{meet}, {from_now, -1}});
    const Theorem strictly = Theorem::discharge(
        symmetric(detach(part(Theorem::specialize(said_, t), 0), Theorem::assume(less(t, c)))), less(t, c));
    const Theorem last =
        Theorem::discharge(Theorem::replace(symmetric(Theorem::assume(equal(t, c))), place,
                                            equal(apply(before, place), apply(X_, place)), there),
                           equal(t, c));
    return for_every(t, during,
                     Theorem::consequence({part(here, 1), strictly, last, Theorem::trichotomy(t, c)}, goal));
  }
  // For all t: c <= t <= e ⇒ after(t) = X(t).
  [[nodiscard]] Theorem after_agrees() const {
    const Variable t = fresh(real_number, {exists_.conclusion()});
    const Formula during = within(pieces_[1].from, t, pieces_[1].to);
    return for_every(
        t, during,
        symmetric(detach(part(Theorem::specialize(said_, t), 1), part(Theorem::assume(during), 0))));
  }

  Variable X_;
  std::array<Piece, 2> pieces_;
  Theorem exists_, said_;
  std::array<Theorem, 2> agrees_;
};

// What holds at the scene, for its variables' values.
class Place {
 public:
  Place(Prover& prover, const Scene& scene)
      : claim_(claim_of(scene)), derivation_(prover, claim_), state_(scene.state) {
    derivation_.leave_divisors();
    for (const Coordinate& coordinate : scene.point) {
      values_.emplace(Variable{coordinate.name}, Term(coordinate.value));
    }
  }

  // Gives values to all of these variables but functions: those of the scene, and any to the others.
  void give_values(Variables variables) {
    Substitution given, squares;
    for (const Variable& variable : variables) {
      if (const auto root = root_of(variable)) {
        squares.emplace(variable, derivation_.read(root->arguments().front()));
      }
    }
    for (const Assumption& one : claim_.assumptions) {
      const Term value = derivation_.read(one.statement.right);
      given.emplace(Variable{one.statement.left.name()}, value);
      variables.insert(value.variables().begin(), value.variables().end());
    }
    for (const Variable& variable : variables) {
      if (variable.type == real_number && !given.contains(variable) && !squares.contains(variable)) {
        values_.emplace(variable, any_value(variable.name, state_));
      }
    }
    for (bool more = true; more;) {  // each in terms of those known, until there are no more
      more = false;
      for (const auto& [variable, value] : given) {
        const Term here = substitute(value, values_);
        more = (roots_.know(here) && values_.emplace(variable, here).second) || more;
      }
      for (const auto& [root, square] : squares) {
        const Term here = substitute(square, values_);
        if (roots_.know(here) && !values_.contains(root) && !roots_.contains(root)) {
          give_root(root, here);
          more = true;
        }
      }
    }
  }

  [[nodiscard]] Derivation& derivation() { return derivation_; }

  // The formula with the motion put in, and its theorem at the place.
  [[nodiscard]] Theorem holds(const Formula& formula) {
    if (joined_) {
      return of_pieces(formula, [this](const Formula& open) { return holds(open); });
    }
    const Formula open = substitute(formula, motion_);
    if (open.kind() == kernel::Kind::equal) {
      if (const auto always = attempt([&] {
            return without_hypotheses(Theorem::instantiate(derivation_.combination(open), values_),
                                      roots_.known());
          })) {
        return *always;
      }
    }  // or it may hold at this point only
    const Formula here = substitute(open, values_);
    for (const Root& root : roots_there_are_) {
      for (std::size_t k = 0; k < root.said.parts().size(); ++k) {
        if (root.said.parts()[k] == here) {
          return part(Theorem::assume(root.said), k);
        }
      }
    }
    return certainly(here, roots_.known());
  }
  [[nodiscard]] Theorem fails(const Formula& formula) {
    if (joined_) {
      return of_pieces(negation(formula), [this](const Formula& open) { return fails(open.parts()[0]); });
    }
    return certainly_not(substitute(substitute(formula, motion_), values_), roots_.known());
  }

  // The first of the functions, for its motion, that obeys the phase, with the theorem. Throws KernelError if
  // none does.
  [[nodiscard]] std::pair<Term, Theorem> moving(const Formula& phase, const std::vector<Term>& functions) {
    const auto found = first_that_works(functions, [&](const Term& one) {
      const Theorem open = obeys(derivation_, substitute(phase, {{motion_of(phase), one}}));
      return std::pair(one, without_hypotheses(Theorem::instantiate(open, values_)));
    });
    if (!found) {
      throw KernelError("no motion is known that obeys " + to_string(phase));
    }
    return *found;
  }
  Theorem move(const Formula& phase, const std::vector<Term>& functions) {
    const auto [function, theorem] = moving(phase, functions);
    motion_.insert_or_assign(motion_of(phase), function);
    return theorem;
  }
  // Two phases, one after the other: X is a function of each. Of both phases.
  std::vector<Theorem> join(const std::array<Formula, 2>& phases,
                            const std::array<std::vector<Term>, 2>& functions) {
    std::vector<Theorem> moves;
    for (std::size_t k : {0U, 1U}) {
      const auto [function, theorem] = moving(phases[k], functions[k]);
      functions_.push_back(function);
      moves.push_back(theorem);
    }
    motion_.clear();
    const auto time = [&](std::size_t k, std::size_t end) { return phases[k].parts()[0].parts()[end]; };
    const Term &a = time(0, 1), &c = time(0, 2), &e = time(1, 2);
    const Theorem meet = holds(equal(apply(functions_[0], c), apply(functions_[1], c)));
    const auto here = [&](const Term& term) { return substitute(term, values_); };
    joined_.emplace(here(functions_[0]), here(functions_[1]), here(a), here(c), here(e), meet);
    for (std::size_t k : {0U, 1U}) {
      moves[k] = joined_->moves(k, here(phases[k]), moves[k]);
    }
    return moves;
  }

  // Of a further phase: that the motion obeys it, too, with these values.
  [[nodiscard]] Theorem moves_on(const Formula& phase) {
    return without_hypotheses(obeys(derivation_, substitute(substitute(phase, motion_), values_)));
  }

  // ⊢ there are values of all its variables with the formula, which holds here.
  [[nodiscard]] Theorem exists(const Formula& formula, const Theorem& theorem) const {
    Substitution all = values_;
    if (joined_) {
      all.emplace(Variable{"X", functions_[0].type()}, Variable{"X", functions_[0].type()});
    }
    for (const auto& [X, function] : motion_) {
      all.insert_or_assign(X, substitute(function, values_));
    }
    const std::vector<Variable> names(formula.variables().begin(), formula.variables().end());
    for (const Variable& name : names) {
      if (!all.contains(name) && !roots_.contains(name)) {
        throw KernelError(name.name + " has no value at this point");
      }
    }
    Theorem there = there_are(names, formula, all, theorem);
    for (auto root = roots_there_are_.rbegin(); root != roots_there_are_.rend(); ++root) {
      there = Theorem::choose(root->exists, root->name, roots_.without_range(root->name, there));
    }
    return joined_ ? joined_->closed(there) : there;
  }

 private:
  // A root that is no rational number: that there is one, and what is said of it then.
  struct Root {
    Variable name;
    Theorem exists;
    Formula said;
  };

  // The root of `square`, which is known: a rational number, or one in a range.
  void give_root(const Variable& name, const Term& square) {
    if (const auto exact = roots_.rational_root(square)) {
      values_.emplace(name, Term(*exact));
      return;
    }
    const Theorem exists =
        detach(Theorem::square_root(square), certainly(at_most(0, square), roots_.known()));
    const Formula said = opened(exists.conclusion(), name);
    roots_.add(part(Theorem::assume(said), 1), part(Theorem::assume(said), 0));
    roots_there_are_.push_back({name, exists, said});
  }

  // Where X is joined of two: its values are those of one of these, of which `prove` makes the theorem.
  template <class Prove>
  [[nodiscard]] Theorem of_pieces(const Formula& formula, const Prove& prove) {
    const Variable X{"X", functions_[0].type()};
    std::set<Term> times;
    for (const Term& state : parts_that(formula, [&](const Term& term) {
           return term.kind() == kernel::Kind::apply && term.parts()[0] == Term(X);
         })) {
      times.insert(state.parts()[1]);
    }
    const auto joined = std::exchange(joined_, std::nullopt);
    Formula open = formula;
    std::vector<std::pair<Term, std::size_t>> pieces;
    for (const Term& time : times) {
      pieces.emplace_back(time, joined->piece_at(substitute(time, values_)));
      open = replaced(open, apply(X, time), apply(functions_[pieces.back().second], time));
    }
    Theorem theorem = prove(open);
    joined_ = joined;
    for (const auto& [time, piece] : pieces) {
      open = replaced(open, apply(functions_[piece], time), apply(X, time));
      const Term here = substitute(time, values_);
      theorem = joined->with_X(joined->at_time(here, piece), here, substitute(open, values_), theorem);
    }
    return theorem;
  }

  Claim claim_;
  Derivation derivation_;
  Rational state_;
  Substitution values_;  // terms without variables, but for roots
  Roots roots_;
  std::vector<Root> roots_there_are_;  // each after those of which its square speaks
  Substitution motion_;                // X in terms of the variables
  std::vector<Term> functions_;        // or those of which it is joined
  std::optional<Joined> joined_;
};

}  // namespace

Theorem refutation(Prover& prover, const Scene& scene, const std::vector<symbols::Statement>& holding,
                   const std::vector<symbols::Statement>& failing) {
  Place place(prover, scene);
  Derivation& derivation = place.derivation();
  const auto phase = std::ranges::find_if(holding, is_of_a_phase);
  std::vector<Formula> held, failed;
  for (const symbols::Statement& one : holding) {
    held.push_back(derivation.read(one));
  }
  for (const symbols::Statement& one : failing) {
    failed.push_back(derivation.read(one));
  }
  std::vector<Formula> said = held;
  std::ranges::transform(failed, std::back_inserter(said), negation);
  const std::vector<Formula> domain = domain_of(all(said).variables());
  said.insert(said.end(), domain.begin(), domain.end());
  place.give_values(all(said).variables());

  // What speaks of numbers only first: where that fails, no motion is looked for.
  std::map<Formula, Theorem> known;
  const auto speaks_of_motion = [](const Formula& formula) {
    return std::ranges::any_of(formula.variables(),
                               [](const Variable& x) { return x.type.sort == Sort::function; });
  };
  for (const Formula& one : held) {
    if (!speaks_of_motion(one)) {
      known.emplace(one, place.holds(one));
    }
  }
  if (phase != holding.end()) {
    const auto next = std::find_if(phase + 1, holding.end(), is_of_a_phase);
    const auto formula = [&](auto one) { return held[static_cast<std::size_t>(one - holding.begin())]; };
    const auto functions = [&](auto one) {
      return symbols::vocabulary_here().is_of_model()
                 ? candidates(derivation, *one, start_of(*one, holding))
                 : closed_forms(derivation, scene.closed_forms, motion_of(formula(one)), held);
    };
    known.emplace(formula(phase), place.move(formula(phase), functions(phase)));
    if (next != holding.end()) {
      try {
        known.emplace(formula(next), place.moves_on(formula(next)));
      } catch (const KernelError&) {
        const std::vector<Theorem> moves =
            place.join({formula(phase), formula(next)}, {functions(phase), functions(next)});
        known.insert_or_assign(formula(phase), moves[0]);
        known.insert_or_assign(formula(next), moves[1]);
      }
    }
  }
  std::vector<Theorem> theorems;
  for (const Formula& one : held) {
    const auto found = known.find(one);
    theorems.push_back(found != known.end() ? found->second : place.holds(one));
  }
  std::ranges::transform(failed, std::back_inserter(theorems),
                         [&](const Formula& one) { return place.fails(one); });
  std::ranges::transform(domain, std::back_inserter(theorems),
                         [&](const Formula& one) { return place.holds(one); });
  const Theorem result = place.exists(all(said), both(theorems));
  if (!result.hypotheses().empty()) {
    throw KernelError("the refutation rests on something");
  }
  return result;
}

std::optional<Theorem> obeying_values(Prover& prover, const Claim& claim,
                                      const std::vector<Hypothesis>& hypotheses) {
  Scene scene{.state = 0};
  const std::vector<symbols::Statement> holding = assumed_statements(with_hypotheses(claim, hypotheses));
  auto given = Given::in_both_directions(claim);
  for (const Assumption& assumption : claim.assumptions) {
    if (const auto value = given.value_in(assumption)) {
      scene.values.push_back(*value);
    }
  }
  for (const symbols::Statement& one : claim.printed) {  // what is proved holds wherever the rest does
    if (is_substitution({"", one}) && given.take(one)) {
      scene.values.push_back(one);
    }
  }
  scene.closed_forms = claim.printed;
  for (const Claim * before : prover.before(claim.id)) {
    scene.closed_forms.insert(scene.closed_forms.end(), before->printed.begin(), before->printed.end());
  }
  if (std::ranges::count_if(holding, is_of_a_phase) > 1) {
    return std::nullopt;  // that they fit is a matter of closing equations
  }
  const std::vector<Rational> states = symbols::vocabulary_here().is_of_model()
                                           ? std::vector<Rational>{0}
                                           : std::vector<Rational>{0, {1, 2}, {7, 3}};
  std::optional<Theorem> found;
  for (const Rational& state : states) {
    scene.state = state;
    if (!failure_of([&] { found = refutation(prover, scene, holding, {}); })) {
      break;
    }
  }
  return found;
}

}  // namespace stickslip::proofs::methods
