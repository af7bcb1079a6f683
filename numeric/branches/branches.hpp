// Branches of orbits over an interval of one parameter: every place where something changes, enclosed, named
// and proved.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "numeric/branches/state.hpp"
#include "numeric/machine_along.hpp"
#include "numeric/orbits.hpp"

namespace stickslip::numeric::branches {

// Orbits through any phases, at the friction and the value `at` that the question says: their branches are
// followed, others are not looked for.
struct WordOrbits {
  std::shared_ptr<const families::Family> family;  // a record of the word: what question.orbits.family is
  std::vector<motion::Motion> motions;             // that close, nearly
  int periods = 1;                                 // of the load, each
  std::size_t not_admissible = 0;                  // orbits that are known, too, and are not followed
};

struct Branch;
struct BranchQuestion {
  OrbitQuestion orbits;  // exact; what it says of the free parameter does not count
  // chi, eta, us, V, omega, p; phi or ur where the family takes it; or a value of `machine`.
  std::string parameter;
  Rational from, to;  // from < to
  // Follow the branches of the orbits that there are at this value; without it all branches are looked for.
  std::optional<Rational> at;
  std::optional<WordOrbits> word = {};
  // In SI units: then `orbits` are the data taken for it at one of the values, and what varies is the name of
  // the machine's value.
  std::optional<MachineAlong> machine = {};
  std::string machine_file = {};  // for the command that asks again
  // Called with each branch as soon as all is known of it, in the order of the list.
  std::function<void(const Branch&)> found = {};
};

struct Change {
  ChangeKind kind = ChangeKind::fold;
  std::string what;          // which condition, multiplier or duration; empty for a fold
  std::string words;         // a sentence
  Ball at;                   // contains the value of the parameter
  std::optional<Ball> when;  // where in the motion, its time from the beginning: of a condition
  // Of "it happens there exactly once, and transversally": a fold is a strict extremum of the parameter along
  // the branch. That it happens is proved in any case, by what is proved on both sides.
  Verdict verdict;
};

// One orbit of a branch, for tables and pictures: nearly.
struct Sample {
  double value = 0;
  motion::MotionOf<double> motion;
};

// A piece on which nothing changes, in the direction of the branch.
struct Piece {
  State state = State::undecided;
  std::string condition;        // one that is violated all along, if one is; of an inadmissible piece
  Ball first, last;             // the parameter where it begins and ends
  std::vector<Sample> samples;  // none of motions that grow beyond all bounds
  bool may_turn = false;        // of an undecided piece: how many motions it has at a value is not known
};

// Why a branch begins or ends where it does.
struct BranchEnd {
  Ball at;  // contains the parameter; where the motion is infinite it may hold ones that are not decided
  std::string words;
  End kind = End::stopped;
  bool resonance = false;  // the reason why it is stopped

  [[nodiscard]] bool resolved() const { return kind != End::stopped; }
};

struct Branch {
  std::vector<Piece> pieces;
  std::vector<Change> changes;  // in the direction of the branch
  BranchEnd first, last;
  bool closed = false;    // a closed curve
  std::size_t cells = 0;  // that its proof has
};

struct UnresolvedPart {
  Ball value;  // of the parameter
  std::vector<NamedBall> where;
  std::string reason;
  bool resonance = false;  // it is next to one, where the interval is split
};

// How many orbits there are on the branches of the list between two values at which that may change; of those
// that are admissible the stability of so many is `unsettled`, and of so many more motions that close it is
// `undecided` whether they are orbits and admissible: neither counts in the numbers before. There may be
// `more` where all branches are looked for and an unresolved part may hold some; and where only some are, and
// one of these was followed no further: it may come back.
struct Count {
  Ball from, to;
  int orbits = 0, admissible = 0, stable = 0, unsettled = 0, undecided = 0;
  bool more = false;
};

struct BranchList {
  BranchQuestion question;
  std::vector<Branch> branches;
  std::vector<UnresolvedPart> unresolved;
  std::vector<Count> counts;  // leave out where a branch may turn
  // Every orbit of the family at any value of the interval is on a branch of the list.
  bool complete = false;
  bool interrupted = false;

  // Nothing is unresolved but next to resonances.
  [[nodiscard]] bool resolved() const {
    return std::all_of(unresolved.begin(), unresolved.end(),
                       [](const UnresolvedPart& part) { return part.resonance; });
  }
};

// Changes are enclosed to this.
inline constexpr double resolution = 1e-10;

// Throws UsageError for a parameter that the family does not have or an interval that does not rise, and what
// list_orbits throws where some value of the interval is outside the family's domain.
[[nodiscard]] BranchList list_branches(const BranchQuestion& question);

}  // namespace stickslip::numeric::branches
