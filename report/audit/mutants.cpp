#include "report/audit/mutants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/audit/summary.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::audit {

using namespace proofs::checks;
using namespace tools;

namespace {

// By their fates.
constexpr std::array by_fate{&GateRow::refuted, &GateRow::unproved, &GateRow::meaningless, &GateRow::true_too,
                             &GateRow::survived};

void count(GateRow& row, const Mutant& mutant) {
  ++(row.*by_fate.at(static_cast<std::size_t>(mutant.fate)));
}

void count(GateRow& row, const Twin& twin) {
  ++row.twins;
  row.twins_proved += twin.verdict.truth == Truth::proved ? 1 : 0;
}

// Rows in the order in which their names first occur.
template <class Name>
std::vector<GateRow> rows_by(const Gate& gate, const Name& name) {
  std::vector<GateRow> rows;
  const auto add = [&](const auto& one) {
    auto row = std::ranges::find(rows, name(one), &GateRow::name);
    if (row == rows.end()) {
      rows.push_back({.name = name(one)});
      row = std::prev(rows.end());
    }
    count(*row, one);
  };
  std::ranges::for_each(gate.mutants, add);
  std::ranges::for_each(gate.twins, add);
  return rows;
}

void write_row(Object& json, const GateRow& row) {
  json.has("name", row.name);
  json.has("mutants", row.mutants());
  json.has("refuted", row.refuted);
  json.has("unproved", row.unproved);
  json.has("meaningless", row.meaningless);
  json.has("true_too", row.true_too);
  json.has("survived", row.survived);
  json.has("kill_rate", row.kill_rate());
  json.has("twins", row.twins);
  json.has("twins_proved", row.twins_proved);
}

// Those that are true, with why, and those that should not be.
std::vector<const Mutant *> proved(const Gate& gate) {
  std::vector<const Mutant *> result;
  for (const Mutant& mutant : gate.mutants) {
    if (mutant.fate == Fate::survived || mutant.fate == Fate::equivalent) {
      result.push_back(&mutant);
    }
  }
  return result;
}

std::string sampling_line(const Gate& gate) {
  return gate.sampling.one_in <= 1
             ? "all of them"
             : fmt::format("a sample, one in {}, seed {}", gate.sampling.one_in, gate.sampling.seed);
}

Row cells(const GateRow& row) {
  return {{row.name},
          {std::to_string(row.mutants())},
          {std::to_string(row.refuted)},
          {std::to_string(row.unproved)},
          {std::to_string(row.meaningless)},
          {std::to_string(row.true_too)},
          {std::to_string(row.survived)},
          {row.kill_rate()},
          {fmt::format("{}/{}", row.twins_proved, row.twins)}};
}

}  // namespace

std::string GateRow::kill_rate() const {
  return wrong() == 0 ? "-" : fmt::format("{} %", 100 * (refuted + unproved) / wrong());
}

std::vector<GateRow> rows_by_kind(const Gate& gate) {
  return rows_by(gate, [](const auto& one) { return to_string(one.kind); });
}
std::vector<GateRow> rows_by_place(const Gate& gate) {
  return rows_by(gate, [](const auto& one) { return one.place; });
}
GateRow row_of_all(const Gate& gate) {
  const std::vector<GateRow> rows = rows_by(gate, [](const auto&) { return std::string("all"); });
  return rows.empty() ? GateRow{.name = "all"} : rows.front();
}

void write_gate(Object& json, const Gate& gate) {
  json.has("seed", gate.sampling.seed);
  json.has("one_in", gate.sampling.one_in, {{"minimum", 1}});
  json.has("drawn", sampling_line(gate));
  json.object("all", [&](Object& to) { write_row(to, row_of_all(gate)); });
  json.list("kinds", rows_by_kind(gate), write_row);
  json.list("places", rows_by_place(gate), write_row);
  json.has("has_proved", !proved(gate).empty());
  json.list(
      "proved", proved(gate),
      [](Object& to, const Mutant& mutant) {
        to.has("claim", mutant.claim);
        to.has("statement", mutant.statement);
        to.has("fate", mutant.fate, names_through(Fate::survived, Fate::equivalent));
        to.has("reason", plain(mutant.reason));
      },
      "The mutants that are proved, and why they are true.");
}

std::string terminal_mutants(const Gate& gate, const Style& style) {
  std::vector<Row> rows{{{"edit"},
                         {"mutants"},
                         {"refuted"},
                         {"unproved"},
                         {"void"},
                         {"true"},
                         {"survived"},
                         {"killed"},
                         {"twins proved"}}};
  for (const std::vector<GateRow>& part : {rows_by_kind(gate), rows_by_place(gate), {row_of_all(gate)}}) {
    std::ranges::transform(part, std::back_inserter(rows), cells);
  }
  std::string result =
      "Wrong statements on purpose: " + sampling_line(gate) + "\n" + columns_of(rows, style.width);
  for (const Mutant * mutant : proved(gate)) {
    if (mutant->fate == Fate::survived) {
      result += fmt::format("survived  {}: {}\n          {}\n", mutant->claim, mutant->statement,
                            plain(mutant->reason));
    }
  }
  return result;
}

}  // namespace stickslip::report::audit
