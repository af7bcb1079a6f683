// The periodic orbit of a word at a given friction, proved near a guess, with everything decided about it.
#pragma once

#include <vector>

#include "numeric/families/orbit.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::machines {
struct MachineGuess;
}

namespace stickslip::numeric::words {

// The load is cos omega t: its phase is 0 at t = 0.
struct WordQuestion {
  motion::ExactParameters data;
  Rational ur;
  int digits = 20;            // significant ones, of every value
  long most_bits = 1L << 14;  // that a proof is tried with
};

struct WordOrbit {
  Word word;
  long periods = 1;   // n, the least: the orbit is no repetition of a shorter one
  Verdict existence;  // of "exactly one closed motion of the word lies near the guess"; else no more is known
  families::Orbit orbit;       // its motion begins with the word's first phase
  motion::Requirements asked;  // the conditions of `orbit`, in the same order
};

// The whole of the friction law for a motion through these phases, (4), with ur known.
[[nodiscard]] motion::Requirements requirements_of(const std::vector<motion::PhaseKind>& phases);

// Throws DomainError unless 0 < chi < 1, eta > 0, us > 0, omega > 0 and no natural frequency, p >= 0, ur >
// us.
void require_machine_domain(const WordQuestion& question);
// Likewise, and unless p > 0: there a closed motion is isolated, except for chance.
void require_word_domain(const WordQuestion& question);
// Likewise, but omega may be a natural frequency: there motions are simulated, and none is proved.
void require_simulated_domain(const WordQuestion& question);
[[nodiscard]] bool in_word_domain(const WordQuestion& question);

// Proves the orbit that Newton's method reaches from the guess, a motion over n periods of the load that
// nearly closes, its events over less than these; how long it lasts follows. When that is a shorter orbit
// taken several times, the shorter one. A condition or the stability that the asked digits leave undecided is
// looked at with more. Throws as require_word_domain and Word::of do.
[[nodiscard]] WordOrbit prove_word_orbit(const WordQuestion& question, const machines::MachineGuess& guess);

}  // namespace stickslip::numeric::words
