// A list of orbits as its reports see it, whether of a family or of a word: a word is a family, too.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "numeric/attractors/word_search.hpp"
#include "numeric/orbits.hpp"

namespace stickslip::report::orbits {

struct Listed {
  Listed(const numeric::OrbitList& list);               // NOLINT: either list is one
  Listed(const numeric::attractors::WordOrbits& list);  // NOLINT

  // Of a word, its orbits with the worst of each kind of condition, and a record of the word as the family.
  numeric::OrbitList list;
  std::string title;                   // with its phases
  std::string searched;                // the domain
  std::string result;                  // "complete: 2 orbits, 1 admissible, no unresolved boxes"
  std::string command;                 // that lists the same orbits
  std::vector<std::string> durations;  // names of how long the phases last; of a word, their letters
  // Of a word: as it was found, and what list.question.family is.
  std::shared_ptr<const numeric::attractors::WordOrbits> word = nullptr;
  std::shared_ptr<const numeric::Family> record = nullptr;
};

}  // namespace stickslip::report::orbits
