// Orbits of a given word: where simulations find them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "numeric/words/complete_list.hpp"

namespace stickslip::numeric::attractors {

struct WordSearch {
  words::WordQuestion machine;
  words::Word word;
  long periods = 1;                            // n
  std::optional<model::Vector4<double>> near;  // (x1, x2, x1', x2') at load phase 0; else random starts
  bool all =
      true;  // of four phases or more, too, where that may take minutes; else what random starts end on
  bool neighbourhood = false;  // of each stable orbit, too
};

struct WordOrbits {
  WordSearch question;
  std::vector<words::WordOrbit> orbits;  // some of them may be of a shorter word that the asked one repeats
  std::string seen;  // what was met instead, or why there is none, in half a sentence; empty with an orbit
  bool interrupted = false;
  bool searched = false;  // the whole domain: nothing is missing but what is unresolved
  std::vector<families::Unresolved> unresolved = {};

  [[nodiscard]] bool complete() const { return searched && unresolved.empty(); }
};

// With a start: the motion from there through n periods if it goes through the word, else what it settles on.
// Without: all orbits where words/complete_list.hpp has them, of four phases first those that random starts
// settle on, and these alone if not all are asked for; else those alone. Throws as words::require_word_domain
// and simulation::Simulation do.
[[nodiscard]] WordOrbits find_word_orbits(const WordSearch& question);

}  // namespace stickslip::numeric::attractors
