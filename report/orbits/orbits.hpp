// Lists of orbits for readers and for programs.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/word_search.hpp"
#include "numeric/orbits.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// A list of orbits as its reports see it, whether of a family or of a word: a word is a family, too.

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

// Lists of orbits for readers and for programs.

// What a list is as JSON, to the digits asked for; their schemas. Keys that do not apply are absent,
// "admissible" is null when undecided. Values and durations are in the units, the data those of (2).
void write_orbits(tools::Object& json, const numeric::OrbitList& list);
[[nodiscard]] tools::Json to_json(const numeric::OrbitList& list);
[[nodiscard]] tools::Json to_json(const numeric::attractors::WordOrbits& list, const Units& units = {});
[[nodiscard]] tools::File orbits_schema();
[[nodiscard]] tools::File words_schema();

// Which orbits are described in full: those that may be admissible, or all.
enum class InFull { admissible, all };

// The parameters; how complete the search is; each orbit with its values to the asked digits and its
// conditions, admissible ones first; formal solutions, which are not admissible, in a line each unless all
// are asked for in full. An orbit of a word with its phases and, of all of them, the least margin of each
// condition. An orbit keeps its number in the list. Parameters and conditions are those of (2) in any units.
// No line is longer than the width of the style, except for what cannot be broken.
[[nodiscard]] std::string terminal_report(const Listed& listed, const tools::Style& style,
                                          const Units& units = {}, InFull in_full = InFull::admissible);

// Orbits as pictures.

// The script for gnuplot that draws the admissible orbits, or all if none is admissible, or the one named:
// for each the phase portraits of both masses, the phases in the line weights of Fig. 3, and the
// displacements and velocities over one period with the times at which the phases change; an arrow in each
// phase of a portrait shows the direction of motion, a dot where the phase begins. (z_i, z_i') for
// orbits that stick, (x_i, x_i') for those that do not, as in the paper. Drawn from midpoints in double: a
// picture proves nothing. In the units of (2), whatever the units; of these only the machine is taken, for
// the title. Empty when there is no orbit.
[[nodiscard]] std::string plot_script(const numeric::OrbitList& list, tools::PlotFormat format,
                                      tools::PlotShape shape = tools::PlotShape::wide,
                                      std::optional<std::size_t> only = std::nullopt,
                                      const Units& units = {});

// The same picture for one who does not see it: of each orbit its phases and their times, the extent of each
// displacement and velocity, and the belt's velocity; from midpoints in double.
[[nodiscard]] std::string picture_in_words(const numeric::OrbitList& list,
                                           std::optional<std::size_t> only = std::nullopt);

// What arrows, dots and line widths mean, and the units, in half a sentence.
[[nodiscard]] std::string meaning_of_picture();

}  // namespace stickslip::report::orbits

template <>
struct stickslip::report::tools::SampleOf<stickslip::numeric::OrbitList> {
  [[nodiscard]] static numeric::OrbitList made() {
    numeric::OrbitList list;
    list.question.family = numeric::all_families().front();
    return list;
  }
};
