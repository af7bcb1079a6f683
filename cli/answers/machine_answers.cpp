#include "cli/answers/machine_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cli/answers/asked.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "model/named_data.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/machines/orbits/machine_branch.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

using namespace numeric::machines;
using numeric::simulation::AnyState;
using numeric::words::Word;

namespace {

// Beside the file nothing says anything about the machine; nor do these options go with it.
void refuse_others(const GivenMachine& o, const std::string& file, bool takes_phi,
                   const std::vector<std::string>& options) {
  for (const auto& [name, text] : o.parameters) {
    if (!takes_phi || name != "phi") {
      throw UsageError(fmt::format(
          "{} is a machine in tables: its data stand in it alone, --{} does not go with it", file, name));
    }
  }
  if (!o.example.empty()) {
    throw UsageError(fmt::format("{} is a machine in tables: --example does not go with it", file));
  }
  if (o.si) {
    throw UsageError(fmt::format("{} says what its units are: --units does not go with it", file));
  }
  for (const std::string& name : options) {
    if (o.typed.contains(name)) {
      throw UsageError(fmt::format("{} does not go with a machine in tables, {}", name, file));
    }
  }
}

AnyState state_for(const GivenInTables& given, const char * name, const State& state) {
  const std::size_t n = given.machine.oscillator.size();
  if (state.size() != 2 * n) {
    throw UsageError(
        fmt::format("{}: the positions of the {} {} and then their velocities are {} numbers, not {}", name,
                    n, n == 1 ? "mass" : "masses", 2 * n, state.size()));
  }
  constexpr double greatest = 1e100;
  for (const double x : state) {
    if (!(std::abs(x) <= greatest)) {
      throw DomainError(fmt::format("a number of {}", name), fmt::format("{}", x), "from -1e100 to 1e100");
    }
  }
  return Eigen::Map<const AnyState>(state.data(), static_cast<Eigen::Index>(state.size()));
}

Word word_for(const GivenInTables& given, const std::string& text, const char * command) {
  if (!numeric::words::looks_like_word(text)) {
    throw UsageError(
        fmt::format("stickslip {} of a machine in tables, {}, is for a word of phases such as OTS, not for a "
                    "family of the paper's oscillator",
                    command, given.origin.file));
  }
  return Word::parse(text);
}

MachineWord question_for(const GivenInTables& given, const std::string& text, const char * command,
                         std::optional<int> period, const std::optional<State>& near) {
  MachineWord q{given.machine, word_for(given, text, command), {}, {}};
  if (period && q.machine.oscillator.is_autonomous()) {
    throw UsageError(
        fmt::format("--period counts periods of the load, and {} has none that varies", given.origin.file));
  }
  q.periods = period ? std::optional<long>(*period) : std::nullopt;
  if (near) {
    q.near = state_for(given, "near", *near);
  }
  return q;
}

struct AlongPath {
  report::machines::Varied varied;  // without a start
  std::function<Machine(const Rational&)> at;
};

AlongPath along_path(const GivenInTables& given, const Ranges& along) {
  if (along.empty()) {
    throw UsageError(fmt::format(
        "what varies is missing: --along PATH A..B, PATH such as belt.velocity in {}", given.origin.file));
  }
  if (along.size() > 1) {
    throw UsageError(fmt::format("--along is for one number here, not for {} of them", along.size()));
  }
  const std::string& path = along.front().first;
  const auto [from, to] = interval(path, along.front().second);
  return {{path, from, to, {}}, [with = given.with, path](const Rational& value) {
            return with({{path, value}});
          }};
}

// Where motions are looked for: at what the file says, or in the middle where that is not in the interval.
Rational start_in(const GivenInTables& given, const std::string& path, const Rational& from,
                  const Rational& to) {
  const Rational in_file = given.value(path);
  return from <= in_file && in_file <= to ? in_file : Rational((from + to) / 2);
}

// Of the motions that were found those that are asked for, by their places; `at` says where.
std::vector<std::size_t> wanted(const MachineWordOrbits& found, const BranchOptions& o,
                                const std::string& at) {
  if (o.orbit && static_cast<std::size_t>(*o.orbit) > found.orbits.size()) {
    throw UsageError(fmt::format("orbit: there is no orbit {} through {} at {}, there are {}", *o.orbit,
                                 found.question.word.letters(), at, found.orbits.size()));
  }
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < found.orbits.size(); ++k) {
    if (o.orbit ? k + 1 == static_cast<std::size_t>(*o.orbit)
                : o.all || found.orbits[k].admissible.truth == Truth::proved) {
      places.push_back(k);
    }
  }
  return places;
}

report::machines::FromOrbits from_orbits(const GivenInTables& given, const MachineWordOrbits& found,
                                         const BranchOptions& o) {
  return {found.question, given.origin, o.orbit, o.all, found.seen, found.interrupted};
}

void surround(MachineOrbit& orbit, const Machine& machine) {
  orbit.neighbourhood = std::make_shared<Neighbourhood>(neighbourhood_of(machine, orbit));
}

}  // namespace

GivenInTables as_tables(const numeric::words::WordQuestion& machine, const ParameterFile& file,
                        const report::orbits::Units& units, const char * why) {
  if (file.machine && !units.are_SI()) {
    throw UsageError(
        fmt::format("{} takes a machine in SI units, such as {}, in these: add --units si", why, file.name));
  }
  if (file.machine) {
    if (!file.machine->machine.friction_at_rest) {
      throw UsageError(
          fmt::format("{} takes the machine of {}, and the friction at rest of that orbit is another one, a "
                      "result: give --state",
                      why, file.name));
    }
    const auto value = [all = file.in_SI](const std::string& name) {
      const auto found = all.find(name);
      if (found == all.end() || name == "load_phase") {
        throw UsageError(fmt::format("along: {} is no value of the machine that can vary", name));
      }
      return exact_number(name, found->second);
    };
    const auto with = [value, all = file.in_SI, name = file.name](const std::vector<Datum>& data) {
      TypedParameters there = all;
      for (const Datum& datum : data) {
        (void)value(datum.path);
        there[datum.path] = to_string(datum.value);
      }
      return machine_of(machine_in_SI(there, name, FrictionAtRest::needed));
    };
    return {{file.name, true, "--params " + file.name + " --units si"},
            machine_of(file.machine->machine),
            with,
            value};
  }
  std::string options;
  for (const auto& [name, member] : model::named_data<Rational>) {
    options += fmt::format("--{} {} ", name, to_string(machine.data.*member));
  }
  const auto place = [](model::Parameters<Rational>& data, Rational& ur, const std::string& name) {
    const auto& named = model::named_data<Rational>;
    const auto * const member =
        std::ranges::find_if(named, [&](const auto& one) { return one.first == name; });
    if (name != "ur" && member == named.end()) {
      throw UsageError(fmt::format("along: {} is none of chi, eta, us, V, omega, p, ur", name));
    }
    return name == "ur" ? &ur : &(data.*(member->second));
  };
  const auto with = [place, machine](const std::vector<Datum>& data) {
    auto there = machine;
    for (const Datum& datum : data) {
      *place(there.data, there.ur, datum.path) = datum.value;
    }
    return Machine{model::friction_oscillator<Rational>(there.data, there.ur)};
  };
  const auto value = [place, machine](const std::string& name) {
    auto there = machine;
    return *place(there.data, there.ur, name);
  };
  return {
      {"the paper's oscillator", false, options + "--ur " + to_string(machine.ur)}, with({}), with, value};
}

std::pair<GivenInTables, BranchOptions> box_in_tables(const BranchOptions& o,
                                                      const proofs::methods::Examples& examples) {
  if (!numeric::words::looks_like_word(o.family)) {
    throw UsageError(
        "several --along are for a word of phases such as OTS; of a family stickslip atlas maps a box");
  }
  const auto asked = asked_box(o, examples);
  return {as_tables(asked.question, asked.file, asked.units, "a box of data"), without_machine(o)};
}

std::optional<GivenInTables> given_in_tables(const GivenMachine& options) {
  if (options.file.values || options.file.empty()) {
    return std::nullopt;
  }
  const std::string text = report::tools::read_file(options.file.name);
  const auto read = machine_in_tables(text, options.file.name);
  if (!read) {
    return std::nullopt;
  }
  const std::string& file = options.file.name;
  return GivenInTables{
      {file, read->in_SI},
      read->machine,
      [text, file](const std::vector<Datum>& data) { return machine_in_tables(text, file, data)->machine; },
      [text, file](const std::string& path) { return value_in_tables(text, file, path); }};
}

namespace {

MachineStarts starts_of(const GivenInTables& given, const AttractorsOptions& o, int starts) {
  refuse_others(o, given.origin.file, false, {});
  require_sense(o);
  return {given.machine, o.starts.value_or(starts), static_cast<std::uint64_t>(o.seed.value_or(1)),
          o.most_periods.value_or(AttractorsOptions::default_most_periods),
          o.digits.value_or(OrbitsOptions::default_digits)};
}

}  // namespace

report::machines::Attractors answer(const GivenInTables& given, const AttractorsOptions& o) {
  report::machines::Attractors list{find_attractors(starts_of(given, o, AttractorsOptions::default_starts)),
                                    given.origin};
  for (MachineAttractor& a : list.attractors) {
    if (o.neighbourhood && a.orbit) {
      surround(*a.orbit, given.machine);
    }
  }
  return list;
}

report::machines::Diagram diagram_answer(const GivenInTables& given, const AttractorsOptions& o) {
  MachineDiagram diagram;
  diagram.question = starts_of(given, o, AttractorsOptions::default_starts_at_value);
  const auto [varied, at] = along_path(given, o.along);
  (void)given.value(varied.path);
  diagram.at = at;
  diagram.from = varied.from;
  diagram.to = varied.to;
  diagram.values = values_of(o);
  return {along(std::move(diagram)), varied.path, given.origin};
}

report::machines::Basins basins_answer(const GivenInTables& given, const AttractorsOptions& o) {
  MachineBasins basins;
  basins.question = starts_of(given, o, 1);
  basins.across = plane("plane", o.plane.value(), given.machine.oscillator.size());
  const long pixels = pixels_of(o);
  basins.pixels = {pixels, pixels};
  if (o.through) {
    basins.through = state_for(given, "through", *o.through);
  }
  if (o.window) {
    const State& half = *o.window;
    if (half.size() != 2 || !(half[0] > 0) || !(half[1] > 0)) {
      throw UsageError("window: two numbers above 0 are wanted, how far it goes to each side of its middle");
    }
    basins.half = {half[0], half[1]};
  }
  basins.prove = o.neighbourhood;
  return {in_plane(std::move(basins)), given.origin};
}

report::machines::WordOrbits answer(const GivenInTables& given, const OrbitsOptions& o) {
  require_no_basin(o.basin);
  MachineWord q = question_for(given, o.family, "orbits", o.period, o.near);
  refuse_others(o, given.origin.file, false, {"--cells", "--time", "--certify", "--all", "--plot"});
  q.digits = o.digits.value_or(OrbitsOptions::default_digits);
  report::machines::WordOrbits list{find_word_orbits(q), given.origin};
  for (MachineOrbit& orbit : list.orbits) {
    if (o.neighbourhood) {
      surround(orbit, given.machine);
    }
  }
  return list;
}

namespace {

// "A..B,C..D": positions and velocities.
Rectangle rectangle(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw UsageError(fmt::format(
        "basin: '{}' is no rectangle of starts: positions A..B and velocities, such as -2..2,0..2", text));
  }
  const auto [x_from, x_to] = interval("basin", text.substr(0, comma));
  const auto [y_from, y_to] = interval("basin", text.substr(comma + 1));
  return {x_from, x_to, y_from, y_to};
}

}  // namespace

report::machines::Steady steady_answer(const GivenInTables& given, const OrbitsOptions& o) {
  refuse_others(
      o, given.origin.file, false,
      {"--period", "--near", "--cells", "--time", "--certify", "--plot", "--out", "--neighbourhood"});
  const int digits = o.digits.value_or(OrbitsOptions::default_digits);
  report::machines::Steady result{
      {given.machine, digits}, steady_sliding(given.machine, digits), given.origin};
  if (o.basin) {
    const Rectangle starts = rectangle(*o.basin);
    result.basin = {starts, planar_basin(given.machine, starts, digits)};
  }
  return result;
}

report::machines::SteadyBranch steady_answer(const GivenInTables& given, const BranchOptions& o) {
  refuse_others(
      o, given.origin.file, false,
      {"--period", "--near", "--orbit", "--at", "--without-gaps", "--parts", "--csv", "--plot", "--out"});
  const auto [varied, at] = along_path(given, o.along);
  const auto& [path, from, to, start] = varied;
  const int digits = OrbitsOptions::default_digits;
  report::machines::SteadyBranch result{
      {given.machine, digits}, varied, steady_sliding_along(at, from, to, digits), given.origin};
  if (o.basin) {
    const Rectangle starts = rectangle(*o.basin);
    result.basins = {starts, planar_basin_along(at, from, to, starts, digits)};
  }
  return result;
}

report::machines::Branches answer(const GivenInTables& given, const BranchOptions& o) {
  require_no_basin(o.basin);
  auto [varied, at] = along_path(given, o.along);
  auto& [path, from, to, start] = varied;
  start = o.at.value_or(start_in(given, path, from, to));
  if (start < from || start > to) {
    throw UsageError(fmt::format("at: {} = {} is not in the interval {}..{}", path, to_string(start),
                                 to_string(from), to_string(to)));
  }
  MachineWord q = question_for(given, o.family, "branch", o.period, o.near);
  refuse_others(o, given.origin.file, false, {});
  if (o.parts) {
    throw UsageError("--parts is for several --along");
  }
  q.machine = at(start);
  const MachineWordOrbits found = find_word_orbits(q);
  report::machines::Branches result{from_orbits(given, found, o), varied, o.without_gaps};
  for (const std::size_t k : wanted(found, o, path + " = " + to_string(start))) {
    result.branches.push_back(follow_machine_branch(
        {at, from, to, start, guess_of(found.orbits[k], q.machine), q.digits, o.without_gaps}));
    result.interrupted = result.interrupted || result.branches.back().interrupted;
  }
  return result;
}

report::machines::OverBox box_answer(const GivenInTables& given, const BranchOptions& o) {
  require_no_basin(o.basin);
  MachineWord q = question_for(given, o.family, "branch", o.period, o.near);
  std::vector<report::machines::Varied> varied;
  DataBox box;
  Values start;
  for (const auto& [path, range] : o.along) {
    const std::string& name = path;
    if (std::ranges::count(o.along, name, [](const auto& one) { return one.first; }) > 1) {
      throw UsageError(
          fmt::format("{}: {} and {} vary together: give one of them", given.origin.file, name, name));
    }
    const auto [from, to] = interval(path, range);
    varied.push_back({path, from, to, start_in(given, path, from, to)});
    box.low.push_back(from);
    box.high.push_back(to);
    start.push_back(varied.back().start);
  }
  box.at = [&](const Values& values) {
    std::vector<Datum> data;
    for (std::size_t k = 0; k < values.size(); ++k) {
      data.push_back({varied[k].path, values[k]});
    }
    return given.with(data);
  };
  refuse_others(o, given.origin.file, false, {});
  if (o.at) {
    throw UsageError("--at is for one --along: of several the orbits are looked for at what is given");
  }
  q.machine = box.at(start);
  const MachineWordOrbits found = find_word_orbits(q);
  report::machines::OverBox result{from_orbits(given, found, o), varied,
                                   o.parts.value_or(BranchOptions::default_parts)};
  constexpr int most_halvings = 40;
  for (const std::size_t k : wanted(found, o, "the file's data")) {
    const MotionAt motion{start, guess_of(found.orbits[k], q.machine)};
    result.motions.push_back(
        {found.orbits[k],
         motions_over(box, {motion}, {.most_halvings = most_halvings, .most_parts = result.most_parts})});
  }
  result.interrupted = result.interrupted || interrupted();
  return result;
}

namespace {

// The start, the load's phase there and the duration.
report::machines::MotionQuestion start_of(const GivenInTables& given, const SimulateOptions& o) {
  refuse_others(o, given.origin.file, true, {"--orbit", "--plot"});
  if (!o.state) {
    throw UsageError(
        fmt::format("the start is missing: --state, the positions of all masses of {} and then their "
                    "velocities",
                    given.origin.file));
  }
  report::machines::MotionQuestion result{given.machine};
  const auto oscillator = oscillator_as<double>(result.machine);
  const bool autonomous = oscillator.is_autonomous();
  result.start = state_for(given, "state", *o.state);
  if (o.perturb) {
    result.start += state_for(given, "perturb", *o.perturb);
  }
  const auto phi = o.parameters.find("phi");
  if (phi != o.parameters.end()) {
    result.theta = number("phi", phi->second);
  }
  if (autonomous && (o.periods || !o.duration || phi != o.parameters.end())) {
    throw UsageError(
        fmt::format("{} has no load that varies: --time T says how long, and neither --periods nor "
                    "--phi goes with it",
                    given.origin.file));
  }
  if (o.periods && o.duration) {
    throw UsageError("--periods and --time do not go together");
  }
  const double period = autonomous ? *o.duration : 2 * numeric::scalars::pi<double>() / oscillator.omega;
  result.duration = o.duration.value_or(period * o.periods.value_or(SimulateOptions::default_periods));
  return result;
}

}  // namespace

report::machines::SetMotion set_answer(const GivenInTables& given, const SimulateOptions& o) {
  for (const char * name : {"--csv", "--every"}) {
    if (o.typed.contains(name)) {
      throw UsageError(fmt::format("{} is for one motion, not for a set of them", name));
    }
  }
  const report::machines::MotionQuestion one = start_of(given, o);
  const AnyState half = state_for(given, "set", *o.set);
  return {set_after({one.machine, one.start, half, one.theta, one.duration}), given.origin};
}

report::machines::Motion answer(const GivenInTables& given, const SimulateOptions& o,
                                const std::function<bool(double)>& go_on,
                                const std::function<void(const SampleOfMachine&)>& take) {
  report::machines::MotionQuestion q = start_of(given, o);
  const auto oscillator = oscillator_as<double>(q.machine);
  if (take) {
    const double period =
        oscillator.is_autonomous() ? q.duration : 2 * numeric::scalars::pi<double>() / oscillator.omega;
    q.every = o.every.value_or(period / SimulateOptions::samples_in_period);
  }
  return {
      q, given.origin,
      numeric::simulation::record_motion(oscillator, q.theta, q.start, {q.duration, q.every}, go_on, take)};
}

bool is_steady(const std::string& word) {
  return word == "S" || word == "O";
}

void require_no_basin(const std::optional<std::string>& basin) {
  if (basin) {
    throw UsageError("--basin is for steady sliding, S, of a machine in tables");
  }
}

}  // namespace stickslip::cli
