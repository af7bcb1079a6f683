// Leaves as a tiling: what they cover, and what is left to do.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/rational.hpp"
#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

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

}  // namespace stickslip::numeric::atlas
