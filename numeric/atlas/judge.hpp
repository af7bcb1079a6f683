// What is proved of one box: a function of the question and the tile alone.
#pragma once

#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

enum class Balls {
  hardware,  // doubles (scalars/hardware_ball.hpp)
  arb,       // at the working precision of 64 bits
};

// For every member of the tile, its boundary included: how many orbits of the family there are, how many of
// them are admissible, how many stable. What is not proved is -1, and the reason says why the first of it is
// not. Proofs in different balls never contradict each other; those in Arb prove at least what 53 bits keep
// from the others.
[[nodiscard]] Finding judge(const Question& question, Tile tile, Balls balls);

// In doubles; in Arb where they leave open what is too narrow for them.
[[nodiscard]] Finding judge(const Question& question, Tile tile);

}  // namespace stickslip::numeric::atlas
