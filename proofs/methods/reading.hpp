// What a printed statement says, in the kernel's language.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofs/kernel/term.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/methods/claim.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::methods {

// Printed terms as kernel terms. A scalar is a variable, a number, or, where the table of symbols or model/
// has a formula for it, a definition in what it depends on: chi is chi(omega1, omega2), H(t) is H(t, omega1,
// omega2), F_0 is F0(omega, phi, …). The motion is a function of time, X(t) = (x1, x2, x1', x2')(t); Z(t) and
// Zbar(t) are X(t) seen from the places of rest. The kernel has no roots: sqrt(a) is a variable, of which a
// claim assumes that its square is a and that it is not negative (saying() in assumptions.hpp). Throws
// symbols::NoValue for what has no meaning, and where a root would change with the time of a rate or an
// interval.
class Reader {
 public:
  [[nodiscard]] kernel::Term operator()(const symbols::Term& printed);
  // left = right (or <, …), entry by entry. |a| < b is -b < a and a < b; any other |a| is a unless a < 0, and
  // -a unless 0 < a: of both it is said what the statement says.
  //
  // A derivative d/dt f of a formula is D(t): there are functions D1, D2, …, the derivatives that occur at
  // all times, with left = right. A statement "d/dt f = g during [a, b]" says that f is continuous on [a, b]
  // and has the derivative g(t) at each t between; any other "during [a, b]", that it holds for each t
  // between.
  //
  // "d/dt f = g almost always on [a, b]" says that f is continuous on [a, b], and that finitely many t
  // between have not f'(t) = g(t); any other such statement, that it fails for finitely many t between. Each
  // sign(a) in it is 1 where 0 < a(t) and -1 where a(t) < 0; where a(t) = 0 the statement fails.
  [[nodiscard]] kernel::Formula operator()(const symbols::Statement& statement);

 private:
  [[nodiscard]] kernel::Term scalar(const std::string& name);
  [[nodiscard]] kernel::Term symbol(const symbols::Term& printed);
  [[nodiscard]] kernel::Term function(const symbols::Term& printed);
  [[nodiscard]] kernel::Formula relation(const symbols::Statement& statement);
  [[nodiscard]] kernel::Formula without_absolute_value(const symbols::Statement& statement,
                                                       const symbols::Term& absolute);
  [[nodiscard]] kernel::Formula at_one_time(const symbols::Statement& statement);
  [[nodiscard]] kernel::Formula with_signs(const symbols::Statement& statement);

  // Of the derivatives in a statement: D, and what it is the derivative of.
  std::vector<std::pair<kernel::Variable, kernel::Term>> rates_;
};

// The printed root that this variable stands for, as this thread has read it; nothing for any other variable.
[[nodiscard]] std::optional<symbols::Term> root_of(const kernel::Variable& variable);

// The parameters' domain, which every statement supposes, as the vocabulary in force has it: theorems "x < u"
// that rest on themselves, and what these say. Of the oscillator: 0 < omega1 < 1 < omega2, positive omega,
// us, ur.
[[nodiscard]] const std::vector<kernel::Theorem>& parameters();
[[nodiscard]] const kernel::Formulas& domain_formulas();
// The domain of the variables among these.
[[nodiscard]] std::vector<kernel::Formula> domain_of(const kernel::Variables& variables);
// The numbers between which it has the parameter.
struct Bounds {
  std::optional<Rational> lower, upper;
};
[[nodiscard]] Bounds bounds_of(const std::string& parameter);

// Kernel terms of numbers as they are printed (printed.cpp).

// Both throw symbols::NoValue for what has no print, a function of time applied or an entry of a vector.

// As it is built.
[[nodiscard]] symbols::Term printed_term(const kernel::Term& number);
// As a quotient of sums of monomials, those of low degree first; so are the arguments of cosines and sines.
// Throws KernelError where that would take too long.
[[nodiscard]] symbols::Term neat_term(const kernel::Term& number);

// That the factor is not zero: of f and -f the one whose first term is positive. `origin` is the id of the
// claim whose proof divides by it.
[[nodiscard]] Hypothesis hypothesis(const kernel::Term& factor, const std::string& origin);

}  // namespace stickslip::proofs::methods
