// A bound of a function over a range of one of its variables, by a bound of its slope there.
#pragma once

#include <algorithm>

#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"

namespace stickslip::proofs::pascal2012 {

// f(x) <= f(m) + K r: a bound K of the slope, as far as the range of x reaches from m.
class MeanValue {
 public:
  using Term = kernel::Term;
  using Theorem = kernel::Theorem;
  using Variable = kernel::Variable;

  // The name is the function's.
  MeanValue(const std::string& name, const kernel::Term& f, const Variable& x)
      : x_(x), parameters_(parameters(f, x)), f_(orbits::differentiable({name, parameters_, f})) {}

  // In ranges, that of x among them; of the other variables some have values.
  [[nodiscard]] MeanValue in(const orbits::Ranges& ranges, const kernel::Substitution& values = {}) const {
    MeanValue here = *this;
    here.ranges_ = ranges;
    here.values_ = values;
    return here;
  }

  // K r, by a search alone.
  [[nodiscard]] Rational reach() const {
    const auto bounds = orbits::enclosure(f_.slope.unfolded(at(x_)), ranges_, Rational(1, 1024));
    return std::max(Rational(-bounds.first.value()), Rational(bounds.second.value())) * radius();
  }
  // Ranges ⊢ f(x) <= f(m) + the reach.
  [[nodiscard]] Theorem above(const Rational& reach) const {
    const auto& [lower, upper] = ranges_.at(x_);
    const Rational lo = lower.value(), hi = upper.value(), m = middle(), K = reach / radius();
    orbits::Ranges here = ranges_;
    const Variable c{"c"};
    here[c] = ranges_.at(x_);
    const kernel::Formula goal = at_most(value(x_), value(m) + Term(reach));
    std::vector<Theorem> cases{Theorem::trichotomy(x_, m)};
    for (const bool before : {true, false}) {
      const Theorem order = Theorem::assume(before ? less(x_, m) : less(m, x_));
      const Theorem mean = chord(before ? Term(x_) : Term(m), before ? Term(m) : Term(x_), order);
      const Theorem there = Theorem::assume(opened(mean.conclusion(), c)), where = tactics::part(there, 0);
      Theorem slope = sign(before ? less(Term(Rational(-K)), slope_at(c)) : less(slope_at(c), K), here);
      const Theorem from = Theorem::assume(at_most(lo, x_)), to = Theorem::assume(at_most(x_, hi));
      slope = Theorem::cut(
          Theorem::order(at_most(lo, c), {{{tactics::part(where, 0)}},
                                          before ? kernel::Positive{{from}} : kernel::Positive{{}, m - lo}}),
          slope);
      slope = Theorem::cut(
          Theorem::order(at_most(c, hi), {{{tactics::part(where, 1)}},
                                          before ? kernel::Positive{{}, hi - m} : kernel::Positive{{to}}}),
          slope);
      const Theorem one = Theorem::order(goal, {{{slope, order}}, {{before ? from : to}, K}},
                                         {{tactics::part(there, 1), before ? 1 : -1}});
      cases.push_back(Theorem::discharge(Theorem::choose(mean, c, one), order.conclusion()));
    }
    const Theorem equation = Theorem::assume(equal(x_, m));
    const Variable place{"place"};
    const Theorem same = Theorem::replace(
        tactics::symmetric(equation), place, at_most(value(place), value(m) + Term(reach)),
        Theorem::order(at_most(value(m), value(m) + Term(reach)), {kernel::Positive{{}, reach}}));
    cases.push_back(Theorem::discharge(same, equation.conclusion()));
    return Theorem::convert(Theorem::consequence(cases, goal), unfold(goal, {f_.value}), {f_.value});
  }
  [[nodiscard]] Rational middle() const {
    return (ranges_.at(x_).first.value() + ranges_.at(x_).second.value()) / 2;
  }

 private:
  [[nodiscard]] Rational radius() const {
    return (ranges_.at(x_).second.value() - ranges_.at(x_).first.value()) / 2;
  }
  static std::vector<Variable> parameters(const kernel::Term& f, const Variable& x) {
    std::vector<Variable> result;
    for (const Variable& one : f.variables()) {
      if (one != x) {
        result.push_back(one);
      }
    }
    result.push_back(x);
    return result;
  }
  [[nodiscard]] std::vector<Term> at(const Term& x) const {
    std::vector<Term> arguments;
    for (const Variable& one : parameters_) {
      arguments.push_back(one == x_ ? x : substitute(one, values_));
    }
    return arguments;
  }
  [[nodiscard]] Term value(const Term& x) const { return f_.value(at(x)); }
  [[nodiscard]] Term slope_at(const Term& x) const { return f_.slope(at(x)); }
  [[nodiscard]] Theorem sign(const kernel::Formula& relation, const orbits::Ranges& ranges) const {
    return Theorem::sign(relation, orbits::ranges_in(relation, ranges));
  }
  [[nodiscard]] Theorem discharged(Theorem theorem) const {
    const kernel::Formulas hypotheses = theorem.hypotheses();
    for (const kernel::Formula& one : hypotheses) {
      theorem = tactics::is_divisor(one) ? Theorem::cut(sign(one, ranges_), theorem) : theorem;
    }
    return theorem;
  }
  // There is c between the ends with f(b) - f(a) = f'(c) (b - a).
  [[nodiscard]] Theorem chord(const Term& a, const Term& b, const Theorem& order) const {
    const Variable s{"s"};
    return Theorem::mean_value(discharged(Theorem::continuity(lambda(s, value(s)), a, b)),
                               tactics::for_every(s, kernel::between(a, s, b),
                                                  discharged(Theorem::instantiate(
                                                      Theorem::instantiate(f_.rate, values_), {{x_, s}}))),
                               order);
  }

  Variable x_;
  orbits::Ranges ranges_;
  std::vector<Variable> parameters_;
  orbits::Differentiable f_;
  kernel::Substitution values_;
};

}  // namespace stickslip::proofs::pascal2012
