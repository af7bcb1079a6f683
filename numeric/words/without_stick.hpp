// All periodic orbits that never stick, OS and its repetitions.
//
// Two motions that never stick, or one and the same with the load a period later, differ by w with
//   E = (w'ᵀ M w' + wᵀ M K w)/2,  E' = eta (x2' - y2') (u(x2') - u(y2')) <= 0
// (families/nonsticking.hpp). If they return after n periods so does E, so w is a free motion that does, and
// zero unless some n omega_j is a multiple of omega. So off these resonances there is at most one such
// motion, whatever the number of its phases, and it returns after one period already: where OS has an orbit
// that obeys the law, OSOS has none.
#pragma once

#include "numeric/words/complete_list.hpp"

namespace stickslip::numeric::words {

// Whether the function below takes the word, a power of OS, over n periods: more than one OS in a period only
// where OS is proved to have such an orbit.
[[nodiscard]] bool is_without_stick(const WordQuestion& question, const Word& word, long periods);

// As all_orbits. Unresolved at the resonances above. Assumes the domain of words.
[[nodiscard]] WordList all_without_stick(const WordQuestion& question, const Word& word, long periods);

}  // namespace stickslip::numeric::words
