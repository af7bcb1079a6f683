#include <fmt/format.h>

#include "report/orbits/attractors.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/simulation.hpp"

namespace stickslip::report::orbits {

using namespace numeric::motion;
using namespace numeric::simulation;
using namespace tools;

namespace {

constexpr int digits_of_proof = 20;

Json state(const model::Vector4<double>& X) {
  return {X(0), X(1), X(2), X(3)};
}

Json parameters(const Start& s) {
  return {{"chi", s.data.chi},     {"eta", s.data.eta}, {"us", s.data.us}, {"V", s.data.V},
          {"omega", s.data.omega}, {"p", s.data.p},     {"phi", s.phi},    {"ur", s.ur}};
}

Json events(const std::vector<Transition>& all) {
  return list_of(all, [](const Transition& e) -> Json {
    return {{"t", e.time},
            {"from", to_string(e.before)},
            {"to", to_string(e.after)},
            {"r", e.r},
            {"state", state(e.X)}};
  });
}

// Doubles are printed so that they are read back as they are.
std::string command_of(const Simulated& simulated) {
  std::string command = "stickslip simulate";
  const Json all = parameters(simulated.record.start);
  for (const auto& [name, value] : all.items()) {
    command += fmt::format(" --{}={}", name, value.get<double>());
  }
  const model::Vector4<double>& X = simulated.record.start.X;
  command += fmt::format(" --state={},{},{},{} --periods={}", X(0), X(1), X(2), X(3), simulated.periods);
  return command + (simulated.every ? fmt::format(" --every={}", *simulated.every) : "");
}

}  // namespace

Json to_json(const Simulated& simulated) {
  const Record& record = simulated.record;
  Json json = provenance(command_of(simulated));
  json["parameters"] = parameters(record.start);
  json["start"] = state(record.start.X);
  json["periods"] = simulated.periods;
  json["done"] = {{"periods", record.done / record.period}, {"t", record.done}};
  json["interrupted"] = record.interrupted;
  json["end"] = {{"phase", to_string(record.end.phase)},
                 {"state", state(record.end.X)},
                 {"r", record.end.r},
                 {"u", record.end.u},
                 {"energy", record.end.energy}};
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    json["shares"][to_string(kind)] = record.time_in[static_cast<std::size_t>(kind)] / record.done;
  }
  json["samples"] = record.samples;
  if (record.energy) {
    json["energy"] = {{"least", record.energy->least}, {"greatest", record.energy->greatest}};
  }
  json["events"] = {
      {"count", record.events}, {"first", events(record.first_events)}, {"last", events(record.last_events)}};
  if (simulated.settles) {
    json["settles"] = to_json(*simulated.settles, digits_of_proof);
    for (const char * of_many : {"share", "share_interval", "count"}) {
      json["settles"].erase(of_many);
    }
  }
  return json;
}

}  // namespace stickslip::report::orbits
