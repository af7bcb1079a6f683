// Branches of orbits through any phases: the question about them, as one about a family.
#pragma once

#include "numeric/branches/branches.hpp"
#include "numeric/families/family.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::branches {

// Of the orbits of that word and over n periods that are among the known ones, at the machine's data and
// friction with the parameter at `at`. The durations are named t1, t2, … in the order of the word's letters.
[[nodiscard]] BranchQuestion word_question(const words::WordQuestion& machine, const words::Word& word,
                                           int periods, const std::vector<words::WordOrbit>& known);

// The closing conditions of its orbits, and of each a guess at `at`.
[[nodiscard]] std::vector<families::Candidate> word_candidates(const WordOrbits& word);

}  // namespace stickslip::numeric::branches
