// A family of orbits as one record: everything that the rest of the program knows of it. A new family is its
// record and its search in a file of its own, and a row of the table.
//
// Its closing conditions are a system f(x, p) = 0 (motion/closing.hpp), the same for an orbit at exact data,
// to any precision, and for all members of a box of parameters: reduced equations in two to six unknowns
// (model/), which the paper's claims prove to be equivalent to closing. There is one other formulation, the
// flows from event to event of machines/chain.hpp, and each does what the other cannot. A chain serves any
// word, up to hundreds of phases, in a time that grows with their number; but ur has to be given, which is a
// result of symmetric orbits and of overshooting ones at a given phase, and over a box of parameters the
// error of a flow grows with its duration. The reduced equations stay regular over boxes that are ten to a
// hundred times as wide, are what a search can exclude with, and leave the datum free; but they are the work
// of a derivation for each family. That both lead to the same orbits, digit by digit, is a test
// (tests/numeric/words). Branches of words take the flows, too, from end to end (branches/setting.hpp).
//
// The search isolates the zeros of reduced equations in one or two unknowns, the only ones in which
// everything else can be excluded; a motion that is then proved to close counts as the zero in whose box of
// uniqueness it lies.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/families/orbit.hpp"
#include "numeric/families/strip.hpp"
#include "numeric/motion/closing.hpp"

namespace stickslip::numeric::atlas {
struct Judges;  // atlas/judge.hpp
extern const Judges symmetric_judges, overshooting_judges, nonsticking_judges;
}  // namespace stickslip::numeric::atlas

namespace stickslip::numeric::families {

// A zero of reduced equations, proved to be one.
struct Isolated {
  motion::Motion guess;          // its motion, nearly
  std::vector<NamedBall> where;  // contains the zero
  // Whether a closed motion with the guess's phases is this zero: it lies where the zero is the only one.
  std::function<bool(const motion::Motion&)> is_same;
};

// One of a family's.
struct Candidate : Isolated {
  motion::Closing equations;  // that its motion obeys
  int system = 0;             // which of the family's systems of closing conditions they are
  int angle = -1;             // the place of an unknown that counts modulo 2 pi, or none
};

// What a search found: no closed motion is in neither list.
template <class Zero>
struct FoundOf {
  std::vector<Zero> candidates = {};
  std::vector<Unresolved> unresolved = {};
  std::vector<Remark> remarks = {};
  long cells = 0;  // examined
};
using Found = FoundOf<Candidate>;

// How motions can grow beyond all bounds: those unknowns that are lengths and do, those that do not, and the
// closing conditions that do not depend on the first.
struct Growth {
  std::vector<int> growing, bounded;
  std::vector<int> free_rows;
};

struct Family {
  std::string name;                               // on the command line
  std::string title;                              // with its phases
  std::vector<motion::PhaseKind> phases;          // in a period
  std::vector<std::string> durations;             // the paper's names of how long they last
  motion::Requirements requirements;              // the inequalities along the motion, with equation numbers
  std::string why_no_phi, why_no_ur;              // why the datum is not taken; empty when it may be given
  std::string why_datum;                          // why one of those taken is needed; empty when none is
  std::string (*searched)(const OrbitQuestion&);  // the domain of the search, in words
  // All closed motions with positive durations, or where there may be some, over the whole closed domain.
  // Throws DomainError where the data have no such motions that are isolated.
  Found (*search)(const motion::Given<Rational>&);
  // The same for all values of one parameter: a strip for each system of closing conditions.
  std::vector<Strip> (*strips)(const StripQuestion&);
  // Conditions beyond the requirements, of a motion whose largest admissible friction is known; may be null.
  std::vector<motion::Condition> (*further)(const motion::Motion&, const Ball& ur_max,
                                            const std::optional<Ball>& ur) = nullptr;
  // What is proved of its orbits over a box of parameters; null where no atlas is made of them.
  const atlas::Judges * judges = nullptr;
  int belt = 0;               // the sign of V that its orbits need; 0: any
  bool is_symmetric = false;  // each phase ends in the mirror image of where it begins (13)
  // Further inequalities along motions on a belt that stands still.
  motion::Requirements at_rest = {};
  std::vector<Growth> growths = {};  // in the unknowns of its closing conditions
  // Its closing conditions are singular where k omega, k at least this, is a natural frequency; 0: nowhere.
  // And where k omega = 1, that of m1 alone, for k >= 1.
  int first_singular = 0;
  bool is_singular_with_m1 = false;
};

[[nodiscard]] bool has_stick(const Family& family);

// Theta, and where the first phase begins: phi, z10, z20, zdot10, x10, x20, xdot10.
[[nodiscard]] std::vector<NamedBall> start_values(const motion::Motion& motion);

// Its requirements; without ur those that do not need it.
[[nodiscard]] motion::Requirements requirements(const Family& family, bool ur_given = true);

// The friction of a motion: at its beginning, where a stick ends, |r| = ur (12); for one that never sticks
// the largest ur for which (25) and (26) hold, the least friction_ahead of all phases.
[[nodiscard]] Ball friction_of(const Family& family, const motion::ClosedMotion& motion);

// Every condition on a closed motion of the family. ur may be missing for one that never sticks only; then
// those that need it are left out.
[[nodiscard]] std::vector<motion::Condition> conditions(const Family& family,
                                                        const motion::ClosedMotion& motion,
                                                        const std::optional<Ball>& ur);

}  // namespace stickslip::numeric::families
