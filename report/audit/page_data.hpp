// What the templates of an audit see.
#pragma once

#include <vector>

#include "report/audit/summary.hpp"
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
// part of it; "findings" (finding_data) and "hypotheses_to_add".
[[nodiscard]] tools::Json page_data(const Audited& all, const tools::Json& json);

// The findings as the templates see them.

// Whether the claim compares printed numbers.
[[nodiscard]] bool compares(const tools::Json& claim);

// The groups in which a reader meets the findings, most important first: what is open; what the paper says
// and is not so, in the order of the remarks; by status, from the worst; what the paper takes for granted.
// Each
// {"title", "explanation", "count", "claims", "numbers", "hypotheses_groups": [{"hypotheses", "origins":
// [{"id", "words"}], "inherited_by", "inherited_by_count"}]}. `claims` are those of page_data, one for
// each record of the audit.
[[nodiscard]] tools::Json finding_data(const Audited& all, const std::vector<tools::Json>& claims);

// What a letter to the journal would correct.

// The corrections, from the claims as page_data() has them, in the order of the paper's statements: {"place",
// "heading": the place where it is another than before, else null, "misprint", "printed", "corrected",
// "numbers", "remark", "illegible"}. Printed numbers of one place make one.
[[nodiscard]] tools::Json errata_data(const proofs::methods::Paper& paper,
                                      const std::vector<tools::Json>& claims);

// Of the groups of hypotheses among the findings those that matter and of which no
// correction of their equation speaks.
[[nodiscard]] tools::Json hypotheses_to_add(const std::vector<tools::Json>& claims,
                                            const tools::Json& findings);

// Which part of the paper rests on which; which claim uses which stands with the claims.

// {"parts": [{"id", "title", "short": the title without its subject, "rests_on": [{"id", "title"}], "row":
// [{"short", "count", "weight"}]}]}: a part for every place; its row has for every place how many of its
// claims the proofs of the part use ("" if none), and 1 to 4 by how many these are (0 if none).
[[nodiscard]] tools::Json uses_of_places(const Audited& all);

}  // namespace stickslip::report::audit
