// What the JSON of a simulated motion has, whatever the oscillator.
#pragma once

#include "numeric/simulation/record.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

[[nodiscard]] inline tools::Json phase_names() {
  return tools::names_through(numeric::motion::PhaseKind::stick);
}

// "end" and "shares" of the time; `state` says what a state is.
template <class State>
void write_end(tools::Object& json, const numeric::simulation::RecordOf<State>& record, const char * state) {
  using numeric::motion::PhaseKind;
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
        for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
          to.has(to_string(kind), record.time_in.at(static_cast<std::size_t>(kind)) / record.done);
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
