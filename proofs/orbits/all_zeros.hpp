// All zeros of a function of one number between two ends, each enclosed, as theorems.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "proofs/kernel/theorem.hpp"
#include "proofs/orbits/along.hpp"

namespace stickslip::proofs::orbits {

// A definition, of whose last parameter it is a function, its derivative by that parameter, and ⊢ that it is:
// from what it divides by.
struct Differentiable {
  kernel::Definition value, slope;
  kernel::Theorem rate;
};
// The slope has the value's name and "_slope".
[[nodiscard]] Differentiable differentiable(const kernel::Definition& value);

struct EnclosedZero {
  kernel::Variable x;
  kernel::Interval bounds;
  kernel::Formula says;    // l < x, x < u, f(x) = 0
  kernel::Theorem exists;  // ranges ⊢ there is x: that
};
// The theorem with what is said of the zero in place of its bounds l <= x, x <= u.
[[nodiscard]] kernel::Theorem within_bounds(const EnclosedZero& zero, kernel::Theorem theorem);
// ⊢ there are these zeros, in their order: what the theorem says, from what is said of each.
[[nodiscard]] kernel::Theorem there_are(const std::vector<EnclosedZero>& zeros, kernel::Theorem theorem);

struct AllZeros {
  std::vector<EnclosedZero> zeros;  // as they were given
  // ranges, what is said of each zero, from <= t, t <= to, f(t) = 0 ⊢ t = x1 or t = x2 or ….
  kernel::Theorem only;
};
// Of f with these values of its other parameters, of which the ranges say where they are: between two ends,
// ends included, it has one zero within 1e-9 of each number given, and no other. The zeros are named
// t_1, t_2, …. Signs in balls show that, of f away from the numbers, and of its slope near them. Throws
// KernelError where they do not, and where no number is given.
[[nodiscard]] AllZeros all_zeros(const Differentiable& f, const std::vector<kernel::Term>& others,
                                 const kernel::Variable& t, const kernel::Interval& ends,
                                 const Ranges& ranges, const std::vector<Rational>& nearly);

// Unknowns that are known only as a zero of a system.

// ⊢ exactly one column of unknowns in the box lets the terms vanish, in which the variables of `at_value`
// have their values. Throws KernelError where Krawczyk's test does not prove it.
[[nodiscard]] kernel::Theorem exactly_one_zero(const std::vector<kernel::Variable>& unknowns,
                                               const std::vector<kernel::Term>& terms, const kernel::Box& box,
                                               const kernel::Substitution& at_value = {});

// The theorem less its hypotheses on the unknowns, which are their ranges l <= x, x <= u and that the terms
// vanish, equal(term, 0): by Krawczyk's test there are such unknowns. Its conclusion names none of them. In
// the system and in the theorem the variables of `at_value` get their values; hypotheses without variables
// go, where they hold. Throws KernelError where one of this is not so.
[[nodiscard]] kernel::Theorem with_zero(const kernel::Theorem& theorem,
                                        const std::vector<kernel::Variable>& unknowns,
                                        const std::vector<kernel::Term>& terms, const kernel::Box& box,
                                        const kernel::Substitution& at_value = {});

// What else is true of an orbit that a theorem says to exist.

// From ⊢ there are …: B, and B ⊢ C by `more`: ⊢ there are those of them that C speaks of: C.
[[nodiscard]] kernel::Theorem of_orbit(const kernel::Theorem& orbit,
                                       const std::function<kernel::Theorem(const kernel::Theorem&)>& more);

// From ⊢ there are …: B, and B ⊢ C by `more`: ⊢ there are …: B and C.
[[nodiscard]] kernel::Theorem orbit_with(const kernel::Theorem& orbit,
                                         const std::function<kernel::Theorem(const kernel::Theorem&)>& more);

}  // namespace stickslip::proofs::orbits
