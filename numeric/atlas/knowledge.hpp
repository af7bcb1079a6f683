// What has been proved of a box: it holds in every part of the box, so that only the rest is looked at there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

// Of what is not decided: whether smaller boxes are likely to decide it, and which variable of the forms to
// halve first, the one that it varies most with; 0 where that is not known. It proves nothing.
struct Hope {
  bool is_promising = false;
  int steepest = 0;
  bool is_below = false;  // a quantity that is likely to be found negative

  // Of two things each of which has to be decided.
  [[nodiscard]] Hope and_also(const Hope& other) const {
    return {is_promising && other.is_promising, steepest > 0 ? steepest : other.steepest};
  }
  // Of two quantities that both have to be positive: one that is not decides.
  [[nodiscard]] Hope of_both(const Hope& other) const {
    return is_promising && is_below ? *this : other.is_promising && other.is_below ? other : and_also(other);
  }
};

// Of a quantity's sign where all variables before the first are 0. Were the box smaller by 2^-r, the ranges
// of its slopes would be narrower by as much, and so would it be; r = 7 is what some halvings of the steepest
// reach.
template <class S, int N>
[[nodiscard]] Hope hope_of(const scalars::Form<S, N>& x, std::size_t first = 0) {
  Hope hope = {};
  double sum = 0;
  double most = 0;
  for (std::size_t i = first; i < x.slopes.size(); ++i) {
    const auto [low, high] = scalars::ends(x.slopes[i]);
    sum += std::abs(low / 2 + high / 2) + 0x1p-15 * (high - low);
    const double size = std::max(std::abs(low), std::abs(high));
    if (i > 0 && size > most) {
      most = size;
      hope.steepest = static_cast<int>(i);
    }
  }
  hope.is_promising = std::abs(x.at.approximate()) > sum;
  hope.is_below = x.at.approximate() < 0;
  return hope;
}

// On first <= u <= last, for every member of the box: f keeps the sign `value`, or else f' keeps the sign
// `slope` and lies between these bounds; 0 where that is not known.
struct Cell {
  double first, last;
  int value = 0, slope = 0;
  double least_slope = 0, greatest_slope = 0;
  Hope hope = {};
};

// Whether all numbers between these two have one sign, and none is `factor` times another.
[[nodiscard]] inline bool vary_less_than(double factor, double least, double greatest) {
  return least * greatest > 0 && std::max(std::abs(least), std::abs(greatest)) <
                                     factor * std::min(std::abs(least), std::abs(greatest));
}

// f has exactly one zero in [first, last], for every member of the box, and f' keeps its sign there: it lies
// between these bounds.
struct Bracket {
  double first = 0, last = 1;
  double least_slope = 0, greatest_slope = 0;
  int steepest = 0;  // of f, see Hope

  // Whether f' hardly varies, so that Newton's operator encloses the zero well.
  [[nodiscard]] bool is_straight() const { return vary_less_than(4, least_slope, greatest_slope); }
};

// A rectangle of two unknowns; and, for every member of the box, exactly one zero: in `where`, and no other
// in `unique`, which contains that.
using Patch = std::array<std::pair<double, double>, 2>;
struct ZeroPatch {
  Patch unique, where;
};

// Times of a phase, as shares of its duration.
using Times = std::vector<std::pair<double, double>>;

struct Knowledge {
  struct Condition {
    Truth truth = Truth::undecided;
    Times open{{0, 1}};  // at the other times it holds
    Hope hope = {};
  };
  struct Orbit {
    Bracket zero;         // of one unknown
    ZeroPatch patch{};    // of two
    bool exists = false;  // the zero is an orbit
    Truth admissible = Truth::undecided;
    Truth stable = Truth::undecided;
    Hope of_stability = {};
    std::vector<Condition> conditions;  // one for each requirement of the family, while they are open

    [[nodiscard]] bool is_decided() const {
      return admissible == Truth::refuted || (admissible == Truth::proved && stable != Truth::undecided);
    }
    // Of all that is open; what is not known nearly is hoped to be known better.
    [[nodiscard]] Hope hope() const {
      if (is_decided()) {
        return {true};
      }
      if (!zero.is_straight() && zero.steepest > 0) {
        return {true, zero.steepest};
      }
      if (admissible == Truth::proved) {
        return of_stability;
      }
      Hope hope{true};
      for (const Condition& condition : conditions) {
        if (condition.truth != Truth::proved) {
          hope = hope.of_both(condition.hope);
        }
      }
      return hope;
    }
  };
  struct Sheet {
    std::vector<Cell> cells{{0, 1}};  // of one unknown, from left to right
    // Of two: where there may be zeros besides those that are known.
    std::vector<Patch> patches{{{{0, 1}, {0, 1}}}};
    std::vector<ZeroPatch> zeros = {};
    Hope of_patches{true};
    std::optional<std::vector<Orbit>> orbits;  // all zeros, once their number is known
  };
  std::vector<Sheet> sheets;  // of sheets.hpp; empty where nothing is known

  [[nodiscard]] Hope hope() const {
    Hope hope{!sheets.empty()};
    for (const Sheet& sheet : sheets) {
      if (sheet.orbits) {
        for (const Orbit& orbit : *sheet.orbits) {
          hope = hope.and_also(orbit.hope());
        }
      } else {
        hope = hope.and_also(sheet.of_patches);
        for (const Cell& cell : sheet.cells) {
          if (cell.value == 0 && cell.slope == 0) {
            hope = hope.and_also(cell.hope);
          }
        }
      }
    }
    return hope;
  }
};

}  // namespace stickslip::numeric::atlas
