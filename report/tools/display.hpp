// Formulas displayed in columns as narrow as those of a journal.
#pragma once

#include <string>

namespace stickslip::report::tools {

// The LaTeX of a formula, as proofs/symbols prints it, between the commands of amsmath that display it: in
// one line if that is estimated to fit a column of 230 pt, else broken in front of signs and relations, at
// need of factors in brackets, that stand in no bracket themselves.
[[nodiscard]] std::string displayed(const std::string& latex);

}  // namespace stickslip::report::tools
