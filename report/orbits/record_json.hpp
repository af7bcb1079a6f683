// What text, JSON and tables of a simulated motion have, whatever the oscillator.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "numeric/simulation/record.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
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

// "events", with the pieces of the friction law where it may have several; `state` says what a state is.
template <class State>
void write_events(tools::Object& json, const numeric::simulation::RecordOf<State>& record,
                  const char * state) {
  const auto write_event = [state](tools::Object& to, const numeric::simulation::TransitionOf<State>& event) {
    to.has("t", event.time);
    to.has("from", event.before, phase_names());
    to.has("to", event.after, phase_names());
    if constexpr (State::SizeAtCompileTime == Eigen::Dynamic) {
      to.has("from_piece", event.piece_before + 1, {{"minimum", 1}});
      to.has("to_piece", event.piece_after + 1, {{"minimum", 1}});
    }
    to.has("r", event.r);
    to.has("state", event.X, state);
  };
  json.object("events", [&](tools::Object& to) {
    const tools::Json few = {{"maxItems", record.shown}};
    to.has("count", record.events, {{"minimum", 0}});
    to.list("first", record.first_events, write_event, few);
    to.list("last", record.last_events, write_event, few);
  });
}

// A line of names, with their units if they are in SI; a line for a sample: t, phase, the coordinates, r, u,
// E; numbers with 17 digits.
[[nodiscard]] inline std::string csv_names(const std::vector<Coordinate>& coordinates) {
  const bool in_SI = !coordinates.front().unit.empty();
  return fmt::format("t{},phase,{},r{},u{},E{}\n", in_SI ? " in s" : "",
                     tools::enumerated(coordinates, named, ","), in_SI ? " in N" : "", in_SI ? " in N" : "",
                     in_SI ? " in J" : "");
}
template <class State>
[[nodiscard]] std::string csv_line(const numeric::simulation::SampleOf<State>& s) {
  return fmt::format("{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g}\n", s.time, to_string(s.phase),
                     fmt::join(s.X.data(), s.X.data() + s.X.size(), ","), s.r, s.u, s.energy);
}

}  // namespace stickslip::report::orbits
