// What has been proved of a box: it holds in every part of the box, so that only the rest is looked at there.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/verdict.hpp"

namespace stickslip::numeric::atlas {

// On first <= u <= last, for every member of the box: f keeps the sign `value`, or else f' keeps the sign
// `slope` and lies between these bounds; 0 where that is not known.
struct Cell {
  double first, last;
  int value = 0, slope = 0;
  double least_slope = 0, greatest_slope = 0;
  bool is_promising = false;  // smaller boxes are likely to tell
};

// f has exactly one zero in [first, last], for every member of the box, and f' keeps its sign there: it lies
// between these bounds.
struct Bracket {
  double first = 0, last = 1;
  double least_slope = 0, greatest_slope = 0;
};

// Times of a phase, as shares of its duration.
using Times = std::vector<std::pair<double, double>>;

struct Knowledge {
  struct Condition {
    Truth truth = Truth::undecided;
    Times open{{0, 1}};         // at the other times it holds
    bool is_promising = false;  // smaller boxes are likely to decide it
  };
  struct Orbit {
    Bracket zero;
    bool exists = false;  // the zero is an orbit
    Truth admissible = Truth::undecided;
    Truth stable = Truth::undecided;
    bool stability_promising = false;
    std::vector<Condition> conditions;  // one for each requirement of the family, while they are open

    [[nodiscard]] bool is_decided() const {
      return admissible == Truth::refuted || (admissible == Truth::proved && stable != Truth::undecided);
    }
    // Whether smaller boxes are likely to decide it.
    [[nodiscard]] bool is_promising() const {
      const auto is_likely = [](const Condition& c) { return c.truth == Truth::proved || c.is_promising; };
      return is_decided() ||
             (admissible == Truth::proved ? stability_promising
                                          : std::all_of(conditions.begin(), conditions.end(), is_likely));
    }
  };
  struct Sheet {
    std::vector<Cell> cells{{0, 1}};           // from left to right
    std::optional<std::vector<Orbit>> orbits;  // all zeros, once their number is known
  };
  std::vector<Sheet> sheets;  // of sheets.hpp; empty where nothing is known

  // Whether smaller boxes are likely to decide all that is open.
  [[nodiscard]] bool is_promising() const {
    return !sheets.empty() && std::all_of(sheets.begin(), sheets.end(), [](const Sheet& sheet) {
      return sheet.orbits ? std::all_of(sheet.orbits->begin(), sheet.orbits->end(),
                                        [](const Orbit& orbit) { return orbit.is_promising(); })
                          : std::all_of(sheet.cells.begin(), sheet.cells.end(), [](const Cell& cell) {
                              return cell.value != 0 || cell.slope != 0 || cell.is_promising;
                            });
    });
  }
};

}  // namespace stickslip::numeric::atlas
