// Proved neighbourhoods of stable orbits, for readers and programs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/orbits.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// One of (x, x'): its name, its unit, if any, and what a number is to be multiplied with for that.
struct Coordinate {
  std::string name, unit;
  double factor = 1;
};
// "x1", or "x1 in m".
[[nodiscard]] std::string named(const Coordinate& coordinate);
// "x1 = 0.1, x2 = 0.2, ...", with the units behind.
[[nodiscard]] std::string state_in_words(const Eigen::VectorXd& X,
                                         const std::vector<Coordinate>& coordinates);
// Of the paper's oscillator.
[[nodiscard]] std::vector<Coordinate> coordinates_in(const Units& units);

// Names first, then a row for each coordinate: where the orbit is, how far a start may be from there in this
// number alone, half the width of the whole set; or why there is none.
[[nodiscard]] std::vector<tools::Row> neighbourhood_rows(
    const numeric::machines::Neighbourhood& neighbourhood, const std::vector<Coordinate>& coordinates);
// The same in a sentence, without the widths.
[[nodiscard]] std::string neighbourhood_in_words(const numeric::machines::Neighbourhood& neighbourhood,
                                                 const std::vector<Coordinate>& coordinates);
// The rows of an orbit of a list as text; empty unless they were asked for. `ur`: of the machine that they
// are about, where ur is a result.
[[nodiscard]] std::string neighbourhood_text(const numeric::Orbit& orbit, const tools::Style& style,
                                             const Units& units, const std::optional<Rational>& ur = {});
// Where ur is a result, of which machine the neighbourhood is, if there is one.
[[nodiscard]] std::optional<Rational> ur_of_neighbourhood(const numeric::OrbitQuestion& question,
                                                          const numeric::Orbit& orbit);
[[nodiscard]] std::string ur_in_words(const Rational& ur);
// What the rows mean, in one sentence, for a label below.
[[nodiscard]] std::string meaning_of_neighbourhood();

// In the units, under the key "neighbourhood", if there is one; of a family's orbit with ur_of_neighbourhood.
void write_neighbourhood(tools::Object& json,
                         const std::shared_ptr<const numeric::machines::Neighbourhood>& neighbourhood,
                         const Units& units = {});
void write_neighbourhood(tools::Object& json, const numeric::OrbitQuestion& question,
                         const numeric::Orbit& orbit, const Units& units = {});

}  // namespace stickslip::report::orbits
