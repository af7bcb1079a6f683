// The schemas of all that the program prints as JSON.
#pragma once

#include <vector>

#include "report/tools/files.hpp"

namespace stickslip::report {

// NAME.schema.json each, as doc/formats.md names them.
[[nodiscard]] std::vector<tools::File> schemas();

}  // namespace stickslip::report
