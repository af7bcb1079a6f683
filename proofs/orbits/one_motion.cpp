// An orbit as one motion: its phases, joined at their ends and continued with the period.
#include "core/transformed.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// In the names that the orbit theorem declares, from what it says of them.
class OneMotion {
 public:
  OneMotion(const Question& question, const Theorem& said)
      : q_(question), names_(question), said_(said), period_(at_omega(names_.end(count() - 1))) {
    for (std::size_t k = 0; k + 1 < count(); ++k) {
      joined_.push_back({"W" + std::to_string(k + 1), motion_type});
    }
    joined_.push_back(Names::motion(count() - 1));
  }

  // What the theorem says of its motions, of X; and that X has the period. From what is said, the pieces
  // joined, and X.
  [[nodiscard]] Theorem operator()() {
    const Theorem repeats = part(periodic(), 1);
    for (std::size_t k = 0; k < count(); ++k) {
      agrees_.push_back(agrees(k));
    }
    std::vector<Theorem> parts{repeats};
    for (const Formula& one : said_.conclusion().parts()) {
      const Theorem holds = Theorem::consequence({said_}, one);
      const Theorem of_X = one.kind() == Kind::defined ? phase_of(holds) : at_times(holds);
      const Formula& formula = of_X.conclusion();
      if (formula.kind() != Kind::equal || formula.parts()[0] != formula.parts()[1]) {
        parts.push_back(of_X);
      }
    }
    return both(parts);
  }

  // ⊢ there are X, W1, …: what the theorem says; the pieces' names are gone.
  [[nodiscard]] Theorem closed(Theorem theorem) const {
    theorem = Theorem::choose(Theorem::periodic(joined_[0], positive_period()), X_,
                              tactics::there_are({X_}, theorem));
    for (std::size_t k = 0; k + 1 < count(); ++k) {
      theorem = Theorem::choose(join(k), joined_[k], theorem);
    }
    return theorem;
  }

 private:
  [[nodiscard]] std::size_t count() const { return q_.phases.size(); }
  [[nodiscard]] Term at_omega(const Term& term) const {
    return substitute(term, {{names_.omega(), q_.data.omega}});
  }
  [[nodiscard]] Term start(std::size_t k) const { return names_.start(k); }
  [[nodiscard]] Term end(std::size_t k) const { return k + 1 == count() ? period_ : names_.start(k + 1); }
  [[nodiscard]] Theorem known(const Formula& formula) const { return Theorem::consequence({said_}, formula); }

  // Of times that are sums of durations: what follows from their being positive and what they sum up to.
  [[nodiscard]] Theorem order(const Formula& inequality, const std::vector<Positive>& also) const {
    const Theorem whole = known(equal(start(count()), period_));
    for (unsigned chosen = 0; chosen < 1U << count(); ++chosen) {
      std::vector<Positive> positives = also;
      for (std::size_t k = 0; k < count(); ++k) {
        if ((chosen >> k & 1U) != 0) {
          positives.push_back({{known(less(0, Variable{q_.durations.at(k)}))}});
        }
      }
      for (const int sign : {0, 1, -1}) {
        const std::vector<Multiple> because(sign == 0 ? 0 : 1, {whole, sign});
        if (const auto found = attempt([&] { return Theorem::order(inequality, positives, because); })) {
          return *found;
        }
      }
    }
    throw KernelError("the times' order does not follow: " + to_string(inequality));
  }
  [[nodiscard]] Theorem positive_period() const { return order(less(0, period_), {}); }

  [[nodiscard]] Theorem join(std::size_t k) const {
    return Theorem::piecewise(Names::motion(k), joined_[k + 1], end(k));
  }
  [[nodiscard]] Theorem periodic() const {
    return Theorem::assume(opened(Theorem::periodic(joined_[0], positive_period()).conclusion(), X_));
  }

  // start <= t, t < end ⊢ X(t) = X_k(t).
  [[nodiscard]] Theorem inside(std::size_t k, const Term& t, const Theorem& from, const Theorem& to) const {
    const Theorem in_period = both({order(at_most(0, t), {{{from}}}), order(less(t, period_), {{{to}}})});
    std::vector<Theorem> steps{at(part(periodic(), 0), t, in_period)};
    for (std::size_t j = 0; j <= k && j + 1 < count(); ++j) {
      const Theorem pieces =
          Theorem::specialize(Theorem::assume(opened(join(j).conclusion(), joined_[j])), t);
      steps.push_back(j < k ? detach(part(pieces, 1), order(at_most(end(j), t), {{{from}}}))
                            : detach(part(pieces, 0), to));
    }
    return Theorem::combination(equal(Names::state(k, t), apply(X_, t)),
                                transformed(steps, [](const Theorem& step) {
                                  return Multiple{step, -1};
                                }));
  }
  // X_k(end) = X(end).
  [[nodiscard]] Theorem at_end(std::size_t k) const {
    const bool last = k + 1 == count();
    const std::size_t next = last ? 0 : k + 1;
    const Term from = last ? Term(0) : end(k);
    const Theorem there =
        inside(next, from, order(at_most(start(next), from), {}), order(less(from, end(next)), {}));
    std::vector<Multiple> because{{known(equal(Names::state(k, end(k)), Names::state(next, from)))}, {there}};
    if (last) {  // X(0 + period) = X(0)
      const Theorem returns = Theorem::specialize(part(periodic(), 1), 0);
      because.push_back(
          {tactics::by_rewriting(returns, Theorem::combination(equal(Term(0) + period_, period_))), -1});
    }
    return Theorem::combination(equal(Names::state(k, end(k)), apply(X_, end(k))), because);
  }
  // For all t: start <= t <= end ⇒ X_k(t) = X(t).
  [[nodiscard]] Theorem agrees(std::size_t k) const {
    const Variable t{"t"}, place{"place"};
    const Formula during = within(start(k), t, end(k)), goal = equal(Names::state(k, t), apply(X_, t));
    const Theorem here = Theorem::assume(during), ends = Theorem::assume(equal(end(k), t));
    const Theorem before =
        Theorem::discharge(inside(k, t, part(here, 0), Theorem::assume(less(t, end(k)))), less(t, end(k)));
    const Theorem last = Theorem::discharge(
        Theorem::replace(ends, place, equal(Names::state(k, place), apply(X_, place)), at_end(k)),
        equal(end(k), t));
    const Theorem either = Theorem::consequence(
        {part(here, 1), before, last, Theorem::trichotomy(t, end(k)), symmetry(t, end(k))}, goal);
    return for_every(t, during, either);
  }
  // t = e ⇒ e = t.
  [[nodiscard]] static Theorem symmetry(const Term& t, const Term& e) {
    return Theorem::discharge(symmetric(Theorem::assume(equal(t, e))), equal(t, e));
  }

  // A phase's definition, of X.
  [[nodiscard]] Theorem phase_of(const Theorem& holds) const {
    const Formula& formula = holds.conclusion();
    std::size_t k = 0;
    while (formula.parts()[0] != Term(Names::motion(k))) {
      ++k;
    }
    const Definition& definition = formula.definition();
    std::vector<Term> arguments = formula.parts();
    arguments[0] = X_;
    const Formula unfolded = definition.unfolded(formula.parts()), goal = definition.unfolded(arguments);
    const Theorem opened_phase = Theorem::convert(holds, unfolded, {definition});
    std::vector<Theorem> parts{Theorem::same_continuity(part(opened_phase, 0), agrees_[k])};
    for (std::size_t i = 1; i < unfolded.parts().size(); ++i) {
      parts.push_back(at_all_times(k, part(opened_phase, i)));
    }
    return Theorem::convert(both(parts), definition(arguments), {definition});
  }
  // For all t: inside ⇒ C of X_k, and that of X.
  [[nodiscard]] Theorem at_all_times(std::size_t k, const Theorem& theorem) const {
    const Variable t{"t"};
    const Formula during = opened(theorem.conclusion(), t).parts()[0];
    const Theorem here = Theorem::assume(during), holds = at(theorem, t, here);
    const Theorem same = same_at(k, t, here);
    const bool several = holds.conclusion().kind() == Kind::conjunction;
    std::vector<Theorem> parts;
    for (std::size_t i = 0; i < (several ? holds.conclusion().parts().size() : 1); ++i) {
      Theorem one = several ? part(holds, i) : holds;
      if (one.conclusion().kind() == Kind::derivative) {
        one = Theorem::same_derivative(one, open_agreement(k), part(here, 0), part(here, 1));
      }
      parts.push_back(tactics::by_rewriting(one, same));
    }
    return for_every(t, during, several ? both(parts) : parts[0]);
  }
  // X_k(t) = X(t), from start < t or start <= t, and t < end.
  [[nodiscard]] Theorem same_at(std::size_t k, const Term& t, const Theorem& during) const {
    return at(agrees_[k], t,
              both({Theorem::order(at_most(start(k), t), {Positive{{part(during, 0)}}}),
                    Theorem::order(at_most(t, end(k)), {Positive{{part(during, 1)}}})}));
  }
  [[nodiscard]] Theorem open_agreement(std::size_t k) const {
    const Variable s{"s"};
    const Formula during = between(start(k), s, end(k));
    return for_every(s, during, same_at(k, s, Theorem::assume(during)));
  }
  // What is said of states at the ends of phases, of X.
  [[nodiscard]] Theorem at_times(Theorem theorem) const {
    for (std::size_t k = 0; k < count(); ++k) {
      for (const Term& time : {start(k), end(k)}) {
        const Theorem there = both({order(at_most(start(k), time), {}), order(at_most(time, end(k)), {})});
        theorem = tactics::by_rewriting(theorem, at(agrees_[k], time, there));
      }
    }
    return theorem;
  }

  const Question& q_;
  Names names_;
  Theorem said_;
  Term period_;
  Variable X_{"X", motion_type};
  std::vector<Variable> joined_;  // W_k: X_k until its end, and then W_(k+1); the last is X_n
  std::vector<Theorem> agrees_;
};

}  // namespace

Theorem one_motion(const Theorem& orbit, const Question& question) {
  return of_orbit(orbit, [&](const Theorem& said) {
    OneMotion motion(question, said);
    return motion.closed(motion());
  });
}

}  // namespace stickslip::proofs::orbits
