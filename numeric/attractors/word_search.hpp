// Orbits of a given word: where simulations find them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "numeric/words/stick_slip.hpp"

namespace stickslip::numeric::attractors {

struct WordSearch {
  words::WordQuestion machine;
  words::Word word;
  long periods = 1;                            // n
  std::optional<model::Vector4<double>> near;  // (x1, x2, x1', x2') at load phase 0; else random starts
};

struct WordOrbits {
  WordSearch question;
  std::vector<words::WordOrbit> orbits;  // some of them may be of a shorter word that the asked one repeats
  std::string seen;                      // what was met instead, in half a sentence; empty with an orbit
  bool interrupted = false;
  bool searched = false;  // the whole domain: nothing is missing but what is unresolved
  std::vector<words::OpenPart> unresolved = {};

  [[nodiscard]] bool complete() const { return searched && unresolved.empty(); }
};

// With a start: the motion from there through n periods if it goes through the word, else what it settles on.
// Without: for ST and V > 0 all orbits; for another word those that some random starts settle on.
// Throws as words::require_word_domain and simulation::Simulation do.
[[nodiscard]] WordOrbits find_word_orbits(const WordSearch& question);

}  // namespace stickslip::numeric::attractors
