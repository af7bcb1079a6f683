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

// Claims that are made in C++, by the names under which entries `program NAME` of a text call them; or of one
// its proof, which a line `by program` calls by the id of its claim.
using Programs = std::map<std::string, std::vector<methods::Claim>>;

// Without an entry `paper` the file stands on the known paper: its symbols and claims, to which those of the
// file are added, are at hand. A text with programs is a part of this program: its proofs may use claims that
// follow, and its words are printed as they are. Throws UsageError, or symbols::ParseError, that begins with
// `name` and the number of the line.
[[nodiscard]] methods::Paper read_claims(const std::string& content, const std::string& name,
                                         const methods::Paper& known, const Programs& programs = {});

}  // namespace stickslip::proofs::text
