// The motion of a machine without a varying load on which nothing moves but the belt: the mass on it slides
// steadily, all others are at rest.
//
// With side the sign of V and f the friction at the relative velocity |V|, K x = F + side f e_j; it is a
// solution where K is invertible and V is not 0. Inside a piece of the friction law, of slope d, deviations
// obey M x'' + (C + d e_j e_jᵀ) x' + K x = 0: the solution is asymptotically stable where all of their
// eigenvalues have negative real parts, and unstable where one has a positive one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/machines/machine.hpp"
#include "numeric/machines/phases/linear_phases.hpp"
#include "numeric/motion/eigenvalues.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::numeric::machines {

struct SteadySliding {
  Verdict existence;  // of "there is exactly one"; what follows needs it proved
  Piece piece;        // of the friction law
  Vector x;           // the positions, lengths
  Ball friction;      // a force
  motion::StabilityKind stability = motion::StabilityKind::undecided;
  std::string reason;                            // why it is undecided
  std::vector<motion::ComplexBall> eigenvalues;  // per time, by falling real part; empty if not enclosed
};

// Refuted where the loads on a mass vary together, and for V = 0, where the mass rests on the belt; undecided
// where K may be singular. The stability is undecided where |V| is an end of a piece. Throws as
// require_machine does.
[[nodiscard]] SteadySliding steady_sliding(const Machine& machine, int digits = 20);

// Steady sliding over an interval of one datum: proved at some values, and between those at which it differs
// at more, until these are close. What is between two values at which it is the same is not looked at.
struct SteadyAlong {
  struct Sample {
    Rational value;
    SteadySliding state;
  };
  struct Change {
    Rational first, last;  // of the datum: the stability is not the same at both
    bool is_lost = false;
    // Two pieces of the friction law meet there. Else eigenvalues cross the imaginary axis, and not at 0, for
    // K is invertible: a Hopf bifurcation of the piece's own equation.
    bool is_corner = false;
    std::optional<Ball> frequency;  // of the pair, per time, at the one of both values that is unstable
  };
  std::vector<Sample> samples;  // by rising values
  std::vector<Change> changes;
};
// The machine at a value of the datum, between from < to. Throws as steady_sliding does, and UsageError.
[[nodiscard]] SteadyAlong steady_sliding_along(const std::function<Machine(const Rational&)>& at,
                                               const Rational& from, const Rational& to, int digits = 20);

}  // namespace stickslip::numeric::machines
