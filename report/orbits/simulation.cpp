#include "report/orbits/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/named_data.hpp"
#include "report/orbits/attractors/attractors.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/record_json.hpp"
#include "report/tools/json.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric::motion;
using namespace numeric::simulation;
using namespace tools;

namespace {

std::string data_of(const Start& s) {
  return fmt::format("chi={}, eta={}, us={}, ur={}, V={}, omega={}, p={}, phi={}", s.data.chi, s.data.eta,
                     s.data.us, s.ur, s.data.V, s.data.omega, s.data.p, s.phi);
}

std::string events(const Record& record, const Style& style, const Units& units) {
  // In SI units lengths of a machine are small.
  const auto number = [&](double x) -> Cell {
    return {units.are_SI() ? fmt::format("{:.6g}", x) : fmt::format("{:.6f}", x)};
  };
  return event_table({{units.labelled("  event at t", "s")},
                      {"from"},
                      {"to"},
                      {units.labelled("r", "N")},
                      {units.labelled("x1", "m")},
                      {units.labelled("x2", "m")},
                      {units.labelled("x1'", "m/s")}},
                     record, style, [&](const Transition& e) -> Row {
                       return {{fmt::format("  {:.9g}", e.time)},
                               {to_string(e.before)},
                               {to_string(e.after)},
                               number(e.r),
                               number(e.X(0)),
                               number(e.X(1)),
                               number(e.X(2))};
                     });
}

}  // namespace

std::string terminal_report(const Simulated& simulated, const Style& style, const Units& units) {
  const Record record = units.record(simulated.record);
  const double periods = record.done / record.period;
  const std::vector<Coordinate> coordinates = coordinates_in(units);
  std::vector<Row> rows{
      {{"data"}, {data_of(record.start)}},
      {{"start"}, {state_in_words(record.start.X, coordinates)}},
      {{"simulated"},
       {fmt::format("{:.9g} periods of the load, t = {:.9g}{}{}", periods, record.done, units.unit(" s"),
                    record.interrupted ? "; interrupted" : "")}},
      {{"end"},
       {fmt::format("{}: {}", to_string(record.end.phase), state_in_words(record.end.X, coordinates))}},
      {{"shares"}, {shares_in_words(record)}},
      {{"energy"},
       {fmt::format("{:.6g}{} at the end", record.end.energy, units.unit(" J")) +
        (record.energy ? fmt::format("; between {:.6g} and {:.6g}{}", record.energy->least,
                                     record.energy->greatest, units.unit(" J"))
                       : "")}},
      {{"events"},
       {fmt::format("{}, {:.4g} in a period", record.events, static_cast<double>(record.events) / periods)}}};
  if (simulated.settles) {
    rows.push_back({{"settles"}, {in_words(*simulated.settles)}});
  }
  return columns_of(rows, style.width) + events(record, style, units);
}

namespace {

constexpr int digits_of_proof = 20;

std::vector<std::pair<std::string, double>> values_of(const Start& s) {
  auto values = model::with_names(s.data);
  values.emplace_back("phi", s.phi);
  values.emplace_back("ur", s.ur);
  return values;
}

constexpr const char * state_words = "x1, x2, x1', x2'.";

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

// The record is in the units.
void write_simulation(Object& json, const Simulated& simulated, const Units& units) {
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
  write_events(json, record, state_words);
  json.object_if(
      "settles", simulated.settles,
      [&](Object& to, const numeric::attractors::Attractor& a) {
        write_attractor(to, a, digits_of_proof, units, Share::untold);
      },
      "What the motion settles on when it goes on from its end: an attractor without shares; the proof is of "
      "orbits alone.");
}

}  // namespace

Json to_json(const Simulated& simulated, const Units& units) {
  Simulated told = simulated;
  told.record = units.record(told.record);
  return written(told, in_units(write_simulation, units));
}

File simulation_schema() {
  return schema_file("simulation", "stickslip simulate: a motion under the friction law, in double",
                     schema_by(Simulated{}, in_units(write_simulation)));
}

namespace {

std::string line(const Sample& s) {
  return fmt::format("{:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g}\n", s.time, s.X(0), s.X(1), s.X(2), s.X(3),
                     s.energy);
}

template <class Samples>
std::string lines(const Samples& samples) {
  std::string text;
  for (const Sample& s : samples) {
    text += line(s);
  }
  return text;
}

// The samples from the time on that are in one kind of phase; a blank line ends each stretch, which goes on
// to the first sample after it, so that the curve has no gaps.
std::string stretches(const std::deque<Sample>& samples, double from, PhaseKind kind) {
  std::string text;
  bool inside = false;
  for (const Sample& s : samples) {
    if (s.time < from) {
      continue;
    }
    const bool here = s.phase == kind;
    if (here || inside) {
      text += line(s);
    }
    if (inside && !here) {
      text += "\n";
    }
    inside = here;
  }
  return text;
}

}  // namespace

void PictureSamples::add(const Sample& sample) {
  last_.push_back(sample);
  const double from = sample.time - periods_at_end * period_;
  while (last_.size() > most_points && last_.front().time < from) {
    last_.pop_front();
  }
  if (count_++ % stride_ == 0) {
    all_times_.push_back(sample);
  }
  if (all_times_.size() > most_points) {  // every second one from now on
    std::size_t kept = 0;
    for (std::size_t k = 0; k < all_times_.size(); k += 2) {
      all_times_[kept++] = all_times_[k];
    }
    all_times_.resize(kept);
    stride_ *= 2;
  }
}

Json phase_tables(const std::deque<Sample>& samples, double from) {
  Json phases = Json::array();
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    const std::string table = stretches(samples, from, kind);
    if (!table.empty()) {
      phases.push_back({{"block", "$" + to_string(kind)},
                        {"kind", to_string(kind)},
                        {"colour", colour_of(kind)},
                        {"table", table},
                        {"first", phases.empty()}});
    }
  }
  return phases;
}

std::string plot_script(const Record& record, const PictureSamples& samples, PlotFormat format,
                        const Units& units) {
  const double from = std::max(0.0, record.done - PictureSamples::periods_at_end * record.period);
  const model::Parameters<double>& a = record.start.data;
  const Json data = {
      {"terminal", terminal(format, 1000, 760)},
      {"portrait", lines(samples.last())},
      {"history", lines(samples.all_times())},
      {"phases", phase_tables(samples.last(), from)},
      {"from", fmt::format("{:.8g}", from)},
      {"to", fmt::format("{:.8g}", record.done)},
      {"V", fmt::format("{:.8g}", units.velocity(a.V))},
      {"metres", units.unit(" in m")},
      {"speed", units.unit(" in m/s")},
      {"seconds", units.unit(" in s")},
      {"joules", units.unit(" in J")},
      {"periods", fmt::format("{:.6g}", record.done / record.period)},
      {"parameters",
       units.machine_or(fmt::format(
           "χ = {:.6g}, η = {:.6g}, u_s = {:.6g}, u_r = {:.6g}, V = {:.6g}, ω = {:.6g}, p = {:.6g}", a.chi,
           a.eta, a.us, record.start.ur, a.V, a.omega, a.p))}};
  return render_file("simulation.gp", data, plain_format);
}

}  // namespace stickslip::report::orbits
