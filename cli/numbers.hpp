// Whole numbers on the command line.
#pragma once

#include <string>

#include "core/parallel.hpp"

namespace stickslip::cli {

// The number that was typed, from 1 to `most`; `otherwise` if nothing was. Throws UsageError naming `name`.
[[nodiscard]] int whole_number(const std::string& name, const std::string& text, int most, int otherwise);

// --jobs: how many threads may search for orbits and prove them; all cores if nothing was typed. Throws
// UsageError.
[[nodiscard]] Jobs jobs(const std::string& text);

}  // namespace stickslip::cli
