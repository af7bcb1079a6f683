// Points where all that a claim rests on holds: on them what it prints must hold, and a wrong statement need
// not.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "proofs/prover.hpp"
#include "proofs/sample.hpp"

namespace stickslip::proofs {

// Random parameters and times, and states, belt speed and friction such that the equations hold which the
// claim assumes or uses as premises, in balls. All of these are linear in the states; a premise "Z(t) = …"
// gives Z its meaning, one such as "a_1 = …" a value to the name.
class PremisePoint {
 public:
  // The point with this number. Nothing where the equations are not linear in the unknowns, a premise gives
  // the same motion two meanings, a denominator vanishes, an inequality that is assumed fails, or what the
  // claim prints does not come out there: then the premises cannot all be evaluated.
  [[nodiscard]] static std::optional<PremisePoint> find(Prover& prover, const Record& record, unsigned seed);

  // Whether the statement certainly fails here. Throws InternalError for what has no value.
  [[nodiscard]] bool contradicts(const Statement& statement) const;
  // Whether both sides have values here, as small balls.
  [[nodiscard]] bool evaluates(const Statement& statement) const;

 private:
  struct Point;
  explicit PremisePoint(std::shared_ptr<Point> point) : point_(std::move(point)) {}
  std::shared_ptr<Point> point_;
};

}  // namespace stickslip::proofs
