// What is known of an orbit as one motion, and that it obeys what claims assume.
#include "core/transformed.hpp"
#include "proofs/pascal2012/met_by_orbits.hpp"

#include <algorithm>
#include <optional>

#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/gate.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using kernel::Definition;
using kernel::Formula;
using kernel::Kind;
using kernel::Multiple;
using kernel::Positive;
using kernel::Term;
using kernel::Theorem;
using kernel::Variable;
using numeric::motion::PhaseKind;

namespace {

// Of what "S.motion" says of durations, phi, ur and X, at frequencies that give the example's chi and eta.
class MotionOf {
 public:
  MotionOf(const Met& met, const Theorem& said, const orbits::Ranges& frequencies)
      : example_(example_of(met)), met_(met), said_(said), frequencies_(frequencies) {
    const numeric::motion::ExactParameters& a = example_.data;
    give({"omega"}, a.omega);
    give({"p"}, a.p);
    give({"us"}, a.us);
    give({"V"}, a.V);
    give({"Theta"}, Term(2) * kernel::pi() / Term(a.omega));
    for (const auto& [name, datum] : {std::pair{"phi", example_.phi}, std::pair{"ur", example_.ur}}) {
      if (datum) {
        give({name}, *datum);
      }
    }
    give({"Y", orbits::motion_type}, Term(X_));  // the difference to another motion is zero
    give({"delta", orbits::motion_type}, lambda(Variable{"t"}, zero(orbits::state_type)));
    look_at_what_is_said();
    for (const Theorem& one : std::vector(facts_)) {
      put_in(one);
    }
  }

  // What the claim's theorems say of this motion, as all that they rest on holds of it.
  void learn(const Claim& claim, const std::vector<Theorem>& theorems) {
    name_states();
    name_as_assumed(claim);
    for (Theorem theorem : theorems) {
      theorem = discharged(Theorem::instantiate(theorem, values_));
      facts_.push_back(theorem);
      put_in(theorem);
    }
  }

  // ⊢ there are values of all variables, but of the frequencies, with which all that these claims assume
  // holds at once.
  [[nodiscard]] Theorem obeys(const std::vector<const Claim *>& claims) {
    name_states();
    if (met_.goes_on_to) {
      const Theorem repeats = facts_.front();
      const Term end = substitute(Reader()(*met_.goes_on_to), values_);
      phases_.push_back(again(repeats, end));
      facts_.push_back(Theorem::specialize(repeats, interval(0).second));
    }
    kernel::Formulas formulas;
    for (const Claim * claim : claims) {
      name_as_assumed(*claim);
      formulas.merge(assumed_by(*claim));
    }
    const auto proved =
        transformed(formulas, [&](const Formula& one) { return holds(substitute(one, values_)); });
    const Formula whole = kernel::all({formulas.begin(), formulas.end()});
    std::vector<Variable> names;  // innermost what has a value in terms of the others
    for (const bool has_value : {true, false}) {
      for (const Variable& one : whole.variables()) {
        if (!frequencies_.contains(one) && values_.contains(one) == has_value) {
          names.insert(names.begin(), one);
        }
      }
    }
    return tactics::there_are(names, whole, values_, tactics::both(proved));
  }

 private:
  // ---- What is known, and the values of letters.
  // The first value stays.
  void give(const Variable& letter, const Term& value) {
    if (!said_.conclusion().variables().contains(letter)) {
      values_.emplace(letter, substitute(value, values_));
    }
  }
  void name_as_assumed(const Claim& claim) {
    for (const Assumption& one : claim.assumptions) {
      if (is_substitution(one)) {
        const Term name = Reader()(one.statement.left);
        if (name.kind() == Kind::variable) {
          give({name.name()}, Reader()(one.statement.right));
        }
      }
    }
  }
  void look_at_what_is_said() {
    facts_.clear();
    phases_.clear();
    for (const Formula& one : said_.conclusion().parts()) {
      const Theorem fact = Theorem::consequence({said_}, one);
      if (one.kind() == Kind::defined) {
        const Definition& phase = one.definition();
        phases_.push_back(Theorem::convert(fact, unfold(one, {phase}), {phase}));
      } else {
        facts_.push_back(fact);
      }
    }
    const Term returns = interval(phases_.size() - 1).second;
    for (const Theorem& closes : std::vector(facts_)) {
      if (closes.conclusion() == equal(apply(X_, returns), apply(X_, 0))) {
        for (const Theorem& one : std::vector(facts_)) {
          facts_.push_back(tactics::by_rewriting(one, closes));
        }
      }
    }
  }
  // A letter that is said to be something else: that stands for it from now on.
  void put_in(const Theorem& fact) {
    const Formula& formula = fact.conclusion();
    if (formula.kind() == Kind::equal && formula.parts()[0].kind() == Kind::variable) {
      const Variable letter{formula.parts()[0].name()};
      const Term& value = formula.parts()[1];
      if (said_.conclusion().variables().contains(letter) && !value.variables().contains(letter)) {
        said_ = tactics::by_rewriting(said_, fact);
        look_at_what_is_said();
        for (auto& one : values_) {
          one.second = substitute(one.second, {{letter, value}});
        }
        give(letter, value);
      }
    }
  }
  // z10, …, z1B, …, z1C, …: the state, seen from the place of rest, where the phases begin.
  void name_states() {
    Reader read;
    const Term rest = substitute(read(symbols::vocabulary::delta0), values_);
    static const std::vector<std::vector<const char *>> names{{"z10", "z20", "zdot10", "zdot20"},
                                                              {"z1B", "z2B", "zdot1B", "zdot2B"},
                                                              {"z1C", "z2C", "zdot1C", "zdot2C"}};
    for (std::size_t k = 0; k < phases_.size(); ++k) {
      for (int i = 0; i < orbits::matrix_rows; ++i) {
        values_.insert_or_assign(Variable{names.at(k).at(static_cast<std::size_t>(i))},
                                 entry(apply(X_, interval(k).first), i) - entry(rest, i));
      }
    }
    for (const auto& [name, value] : met_.values) {
      give({name}, read(value));
    }
    give({"t"}, met_.at_the_last_phase ? interval(phases_.size() - 1).first : Term(0));
    give({"t1"}, 0);
    letters_ = known_ranges();
  }
  [[nodiscard]] std::pair<Term, Term> interval(std::size_t k) const {
    const Formula& smooth = phases_.at(k).conclusion().parts()[0];
    return {smooth.parts()[1], smooth.parts()[2]};
  }

  // ---- What holds.
  [[nodiscard]] Theorem holds(const Formula& formula) const {
    switch (formula.kind()) {
      case Kind::conjunction:
        return tactics::both(transformed(formula.parts(), [&](const Formula& one) { return holds(one); }));
      case Kind::continuous:
        return continuity(formula);
      case Kind::for_all:
        return at_all_times(formula);
      case Kind::finite:
        return but_finitely_often(formula);
      case Kind::equal:
        return equation(formula);
      default:
        return relation(formula);
    }
  }
  [[nodiscard]] static kernel::KernelError unknown(const Formula& formula) {
    return kernel::KernelError("of this motion it is not known: " + to_string(formula));
  }
  // The theorem without hypotheses: they hold.
  [[nodiscard]] Theorem discharged(const Theorem& theorem) const {
    return tactics::settled_by(theorem, [&](const Formula& one) {
      return said_.hypotheses().contains(one) || is_of_data(one) || orbits::is_range(one, frequencies_)
                 ? std::nullopt
                 : std::optional(holds(one));
    });
  }

  // chi = …, eta = …: what the frequencies give.
  struct Datum {
    Term symbol, value;
    Variable place;
  };
  [[nodiscard]] std::vector<Datum> data() const {
    Reader read;
    return {{read(symbols::vocabulary::chi), example_.data.chi, {"of chi"}},
            {read(symbols::vocabulary::eta), example_.data.eta, {"of eta"}}};
  }
  [[nodiscard]] bool is_of_data(const Formula& formula) const {
    return std::ranges::any_of(data(),
                               [&](const Datum& one) { return formula == equal(one.symbol, one.value); });
  }
  // The formula from what `prove` makes of it once all definitions are opened and chi and eta have their
  // values.
  [[nodiscard]] Theorem at_the_data(const Formula& formula,
                                    const std::function<Theorem(const Formula&)>& prove) const {
    kernel::Definitions definitions = openings({formula}).all();
    std::vector<Formula> steps;  // with fewer and fewer values
    const std::vector<Datum> known = data();
    for (const Datum& one : known) {
      definitions.erase(one.symbol.definition());
    }
    Formula open = unfold(formula, definitions);
    for (const Datum& one : known) {
      open = replaced(open, one.symbol, one.place);
    }
    kernel::Substitution values;
    for (const Datum& one : known) {
      values.emplace(one.place, one.value);
    }
    Theorem result = prove(substitute(open, values));
    for (const Datum& one : known) {
      values.erase(one.place);
      const Theorem is = tactics::symmetric(Theorem::assume(equal(one.symbol, one.value)));
      result = Theorem::replace(is, one.place, substitute(open, values), result);
      values.emplace(one.place, one.symbol);
    }
    return Theorem::convert(result, formula, definitions);
  }

  // By what is known of the motion, one equation at a time.
  [[nodiscard]] Theorem equation(const Formula& formula) const {
    for (const Theorem& one : facts_) {
      if (one.conclusion() == formula) {
        return one;
      }
    }
    std::vector<std::vector<Multiple>> attempts{{}};
    for (const Theorem& one : facts_) {
      if (one.conclusion().kind() == Kind::equal &&
          one.conclusion().parts()[0].type() == formula.parts()[0].type()) {
        for (const Term& factor : factors(one.conclusion())) {
          attempts.push_back({{one, factor}});
        }
      }
    }
    if (const std::optional<Term> row = row_that_solves(formula)) {
      for (const Theorem& one : facts_) {
        if (one.conclusion().kind() == Kind::equal &&
            one.conclusion().parts()[0].type() == kernel::real_matrix(row->type().columns, 1)) {
          attempts.push_back({{one, *row}});
        }
      }
    }
    const auto from_one = [&](const Formula& open) {
      const auto found = tactics::first_that_works(attempts, [&](const std::vector<Multiple>& because) {
        const Formula other = because.empty() ? open : because.front().equation.conclusion();
        return discharged(Theorem::combination(open, because, openings({open, other}).all()));
      });
      return found ? *found : throw unknown(formula);
    };
    const auto there = tactics::attempt([&] { return at_the_data(formula, from_one); });
    return there ? *there : from_one(formula);
  }
  // Of z = row inverse(M) …, which solves M z = … for one component: row inverse(M).
  [[nodiscard]] static std::optional<Term> row_that_solves(const Formula& equation) {
    Term left = equation.parts()[1];
    for (; left.kind() == Kind::product; left = left.parts()[0]) {
      if (left.parts()[1].kind() == Kind::inverse && !left.type().is_scalar()) {
        return left;
      }
    }
    return std::nullopt;
  }
  // What the fact is multiplied with: a datum, or what its right side divides by.
  [[nodiscard]] std::vector<Term> factors(const Formula& fact) const {
    std::vector<Term> result{1};
    if (fact.parts()[0].type().is_scalar()) {
      const Term eta = example_.data.eta, &right = fact.parts()[1];
      result.insert(result.end(), {eta, 1 / eta});
      if (right.kind() == Kind::product && right.parts().back().kind() == Kind::inverse) {
        result.push_back(right.parts().back().parts()[0]);
      }
    }
    const std::vector<Term> positive = result;
    std::ranges::transform(positive, std::back_inserter(result), [](const Term& one) { return -one; });
    return result;
  }

  // An inequality, or that two numbers differ, from the ranges in which numbers and states lie.
  [[nodiscard]] Theorem relation(const Formula& formula) const {
    if (formula.kind() == Kind::at_most && formula.parts()[0] == formula.parts()[1]) {
      const Term& a = formula.parts()[0];
      return Theorem::consequence({Theorem::reflexive(a), Theorem::trichotomy(a, a)}, formula);
    }
    for (const Theorem& one : facts_) {
      if (one.conclusion() == formula) {
        return one;
      }
    }
    Formula in_letters = formula;
    orbits::Ranges ranges = frequencies_;
    for (const auto& [letter, known] : letters_) {
      in_letters = replaced(in_letters, known.value, letter);
      ranges.emplace(letter, known.range);
    }
    return orbits::settled(orbits::sign_by_parts(in_letters, ranges), letters_);
  }
  // Letters for durations, phi, ur and entries of states, with the decimals between which they lie.
  [[nodiscard]] orbits::Letters known_ranges() const {
    orbits::Letters result;
    for (const auto& [value, known] : orbits::bounds_said(facts_)) {
      const std::string prefix = value.kind() == Kind::entry ? "entry " : "number ";  // entries first
      result.emplace(Variable{prefix + std::to_string(result.size())}, known);
    }
    return result;
  }

  [[nodiscard]] Theorem continuity(const Formula& formula) const {
    std::vector<Theorem> found;
    for (std::size_t k = 0; k < phases_.size(); ++k) {  // from phase k to the end of a later one
      found.push_back(tactics::part(phases_[k], 0));
      for (std::size_t j = k + 1; j < phases_.size(); ++j) {
        found.push_back(Theorem::continuous_union(found.back(), tactics::part(phases_[j], 0)));
      }
    }
    for (const Theorem& one : found) {
      if (one.conclusion() == formula) {
        return one;
      }
      const Formula& known = one.conclusion();
      if (known.parts()[1] == formula.parts()[1] && known.parts()[2] == formula.parts()[2]) {
        return Theorem::continuity(formula.parts()[0], known.parts()[1], known.parts()[2], {one});
      }
    }
    throw unknown(formula);
  }
  // For all t: a < t < b ⇒ a derivative, or a side of the belt.
  [[nodiscard]] Theorem at_all_times(const Formula& formula) const {
    const Variable t{"s"};
    const Formula body = opened(formula, t);
    for (const Theorem& one : phases_) {
      const Theorem during = tactics::part(one, 1);
      if (opened(during.conclusion(), t).parts()[0] == body.parts()[0]) {
        const Theorem here = tactics::at(during, t, Theorem::assume(body.parts()[0]));
        return tactics::for_every(t, body.parts()[0], in_form(body.parts()[1], here));
      }
    }
    throw unknown(formula);
  }
  // Of one time: the derivative, or the inequality, as the formula has it.
  [[nodiscard]] Theorem in_form(const Formula& formula, const Theorem& here) const {
    if (formula.kind() == Kind::conjunction) {
      return tactics::both({in_form(formula.parts()[0], here), in_form(formula.parts()[1], here)});
    }
    if (formula.kind() == Kind::disjunction) {  // of both sides of the belt
      const auto side = tactics::first_that_works(formula.parts(), [&](const Formula& one) {
        return Theorem::consequence({in_form(one, here)}, formula);
      });
      return side ? *side : throw unknown(formula);
    }
    if (formula.kind() != Kind::derivative) {
      return Theorem::order(formula, {Positive{{tactics::part(here, 1)}}});
    }
    Theorem slope = here.conclusion().kind() == Kind::conjunction ? tactics::part(here, 0) : here;
    if (formula.parts()[0] != Term(X_)) {  // a difference of motions
      slope = Theorem::differentiate(formula.parts()[0], formula.parts()[1], {slope});
    }
    // The load is one letter: cos(omega t) and cos(t), with omega a number, would be multiples of one phase.
    const Variable of_load{"load"};
    const Term now = load(formula.parts()[1]);
    const Formula same = replaced(equal(slope.conclusion().parts()[2], formula.parts()[2]), now, of_load);
    const Theorem value = at_the_data(same, [](const Formula& open) { return Theorem::combination(open); });
    const Variable place{"place", orbits::state_type};
    return Theorem::replace(Theorem::instantiate(value, {{of_load, now}}), place,
                            derivative(slope.conclusion().parts()[0], slope.conclusion().parts()[1], place),
                            slope);
  }

  // finite t: 0 < t < b and not …: where phases end before b.
  [[nodiscard]] Theorem but_finitely_often(const Formula& formula) const {
    const Variable t{"s"};
    const Formula body = opened(formula, t), inside = body.parts()[0], usual = body.parts()[1].parts()[0];
    std::vector<Theorem> cases{Theorem::assume(body)};
    std::optional<Theorem> finite;
    for (std::size_t k = 0; k < phases_.size(); ++k) {
      const auto [from, to] = interval(k);
      const Formula during = kernel::between(from, t, to);
      const Theorem here = tactics::at(tactics::part(phases_[k], 1), t, Theorem::assume(during));
      cases.push_back(Theorem::discharge(in_form(usual, here), during));
      if (less(t, to) == inside.parts()[1]) {
        break;
      }
      cases.push_back(Theorem::trichotomy(t, to));
      const Theorem end = Theorem::finite_point(to);
      finite = finite ? Theorem::finite_union(*finite, end) : end;
    }
    if (!finite) {
      throw unknown(formula);
    }
    const Theorem only = Theorem::consequence(cases, opened(finite->conclusion(), t));
    return Theorem::finite_part(*finite, Theorem::generalize(Theorem::discharge(only, body), t));
  }

  // The first phase once more, a period later, which ends then: X(t - Theta) is X(t).
  [[nodiscard]] Theorem again(const Theorem& repeats, const Term& end) const {
    const Variable t{"s"}, u{"u"};
    const Term period = interval(phases_.size() - 1).second, to = interval(0).second;
    const auto earlier = [&](const Term& time) { return time - period; };
    const auto same = [&](const Term& time) {
      return tactics::symmetric(
          tactics::by_rewriting(Theorem::specialize(repeats, earlier(time)),
                                Theorem::combination(equal(earlier(time) + period, time))));
    };
    const Formula within = kernel::within(period, t, end), during = kernel::between(period, t, end);
    const Theorem closed = Theorem::assume(within), open = Theorem::assume(during);
    const auto from = [](const Formula& order, const Theorem& by) {
      return Theorem::order(order, {Positive{{by}}});
    };
    const Theorem places = tactics::both({from(at_most(0, earlier(t)), tactics::part(closed, 0)),
                                          from(at_most(earlier(t), to), tactics::part(closed, 1))});
    const Theorem smooth = Theorem::same_continuity(
        Theorem::continuity(lambda(t, apply(X_, earlier(t))), period, end,
                            {tactics::part(phases_[0], 0), tactics::for_every(t, within, places)}),
        tactics::for_every(t, within, same(t)));
    const Theorem here = tactics::at(tactics::part(phases_[0], 1), earlier(t),
                                     tactics::both({from(less(0, earlier(t)), tactics::part(open, 0)),
                                                    from(less(earlier(t), to), tactics::part(open, 1))}));
    const Theorem slope = Theorem::same_derivative(
        Theorem::differentiate(lambda(u, apply(X_, earlier(u))), t, {tactics::part(here, 0)}),
        tactics::for_every(u, kernel::between(period, u, end), same(u)), tactics::part(open, 0),
        tactics::part(open, 1));
    const Theorem later = Theorem::combination(equal(load(earlier(t)), load(t)));
    return tactics::both(
        {smooth, tactics::for_every(
                     t, during,
                     tactics::both({tactics::by_rewriting(tactics::by_rewriting(slope, same(t)), later),
                                    tactics::by_rewriting(tactics::part(here, 1), same(t))}))});
  }
  [[nodiscard]] Term load(const Term& time) const {
    return cos(Term(example_.data.omega) * time + substitute(Variable{"phi"}, values_));
  }

  const Example& example_;
  const Met& met_;
  Theorem said_;
  const orbits::Ranges& frequencies_;
  Variable X_{"X", orbits::motion_type};
  kernel::Substitution values_;
  std::vector<Theorem> facts_, phases_;
  orbits::Letters letters_;
};

}  // namespace

const Example& example_of(const Met& met) {
  return met.example == on_a_moving_belt().name ? on_a_moving_belt() : example_named(met.example);
}

Theorem met_theorem(Prover& prover, const Met& met) {
  const numeric::motion::ExactParameters& a = example_of(met).data;
  const auto claims = transformed(met.ids, [&](const std::string& id) { return &prover.claim(id); });
  const Theorem& orbit = prover.theorem(met.example + ".motion");
  return at_frequencies(a.chi, a.eta, [&](const orbits::Ranges& frequencies) {
    return orbits::of_orbit(orbit, [&](const Theorem& said) {
      MotionOf motion(met, said, frequencies);
      for (const std::string& id : met.premises) {
        motion.learn(prover.claim(id), final_outcome(prover.prove(id)).theorems);
      }
      return motion.obeys(claims);
    });
  });
}

}  // namespace stickslip::proofs::pascal2012
