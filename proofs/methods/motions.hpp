// Methods of proof for what is said of motions, functions of time: at a time of an interval, at all times or
// at all but finitely many.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "numeric/orbits.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::methods {

// A motion in closed form. The claim assumes, under the id `phase`, "d/dt X(t) = A X(t) + f(t) during [a,
// b]", and under `initial`, y(a) = y_a, for a function y of X; and prints y(t) = flow(t - a) (y_a -
// forced(a)) + forced(t), which follows as flow(a - t) (y(t) - forced(t)) does not change. Without `initial`,
// y_a is y(a).
struct ClosedForm {
  std::string phase, initial;
  symbols::Term flow, forced;  // at t
};
[[nodiscard]] Proof by_differential_equation(ClosedForm solution);

// Mean value theorem. The claim assumes, under these ids, the differential equation of X during [a, b], what
// bounds the derivative of row * X there by a constant, the states y(a) and y(b) at both ends, y = X + a
// constant, and b - a > 0. The printed inequality bounds row * (y(b) - y(a)).
struct MeanValue {
  std::string phase, slope, begins, ends, lasts;
  symbols::Term row = 1;
};
[[nodiscard]] Proof by_mean_value(MeanValue step);

// The printed statement "d/dt f = g" (or another one) of almost all times of an interval, by the chain
// rule from premises that say such things of the motions in it: in each case that the premises' signs leave.
// With `later`, the premises are used at t + later.
[[nodiscard]] Proof by_chain_rule(const std::vector<Premise>& premises,
                                  const std::optional<symbols::Term>& later = {});

// `rate` says "d/dt E = r" of almost all times of [a, b], a <= b. Where r is not zero by its signs sign(a_i),
// r is at most minus the weight times the sum of |a_i|. The printed inequality is E(b) <= E(a).
[[nodiscard]] Proof by_decrease(const Premise& rate, const symbols::Term& weight);

// The same, and what is assumed under the ids `returns`, as "X(b) = X(a)", says that E is at b what it is at
// a. So E does not change, r = 0, and the printed statement, of almost
// all times of [a, b], holds in the cases that this leaves.
struct PeriodicDecrease {
  Premise rate;
  std::vector<std::string> returns;
  symbols::Term weight = 1;
};
[[nodiscard]] Proof by_periodic_decrease(PeriodicDecrease step);

// left * (a premise of functions) * right, each function replaced by one that the value gives at the time t.
// What the premise then supposes is assumed, on that interval or a longer one, is said by the claims
// `supplied`, or is a sum of assumed equations.
struct Instance {
  Premise premise;
  std::map<std::string, symbols::Term> functions = {};
  std::vector<Premise> supplied = {};
  symbols::Term left = 1;
};
// The printed equation is the sum of these instances.
[[nodiscard]] Proof by_instances(std::vector<Instance> instances);

// The orbits that a paper's examples speak of, proved.

// What `orbits` is asked for the data of the example.
[[nodiscard]] numeric::OrbitQuestion question_of(const Example& example, int digits = 20);

// An example and the complete list of orbits at its data.
struct ExampleOrbits {
  Example example;
  numeric::OrbitList list;
};

// The list at the example's data to 30 digits; made once, when it is first asked for.
[[nodiscard]] const ExampleOrbits& orbits_of(const Example& example);

// The orbit whose values are nearest to the printed ones, the largest relative difference deciding: the one
// that the figure shows. None when the list is empty.
[[nodiscard]] std::optional<std::size_t> printed_orbit(const ExampleOrbits& orbits);

// That orbit of orbits_of(example). Throws InternalError when there is none.
[[nodiscard]] const numeric::Orbit& printed_orbit(const Example& example);

}  // namespace stickslip::proofs::methods
