// What the paper's symbols mean: terms evaluated with the formulas of model/.
#pragma once

#include <functional>
#include <string>

#include "core/ball.hpp"
#include "core/error.hpp"
#include "model/linear.hpp"
#include "numeric/scalars/exact.hpp"
#include "numeric/scalars/scalars.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::symbols {

template <class S>
using Value = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

// The value of a scalar symbol: chi, eta, omega1, lambda1, q1, d01, t, z10, pi, …
template <class S>
using Lookup = std::function<S(const std::string&)>;

// The value of a term; 1×1 for a scalar. H, Gamma, F, … are those of model/; d/dt is exact. Throws NoValue.
// For Ball and Exact.
template <class S>
[[nodiscard]] Value<S> evaluate(const Term& term, const Lookup<S>& scalar);
extern template Value<Ball> evaluate(const Term&, const Lookup<Ball>&);
extern template Value<numeric::scalars::Exact> evaluate(const Term&, const Lookup<numeric::scalars::Exact>&);

// The values of both sides of a statement: a plain 0 takes the shape of the other side.
template <class S>
struct Sides {
  Value<S> left, right;
};
template <class S>
[[nodiscard]] Sides<S> both_sides(const Statement& statement, const Lookup<S>& scalar) {
  const auto value = [&](const Term& side, const Term& other) {
    return side.is_zero() ? Value<S>(Value<S>::Constant(other.shape().rows, other.shape().columns, S(0)))
                          : evaluate<S>(side, scalar);
  };
  return {value(statement.left, statement.right), value(statement.right, statement.left)};
}

// Whether it is an element of the field in which identities are decided: every name has a meaning in the
// model, and there is no absolute value.
[[nodiscard]] bool is_in_field(const Term& term);

}  // namespace stickslip::proofs::symbols
