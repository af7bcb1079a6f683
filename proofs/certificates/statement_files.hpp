// The files in which a referee reads what is certified, and by which Coq is asked whether it is: what the
// statements mean depends on these and on the prelude alone.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofs/certificates/certificates.hpp"
#include "proofs/certificates/statements.hpp"
#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::certificates {

inline constexpr const char *definitions_name = "Definitions.v", *auxiliary_name = "Auxiliary.v",
                            *statements_name = "Statements.v", *final_name = "Final.v";

// Records with theorems, each of which has a certificate, in the paper's order.
using Records = std::vector<const methods::Record *>;

// All that the statements speak of. Throws KernelError if two definitions have one name.
[[nodiscard]] std::vector<kernel::Definition> definitions_of(const Records& records);
// Definitions.v: these, in Coq. What only lemmas speak of is not among them.
[[nodiscard]] std::string definitions_file(const Records& records);

// Statements.v: "Definition claim_44_H_1 : Prop := …" for each theorem, after a comment that says in words
// what this very theorem says. Long parts that stand in many of them have the names of these abbreviations,
// which are defined before.
[[nodiscard]] std::string statements_file(const Records& records,
                                          const std::vector<kernel::Definition>& abbreviations);

// A file of theorems: "Claim_44_H", {"claim_44_H_1", …}.
struct Proved {
  std::string file;
  std::vector<std::string> theorems;
};
// Final.v: checks that each of the theorems is of the type that Statements.v has under its name, and asks
// what all of them rest on. A line for each file, and after these for each theorem, so that the number of the
// line that Coq refuses says which it is.
[[nodiscard]] std::string final_file(const std::vector<Proved>& proved);

// How make has Coq check a directory of certificates.

// make -k -j: has coqc compile the certificates that were asked for and the statements, each file in a
// process of its own, the longest first; what it says of each is in NAME.log, with the seconds. make
// Final.vo: compiles Final.v, after all others. The sizes of files are in characters, by their names without
// ".v".
[[nodiscard]] std::string makefile(const std::vector<Certificate>& certificates,
                                   const std::map<std::string, std::size_t>& sizes);

// Statements with names for what is long and stands in many of them.

// The term with each part that is the body of one of these definitions, of whatever arguments, as that
// definition applied. It unfolds to the term.
[[nodiscard]] kernel::Term shortened(const kernel::Term& term,
                                     const std::vector<kernel::Definition>& abbreviations);

}  // namespace stickslip::proofs::certificates
