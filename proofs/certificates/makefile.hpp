// How make has Coq check a directory of certificates.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofs/certificates/certificates.hpp"

namespace stickslip::proofs::certificates {

// make -k -j: has coqc compile the certificates that were asked for and the statements, each file in a
// process of its own, the longest first; what it says of each is in NAME.log, with the seconds. make
// Final.vo: compiles Final.v, after all others. The sizes of files are in characters, by their names without
// ".v".
[[nodiscard]] std::string makefile(const std::vector<Certificate>& certificates,
                                   const std::map<std::string, std::size_t>& sizes);

}  // namespace stickslip::proofs::certificates
