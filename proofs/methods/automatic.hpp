// Proofs of statements for which nobody names a method.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::symbols {
struct Names;
}

namespace stickslip::proofs::methods {

// A statement of one's own and what it assumes, in the paper's symbols and further ones, as typed: the
// notation is that of symbols/parse.hpp.
struct OwnStatement {
  std::string statement;
  std::vector<std::string> assumptions = {};
  std::vector<std::string> symbols = {};  // of numbers, beside the paper's
  std::string symbols_by = {};            // what names them, for messages: "--symbols "
};

inline constexpr const char * own_id = "own";

// As a claim with the id `own`, proved automatically from its assumptions.
// Throws symbols::ParseError for what cannot be read, UsageError for a further symbol that is one of the
// paper's, or no name.
[[nodiscard]] Claim own_claim(const OwnStatement& own);

// The symbol that looks in LaTeX as one of that other name would, as x1 does like x_1: with both a formula
// would be printed that says something else. Empty if there is none.
[[nodiscard]] std::string looks_like(const std::string& name, const symbols::Names& known);

// Each printed statement by the first of these that derives it: the normal form of both sides; from what is
// assumed, the equations solved for one of their symbols each and put in; combined as polynomials; for
// matrices, equals put for equals; inequalities added, and multiplied by what is positive; what a
// claim before it says. Where none does, points drawn at random are looked at: where all that is assumed
// holds, and a statement fails, it is refuted. Undecided otherwise: the methods are not complete.
[[nodiscard]] Proof automatically();

}  // namespace stickslip::proofs::methods
