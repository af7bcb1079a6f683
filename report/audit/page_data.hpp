// What the templates of an audit see.
#pragma once

#include <vector>

#include "proofs/methods/paper.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// The JSON of the audit (json.hpp) and beside it: next to every "status" and "verdict" also "status_words"
// and "verdict_words"; in every claim "examined", "place_title", "words_sentence" and "needs", the hypotheses
// of the form that is proved, "origin_words" and "states", the statements of the paper that it states; each
// hypothesis with "foreign" unless it is the claim's own; shortened balls;
// in every comparison "rounded", the proved value with as many digits as are printed; "sections", the paper's
// statements section by section: [{"title", "statements"}]; "statuses_met", those that occur; "verdict_lead",
// "verdict_sentence", "sentence_of_ours" and "sentence_of_findings"; "numbers", the claims that compare
// printed numbers; "errata", what there is to correct, each {"place", "remark" or null, "misprint",
// "printed", "corrected", "numbers"}; "results", each with "found", what its claims found where that is a
// part of it; "findings" (finding_data.hpp) and "hypotheses_to_add".
[[nodiscard]] tools::Json page_data(const proofs::methods::Paper& paper, const proofs::methods::Audit& audit,
                                    const tools::Json& json);

}  // namespace stickslip::report::audit
