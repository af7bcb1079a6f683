// All symmetric orbits at given parameters: tau over the whole closed domain [0, Theta], both load phases.
#pragma once

#include <string>
#include <vector>

#include "numeric/families/symmetric.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

// A range of tau in which the search could not decide.
struct UnresolvedTau {
  LoadPhase phase = LoadPhase::first;
  Ball tau;
  std::string reason;
};

struct SymmetricList {
  // Sorted by load phase and tau. In each the existence is proved, and no other orbit of its phase has tau in
  // tau_unique, whatever its C.
  std::vector<SymmetricOrbit> orbits;
  std::vector<UnresolvedTau> unresolved;
  // p = 0: the load's phase means nothing, both phases have the same orbits, and only the first is listed.
  bool load_absent = false;
  // A natural frequency is a multiple k omega, k > 1: at T = 0 (13) and (15) hold for a motion that slips all
  // the time. It has no stick phase and is not in the list; for T > 0 the list is what it says.
  bool closes_without_stick = false;
  long cells = 0;  // examined by the search

  // No orbit with 0 <= tau <= Theta and either load phase is missing from the list.
  [[nodiscard]] bool complete() const { return unresolved.empty(); }
};

// The complete list, each orbit enclosed to `digits` digits. Where the search meets something that it cannot
// decide (a multiple zero, an orbit whose stick or slip may last no time at all, a tau at which the amplitude
// C cannot be eliminated) the range of tau is in `unresolved` with the reason.
// Throws DomainError outside the domain of require_stick_slip_domain.
[[nodiscard]] SymmetricList list_symmetric(const motion::ExactParameters& a, int digits);

}  // namespace stickslip::numeric::families
