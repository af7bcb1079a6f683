// Papers as text: symbols, abbreviations, assumptions and claims with their proofs, from a file.
// doc/claims.md has the format.
//
//   paper                                         of its own: none of the oscillator's symbols from here on
//     author J. P. Den Hartog
//   symbols X, a, f, omega in 0 < omega           numbers, and the domain that every claim supposes
//   let q = a/(1 - omega^2)                       put in where it is read
//   let place(s) = (X - f) cos(s) + f
//   section closing Symmetric motions
//   assume returns: place(pi/omega) = -X
//   claim closing.cosine theorem textbook: a symmetric motion has $X = q cos(phi)$
//     X = q cos(phi)
//     if returns
//     by combination 1/2*@returns
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::text {

// What is made in C++.
struct Programs {
  std::map<std::string, std::vector<methods::Claim>> claims = {};  // that an entry `program NAME` stands for
  std::map<std::string, methods::Proof> proofs = {};  // of claims with a line `by program`, by their ids
};

// Without an entry `paper` the file stands on the known paper: its symbols and claims, to which those of the
// file are added, are at hand. A text with programs is a part of this program: its proofs may use claims that
// follow, and its words are printed as they are. Throws UsageError, or symbols::ParseError, that begins with
// `name` and the number of the line.
[[nodiscard]] methods::Paper read_claims(const std::string& content, const std::string& name,
                                         const methods::Paper& known, const Programs * programs = nullptr);

}  // namespace stickslip::proofs::text
