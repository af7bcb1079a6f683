// All periodic orbits of a word of two, three or four phases that sticks, by the search of zeros/search.hpp
// for their durations.
#pragma once

#include "numeric/words/complete_list.hpp"

namespace stickslip::numeric::words {

// Whether all_by_durations takes the word: ST, OT; OTS, OST; OSTS, OSOT; STST, OTST, OTOT.
[[nodiscard]] bool is_searched(const Word& word);

// Every motion of the word over n periods that closes and obeys the friction law is among the orbits or in an
// unresolved part. So is every other that closes with positive durations, but of ST, OT, OTS, OST where
// n/omega is a whole number and no phase lasts longer than pi but the stick. None of these obeys the law:
// x1'' + x1 = chi x2 returns after n Theta, a multiple of 2 pi, only if the integral of (x2' - V) exp(i t)
// over the motion is zero. But where x2' - V has one sign on less than half a turn, or first one and then the
// other on such a stretch each, some cos(t - t0) has the same signs. Of a word that repeats another one over
// fewer periods, such as STST over two, the repetitions are left out: they are orbits of the other one. Lists
// of four phases mostly stay open where n/omega is a whole number: there the rows lose rank as all phases but
// the sticks become short. Assumes the domain of words and is_searched.
[[nodiscard]] WordList all_by_durations(const WordQuestion& question, const Word& word, long periods);

}  // namespace stickslip::numeric::words
