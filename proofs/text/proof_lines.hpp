// Proofs named in a file of claims.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/methods/claim.hpp"
#include "proofs/symbols/parse.hpp"

namespace stickslip::proofs::text {

// What proofs may speak of: the names of the file, and what claims state, by their ids, in the form that is
// proved.
struct ProofContext {
  symbols::Names names;
  std::map<std::string, std::vector<symbols::Statement>> said;
};

// The proof that the line names, of the claim with all that it states and assumes:
//   normal form [of STATEMENT; …] | definition | rewriting PREMISES | premises PREMISES | putting in PREMISES
//   inverse PREMISE | combination SUM; … | order CERTIFICATE; … [positive PREMISE]
//   nonzero ID times EXPRESSION | zero of cosine EXPRESSION; PREMISE; NUMBER; NUMBER
//   flow EXPRESSION; EXPRESSION; ID [from ID] | mean value EXPRESSION; ID; ID; ID; ID; ID
//   chain rule PREMISES [later EXPRESSION] | decrease PREMISE; EXPRESSION
//   periodic decrease PREMISE; EXPRESSION; ID; …
//   instances PREMISE [times EXPRESSION] [with FUNCTION = EXPRESSION, …] [supplied PREMISE, …]; …
//   counterexample at NAME = NUMBER, … [; where STATEMENTS] [; with STATEMENTS] [; not STATEMENTS]
// with
//   PREMISES: [claim] ID [at NAME = EXPRESSION, …] [for EXPRESSION] [over EXPRESSION] [given ID by ID, …]; …
//   SUM, one for each printed equation: each product of it with one @ID or @ID#K, of a claim perhaps at other
//   values, @ID[t = tau]#K: the difference of the sides of statement K, from 1
//   CERTIFICATE, one for each printed inequality: SUM [times SUM], whose products are of what is positive and
//   of any number of @ID of inequalities, or of one @ID of an equation
// in the order in which methods/methods.hpp, implications.hpp and motions.hpp have them. An ID is that of an
// assumption of the claim, or else of a claim of the context; `claim ID` is the claim. Nothing: whatever
// method works (methods/automatic.hpp). Throws UsageError, or ParseError.
[[nodiscard]] methods::Proof proof_of(const methods::Claim& claim, const ProofContext& context,
                                      const std::string& line);

// Without blanks at either end.
[[nodiscard]] std::string trimmed(std::string_view text);

}  // namespace stickslip::proofs::text
