// That an orbit exists, as a theorem of the kernel: motions of (2) and (9), one for each phase, that fit
// together, return after the period, and obey the friction law (4) at all times.
#pragma once

#include "numeric/motion/requirements.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/orbits/phases.hpp"

namespace stickslip::proofs::orbits {

// ⊢ there are durations, phi and ur as far as they are no data, and motions X1, X2, … such that
//   - the durations are positive, lie within 1e-9 of what is found, and add up to the period; phi, ur and the
//     states in which phases that slip begin, except x2', which is V, lie within 1e-9 of what is found;
//     0 < us < ur;
//   - each phase: its motion is continuous, obeys its equation inside, and stays on its side of the belt's
//     velocity, or sticks with |r| < ur until it ends (definitions slips, overshoots, sticks);
//   - each motion begins where the one before ends, the first where the last does, with x2' = V;
//   - at each end of a phase the friction at rest is what (4) asks for: a stick ends at r = ur where a slip
//     follows, at r = -ur where an overshoot does; r < -ur where a slip becomes an overshoot, ur < r where
//     an overshoot becomes a slip.
// No hypotheses. `nearly` is a motion near it, from which everything is found. Throws KernelError, with the
// reason, where one of these does not hold or is not decided.
[[nodiscard]] kernel::Theorem orbit_theorem(const Question& question, const numeric::motion::Motion& nearly);

// ⊢ exactly one zero of the equations by which the phases fit together (phases.hpp: the unknowns in their
// order) lies in the box of half-width 2^-34 about what is found. The phases are motions in closed form, and
// these are determined by the unknowns: the orbit is locally unique. Throws KernelError as before.
[[nodiscard]] kernel::Theorem locally_unique(const Question& question, const numeric::motion::Motion& nearly);

// The unknowns of phases.hpp as terms in parameters and in letters for exact numbers, omega among them, that
// solve the equations where the parameters lie in their ranges and one equation between all these holds.
struct ClosedForm {
  kernel::Substitution values, numbers;
  kernel::Ranges parameters;
  kernel::Formula between;  // a = b of numbers
};
// Parameters' ranges, the equation between them ⊢ there are …, as in the orbit theorem, except the decimals,
// and of them these equations hold, too. Throws KernelError as before, and where the values solve none of it.
[[nodiscard]] kernel::Theorem orbit_theorem(const Question& question, const ClosedForm& known,
                                            const std::vector<kernel::Formula>& also);

// ⊢ there are such numbers and one motion X, X(t + Theta) = X(t) for all t, of which all is true that the
// orbit theorem says of its motions: X obeys (2) and (4) at all times. Throws KernelError where it is of
// another form.
[[nodiscard]] kernel::Theorem one_motion(const kernel::Theorem& orbit, const Question& question);

// ⊢ there is an orbit as before, and a value of it lies between the ends or, as `outside` says, does not. The
// value is named as on the command line: tau, T, Theta, phi, ur, x10, z10, …; ur_max is the friction at rest
// where the first phase, which slips, begins. Throws KernelError where what
// the orbit theorem says of it does not decide that, or it says nothing.
[[nodiscard]] kernel::Theorem value_theorem(const kernel::Theorem& orbit, const Question& question,
                                            const std::string& name, const Rational& lower,
                                            const Rational& upper, bool outside);

// ⊢ there is an orbit as before, and this condition holds of it, in its own words: strictly, and along a
// phase at all times between its ends. z = x - d as in (5). Throws KernelError where it does not follow.
[[nodiscard]] kernel::Theorem condition_theorem(const kernel::Theorem& orbit, const Question& question,
                                                const numeric::motion::Requirement& requirement);

// ⊢ there is an orbit as before, and there are solutions Yk of the equations of variation along its phases
// and their product M with the saltation matrices of its events (definitions.hpp), in their order over one
// period, such that each complex zero of M's characteristic polynomial lies inside the unit circle; or, where
// not, such that it has a real zero mu > 1. Throws KernelError where neither is decided.
[[nodiscard]] kernel::Theorem stability_theorem(const kernel::Theorem& orbit, const Question& question);

}  // namespace stickslip::proofs::orbits
