// What changes at a place between two parts of a branch on which all is decided: named, and proved to happen
// there once.
#pragma once

#include "numeric/branches/crossing.hpp"

namespace stickslip::numeric::branches {

// Everything that a branch's record is made of.
struct Traced {
  const Curve& curve;
  const Law& law;
  const std::vector<Cell>& cells;
  const std::vector<Part>& parts;
};

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

// Which of the exit functions (crossing.hpp) may vanish somewhere, and which pass zero once at most.
struct Crossings {
  std::vector<Exit> possible;
  std::vector<Exit> once;
};

// The changes of stability that these allow between a part that is stable and one that is not.
[[nodiscard]] std::vector<Change> stability_changes(const Crossings& crossings, bool is_lost, const Ball& at);

}  // namespace stickslip::numeric::branches
