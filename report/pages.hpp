// The pages of an audit.
#pragma once

#include <string>
#include <vector>

#include "report/files.hpp"
#include "report/json.hpp"

namespace stickslip::report {

// What the templates see: the JSON of the audit, and beside every "status" and "verdict" also "status_words"
// and "verdict_words", without underscores; in every claim "examined" (it is no part of the model) and
// "needs" (the hypotheses of the form that is proved); in every comparison "proved_short" and
// "units_off_short"; at the top "findings" and "numbers", the claims that are findings or that compare
// printed numbers.
[[nodiscard]] Json page_data(const Json& audit);

// audit.json, index.html and audit.tex. Throws InputOutputError if a template cannot be read.
[[nodiscard]] std::vector<File> pages(const proofs::Audit& audit);

}  // namespace stickslip::report
