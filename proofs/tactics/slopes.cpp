#include "proofs/tactics/slopes.hpp"

#include <algorithm>
#include <optional>

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;

namespace {

// What the formula says of the function D that it is the derivative of.
Term function_in(const Formula& rate) {
  return opened(rate, fresh(real_number, {rate})).parts()[0];
}

// A rate D of which ⊢ for all t: D(t) = f'(t); with its values, and with all of them where f' is known at all
// times.
class Rate {
 public:
  // t stands in nothing that is known of D.
  Rate(Variable D, const Theorem& all, const Variable& t) : D_(std::move(D)), all_(all) {
    const Theorem slope = Theorem::differentiate(function_in(all_.conclusion()), t);
    if (slope.hypotheses().empty()) {
      always_ = Theorem::generalize(Theorem::unique_derivative(Theorem::specialize(all_, t), slope), t);
    }
  }
  [[nodiscard]] const Variable& name() const { return D_; }
  // ⊢ D(p) = f'(p).
  [[nodiscard]] Theorem at(const Term& p) const {
    return always_ ? Theorem::specialize(*always_, p)
                   : Theorem::unique_derivative(
                         Theorem::specialize(all_, p),
                         without_hypotheses(Theorem::differentiate(function_in(all_.conclusion()), p)));
  }

 private:
  Variable D_;
  Theorem all_;
  std::optional<Theorem> always_;
};

// D(p) in the term, but for those of p that are bound there.
Terms values_of(const Variable& D, const Term& term) {
  Terms found;
  each_part({term}, [&](const Term& part) {
    if (part.kind() == Kind::apply && part.parts()[0] == Term(D) && part.is_closed()) {
      found.insert(part);
    }
    return true;
  });
  return found;
}

class Rates {
 public:
  // ⊢ 0 < 0, from the formula.
  Theorem contradiction(const Theorem& said, const Shown& shown_not) {
    const Formula& formula = said.conclusion();
    if (formula.kind() != Kind::exists) {
      Theorem here = said;
      for_each_value(formula, [&](const Theorem& value) { here = by_rewriting(here, value); });
      return Theorem::consequence({here, shown_not(here.conclusion())}, less(0, 0));
    }
    const Variable D = fresh(formula.binds(), beside_rates({formula}));
    const Theorem of_D = Theorem::assume(opened(formula, D)), rate = without_others(part(of_D, 0));
    rates_.emplace_back(D, rate, fresh(real_number, beside_rates({formula, D})));
    return Theorem::choose(said, D, contradiction(part(of_D, 1), shown_not));
  }

 private:
  [[nodiscard]] std::vector<Term> beside_rates(std::vector<Term> terms) const {
    for (const Rate& one : rates_) {
      terms.emplace_back(one.name());
    }
    return terms;
  }

  // Of values in the term, the last rate's first, for it may speak of others.
  template <class Visit>
  void for_each_value(const Term& term, const Visit& visit) const {
    for (auto rate = rates_.rbegin(); rate != rates_.rend(); ++rate) {
      for (const Term& value : values_of(rate->name(), term)) {
        visit(rate->at(value.parts()[1]));
      }
    }
  }

  // ⊢ for all t: D(t) = f'(t), with the values of other rates put into f.
  [[nodiscard]] Theorem without_others(const Theorem& rate) const {
    const Variable t = fresh(real_number, beside_rates({rate.conclusion()})),
                   s = fresh(real_number, beside_rates({rate.conclusion(), t}));
    const Term f = function_in(rate.conclusion()), body = apply(f, t);
    Theorem same = Theorem::reflexive(body);
    for_each_value(body, [&](const Theorem& value) {
      const Term& here = same.conclusion().parts()[1];
      const Variable place = fresh(real_number, {here, value.conclusion(), body});
      same = Theorem::replace(value, place, equal(body, replaced(here, value.conclusion().parts()[0], place)),
                              same);
    });
    if (same.conclusion().parts()[1] == body) {
      return rate;
    }
    const Formula around = between(Term(s) - 1, t, Term(s) + 1);
    return Theorem::generalize(
        Theorem::same_derivative(Theorem::specialize(rate, s), for_every(t, around, same),
                                 Theorem::order(less(Term(s) - 1, s), {Positive{{}}}),
                                 Theorem::order(less(s, Term(s) + 1), {Positive{{}}})),
        s);
  }

  std::vector<Rate> rates_;
};

}  // namespace

Formula with_slopes(const Formula& formula) {
  if (formula.kind() != Kind::exists) {
    return formula;
  }
  const Variable D = fresh(formula.binds(), {formula}), t = fresh(real_number, {formula, D});
  const Formula open = opened(formula, D);
  const Term slope = Theorem::differentiate(function_in(open.parts()[0]), t).conclusion().parts()[2];
  return with_slopes(substitute(open.parts()[1], {{D, lambda(t, slope)}}));
}

Theorem there_are_slopes(const Formula& formula, const Settled& settled, const Shown& shown) {
  if (formula.kind() != Kind::exists) {
    return shown(formula);
  }
  const Variable t{"t"}, D = fresh(formula.binds(), {formula});
  const Formula open = opened(formula, D);
  const Theorem found = Theorem::differentiate(opened(open.parts()[0], t).parts()[0], t),
                slope = settled(found);
  const auto speaks_of_time = [&](const Formula& one) { return one.variables().contains(t); };
  if (std::ranges::any_of(slope.hypotheses(), speaks_of_time)) {
    const Formula divisor = *std::ranges::find_if(found.hypotheses(), speaks_of_time);
    throw KernelError("a derivative is one at all times, and here it divides by " +
                      to_string(divisor.parts()[0].parts()[0]));
  }
  const Term value = lambda(t, slope.conclusion().parts()[2]);
  const Theorem rest = there_are_slopes(substitute(open.parts()[1], {{D, value}}), settled, shown);
  return Theorem::witness(both({Theorem::generalize(slope, t), rest}), formula, value);
}

Theorem there_are_no_slopes(const Formula& formula, const Shown& shown_not) {
  return impossible(formula, Rates().contradiction(Theorem::assume(formula), shown_not));
}

}  // namespace stickslip::proofs::tactics
