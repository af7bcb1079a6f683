// Coq, asked about many theorems in one go.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "proofs/certificates/certificates.hpp"

namespace stickslip {

// Writes these; what prelude.sh has had Coq compile of the same text comes with what came of it.
void write_certificates(const std::filesystem::path& directory,
                        const proofs::certificates::Certificates& all);

// Writes the certificates of these claims, and of what they rest on, and has Coq check them; CHECKs that it
// accepts them.
[[nodiscard]] proofs::certificates::Certificates compiled(const std::filesystem::path& directory,
                                                          const std::set<std::string>& claims);

struct Asked {
  std::string statement;  // "  forall (x : R),\n  0 < x ->\n  x <> 0"
  std::string proof;      // what stands between "Proof." and "Qed."
};

// Which of the theorems Coq accepts, after these files of the directory.
[[nodiscard]] std::vector<bool> accepted(const std::filesystem::path& directory,
                                         const std::set<std::string>& imports,
                                         const std::vector<Asked>& asked);

}  // namespace stickslip
