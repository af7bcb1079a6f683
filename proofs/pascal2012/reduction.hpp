// What the claims about reduced equations share: the flows with the record of what they rest on, and the
// comparison of formulas of the model with each other.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/flows.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::pascal2012::reduction {

using tactics::Symbolic;
using Vector2 = model::Vector2<Symbolic>;
using Vector4 = model::Vector4<Symbolic>;

// The letter of a symbol, and pi.
[[nodiscard]] Symbolic symbol(const std::string& name);
[[nodiscard]] Symbolic half_turn();

[[nodiscard]] model::Modes<Symbolic> modes();
// Q and d_0 by their modes.
[[nodiscard]] Vector2 load();
[[nodiscard]] Vector2 rest();
// Theta = 2 pi/omega.
[[nodiscard]] Symbolic period();

// The flows (5), (8), (10); the ids of the claims behind those that were used.
struct Flows {
  methods::Derivation& derivation;
  std::set<std::string> used{"39.derived"};

  Vector4 slip(const Vector4& Z0, const Symbolic& psi0, const Symbolic& t);
  Vector4 overshoot(const Vector4& Z0, const Symbolic& psi0, const Symbolic& t);
  Vector4 stick(const Vector4& Z0, const Symbolic& t);
};

using Compare = std::vector<methods::Equal> (*)(Flows&);
// Two columns of the model's.
template <class Left, class Right>
[[nodiscard]] methods::Equal same(const Left& left, const Right& right) {
  return {tactics::as_term(left), tactics::as_term(right)};
}

// z = Lambda y, z' = Lambda y', and back.
[[nodiscard]] Vector4 from_modes(const Vector2& y, const Vector2& ydot);
[[nodiscard]] Vector2 to_modes(const Vector2& z);

// lambda_2 - lambda_1 with the sign that it has in row j of the reduced equations.
[[nodiscard]] Vector2 row_scale();
// omega_j, and omega_j duration/2.
[[nodiscard]] Vector2 frequencies();
[[nodiscard]] Vector2 half_angles(const Symbolic& duration);

// That every pair that `compare` builds from the model's own formulas is equal.
[[nodiscard]] methods::Proof reduced(Compare compare);

// Of the claims about Sections 4, 5 and 6.
[[nodiscard]] Proofs of_symmetric();
[[nodiscard]] Proofs of_overshooting();
[[nodiscard]] Proofs of_nonsticking();

}  // namespace stickslip::proofs::pascal2012::reduction
