// LaTeX documents compiled.
#pragma once

#include <string>
#include <vector>

#include "report/tools/files.hpp"

namespace stickslip::report::tools {

// Whether there is TeX.
[[nodiscard]] bool can_compile();

// NAME.pdf from NAME.tex, which is among the files, with the pictures that it includes: without a date and
// the same for the same files. `problem` says in half a sentence why there is none: TeX is not there, or
// complains.
struct Compiled {
  std::vector<File> pdf;  // one file or none
  std::string problem;
};
[[nodiscard]] Compiled compile(const std::vector<File>& files, const std::string& name);

}  // namespace stickslip::report::tools
