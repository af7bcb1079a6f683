// Points where all that a claim rests on holds: on them what it prints must hold, and a wrong statement need
// not.
#pragma once

#include <memory>
#include <vector>

#include "proofs/checks/premises.hpp"

namespace stickslip::proofs::checks {

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
