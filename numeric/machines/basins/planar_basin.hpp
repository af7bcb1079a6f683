// What ends in steady sliding: one mass on a belt, no load, friction that falls smoothly with the velocity.
//
// With y = x' < V and h(y) = c y - f(V - y) + f(V) the slip about steady sliding, x = f(V)/k, is
//   m y'' + h'(y) y' + k y = 0,
// with the divergence -h'(y)/m. Where h'(0) = c + f'(V) > 0, steady sliding attracts.
//
// 1. There is at most one closed motion K of the slip. This is Zhang Zhifen's theorem (Perko, Differential
// Equations and Dynamical Systems, section 3.8): q = -h'/m and g = k y/m, with q(0) < 0 and q/g rising on
// y < 0 and on 0 < y < V, for q'' = -f'''(V - y)/m >= 0 and so (q/g)' ~ q' y - q >= -q(0) > 0. Its proof in
// short, with z = kx/m moved so that a motion is y' = -z - h/m, z' = g, and log of a closed motion's
// multiplier I = ∮ q dt = ∮ (q - a g) dt for any a, as ∮ g dt = 0:
// - Let L1 be closed, y from alpha to beta. If (q/g)(beta) <= (q/g)(alpha), an a between makes q - a g
//   <= 0 along L1, and I(L1) < 0. Else take an a between: q - a g is < 0 on some (alpha', beta') around
//   0 inside (alpha, beta), and > 0 outside. Let L2 be closed around L1. Over alpha' < y < beta' it is
//   faster, |y'| is larger at the same y; beyond, at the same z, it is farther out, where |(q - a g)/g|
//   is larger: dt = dy/y' there, dz/g here. So I(L2) > I(L1) if I(L1) >= 0.
// - The innermost closed motion repels what is inside it, so I >= 0 there and I > 0 for all others: these
//   repel on both sides, and no two neighbours can. Only I = 0 for the innermost, which then attracts from
//   outside, is left; with slightly less damping (q + epsilon still has all that was used) it splits into one
//   that repels and, around it, one that does not, against the same.
// 2. Inside K motions end in steady sliding (Poincaré and Bendixson: nothing else is there, and steady
// sliding attracts); none enters from K or outside, for K is a closed motion of a flow that is unique both
// ways, below the belt.
//
// 3. K exists if and only if the slip that begins at T, y = V and y' = 0, is faster than the belt later on
// (the law being continued to relative velocities below 0). If so, that motion from T to where it first
// meets the belt again, left of T, and the belt between enclose a region that nothing enters: backwards in
// time K is in it. If not, there is a turn of it below the belt and closer to steady sliding, or it comes so
// near to that that its energy falls for ever, and it cannot reach the belt, as it would have to outside of a
// K that repels. Where friction does not drop at the end of
// a stick, sticks end at T: with K the stick-slip cycle is lost, too.
//
// 4. Outside K, with A and B the friction at rest on both sides and r = k x + c V on the belt: a slip that
// begins on the belt where r >= A, at x, comes back at rho(x), which falls with x, for motions do not cross.
// It sticks there if r >= -B; then the stick ends where r = A, and all that sticks goes on alike, on one
// cycle. Else it overshoots; the energy k x²/2 + m y²/2 falls at least by g per length, g <= the friction, so
// that it comes to the belt at some x <= -rho - 2 g/k. So, if one motion sticks after some
// turns, each begun no nearer than the bounds say, all that begin nearer do. And all that is below the belt
// within its first turn, but outside K, comes to the belt: no other closed motion is there.
#pragma once

#include <functional>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/machines/machine.hpp"

namespace stickslip::numeric::machines {

// Positions x_from to x_to, velocities y_from to y_to.
struct Rectangle {
  Rational x_from, x_to, y_from, y_to;
};

struct PlanarBasin {
  // Of "steady sliding is stable, and what ends in it starts inside one closed motion K below the belt". What
  // follows needs it proved.
  Verdict verdict;
  Ball x;           // of K farthest behind, where its velocity is 0
  Ball period;      // a time
  Ball multiplier;  // of K, > 1
  Ball area;        // inside K
  Ball share;       // of the rectangle that is inside K
  Verdict others;   // of "what starts in the rectangle outside K ends on one cycle that sticks"
};

// Refuted where steady sliding is unstable, where the belt stands still, or where there is no such motion;
// undecided where bits do not suffice. Throws as require_machine does, and DomainError for several masses,
// loads, a mass without a spring, a law that is not smooth or does not fall, and an empty rectangle.
[[nodiscard]] PlanarBasin planar_basin(const Machine& machine, const Rectangle& starts, int digits = 20);

// The same at 65 values of one datum, and where the range with such a basin ends: between two values, proved
// at both. What is between two values at which it is the same is not looked at.
struct PlanarBasinAlong {
  struct Sample {
    Rational value;
    PlanarBasin basin;
  };
  struct End {
    Rational first, last;    // one of both has such a basin
    bool is_gained = false;  // the last
    bool at_belt = false;    // K meets the belt; else steady sliding loses its stability, and K shrinks to it
  };
  std::vector<Sample> samples;  // by rising values
  std::vector<End> ends;
};
[[nodiscard]] PlanarBasinAlong planar_basin_along(const std::function<Machine(const Rational&)>& at,
                                                  const Rational& from, const Rational& to,
                                                  const Rectangle& starts, int digits = 20);

}  // namespace stickslip::numeric::machines
