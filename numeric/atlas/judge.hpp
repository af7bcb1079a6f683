// What is proved of one box: a function of the question and the tile alone.
#pragma once

#include "numeric/atlas/knowledge.hpp"
#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

enum class Balls {
  hardware,  // doubles (scalars/hardware_ball.hpp)
  arb,       // at the working precision of 64 bits
  both,      // doubles, and Arb where they leave open what is too narrow for them
};

// For every member of the tile, its boundary included: how many orbits of the family there are, how many of
// them are admissible, how many stable. What is not proved is -1, and the reason says why the first of it is
// not. `known` is what is known of a box around the tile, nothing to begin with, and becomes what is known of
// the tile. Proofs in different balls never contradict each other.
[[nodiscard]] Finding judge(const Question& question, Tile tile, Balls balls, Knowledge& known);

// The same of a tile of which nothing is known: from the whole down, box by box around it. Where smaller
// boxes are likely to decide it, it is halved a few times: what all parts say is said of it.
[[nodiscard]] Finding judge_from_whole(const Question& question, Tile tile, Balls balls);

// The two steps of that: what the boxes around a tile tell of it, and the verdict on one that is cut no more.
[[nodiscard]] Knowledge known_around(const Question& question, Tile tile, Balls balls);
[[nodiscard]] Finding judge_finest(const Question& question, Tile tile, Balls balls, Knowledge known);

// How the boxes of an atlas are judged, family by family.

// Of the family of the question, for all members of a box within its domain: what judge() returns, and what
// becomes of `known`. `last`: no box is smaller.
struct Judges {
  using Judge = Finding (*)(const Question&, const Box&, bool last, Knowledge& known);
  Judge in_doubles, in_balls;
};

}  // namespace stickslip::numeric::atlas
