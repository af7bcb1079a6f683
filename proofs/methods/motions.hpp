// Methods of proof for what is said of motions, functions of time: at a time of an interval, at all times or
// at all but finitely many.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/methods/methods.hpp"

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
[[nodiscard]] Proof by_chain_rule(std::vector<Premise> premises,
                                  const std::optional<symbols::Term>& later = {});

// `rate` says "d/dt E = r" of almost all times of [a, b], a <= b. Where r is not zero by its signs sign(a_i),
// r is at most minus the weight times the sum of |a_i|. The printed inequality is E(b) <= E(a).
[[nodiscard]] Proof by_decrease(Premise rate, symbols::Term weight);

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

}  // namespace stickslip::proofs::methods
