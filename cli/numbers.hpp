// Numbers on the command line.
#pragma once

#include <string>
#include <utility>

#include "core/parallel.hpp"
#include "core/rational.hpp"
#include "model/linear.hpp"

namespace stickslip::cli {

// The number that was typed, from 1 to `most`; `otherwise` if nothing was. Throws UsageError naming `name`.
[[nodiscard]] int whole_number(const std::string& name, const std::string& text, int most, int otherwise);

// A number, exactly and in double, and one above zero; an interval is none. Throw UsageError naming `name`.
[[nodiscard]] Rational exact_number(const std::string& name, const std::string& text);
[[nodiscard]] double number(const std::string& name, const std::string& text);
[[nodiscard]] double positive(const std::string& name, const std::string& text);

// "A..B" with A < B, "0.5+-1e-4", "4+-5%" or a number: its ends. Throws UsageError naming `name`.
[[nodiscard]] std::pair<Rational, Rational> interval(const std::string& name, const std::string& text);

// A state "x1,x2,x1',x2'". Throws likewise.
[[nodiscard]] model::Vector4<double> four_numbers(const std::string& name, const std::string& text);

// --jobs: how many threads may search for orbits and prove them; all cores if nothing was typed. Throws
// UsageError.
[[nodiscard]] Jobs jobs(const std::string& text);

}  // namespace stickslip::cli
