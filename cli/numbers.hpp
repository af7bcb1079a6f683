// Numbers on the command line. All readers throw UsageError naming `name`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "core/rational.hpp"

namespace stickslip::cli {

// From 1 to `most`.
[[nodiscard]] int whole_number(const std::string& name, const std::string& text, int most);

// A number, exactly and in double, and one above zero; an interval is none.
[[nodiscard]] Rational exact_number(const std::string& name, const std::string& text);
[[nodiscard]] double number(const std::string& name, const std::string& text);
[[nodiscard]] double positive(const std::string& name, const std::string& text);

// "A..B" with A < B, "0.5+-1e-4", "4+-5%" or a number: its ends.
[[nodiscard]] std::pair<Rational, Rational> interval(const std::string& name, const std::string& text);

// Positions, then velocities, of "x1,x2,x1',x2'": two for each mass; those of the paper's two masses.
using State = std::vector<double>;
[[nodiscard]] State state(const std::string& name, const std::string& text);
[[nodiscard]] std::array<double, 4> of_two_masses(const std::string& name, const State& state);

// Two of x1, x2, x1', x2', 0 to 3, of "x1,x2".
[[nodiscard]] std::array<int, 2> plane(const std::string& name, const std::string& text, std::size_t masses);

// Of --units: true for "si". Throws UsageError for any other text.
[[nodiscard]] bool is_si(const std::string& text);

// How many threads may search for orbits and prove them: by default all cores.
inline constexpr int most_jobs = 1024;
[[nodiscard]] Jobs jobs(std::optional<int> threads);

}  // namespace stickslip::cli
