// Points where all that a claim rests on holds: on them what it prints must hold, and a wrong statement need
// not.
#pragma once

#include <memory>
#include <vector>

#include "proofs/prover.hpp"
#include "proofs/sample.hpp"

namespace stickslip::proofs {

class PremisePoint {
 public:
  // Whether the statement certainly holds here: an equation by two sides that overlap in small balls. Whether
  // it certainly fails. All three throw NoValue.
  [[nodiscard]] bool confirms(const Statement& statement) const;
  [[nodiscard]] bool contradicts(const Statement& statement) const;
  // Whether both sides have values here, as small balls.
  [[nodiscard]] bool evaluates(const Statement& statement) const;

 private:
  friend class Premises;
  struct Point;
  explicit PremisePoint(std::shared_ptr<const Point> point) : point_(std::move(point)) {}
  std::shared_ptr<const Point> point_;
};

// What the outcome's proof took for granted: what the claim assumes, and what the premises say that are no
// identities. A premise "Z(t) = ..." gives Z its meaning, one such as "a_1 = ..." a value to the name.
class Premises {
 public:
  Premises(Prover& prover, const Claim& claim, const Outcome& outcome);

  // Points, the same on every run, up to `wanted` of each kind: random parameters and times, and states, belt
  // speed and friction such that the premises hold in balls. Their equations must be linear in these; where
  // they ask more of the load, its frequency or phase is what lets a motion close (28), (16), (67), one kind
  // for each. No points where that does not solve them, a premise gives the same motion two meanings, or a
  // denominator vanishes; and none of the hypotheses may vanish there.
  [[nodiscard]] std::vector<PremisePoint> points(std::size_t wanted) const;

  // Whether a point satisfies all of them: none had to be left out because it has no value by itself, such as
  // "Z(tau) = Z_B".
  [[nodiscard]] bool all_evaluated() const;

  struct Parts;

 private:
  std::shared_ptr<const Parts> parts_;
};

}  // namespace stickslip::proofs
