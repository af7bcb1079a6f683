// From the parts of a branch to its pieces, on which nothing changes; and what changes at a place between two
// on which all is decided: named, and proved to happen there once.
#pragma once

#include "numeric/branches/law.hpp"

namespace stickslip::numeric::branches {

// Everything that a branch's record is made of.
struct Traced {
  const Curve& curve;
  const Law& law;
  const std::vector<Cell>& cells;
  const std::vector<Part>& parts;
};

// From the parts to the pieces (pieces.cpp).

// Fills in pieces, changes and ends: `first` and `last` as the path has them, replaced where the branch ends
// by a birth before. What is neither decided nor a change goes to `unresolved`.
void describe(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved);

// Between neighbouring values at which a piece or an unresolved part begins or ends, where nothing changes;
// not where a branch may turn. Where all branches are looked for, `open` are the parts in which there may be
// orbits on none.
[[nodiscard]] std::vector<Count> counts_of(const BranchQuestion& question,
                                           const std::vector<Branch>& branches,
                                           const std::vector<UnresolvedPart>& open);

// What changes between them.

// The undecided parts between two decided ones, and scraps of decided ones among them.
struct Gap {
  std::size_t from, to;  // of Traced::parts
  const Part * before;   // the last decided part, the next one: nullptr at an end of the branch
  const Part * after;
  Ball at;  // contains the parameter
};

// Whether both motions are admissible, and of one of them alone the stability is decided: then nothing may
// change but what is known.
[[nodiscard]] bool may_adjoin(State a, State b);

// For a gap between two decided parts inside the interval. Empty when nothing changes that could be named.
// The name is certain; only "once, and transversally" may be undecided.
[[nodiscard]] std::vector<Change> changes_at(const Traced& traced, const Gap& gap);

// Which of the exit functions (law.hpp) may vanish somewhere, and which pass zero once at most.
struct Crossings {
  std::vector<motion::Exit> possible;
  std::vector<motion::Exit> once;
};

// The changes of stability that these allow between a part that is stable and one that is not.
[[nodiscard]] std::vector<Change> stability_changes(const Crossings& crossings, bool is_lost, const Ball& at);

// Vanishes where a branch along which the load's phase is given turns: det(I - M), M the derivative of the
// map from one start of the first phase to the next, both at that phase of the load whatever the friction,
// after a stick. With the friction given instead, that of the return map does so.
template <class S>
[[nodiscard]] S turn_at_given_phase(const motion::MotionOf<S>& motion) {
  model::Matrix4<S> M = motion::tangent_flow<S>(motion.oscillator, motion.phases.front());
  for (std::size_t k = 1; k < motion.phases.size(); ++k) {
    M = motion::saltation_between<S>(motion.oscillator, motion.phases[k - 1].kind, motion.phases[k]) * M;
    M = motion::tangent_flow<S>(motion.oscillator, motion.phases[k]) * M;
  }
  return (model::Matrix4<S>::Identity() - M).template topLeftCorner<3, 3>().determinant();
}

}  // namespace stickslip::numeric::branches
