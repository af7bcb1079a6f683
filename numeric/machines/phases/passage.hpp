// One phase of a machine in balls, from w where it begins: for all members, also of wide balls.
#pragma once

#include <algorithm>

#include "core/error.hpp"
#include "numeric/machines/machine.hpp"
#include "numeric/machines/phases/linear_phases.hpp"

namespace stickslip::numeric::machines {

struct Passage {
  Vector reached, arrives;  // w and w' after h
  // Of (x, x') after h, by (x, x') where it begins, and by the time at which it does so; empty, as what
  // follows, unless asked for.
  Matrix derivative;
  Vector by_time, leaves;  // w' when it begins
  Matrix flow;             // of w by w; none on a smooth law
};
// Not finite where the motion could not be enclosed.
[[nodiscard]] Passage passage(const LinearPhases& phases, Piece piece, const Vector& w, const Ball& h,
                              bool with_derivative);

// Of all machines over data; likewise, what is not asked for is empty.
struct PassageInData {
  InData<Matrix> reached, leaves, arrives, derivative, by_time;
};
[[nodiscard]] PassageInData passage(const LinearPhases& phases, Piece piece, const InData<Matrix>& w,
                                    const InData<Ball>& h, bool with_derivative);

// Whether an event may lie between the two: the belt's velocity, or that at which pieces of the law meet.
[[nodiscard]] bool may_follow(const Piece& before, const Piece& after);
// x_j' where `before` ends and `after` begins: the belt's velocity, or that at which the law's pieces meet.
// Throws InternalError when no event lies between the two.
template <class S>
[[nodiscard]] S speed_between(const model::FrictionOscillator<S>& o, const Piece& before,
                              const Piece& after) {
  if (!may_follow(before, after)) {
    throw InternalError("two phases after each other that no event separates");
  }
  if (before.kind != after.kind) {
    return o.V;
  }
  const auto upper = static_cast<std::size_t>(std::max(before.number, after.number));
  const S& from = o.law(after.side()).sliding.at(upper).from;
  return after.side() > 0 ? S(o.V - from) : S(o.V + from);
}
// The row that times w is zero where `piece` ends and `after` begins.
[[nodiscard]] Vector event_between(const LinearPhases& phases, const Piece& piece, const Piece& after,
                                   const Ball& speed);

// How the time t of a point of a motion and (x, x') there depend on some parameters.
struct Spread {
  Vector time;
  Matrix state;
};
// Of (x, x') after the passage, the same duration for all.
[[nodiscard]] Matrix after_duration(const Passage& passage, const Spread& from);
// At the event, the zero of that row, after the passage. Not finite when the row may not change there.
[[nodiscard]] Spread at_event(const Passage& passage, const Vector& event, const Spread& from);

[[nodiscard]] Ball dot(const Vector& a, const Vector& b);

}  // namespace stickslip::numeric::machines
