// Claims as files for the proof assistant Coq, whose kernel then checks every step again.
//
// A certificate states the kernel's sequents of a claim in full and proves them from the definitions of
// real numbers and functions, by lemmas that retrace the derivation. Nothing is taken on trust: there is no
// axiom, and nothing admitted, in any file. prelude/ says what a derivative or a matrix is.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "proofs/certificates/statements.hpp"

namespace stickslip::proofs::certificates {

struct File {
  std::string name;
  std::string text;
};

struct Certificate {
  std::string claim;                  // its id
  std::string name;                   // of the file, without ".v": several may have one
  std::vector<std::string> theorems;  // their names in Coq, in the order of what the claim prints; then of
                                      // the corrected form, then of the converse
  std::set<std::string> imports;      // names of other files
  std::string says;                   // the fingerprint of what its theorems say
  bool asked = true;                  // for it, or for one that rests on it
  std::size_t immediate = 0;     // how many of its theorems say no more than a definition, or an assumption
  bool many_enclosures = false;  // more interval arithmetic than coqchk is asked about: its file is its own
};

// A claim that has none, or none any more than in part.
struct Uncertified {
  std::string claim;
  std::string reason;
};

struct Certificates {
  std::vector<Certificate> certificates;  // each after those that it imports
  std::vector<Uncertified> uncertified;
  // All that coqc needs: prelude, definitions, statements (statement_files.hpp), certificates, Final.v, a
  // Makefile.
  std::vector<File> files;
};

// Of the claims with these ids (all if there are none) and of what they rest on, which the Makefile makes;
// and of those to be kept, which it makes on demand. Proves them first. Throws InternalError for an unknown
// id. After an interruption (core/interruption.hpp) only of some.
[[nodiscard]] Certificates certificates(const std::vector<methods::Claim>& claims,
                                        const std::set<std::string>& ids = {},
                                        const std::set<std::string>& kept = {},
                                        const std::vector<kernel::Definition>& abbreviations = {});

}  // namespace stickslip::proofs::certificates
