// What became of the wrong statements made on purpose, as a table.
#pragma once

#include <string>
#include <vector>

#include "proofs/checks/mutants.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::audit {

// Counts of one kind of edit, or of one place of the paper, or of all.
struct GateRow {
  std::string name;
  std::size_t refuted = 0, unproved = 0, meaningless = 0, true_too = 0, survived = 0;
  std::size_t twins = 0, twins_proved = 0;

  [[nodiscard]] std::size_t mutants() const { return refuted + unproved + meaningless + true_too + survived; }
  // Wrong statements that have a meaning.
  [[nodiscard]] std::size_t wrong() const { return refuted + unproved + survived; }
  // "100 %", rounded down; of nothing "-".
  [[nodiscard]] std::string kill_rate() const;
};

[[nodiscard]] std::vector<GateRow> rows_by_kind(const proofs::checks::Gate& gate);
[[nodiscard]] std::vector<GateRow> rows_by_place(const proofs::checks::Gate& gate);
[[nodiscard]] GateRow row_of_all(const proofs::checks::Gate& gate);

// As "mutants" in the JSON of an audit.
void write_gate(tools::Object& json, const proofs::checks::Gate& gate);

// The tables, the survivors, and how the sample was drawn.
[[nodiscard]] std::string terminal_mutants(const proofs::checks::Gate& gate, const tools::Style& style);

}  // namespace stickslip::report::audit
