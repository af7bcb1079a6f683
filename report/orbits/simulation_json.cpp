#include <fmt/format.h>

#include "model/named_data.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/record_json.hpp"
#include "report/orbits/simulation.hpp"

namespace stickslip::report::orbits {

using namespace numeric::motion;
using namespace numeric::simulation;
using namespace tools;

namespace {

constexpr int digits_of_proof = 20;

std::vector<std::pair<std::string, double>> values_of(const Start& s) {
  auto values = model::with_names(s.data);
  values.emplace_back("phi", s.phi);
  values.emplace_back("ur", s.ur);
  return values;
}

constexpr const char * state_words = "x1, x2, x1', x2'.";

void write_event(Object& json, const Transition& e) {
  json.has("t", e.time);
  json.has("from", e.before, phase_names());
  json.has("to", e.after, phase_names());
  json.has("r", e.r);
  json.has("state", e.X, state_words);
}

// Doubles are printed so that they are read back as they are.
std::string command_of(const Simulated& simulated) {
  std::string command = "stickslip simulate";
  for (const auto& [name, value] : values_of(simulated.record.start)) {
    command += fmt::format(" --{}={}", name, value);
  }
  const model::Vector4<double>& X = simulated.record.start.X;
  command += fmt::format(" --state={},{},{},{} --periods={}", X(0), X(1), X(2), X(3), simulated.periods);
  return command + (simulated.every ? fmt::format(" --every={}", *simulated.every) : "");
}

void write_simulation(Object& json, const Simulated& simulated) {
  const Record& record = simulated.record;
  write_origin(json, command_of(simulated));
  json.object("parameters", [&](Object& to) {
    to.each(values_of(record.start), {"chi", "eta", "us", "V", "omega", "p", "phi", "ur"});
  });
  json.has("start", record.start.X, state_words);
  json.has("periods", simulated.periods,
           with({{"exclusiveMinimum", 0}}, "Of the load: those that were asked for."));
  json.object("done", [&](Object& to) {
    to.has("periods", record.done / record.period);
    to.has("t", record.done);
  });
  json.has("interrupted", record.interrupted);
  write_end(json, record, state_words);
  json.has("samples", record.samples, with({{"minimum", 0}}, "Written elsewhere."));
  json.object_if(
      "energy", record.energy,
      [](Object& to, const Extremes& energy) {
        to.has("least", energy.least);
        to.has("greatest", energy.greatest);
      },
      "Of the samples.");
  write_events(json, record, write_event);
  json.object_if(
      "settles", simulated.settles,
      [](Object& to, const numeric::attractors::Attractor& a) {
        write_attractor(to, a, digits_of_proof, Share::untold);
      },
      "What the motion settles on when it goes on from its end: an attractor without shares; the proof is of "
      "orbits alone.");
}

}  // namespace

Json to_json(const Simulated& simulated) {
  return written(simulated, write_simulation);
}

File simulation_schema() {
  return schema_file("simulation", "stickslip simulate: a motion under the friction law, in double",
                     schema_by(Simulated{}, write_simulation));
}

}  // namespace stickslip::report::orbits
