// An audit on a terminal.
#pragma once

#include <string>
#include <vector>

#include "report/audit/certificate_record.hpp"
#include "report/audit/summary.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::audit {

// The table of all claims by place, each with its origin unless it is the paper's; the findings with their
// reasons; the printed numbers; the summary line; what Coq certified. No line is longer than the width of the
// style.
[[nodiscard]] std::string terminal_report(const Audited& all, const tools::Style& style,
                                          const Certification& certificates = {});

// One line per claim, however long: id, status, words; then the summary line.
[[nodiscard]] std::string terminal_lines(const Audited& all, const tools::Style& style);

// Every claim with all that is known about it, then the summary line.
[[nodiscard]] std::string terminal_explanations(const Audited& all, const tools::Style& style);

// A single claim: whether it holds, what it says, and why; where, or what would be true in its place.
[[nodiscard]] std::string terminal_answer(const proofs::methods::Record& record, const tools::Style& style);

// The claims without verdicts: id, kind, origin, words; one line each.
[[nodiscard]] std::string terminal_list(const std::vector<proofs::methods::Claim>& claims);

}  // namespace stickslip::report::audit
