// What `stickslip latex` prints.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "proofs/methods/claim.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

// Audits the claims with these ids, or all if there are none.
using Prove = std::function<proofs::methods::Audit(const std::vector<proofs::methods::Claim>&,
                                                   const std::set<std::string>&)>;

struct LatexText {
  std::string text;
  std::vector<std::string> left_out = {};  // of the parameters, a sentence for each
};

// Expressions, statements, a theorem, an orbit or errata, as the options say. Searches for the orbit. Throws
// UsageError for what there is not and what does not go together, DomainError as list_orbits does.
[[nodiscard]] LatexText latex_text(const LatexOptions& options, const proofs::methods::Paper& paper,
                                   const Prove& prove);

}  // namespace stickslip::cli
