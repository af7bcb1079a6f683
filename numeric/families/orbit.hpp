// Periodic orbits of the paper's families, as they are asked for and found.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/decimal.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::numeric::machines {
struct Neighbourhood;
}

namespace stickslip::numeric::families {

// A family of orbits (family.hpp).
struct Family;

// What is asked for: one set of parameters, or a whole box of them when some radius is not zero.
struct OrbitQuestion {
  const Family * family = nullptr;
  model::Parameters<Range> parameters;
  std::optional<Range> phi;    // overshooting: exactly one of phi and ur
  std::optional<Range> ur;     // non-sticking: optional
  int digits = 20;             // significant ones, of every value of an orbit
  bool neighbourhood = false;  // of each stable orbit, too
};

[[nodiscard]] bool asks_for_box(const OrbitQuestion& question);

// A number under the paper's symbol in ASCII: tau, tau1, T, Theta, phi, z10, z20, zdot10, x10, x20, xdot10,
// ur, ur_max.
struct NamedBall {
  std::string name;
  Ball value;
};

// An orbit that is proved to exist, for all members of the parameters, with everything decided about it.
struct Orbit {
  std::vector<NamedBall> values;  // those that the family has, in the order above
  motion::Motion motion;
  std::vector<motion::Condition> conditions;
  Verdict admissible;                          // of "all conditions hold"
  std::optional<motion::Stability> stability;  // of an admissible orbit
  std::string split;  // for a box, when something is undecided: the parameter to split first
  // Of starts that converge to it, where that was asked for, or why there is none
  // (machines/neighbourhood.hpp).
  std::shared_ptr<const machines::Neighbourhood> neighbourhood = nullptr;

  // One of the values. Each throws InternalError when the orbit has none of that name.
  [[nodiscard]] const Ball& tau() const { return value("tau"); }
  [[nodiscard]] const Ball& tau1() const { return value("tau1"); }
  [[nodiscard]] const Ball& T() const { return value("T"); }
  [[nodiscard]] const Ball& Theta() const { return value("Theta"); }
  [[nodiscard]] const Ball& phi() const { return value("phi"); }
  [[nodiscard]] const Ball& z10() const { return value("z10"); }
  [[nodiscard]] const Ball& z20() const { return value("z20"); }
  [[nodiscard]] const Ball& zdot10() const { return value("zdot10"); }
  [[nodiscard]] const Ball& x10() const { return value("x10"); }
  [[nodiscard]] const Ball& x20() const { return value("x20"); }
  [[nodiscard]] const Ball& xdot10() const { return value("xdot10"); }
  [[nodiscard]] const Ball& ur() const { return value("ur"); }
  [[nodiscard]] const Ball& ur_max() const { return value("ur_max"); }
  // By a name that is data, as that of a printed result.
  [[nodiscard]] const Ball& value(const std::string& name) const;
};

// Each of its conditions is proved; and it is stable; each is proved or refuted.
[[nodiscard]] bool is_admissible(const Orbit& orbit);
[[nodiscard]] bool is_stable(const Orbit& orbit);
[[nodiscard]] bool all_decided(const Orbit& orbit);

// A part of the search's domain that it could not decide.
struct Unresolved {
  std::vector<NamedBall> where;
  std::string reason;
};

// What else there is to know about a list.
enum class Remark {
  load_absent,           // p = 0: the load's phase means nothing
  closes_without_stick,  // omega_j = k omega, k > 1: at T = 0 a motion closes that never sticks; not listed
  interrupted,           // the search was asked to stop: the list is what it had found
  nothing_drives,        // V = 0, the load does not act on x2: friction ends every motion; none is listed
  odd_resonance,       // V = 0, omega_j = k omega, k odd: no motion that never sticks closes; none is listed
  searched_at_middle,  // a box: other orbits were searched for at the middle of the parameters only
};

// The table: symmetric, overshooting, nonsticking.
[[nodiscard]] const std::vector<const Family *>& all_families();

// The family of that name. Throws UsageError naming those that there are.
[[nodiscard]] const Family& family_named(const std::string& name);
// "symmetric, overshooting or nonsticking".
[[nodiscard]] std::string names_of_families();
// The same of those that an atlas is made of.
[[nodiscard]] std::string names_of_judged_families();

}  // namespace stickslip::numeric::families
