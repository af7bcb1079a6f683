// Theorems, and the rules: the only functions that make one.
//
// A sequent says: for all values of its free variables, of their types, the conclusion holds if all
// hypotheses do. Every rule is sound for that reading; doc/kernel.md says why, rule by rule. Every rule takes
// data and theorems and computes the rest itself: no verdict, no callback. It throws KernelError when it does
// not apply.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::kernel {

struct Sequent {
  Formulas hypotheses;
  Formula conclusion;
};

class Theorem;
struct Step;                                 // how a theorem was made, below
struct Multiple;                             // of an equation
struct Positive;                             // a product of inequalities
using Interval = std::pair<Number, Number>;  // closed
using Box = std::vector<Interval>;
using Ranges = std::map<Variable, Interval, Before>;

// Immutable. There is no Theorem but those that the rules make.
class Theorem final {
 public:
  Theorem(const Theorem&) = default;  // and no moves: there is no Theorem without sequent
  Theorem& operator=(const Theorem&) = default;

  [[nodiscard]] const Formulas& hypotheses() const { return data_->sequent.hypotheses; }
  [[nodiscard]] const Formula& conclusion() const { return data_->sequent.conclusion; }
  [[nodiscard]] const Sequent& sequent() const { return data_->sequent; }
  [[nodiscard]] const Step& derivation() const { return *data_->step; }

  // ---- Logic (logic.cpp). Γ, Δ are hypotheses.
  // A ⊢ A.
  [[nodiscard]] static Theorem assume(const Formula& a);
  // Γ ⊢ C gives Γ less A ⊢ A ⇒ C.
  [[nodiscard]] static Theorem discharge(const Theorem& theorem, const Formula& a);
  // Γ ⊢ A and Δ ⊢ C give Γ, Δ less A ⊢ C.
  [[nodiscard]] static Theorem cut(const Theorem& lemma, const Theorem& theorem);
  // Γi ⊢ Ai give Γ1, Γ2, … ⊢ C where A1 and A2 and … imply C by the truth tables of and, or, not, ⇒.
  [[nodiscard]] static Theorem consequence(const std::vector<Theorem>& premises, const Formula& conclusion);
  // Variables replaced by terms of their types, everywhere at once.
  [[nodiscard]] static Theorem instantiate(const Theorem& theorem, const Substitution& substitution);
  // Γ ⊢ C gives Γ ⊢ for all x: C, where x is free in no formula of Γ.
  [[nodiscard]] static Theorem generalize(const Theorem& theorem, const Variable& variable);
  // Γ ⊢ for all x: A(x) gives Γ ⊢ A(t), t of x's type.
  [[nodiscard]] static Theorem specialize(const Theorem& theorem, const Term& term);
  // Γ ⊢ A(t) gives Γ ⊢ there is x: A(x), which is given.
  [[nodiscard]] static Theorem witness(const Theorem& theorem, const Formula& existence, const Term& term);
  // Γ ⊢ there is x: A(x), and Δ ⊢ C give Γ, Δ less A(v) ⊢ C, where v is free neither in Δ less A(v), nor in
  // C, nor in the existence.
  [[nodiscard]] static Theorem choose(const Theorem& existence, const Variable& variable,
                                      const Theorem& theorem);
  // ⊢ a = a, a number or a matrix.
  [[nodiscard]] static Theorem reflexive(const Term& a);
  // Γ ⊢ a = b and Δ ⊢ P(a) give Γ, Δ ⊢ P(b), P being given as a formula with the variable.
  [[nodiscard]] static Theorem replace(const Theorem& equation, const Variable& place, const Formula& formula,
                                       const Theorem& theorem);
  // Γ ⊢ C gives Γ ⊢ C' where both are the same once these definitions are unfolded.
  [[nodiscard]] static Theorem convert(const Theorem& theorem, const Formula& conclusion,
                                       const Definitions& definitions);

  // ---- Algebra (algebra.cpp). All definitions in `unfolded` are looked into; every divisor
  // (normal_form.hpp) of what was given becomes a hypothesis d ≠ 0. Γk ⊢ ak = bk give Γ1, Γ2, …, divisors ⊢ a
  // = b where a - b = Σ Lk (ak - bk) Rk by normal form. With none: an identity.
  [[nodiscard]] static Theorem combination(const Formula& equation);
  [[nodiscard]] static Theorem combination(const Formula& equation, const std::vector<Multiple>& multiples,
                                           const Definitions& unfolded = {});
  // Inequalities and equations give a ≤ b or a < b where b - a = Σ q s² Π (upper - lower) + Σ Lk (ak - bk) Rk
  // by normal form, q > 0 rational; a < b only if all inequalities of one product with s = 1 are strict.
  [[nodiscard]] static Theorem order(const Formula& inequality, const std::vector<Positive>& positives);
  [[nodiscard]] static Theorem order(const Formula& inequality, const std::vector<Positive>& positives,
                                     const std::vector<Multiple>& multiples,
                                     const Definitions& unfolded = {});
  // ⊢ 0 ≤ a ⇒ there is x: 0 ≤ x and x² = a.
  [[nodiscard]] static Theorem square_root(const Term& a);
  // ⊢ exactly one of a < b, a = b, b < a holds; a ≤ b if the first or the second does, b ≤ a if the second or
  // third.
  [[nodiscard]] static Theorem trichotomy(const Term& a, const Term& b);

  // ---- Sine, cosine (algebra.cpp)
  // Γ ⊢ sin x = 0 (or cos x = 0), ⊢ m*pi < x, ⊢ x < n*pi with numbers m, n give ⊢ x = k1*pi or x = k2*pi or
  // …: all zeros strictly between, perhaps none.
  [[nodiscard]] static Theorem zeros_between(const Theorem& equation, const Theorem& lower,
                                             const Theorem& upper);
  // ⊢ 0 < x and x < pi ⇒ 0 < sin x.
  [[nodiscard]] static Theorem sine_is_positive(const Term& x);

  // ---- Calculus (calculus.cpp, continuity.cpp). Intervals as in between() and within().
  // ⊢ f has a derivative at the point, and that of the chain, product and quotient rules: the value is
  // computed. Where f holds g(u(t)) with a function variable g, a premise ⊢ derivative(g, u(point), w) is
  // used. Definitions that depend on the time are looked into. Divisors at the point become hypotheses.
  [[nodiscard]] static Theorem differentiate(const Term& function, const Term& point,
                                             const std::vector<Theorem>& premises = {});
  // derivative(f, p, v) and derivative(f, p, w) give v = w.
  [[nodiscard]] static Theorem unique_derivative(const Theorem& one, const Theorem& other);
  // derivative(f, p, v), for all t: a < t < b ⇒ f(t) = g(t), a < p, p < b give derivative(g, p, v).
  [[nodiscard]] static Theorem same_derivative(const Theorem& derivative, const Theorem& agreement,
                                               const Theorem& lower, const Theorem& upper);
  // ⊢ f is continuous on [a, b] as a composition. Where f holds g(u(t)) with a function variable g, premises
  // continuous(g, c, d) and for all t: a ≤ t ≤ b ⇒ c ≤ u(t) ≤ d are used; u(t) = t on [a, b] needs only the
  // former. A divisor d(t) becomes the hypothesis for all t: a ≤ t ≤ b ⇒ d(t) ≠ 0.
  [[nodiscard]] static Theorem continuity(const Term& function, const Term& a, const Term& b,
                                          const std::vector<Theorem>& premises = {});
  // continuous(f, a, b), a ≤ c, d ≤ b give continuous(f, c, d).
  [[nodiscard]] static Theorem continuous_within(const Theorem& theorem, const Theorem& lower,
                                                 const Theorem& upper);
  // continuous(f, a, b) and for all t: a < t < b ⇒ derivative(f, t, 0) give for all t: a ≤ t ≤ b ⇒ f(t) =
  // f(a). Instead of the latter: finite t: a < t < b and not derivative(f, t, 0).
  [[nodiscard]] static Theorem constant(const Theorem& continuity, const Theorem& no_derivative);
  // continuous(f, a, b) and finite t: a < t < b and not there is v: derivative(f, t, v) and 0 ≤ v, give
  // a ≤ b ⇒ f(a) ≤ f(b). f is a number.
  [[nodiscard]] static Theorem monotone(const Theorem& continuity, const Theorem& few_exceptions);
  // continuous(f, a, b), for all t: a < t < b ⇒ derivative(f, t, v(t)), a < b give
  // there is c: a < c < b and f(b) - f(a) = v(c) (b - a). f is a number.
  [[nodiscard]] static Theorem mean_value(const Theorem& continuity, const Theorem& derivative,
                                          const Theorem& order);
  // continuous(f, a, b), f(a) < 0, 0 < f(b), a < b give there is c: a < c < b and f(c) = 0. f is a number.
  [[nodiscard]] static Theorem intermediate_value(const Theorem& continuity, const Theorem& start,
                                                  const Theorem& end, const Theorem& order);
  // finite t: A(t), for all t: B(t) ⇒ A(t) give finite t: B(t);
  // finite t: A(t), finite t: B(t) give finite t: A(t) or B(t);
  // finite t: A(t) gives finite t: A(t + c).
  [[nodiscard]] static Theorem finite_part(const Theorem& finite, const Theorem& part);
  [[nodiscard]] static Theorem finite_union(const Theorem& one, const Theorem& other);
  [[nodiscard]] static Theorem finite_shift(const Theorem& finite, const Term& c);

  // ---- Functions made of others (joining.cpp), of one shape, and what they inherit.
  // ⊢ there is X: for all t: t < c ⇒ X(t) = before(t), and c ≤ t ⇒ X(t) = after(t).
  [[nodiscard]] static Theorem piecewise(const Term& before, const Term& after, const Term& c);
  // 0 < p gives there is X: for all t: 0 ≤ t < p ⇒ X(t) = function(t), and for all t: X(t + p) = X(t).
  [[nodiscard]] static Theorem periodic(const Term& function, const Theorem& positive);
  // continuous(f, a, b), for all t: a ≤ t ≤ b ⇒ f(t) = g(t) give continuous(g, a, b).
  [[nodiscard]] static Theorem same_continuity(const Theorem& continuity, const Theorem& agreement);
  // continuous(f, a, b), continuous(f, b, c) give continuous(f, a, c).
  [[nodiscard]] static Theorem continuous_union(const Theorem& before, const Theorem& after);
  // ⊢ finite t: t = a.
  [[nodiscard]] static Theorem finite_point(const Term& a);

  // ---- Numbers in balls (numbers.cpp, zeros.cpp). `bits` is the working precision.
  // a < b, a ≤ b or a ≠ b for all values of its variables, numbers, in the ranges given: these are the
  // hypotheses l ≤ x, x ≤ u. Only where no divisor can be zero there and the balls are disjoint.
  [[nodiscard]] static Theorem sign(const Formula& relation, const Ranges& ranges = {}, long bits = 128);
  // ⊢ exactly one X in the box solves f = 0: Krawczyk's test. X is a column, f a column of as many, with no
  // other variable.
  [[nodiscard]] static Theorem one_zero(const Variable& X, const Term& f, const Box& box, long bits = 128);
  // Every complex zero of the polynomial lies inside the unit circle, for all values of its variables in the
  // ranges, as in sign: Jury's test in balls.
  [[nodiscard]] static Theorem jury(const Term& coefficients, const Ranges& ranges = {}, long bits = 128);

 private:
  struct Data {
    Sequent sequent;
    std::shared_ptr<const Step> step;
  };
  // Throw KernelError if something is no closed formula, or if one name stands for two types. Without
  // hypotheses: under all that the step's premises have, and its divisors.
  Theorem(Step step, Formulas hypotheses, const Formula& conclusion);
  Theorem(const Step& step, const Formula& conclusion);
  std::shared_ptr<const Data> data_;
};

// What a theorem was made of: enough to check it again elsewhere.
struct Step {
  std::string rule;
  std::vector<Theorem> premises = {};
  std::vector<Term> data = {};  // what the rule was given, in its order; multipliers left, right
  Definitions unfolded = {};
  Formulas divisors = {};  // what it added as hypotheses
};

struct Multiple {
  Theorem equation;
  Term left = 1;
  Term right = 1;
};

struct Positive {
  std::vector<Theorem> inequalities;
  Number factor = 1;
  Term square = 1;
};

inline Theorem Theorem::combination(const Formula& equation) {
  return combination(equation, {});
}
inline Theorem Theorem::order(const Formula& inequality, const std::vector<Positive>& positives) {
  return order(inequality, positives, {});
}

// x in the box: the entries of a column between their ends, ends included.
[[nodiscard]] Formula inside(const Term& x, const Box& box);
// Exactly one x in the box with A(x).
[[nodiscard]] Formula exactly_one(const Variable& x, const Box& box, const Formula& a);

}  // namespace stickslip::proofs::kernel
