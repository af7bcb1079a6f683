// The work of an atlas: boxes are judged, and cut where that leaves something open.
#pragma once

#include <functional>
#include <vector>

#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

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
