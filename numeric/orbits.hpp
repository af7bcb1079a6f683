// All orbits of one family at given parameters, with everything that is decided about them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "numeric/families/orbit.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric {

namespace motion {
struct ClosedMotion;
}

using families::all_families;
using families::asks_for_box;
using families::Family;
using families::family_named;
using families::is_admissible;
using families::NamedBall;
using families::Orbit;
using families::OrbitQuestion;
using families::Remark;
using families::Unresolved;

struct OrbitList {
  OrbitQuestion question;
  std::vector<Orbit> orbits;
  std::vector<Unresolved> unresolved;
  std::vector<Remark> remarks;
  long cells = 0;  // that the search examined
  // Of the unresolved: orbits at the middle of a box, not proved for the whole of it.
  std::size_t open_at_middle = 0;

  // No orbit of the family is missing; never so for a box.
  [[nodiscard]] bool complete() const { return unresolved.empty() && !asks_for_box(question); }
};

// The machine that an orbit of the list is one of: with the ur that is given, or else that of the orbit to 17
// digits.
[[nodiscard]] words::WordQuestion machine_of(const OrbitQuestion& question, const Orbit& orbit);

// Nothing is unresolved, and each condition of each orbit is proved or refuted.
[[nodiscard]] bool all_decided(const OrbitList& list);

// Throws what list_orbits throws for the question as such, before any search.
void require_answerable(const OrbitQuestion& question);

// The complete list, or what is missing from it. A condition that the asked digits leave undecided is looked
// at again with more. For a box of parameters: the orbits at its middle, each proved, with its conditions,
// for all members of the box, or unresolved. Throws DomainError when the data are outside the domain of the
// family, among them ur <= us, and UsageError for a phi or ur that the family does not take, and for
// neighbourhoods over a box, or of orbits that never stick without ur.
[[nodiscard]] OrbitList list_orbits(const OrbitQuestion& question);

// The values, conditions and stability of a proved motion of the family, at the working precision of the
// moment; ur as far as it is given.
[[nodiscard]] Orbit decided_orbit(const Family& family, const motion::ClosedMotion& closed,
                                  const std::optional<Ball>& ur);

}  // namespace stickslip::numeric
