// All orbits of one family at given parameters, with everything that is decided about them, in one form for
// the three families.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/decimal.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::numeric {

// What is asked for: one set of parameters, or a whole box of them when some radius is not zero.
struct OrbitQuestion {
  motion::Family family = motion::Family::symmetric;
  model::Parameters<Range> parameters;
  std::optional<Range> phi;  // overshooting: exactly one of phi and ur
  std::optional<Range> ur;   // non-sticking: optional
  int digits = 20;           // significant ones, of every value of an orbit
};

[[nodiscard]] bool asks_for_box(const OrbitQuestion& question);

// A number under the paper's symbol in ASCII: tau, tau1, T, Theta, phi, z10, z20, zdot10, x10, x20, xdot10,
// ur, ur_max.
struct NamedBall {
  std::string name;
  Ball value;
};

struct DecidedOrbit {
  std::vector<NamedBall> values;  // those that the family has, in the order above
  motion::Motion motion;
  std::vector<motion::Condition> conditions;
  Verdict admissible;                          // of "all conditions hold"
  std::optional<motion::Stability> stability;  // of an admissible orbit
  std::string split;  // for a box, when something is undecided: the parameter to split first
};

// A part of the search's domain that it could not decide.
struct UnresolvedPart {
  std::vector<NamedBall> where;
  std::string reason;
};

// What else there is to know about a list.
enum class Remark {
  load_absent,           // p = 0: the load's phase means nothing
  closes_without_stick,  // omega_j = k omega, k > 1: at T = 0 a motion closes that never sticks; not listed
  interrupted,           // the search was told to stop: the list is what it had found
  searched_at_middle,    // a box: other orbits were searched for at the middle of the parameters only
};

struct OrbitList {
  OrbitQuestion question;
  std::vector<DecidedOrbit> orbits;
  std::vector<UnresolvedPart> unresolved;
  std::vector<Remark> remarks;

  // No orbit of the family is missing; never so for a box.
  [[nodiscard]] bool complete() const { return unresolved.empty() && !asks_for_box(question); }
};

// Nothing is unresolved, and each condition of each orbit is proved or refuted.
[[nodiscard]] bool all_decided(const OrbitList& list);

// The complete list, or what is missing from it. A condition that the asked digits leave undecided is looked
// at again with more. For a box of parameters: the orbits at its middle, each proved, with its conditions,
// for all members of the box, or unresolved. Throws DomainError when the data are outside the domain of the
// family, among them ur <= us, and UsageError for a phi or ur that the family does not take.
[[nodiscard]] OrbitList list_orbits(const OrbitQuestion& question);

}  // namespace stickslip::numeric
