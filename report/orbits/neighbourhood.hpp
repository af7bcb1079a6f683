// Proved neighbourhoods of stable orbits, for readers and programs.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "numeric/machines/neighbourhood.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// One of (x, x'): its name, its unit, if any, and what a number is to be multiplied with for that.
struct Coordinate {
  std::string name, unit;
  double factor = 1;
};
// Of the paper's oscillator.
[[nodiscard]] std::vector<Coordinate> coordinates_in(const Units& units);

// Names first, then a row for each coordinate: where the orbit is, how far a start may be from there in this
// number alone, half the width of the whole set; or why there is none.
[[nodiscard]] std::vector<tools::Row> neighbourhood_rows(
    const numeric::machines::Neighbourhood& neighbourhood, const std::vector<Coordinate>& coordinates);
// The same in a sentence, without the widths.
[[nodiscard]] std::string neighbourhood_in_words(const numeric::machines::Neighbourhood& neighbourhood,
                                                 const std::vector<Coordinate>& coordinates);
// What the rows mean, in one sentence, for a label below.
[[nodiscard]] std::string meaning_of_neighbourhood();

// Under the key "neighbourhood", if there is one.
void write_neighbourhood(tools::Object& json,
                         const std::shared_ptr<const numeric::machines::Neighbourhood>& neighbourhood);

}  // namespace stickslip::report::orbits
