// The work of an atlas: boxes are judged, and cut where that leaves something open; what they cover together.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "core/rational.hpp"
#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

// Leaves as a tiling: what they cover, and what is left to do.

// Sorts the leaves along the line of tile.hpp and drops those that stand there twice. Throws
// InputOutputError when two of them contradict each other, or overlap, or one is none of the question's.
void put_in_order(const Question& question, std::vector<Leaf>& leaves);

// The largest tiles that the ordered leaves do not cover, in order. Each of them is a box that a search which
// has found these leaves has still to look at: its parent was cut.
[[nodiscard]] std::vector<Tile> gaps(const std::vector<Leaf>& leaves);

// A volume as a share of the whole, exactly.
[[nodiscard]] Rational share(std::uint64_t volume);

// The volumes of ordered leaves.
struct Tally {
  std::uint64_t decided = 0, outside = 0, open = 0;  // outside: of the domain
  std::uint64_t orbits_known = 0, admissible_known = 0;
  std::uint64_t coarser = 0;  // the part of `open` and `outside` that is not at the finest resolution
  std::uint64_t leaves = 0;
  // Of decided leaves, by what is found; of open ones, by the reason.
  struct Counts {
    int orbits, admissible, stable;
    friend auto operator<=>(const Counts&, const Counts&) = default;
  };
  std::map<Counts, std::uint64_t> counts;
  std::map<int, std::uint64_t> reasons;

  [[nodiscard]] std::uint64_t covered() const { return decided + outside + open; }
};
[[nodiscard]] Tally tally(const Question& question, const std::vector<Leaf>& leaves);

// The work of an atlas: boxes are judged, and cut where that leaves something open.

// A piece of work: what became of a tile and the boxes within it.
struct Block {
  std::vector<Leaf> leaves;
  std::vector<Tile> rest;  // what was not looked at
};

// Judges the boxes of a tile, depth first, until none is left, or some thousand were judged or some seconds
// have passed and what is left is large, or `stop` says so; then nothing of this block is lost.
[[nodiscard]] Block work_on(const Question& question, Tile tile, const std::function<bool()>& stop);

// All of these tiles on as many threads as Jobs allow, each block's leaves given to `done`, one call at a
// time. `stop`, which is asked from several threads, ends the work after the boxes that are being judged.
// Throws what `done` throws.
void work_on_all(const Question& question, const std::vector<Tile>& tiles, const std::function<bool()>& stop,
                 const std::function<void(const std::vector<Leaf>&)>& done);

}  // namespace stickslip::numeric::atlas
