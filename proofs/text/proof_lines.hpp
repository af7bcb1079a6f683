// Proofs named in a file of claims.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"
#include "proofs/symbols/parse.hpp"

namespace stickslip::proofs::text {

// What stands about a proof: its claim with all that it states and assumes, the names of the file, the claims
// before.
struct ProofPlace {
  const methods::Claim& claim;
  const symbols::Names& names;
  const std::vector<methods::Claim>& before;
};

// The proof that the line names:
//   normal form | definition | rewriting PREMISES | premises PREMISES | putting in PREMISES | inverse PREMISE
//   combination SUM; …   one for each printed equation: each product of the sum with one @id or @id#k
//   order SUM; …         one for each printed inequality: products of what is positive and any number of @id,
//   or one
//                        @id of an equation
//   counterexample at NAME = NUMBER, …
// with PREMISES: id [at NAME = EXPRESSION, …] [for EXPRESSION] [over EXPRESSION] [given id by id, …]; …
// @id#k is the difference of the sides of statement k, from 1, of an assumption of the claim, or else of a
// claim before it. Nothing: whatever method works (methods/automatic.hpp). Throws UsageError, or ParseError.
[[nodiscard]] methods::Proof proof_of(const ProofPlace& place, const std::string& line);

}  // namespace stickslip::proofs::text
