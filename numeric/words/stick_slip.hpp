// All periodic orbits of one slip and one stick in n periods of the load, at a given friction: none is lost.
#pragma once

#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::words {

// Where a closed motion may be that was neither proved nor excluded.
struct OpenPart {
  Ball tau;  // the duration of the slip
  std::string reason;
};

struct WordList {
  std::vector<WordOrbit> orbits;  // each proved to exist, admissible or not, by rising tau
  std::vector<OpenPart> unresolved;
  long cells = 0;  // examined
};

// Every closed motion of the word ST over n periods with positive durations is among the orbits or in an
// unresolved part. Throws as require_word_domain does, and DomainError unless V > 0.
[[nodiscard]] WordList all_stick_slip_orbits(const WordQuestion& question, long periods);

}  // namespace stickslip::numeric::words
