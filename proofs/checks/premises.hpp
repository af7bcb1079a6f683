// What a claim rests on, sorted by what it is good for when the claim is evaluated.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::checks {

// What the claim assumes, and what the premises of the outcome's proof say that are no identities.
struct Premises {
  std::map<std::string, symbols::Term> motions;  // "Z(t) = ...": the value at t of Z, X, ...
  symbols::Replacements values;                  // "a_1 = ...", of a name that has no other meaning
  std::vector<symbols::Statement> equations, inequalities;  // in what has values, the motions put in
  std::vector<symbols::Statement> left_out;                 // what has none, such as "Z(tau) = Z_B"
  std::vector<methods::Hypothesis> hypotheses;
  bool consistent = true;  // no motion has two meanings

  // The statement with the motions put in.
  [[nodiscard]] symbols::Statement with_motions(const symbols::Statement& statement) const;
  // The names of the symbols with which the value of the term, all values put in, changes.
  [[nodiscard]] std::set<std::string> reached(const symbols::Term& term) const;
  // The premises with further values; nothing where a name has one already, or would be given by itself.
  [[nodiscard]] std::optional<Premises> with(const symbols::Replacements& further) const;
};

[[nodiscard]] Premises premises_of(methods::Prover& prover, const methods::Claim& claim,
                                   const methods::Outcome& outcome);

// Whether it is a scalar to which neither the table of symbols nor the model gives a value, nor is it pi.
[[nodiscard]] bool stands_for_itself(const symbols::Term& term);

// The scalars that equations are solved for: states, the constant coefficients d_i of (21), accelerations,
// belt speed and friction.
[[nodiscard]] const std::vector<std::string>& solved_for();

// Points where all that a claim rests on holds: on them what it prints must hold, and a wrong statement need
// not (premise_point.cpp).
class PremisePoint {
 public:
  // Whether the statement certainly holds here: an equation by two sides that overlap in small balls. Whether
  // it certainly fails. All three throw NoValue.
  [[nodiscard]] bool confirms(const symbols::Statement& statement) const;
  [[nodiscard]] bool contradicts(const symbols::Statement& statement) const;
  // Whether both sides have values here, as small balls.
  [[nodiscard]] bool evaluates(const symbols::Statement& statement) const;

 private:
  friend std::vector<PremisePoint> premise_points(const Premises& premises, std::size_t wanted);
  struct Point;
  explicit PremisePoint(std::shared_ptr<const Point> point) : point_(std::move(point)) {}
  std::shared_ptr<const Point> point_;
};

// Points, the same on every run, up to `wanted` of each kind: random parameters and times, and the rest such
// that the premises hold in balls. Their equations must be linear in what they are solved for; where they ask
// more of the load, its frequency or phase is what lets a motion close (28), (16), (67), one kind for each.
// No points where that does not solve them, a motion has two meanings, or a denominator vanishes; and none of
// the hypotheses may vanish there.
[[nodiscard]] std::vector<PremisePoint> premise_points(const Premises& premises, std::size_t wanted);

}  // namespace stickslip::proofs::checks
