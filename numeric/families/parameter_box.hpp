// The orbits of the three families for whole boxes of parameters: existence and every condition for all
// members at once, or undecided and where to split.
#pragma once

#include <string>
#include <vector>

#include "numeric/motion/conditions.hpp"
#include "numeric/zeros/parametric.hpp"

namespace stickslip::numeric::families {

// An orbit for each member of a box of parameters.
struct BoxOrbit {
  Verdict existence;  // exactly one orbit near the guess, for each member
  std::string split;  // the parameter to split first when something is undecided: "chi", …, "phi", "ur"
  std::vector<Ball> zero;  // contains the unknowns for all members, in the order of the guess
  motion::Motion motion;   // each ball contains the value for all members; meaningless unless proved
  std::vector<model::PhaseWaves<Ball>> waves;  // likewise, of each phase
  Ball ur;  // symmetric, overshooting: from (12); non-sticking: the largest admissible, min(r(0), -r(tau))
  std::vector<motion::Condition> conditions;  // empty unless proved
};

// guess: (tau, C), C the amplitude of z1 about chi z2 during the stick; sigma = 1 is the paper's load phase
// (pi - omega tau)/2, -1 that plus pi.
[[nodiscard]] BoxOrbit prove_symmetric_over(const model::Parameters<Ball>& a, int sigma,
                                            const std::vector<double>& guess);

// guess: (tau, tau1, z10, z20, z10') at the load phase phi, which may be a ball too.
[[nodiscard]] BoxOrbit prove_overshooting_over(const model::Parameters<Ball>& a, const Ball& phi,
                                               const std::vector<double>& guess);

// The same at a given u_r; guess: (tau, tau1, z10, z20, z10', phi).
[[nodiscard]] BoxOrbit prove_overshooting_at_friction_over(const model::Parameters<Ball>& a, const Ball& ur,
                                                           const std::vector<double>& guess);

// guess: (delta, mu) of model/nonsticking.hpp. Without ur, (25) and (26) read ur_max > us.
[[nodiscard]] BoxOrbit prove_nonsticking_over(const model::Parameters<Ball>& a, const std::optional<Ball>& ur,
                                              const std::vector<double>& guess);

}  // namespace stickslip::numeric::families
