// All periodic orbits of a word at a given friction, for the words where that can be had: none is lost.
#pragma once

#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::words {

struct WordList {
  std::vector<WordOrbit> orbits;  // each proved to exist, admissible or not
  // Where: tau, tau1, tau2, how long the phases after a stick last.
  std::vector<families::Unresolved> unresolved;
  long cells = 0;        // examined
  std::string why_none;  // in half a sentence, where the word alone tells; else empty
};

// Why no motion obeys the friction law and goes through the word, at any friction: x2' <= V <= 0, or x2' >= V
// >= 0, all the time, and not equal all the time, so x2 does not return. Empty where that says nothing.
[[nodiscard]] std::string why_no_motion(const Rational& V, const Word& word);

// Whether all_orbits takes the word over n periods: one for which why_no_motion knows why; one of up to four
// phases that sticks; a power of OS, unless its motion may cross the belt's speed more than twice in a period
// of the load: more than one OS in a period only where OS is proved to have an orbit that obeys the law.
[[nodiscard]] bool has_complete_list(const WordQuestion& question, const Word& word, long periods);

// Every motion of the word over n periods that closes and obeys the friction law is among the orbits or in an
// unresolved part. Throws as require_word_domain does; assumes has_complete_list.
[[nodiscard]] WordList all_orbits(const WordQuestion& question, const Word& word, long periods);

}  // namespace stickslip::numeric::words
