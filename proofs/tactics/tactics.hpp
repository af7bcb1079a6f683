// Convenient ways to find derivations. All return theorems that the kernel's rules made; a wrong tactic fails
// with KernelError, it cannot make a false theorem.
#pragma once

#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proofs/kernel/theorem.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::tactics {

using kernel::Definitions;
using kernel::Formula;
using kernel::Multiple;
using kernel::Positive;
using kernel::Term;
using kernel::Theorem;
using kernel::Variable;

// Theorems that bound variables by numbers, l < x or x < u, and theorems d ≠ 0: what divisors are discharged
// with.
using Domain = std::vector<Theorem>;
// {l < x} ⊢ l < x, and {x < u} ⊢ x < u.
[[nodiscard]] Theorem above(const Term& lower, const Variable& x);
[[nodiscard]] Theorem below(const Variable& x, const Term& upper);

// ---- Terms
// a < b or a ≤ b.
[[nodiscard]] bool is_inequality(const Formula& formula);
// a and b, and b - a, for a = b, a < b or a ≤ b. Throw KernelError for any other formula.
[[nodiscard]] const std::vector<Term>& sides_of(const Formula& relation);
[[nodiscard]] Term gap_of(const Formula& relation);
// The terms and the parts of their parts, each once, a whole before its parts: these only where `visit` says
// true of the whole.
template <class Visit>
void each_part(const std::vector<Term>& terms, const Visit& visit) {
  std::set<Term> seen;
  const auto look_at = [&](const auto& self, const Term& term) -> void {
    if (seen.insert(term).second && visit(term)) {
      for (const Term& part : term.parts()) {
        self(self, part);
      }
    }
  };
  for (const Term& term : terms) {
    look_at(look_at, term);
  }
}
// A matrix of zeros with a one, at that place row by row.
[[nodiscard]] Term unit(int rows, int columns, std::size_t place);
// A definition of all that the body depends on, of these first, applied to just that.
[[nodiscard]] Term defined(const std::string& name, const Term& body,
                           const std::vector<Variable>& first = {});
// All definitions applied in the terms, and in the bodies of these.
[[nodiscard]] Definitions definitions_in(std::vector<Term> terms);

// ---- Searches
// What the work makes; nothing where it throws KernelError.
template <class Work>
[[nodiscard]] auto attempt(const Work& work) -> std::optional<decltype(work())> {
  try {
    return work();
  } catch (const kernel::KernelError&) {
    return std::nullopt;
  }
}
// What it makes of the first of these with which it does not throw that.
template <class All, class Work>
[[nodiscard]] auto first_that_works(const All& all, const Work& work)
    -> std::optional<decltype(work(*std::begin(all)))> {
  for (const auto& one : all) {
    if (auto made = attempt([&] { return work(one); })) {
      return made;
    }
  }
  return std::nullopt;
}

// ---- Logic
[[nodiscard]] Theorem symmetric(const Theorem& equation);       // a = b gives b = a
[[nodiscard]] Theorem both(const std::vector<Theorem>& parts);  // their conjunction
[[nodiscard]] Theorem part(const Theorem& conjunction, std::size_t index);
[[nodiscard]] std::vector<Theorem> parts_of(const Theorem& conjunction);
// A, B, … ⊢ C and ⊢ A, ⊢ B, … give ⊢ C, one after the other.
[[nodiscard]] Theorem cut_all(const std::vector<Theorem>& lemmas, Theorem theorem);
// The formula with the values of these names ⊢ there are names: the formula. A name without a value stands
// for itself.
[[nodiscard]] Theorem there_are(const std::vector<Variable>& names, Formula formula,
                                const kernel::Substitution& values, Theorem theorem);
// ⊢ there are these, the first outermost: what the theorem says of them.
[[nodiscard]] Theorem there_are(const std::vector<Variable>& names, const Theorem& theorem);
// A ⇒ C and A give C.
[[nodiscard]] Theorem detach(const Theorem& implication, const Theorem& premise);
// for all t: A(t) ⇒ C(t), and A(x), give C(x).
[[nodiscard]] Theorem at(const Theorem& theorem, const Term& x, const Theorem& premise);
// Γ, A ⊢ C gives Γ ⊢ for all t: A ⇒ C.
[[nodiscard]] Theorem for_every(const Variable& t, const Formula& a, const Theorem& theorem);
// a = b in Γ ⊢ C: every a of C becomes b.
[[nodiscard]] Theorem by_rewriting(const Theorem& theorem, const Theorem& equation);
// The theorem less those of its hypotheses of which there is such a lemma.
using Lemma = std::function<std::optional<Theorem>(const Formula& hypothesis)>;
[[nodiscard]] Theorem settled_by(Theorem theorem, const Lemma& lemma);
// x ≤ c ⊢ C and c ≤ x ⊢ C give C.
[[nodiscard]] Theorem either_side(const Theorem& before, const Theorem& after, const Term& x, const Term& c);
// Γ, A ⊢ 0 < 0 gives Γ ⊢ not A.
[[nodiscard]] Theorem impossible(const Formula& a, const Theorem& contradiction);
// 0 < d or d < 0 gives d ≠ 0.
[[nodiscard]] Theorem different(const Theorem& inequality);
// not for all x: A(x), from a theorem not A(t).
[[nodiscard]] Theorem refuted(const Formula& for_all, const Term& t, const Theorem& counterexample);
// ⊢ a b = 0 ⇒ a = 0 or b = 0, for numbers.
[[nodiscard]] Theorem zero_product(const Term& a, const Term& b);
// Γ ⊢ A B = I gives Γ ⊢ inverse(A) = B, for square matrices A, B.
[[nodiscard]] Theorem inverse_of(const Theorem& product);
// x = k*pi for an integer k and m*pi < x < (m+2)*pi, m whole, are for the kernel: Theorem::zeros_between.

// ---- Divisors
// Hypotheses d ≠ 0 less what the domain implies: of each d the irreducible factors that may vanish remain,
// each as a hypothesis of its own. A factor is discharged when it is one of the domain's, or a polynomial in
// bounded variables and pi whose expansion in the distances from the bounds has coefficients of one sign. The
// hypotheses `kept` stay as they are.
[[nodiscard]] Theorem nonzero(const Theorem& theorem, const Domain& domain,
                              const kernel::Formulas& kept = {});

// Whether it says d ≠ 0, of a number.
[[nodiscard]] bool is_divisor(const Formula& formula);
// a ≠ 0, for a sine or a cosine a, gives f ≠ 0, where a is f or -f by normal form, or 2 sin(u) cos(u) and f
// one of these, or f is linear in a variable at whose zero a vanishes: sin(pi*x/y) for x - y. Nothing says
// nothing.
[[nodiscard]] std::optional<Theorem> differs_too(const Term& f, const Theorem& known);
// d ≠ 0 gives f ≠ 0 for the irreducible factors of d, as far as they are found.
[[nodiscard]] std::vector<Theorem> factors_differ(const Theorem& differs);
// Whether d ≠ 0 gives f ≠ 0 in the domain, where all is defined that d and f divide by.
[[nodiscard]] bool implies_nonzero(const Term& d, const Term& f, Domain domain);
// 0 < a, as a product of powers of irreducible factors whose sign the domain gives; what occurs to even
// powers only is a hypothesis f ≠ 0.
[[nodiscard]] Theorem positive(const Term& a, const Domain& domain);
// ⊢ 0 < exp(x).
[[nodiscard]] Theorem exponential_is_positive(const Term& x);
// 0 < d gives 0 < 1/d.
[[nodiscard]] Theorem inverse_is_positive(const Theorem& positive);

// a² < b² and 0 ≤ b (or 0 < b) give a < b.
[[nodiscard]] Theorem below_by_squares(const Theorem& squares, const Theorem& not_negative, const Term& a,
                                       const Term& b);
// a² ≤ b² and 0 ≤ b give a ≤ b.
[[nodiscard]] Theorem at_most_by_squares(const Theorem& squares, const Theorem& not_negative, const Term& a,
                                         const Term& b);

// ---- Algebra: the kernel's rules, then nonzero().
[[nodiscard]] Theorem by_normal_form(const Formula& equation, const Definitions& unfolded,
                                     const Domain& domain = {});
[[nodiscard]] Theorem by_combination(const Formula& equation, const std::vector<Multiple>& multiples,
                                     const Definitions& unfolded = {}, const Domain& domain = {});
[[nodiscard]] Theorem by_positive_combination(const Formula& inequality,
                                              const std::vector<Positive>& positives,
                                              const std::vector<Multiple>& multiples = {},
                                              const Definitions& unfolded = {}, const Domain& domain = {});

// ---- Motions
// Z is continuous on [a, b] and Z' = w inside: ⊢ continuous(Z, a, b), ⊢ for all t: a < t < b ⇒ derivative(Z,
// t, w). Instead of the latter: finite t: a < t < b and not derivative(Z, t, w).
struct Motion {
  Theorem continuity;
  Theorem rate;
};
// (5), for a function z of time in terms of Z: if the derivative of flow(a - t) (z(t) - forced(t)) is zero by
// normal form and these multiples, in which the variable t is the time, ⊢ for all t: a ≤ t ≤ b ⇒ z(t) =
// flow(t - a) (z(a) - forced(a)) + forced(t). flow and forced are functions of time.
[[nodiscard]] Theorem by_differential_equation(const Motion& motion, const Term& z, const Term& flow,
                                               const Term& forced, const Variable& t,
                                               const std::vector<Multiple>& because,
                                               const Definitions& unfolded, const Domain& domain);

}  // namespace stickslip::proofs::tactics
