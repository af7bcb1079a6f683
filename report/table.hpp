// An audit on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "proofs/claim.hpp"

namespace stickslip::report {

struct Style {
  bool colour = false;
  std::size_t width = 80;
};

// The table of all statements by place; the findings with their reasons; the printed numbers; the summary
// line. No line is longer than the width of the style.
[[nodiscard]] std::string terminal_report(const proofs::Audit& audit, const Style& style);

// One line per statement, however long: id, status, words; then the summary line.
[[nodiscard]] std::string terminal_lines(const proofs::Audit& audit, const Style& style);

// Every statement with all that is known about it, then the summary line.
[[nodiscard]] std::string terminal_explanations(const proofs::Audit& audit, const Style& style);

// The statements without verdicts: id, kind, words; one line each.
[[nodiscard]] std::string terminal_list(const std::vector<proofs::Claim>& claims);

}  // namespace stickslip::report
