// What text and JSON of a simulated motion have, whatever the oscillator.
#pragma once

#include <fmt/format.h>

#include <array>
#include <vector>

#include "numeric/simulation/record.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

[[nodiscard]] inline tools::Json phase_names() {
  return tools::names_through(numeric::motion::PhaseKind::stick);
}

inline constexpr std::array all_phases{numeric::motion::PhaseKind::slip,
                                       numeric::motion::PhaseKind::overshoot,
                                       numeric::motion::PhaseKind::stick};

// Of the time.
template <class State>
[[nodiscard]] double share_of(numeric::motion::PhaseKind kind,
                              const numeric::simulation::RecordOf<State>& record) {
  return record.time_in.at(static_cast<std::size_t>(kind)) / record.done;
}

// "slip 60.000 %, overshoot 0.000 %, stick 40.000 %".
template <class State>
[[nodiscard]] std::string shares_in_words(const numeric::simulation::RecordOf<State>& record) {
  return tools::enumerated(all_phases, [&](numeric::motion::PhaseKind kind) {
    return fmt::format("{} {:.3f} %", to_string(kind), 100 * share_of(kind, record));
  });
}

// The first and the last events below the names, each as `row_of` makes it; empty where there was none.
template <class State, class RowOf>
[[nodiscard]] std::string event_table(const tools::Row& names,
                                      const numeric::simulation::RecordOf<State>& record,
                                      const tools::Style& style, const RowOf& row_of) {
  if (record.events == 0) {
    return "";
  }
  std::vector<tools::Row> rows{names};
  for (const auto& event : record.first_events) {
    rows.push_back(row_of(event));
  }
  const long left_out = record.events - std::ssize(record.first_events) - std::ssize(record.last_events);
  if (left_out > 0) {
    rows.push_back({{"  ..."}, {fmt::format("{} more", left_out)}});
    rows.back().resize(names.size(), {""});
  }
  for (const auto& event : record.last_events) {
    rows.push_back(row_of(event));
  }
  return "\n" + tools::columns_of(rows, style.width);
}

// "end" and "shares" of the time; `state` says what a state is.
template <class State>
void write_end(tools::Object& json, const numeric::simulation::RecordOf<State>& record, const char * state) {
  json.object("end", [&](tools::Object& to) {
    to.has("phase", record.end.phase, phase_names());
    to.has("state", record.end.X, state);
    to.has("r", record.end.r);
    to.has("u", record.end.u);
    to.has("energy", record.end.energy);
  });
  json.object(
      "shares",
      [&](tools::Object& to) {
        for (const numeric::motion::PhaseKind kind : all_phases) {
          to.has(to_string(kind), share_of(kind, record));
        }
      },
      "Of the time.");
}

// "events", each as `write_event` writes it.
template <class State, class WriteEvent>
void write_events(tools::Object& json, const numeric::simulation::RecordOf<State>& record,
                  const WriteEvent& write_event) {
  json.object("events", [&](tools::Object& to) {
    const tools::Json few = {{"maxItems", record.shown}};
    to.has("count", record.events, {{"minimum", 0}});
    to.list("first", record.first_events, write_event, few);
    to.list("last", record.last_events, write_event, few);
  });
}

}  // namespace stickslip::report::orbits
