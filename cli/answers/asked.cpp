#include "cli/answers/asked.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/answers/orbit_data.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/attractors/settle.hpp"
#include "numeric/branches/setting.hpp"
#include "numeric/families/family.hpp"
#include "numeric/scalars/scalars.hpp"
#include "report/orbits/attractors/attractors.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::attractors;
using branches::BranchQuestion;
using proofs::methods::Examples;
using report::orbits::Units;

// ---- orbits

Asked<OrbitQuestion> asked_orbits(const OrbitsOptions& o, const Examples& examples) {
  if (o.period || o.near) {
    throw UsageError(
        fmt::format("--period and --near are for words of phases, not for the family '{}'", o.family));
  }
  const Family& family = family_named(o.family);
  ParameterFile file = read_parameters(o, FrictionAtRest::optional);
  leave_results_out(file, family);
  const int digits = digits_of(o.digits, file);
  Units units = units_of(o.si, file, o.json);
  OrbitQuestion asked = question(examples, family, file, digits);
  asked.neighbourhood = o.neighbourhood;
  return {std::move(file), std::move(units), std::move(asked)};
}

namespace {

constexpr const char * phi_is_result =
    "the load is cos(omega t), and where in it an orbit begins is a result";

// The machine whose motions are asked for, its load cos(omega t).
Asked<words::WordQuestion> asked_machine(const GivenMachine& o, std::optional<int> wanted, bool json,
                                         const Examples& examples) {
  ParameterFile file = read_parameters(o, FrictionAtRest::needed);
  leave_out(file, "phi", phi_is_result);
  const int digits = digits_of(wanted, file);
  Units units = units_of(o.si, file, json);
  words::WordQuestion asked = machine(examples, file, digits);
  return {std::move(file), std::move(units), std::move(asked)};
}

}  // namespace

Asked<words::WordQuestion> asked_pure_word(const OrbitsOptions& o, const Examples& examples) {
  if (o.period || o.near || o.parameters.contains("phi")) {
    throw UsageError(fmt::format(
        "--period, --near and --phi are for words with events: the motions {} have one phase for ever",
        o.family));
  }
  Asked<words::WordQuestion> asked = asked_machine(o, o.digits, o.json, examples);
  words::require_machine_domain(asked.question);
  return asked;
}

Asked<WordSearch> asked_word(const OrbitsOptions& o, const Examples& examples) {
  const words::Word word = words::Word::parse(o.family);
  OrbitsOptions of_machine = o;
  const auto phase = of_machine.parameters.extract("phi");
  if (phase && !o.near) {
    throw UsageError(
        "phi is not given for a word without --near: it is the load's phase at the start that --near gives");
  }
  Asked<words::WordQuestion> given = asked_machine(of_machine, o.digits, o.json, examples);
  const words::WordQuestion& q = given.question;
  WordSearch search{.machine = q,
                    .word = word,
                    .periods = o.period.value_or(1),
                    .near = {},
                    .neighbourhood = o.neighbourhood};
  if (o.near) {
    search.near =
        at_phase_0({motion::parameters_as<double>(q.data), scalars::scalar<double>(q.ur),
                    phase ? number("phi", phase.mapped()) : 0, in_data("near", *o.near, given.units)});
  }
  return {std::move(given.file), std::move(given.units), std::move(search)};
}

// ---- branches

namespace {

// The parameter that a branch is along.
struct Along {
  std::string parameter;
  Rational from, to;
};

// The one parameter that is typed as an interval "A..B". Throws UsageError when none or several are
// intervals, and as exact_number.
Along along_of(const TypedParameters& typed) {
  Along found;
  for (const auto& [name, text] : typed) {
    if (text.find("..") == std::string::npos) {
      continue;
    }
    if (!found.parameter.empty()) {
      throw UsageError(
          fmt::format("{} and {} are both intervals: a branch is along one", found.parameter, name));
    }
    const auto [from, to] = interval(name, text);
    found = {name, from, to};
  }
  if (found.parameter.empty()) {
    throw UsageError(
        "a branch needs one parameter as an interval A..B, such as --omega 0.5..0.6, or --along "
        "load_frequency 7..8 of a machine in SI units");
  }
  return found;
}

// What is typed with what each --along NAME A..B says. Throws UsageError for a name that is neither a
// parameter's nor a machine's in SI units, and for one that is typed already.
TypedParameters with_along(TypedParameters typed, const Ranges& along) {
  for (const auto& [name, range] : along) {
    if (!is_parameter(name) && !is_in_SI(name)) {
      throw UsageError(fmt::format("along: '{}' is none of {}; or, of a machine in SI units, {}", name,
                                   fmt::join(parameter_names, ", "), fmt::join(names_in_SI, ", ")));
    }
    if (range.find("..") == std::string::npos) {
      throw UsageError(fmt::format("along: '{}' is not an interval A..B, such as 0.1..0.5", range));
    }
    if (!typed.emplace(name, range).second) {
      throw UsageError(fmt::format("{} is given twice, once by --along", name));
    }
  }
  return typed;
}

// The value `at`, or the middle of the interval.
Rational value_at(const Along& along, const std::optional<Rational>& at) {
  return at.value_or(Rational((along.from + along.to) / 2));
}

// The file, of a machine in SI units as it is at the value that `at` says or in the middle. Ranges in it are
// as if they were typed.
ParameterFile file_of(const BranchOptions& o, FrictionAtRest at_rest) {
  BranchOptions given = o;
  given.parameters = with_along(o.parameters, o.along);
  TypedParameters typed = given.parameters;
  ParameterFile file = read_parameters(given, at_rest, [&](TypedParameters machine) {
    for (const auto& [name, text] : machine) {
      if (typed.contains(name)) {
        continue;
      }
      const auto [from, to] = interval(name, text);
      if (from != to) {
        typed[name] = to_string(from) + ".." + to_string(to);
      }
    }
    const Along along = along_of(typed);
    if (is_in_SI(along.parameter)) {
      machine[along.parameter] = to_string(value_at(along, o.at));
    }
    return machine;
  });
  std::erase_if(file.parameters, [&](const auto& one) {
    const bool is_range = one.second.find("..") != std::string::npos;
    if (is_range) {
      typed.insert(one);
    }
    return is_range;
  });
  file.typed = typed;
  const Along along = along_of(typed);
  (void)units_of(o.si, file, false);
  if (o.si && !is_in_SI(along.parameter)) {
    throw UsageError(
        fmt::format("--units si goes with --along a value of the machine, not with {}", along.parameter));
  }
  return file;
}

// Along a value of a machine in SI units: the path of its data. The list says all of the machine.
Asked<BranchQuestion> along_machine(ParameterFile file, BranchQuestion q, const Along& along) {
  q.parameter = along.parameter;
  q.from = along.from;
  q.to = along.to;
  if (file.machine && is_in_SI(q.parameter)) {
    q.machine = machine_between(file, q.parameter, q.from, q.to);
    q.machine_file = file.name;
    if (q.orbits.phi) {
      q.machine->phi = q.orbits.phi->middle;
    }
    file.machine.reset();
  }
  return {std::move(file), {}, std::move(q)};
}

Asked<BranchQuestion> asked_branch_of_family(const BranchOptions& o, const Examples& examples) {
  const Family& family = family_named(o.family);
  if (o.period) {
    throw UsageError(fmt::format("--period is for words of phases, not for the family '{}'", o.family));
  }
  if (o.all || o.orbit || o.near) {
    throw UsageError(
        fmt::format("--all, --orbit and --near are for words of phases, not for the family '{}', of which "
                    "all branches are followed",
                    o.family));
  }
  ParameterFile file = file_of(o, FrictionAtRest::optional);
  leave_results_out(file, family);
  const Along along = along_of(file.typed);
  ParameterFile at_first = file;
  at_first.typed[along.parameter] = to_string(along.from);
  BranchQuestion asked;
  asked.orbits = question(examples, family, at_first, OrbitsOptions::default_digits);
  asked.at = o.at;
  return along_machine(std::move(file), std::move(asked), along);
}

Asked<BranchQuestion> asked_branch_of_word(const BranchOptions& o, const Examples& examples) {
  const words::Word word = words::Word::parse(o.family);
  ParameterFile file = file_of(o, FrictionAtRest::needed);
  leave_out(file, "phi", phi_is_result);
  const Along along = along_of(file.typed);
  const Rational value = value_at(along, o.at);
  ParameterFile there = file;
  there.typed[along.parameter] = to_string(value);
  const words::WordQuestion known_at = machine(examples, there, OrbitsOptions::default_digits);
  WordSearch search{known_at, word, o.period.value_or(1), {}, o.all || o.orbit};
  if (o.near) {
    search.near = in_data("near", *o.near, units_of(o.si, file, false));
  }
  std::vector<words::WordOrbit> known = find_word_orbits(search).orbits;
  if (o.orbit) {
    const auto k = static_cast<std::size_t>(*o.orbit);
    if (k > known.size()) {
      throw UsageError(fmt::format("--orbit {}: of {} there are {} orbits at {} = {}", k, word.letters(),
                                   known.size(), along.parameter, to_string(value)));
    }
    known = {known[k - 1]};
  }
  std::size_t not_admissible = 0;
  if (!o.all && !o.orbit && !o.near) {
    not_admissible = std::erase_if(known, [](const words::WordOrbit& one) {
      return one.existence.truth == Truth::proved && one.orbit.admissible.truth == Truth::refuted;
    });
  }
  BranchQuestion asked = branches::word_question(known_at, word, o.period.value_or(1), known);
  asked.word->not_admissible = not_admissible;
  asked.at = value;
  return along_machine(std::move(file), std::move(asked), along);
}

}  // namespace

Asked<words::WordQuestion> asked_box(const BranchOptions& o, const Examples& examples) {
  return asked_machine(o, std::nullopt, false, examples);
}

Asked<BranchQuestion> asked_branch(const BranchOptions& o, const Examples& examples) {
  if (o.parts) {
    throw UsageError("--parts is for several --along");
  }
  return words::looks_like_word(o.family) ? asked_branch_of_word(o, examples)
                                          : asked_branch_of_family(o, examples);
}

// ---- attractors

void require_sense(const AttractorsOptions& o) {
  const bool along = !o.along.empty();
  if (o.along.size() > 1) {
    throw UsageError(fmt::format("--along is for one number here, not for {} of them", o.along.size()));
  }
  if (along && o.plane) {
    throw UsageError("--along and --plane are two questions: give one of them");
  }
  const bool picture = along || o.plane;
  for (const char * name : {"--values", "--pixels", "--through", "--window", "--csv", "--plot"}) {
    if (!picture && o.typed.contains(name)) {
      throw UsageError(fmt::format("{} is for --along and --plane", name));
    }
  }
  const auto others = along     ? std::vector{"--pixels", "--through", "--window", "--neighbourhood"}
                      : o.plane ? std::vector{"--values", "--starts", "--seed"}
                                : std::vector<const char *>{};
  for (const char * name : others) {
    if (o.typed.contains(name)) {
      throw UsageError(fmt::format("{} is not for {}", name, along ? "--along" : "--plane"));
    }
  }
}

int values_of(const AttractorsOptions& o) {
  const int values = o.values.value_or(AttractorsOptions::default_values);
  if (values < 2) {
    throw UsageError("values: a diagram needs at least 2");
  }
  return values;
}

int pixels_of(const AttractorsOptions& o) {
  const int pixels = o.pixels.value_or(AttractorsOptions::default_pixels);
  if (pixels < 2) {
    throw UsageError("pixels: a picture needs at least 2");
  }
  return pixels;
}

namespace {

using Attracted = AttractorsOptions;

AttractorQuestion about(const words::WordQuestion& machine, const Attracted& o, int starts) {
  return {machine, o.starts.value_or(starts), static_cast<std::uint64_t>(o.seed.value_or(1)),
          o.most_periods.value_or(Attracted::default_most_periods), o.neighbourhood};
}

// The machine from which those of a diagram differ in a value, and those of a picture in their starts.
Asked<AttractorQuestion> asked_machines(const Attracted& o, const Examples& examples) {
  require_sense(o);
  ParameterFile file = read_parameters(o, FrictionAtRest::needed);
  Units units = units_of(o.si, file, o.json);
  AttractorQuestion asked = about(machine(examples, file, o.digits.value_or(OrbitsOptions::default_digits)),
                                  o, Attracted::default_starts_at_value);
  return {std::move(file), std::move(units), std::move(asked)};
}

// Along a value of a machine in SI units: the data taken at each.
std::function<DataTaken(const Rational&)> machine_along(const Attracted& o, const ParameterFile& file) {
  const std::string& name = o.along.front().first;
  if (!file.in_SI.contains(name)) {
    if (file.machine && !is_parameter(name)) {
      throw UsageError(
          fmt::format("along: '{}' is none of the parameters in {}: {}", name, file.name,
                      report::tools::enumerated(file.in_SI, &TypedParameters::value_type::first)));
    }
    if (is_in_SI(name)) {
      throw UsageError(
          fmt::format("{} is a value of a machine in SI units: give its file by --params", name));
    }
    return {};
  }
  if (o.json) {
    throw UsageError(fmt::format(
        "--json does not go with --along {}: the unit of length of JSON would change along it", name));
  }
  return [all = file.in_SI, name, in = file.name](const Rational& value) {
    TypedParameters there = all;
    there[name] = to_string(value);
    return data_taken(machine_in_SI(there, in, FrictionAtRest::needed));
  };
}

}  // namespace

Asked<AttractorQuestion> asked_attractors(const Attracted& o, const Examples& examples) {
  require_sense(o);
  Asked<words::WordQuestion> given = asked_machine(o, o.digits, o.json, examples);
  return {std::move(given.file), std::move(given.units), about(given.question, o, Attracted::default_starts)};
}

Asked<DiagramQuestion> asked_diagram(const Attracted& o, const Examples& examples) {
  Asked<AttractorQuestion> given = asked_machines(o, examples);
  auto taken = machine_along(o, given.file);
  const auto [name, range] = *with_along({}, o.along).begin();
  const auto [from, to] = interval(name, range);
  const int values = values_of(o);
  DiagramQuestion asked{given.question, name, from, to, values, std::move(taken)};
  return {std::move(given.file), std::move(given.units), std::move(asked)};
}

Asked<BasinsQuestion> asked_basins(const Attracted& o, const Examples& examples) {
  Asked<AttractorQuestion> given = asked_machines(o, examples);
  BasinsQuestion asked{given.question, plane("plane", o.plane.value(), 2), {}, {}};
  const long pixels = pixels_of(o);
  asked.pixels = {pixels, pixels};
  if (o.through) {
    asked.through = in_data("through", *o.through, given.units);
  }
  return {std::move(given.file), std::move(given.units), std::move(asked)};
}

// ---- an atlas

namespace {

// A machine in the middle of the ranges that values in SI units may be.
TypedParameters in_the_middle(TypedParameters machine) {
  for (auto& [name, text] : machine) {
    const auto [lower, upper] = interval(name, text);
    if (name == "load_phase" && lower != upper) {
      throw UsageError("load_phase: no orbit depends on it, for it is where simulations begin");
    }
    text = to_string(Rational((lower + upper) / 2));
  }
  return machine;
}

}  // namespace

Asked<atlas::Question> asked_atlas(const AtlasOptions& o, const Examples& examples) {
  if (o.family.empty()) {
    throw UsageError("a family of orbits is missing: " + numeric::families::names_of_judged_families());
  }
  atlas::Question q;
  q.family = &family_named(o.family);
  AtlasOptions machine = o;
  machine.parameters = with_along(std::move(machine.parameters), o.along);
  ParameterFile file = read_parameters(machine, FrictionAtRest::optional, in_the_middle);
  (void)units_of(o.si, file, false);
  leave_results_out(file, *q.family);
  TypedParameters given = given_parameters(examples, file);
  for (const auto& [name, why] :
       {std::pair("phi", q.family->why_no_phi), std::pair("ur", q.family->why_no_ur)}) {
    if (file.typed.contains(name) && !why.empty()) {
      throw UsageError(why);
    }
    if (!why.empty()) {
      given.erase(name);  // the example's
    }
  }
  if (atlas::takes_phi(*q.family) && file.typed.contains("ur")) {
    throw UsageError(fmt::format("ur: an atlas of {} orbits takes phi, and u_r is a result", q.family->name));
  }
  if (file.machine) {
    q.values = file.in_SI.contains("normal_force") ? atlas::Values::coefficients : atlas::Values::forces;
    given.insert(file.in_SI.begin(), file.in_SI.end());
    if (!file.machine->machine.friction_at_rest) {
      given.erase("friction_at_rest");
      given.erase("friction_force_at_rest");
    }
  }
  const std::vector<std::string>& names = names_of(q);
  require_given(given, {names.begin(), names.end() - 1});
  for (const std::string& name : names) {
    if (given.contains(name)) {
      const auto [lower, upper] = interval(name, given.at(name));
      q.region.push_back({lower, upper});
      if (!q.region.back().is_point()) {
        q.axes.push_back(q.region.size() - 1);
      }
    }
  }
  q.resolution = o.resolution.value_or(AtlasOptions::default_resolution);
  atlas::require_understood(q);
  return {std::move(file), {}, std::move(q)};
}

// ---- a motion

double MotionAsked::period() const {
  return 2 * std::acos(-1.0) / from.start.data.omega;
}

Asked<MotionAsked> asked_motion(const SimulateOptions& o, const Examples& examples) {
  ParameterFile file =
      read_parameters(o, o.orbit.empty() ? FrictionAtRest::needed : FrictionAtRest::optional);
  Units units = units_of(o.si, file, o.json);
  MotionAsked asked{simulation_start(o, file, examples, units)};
  if (o.periods && o.duration) {
    throw UsageError("--periods and --time do not go together");
  }
  asked.periods = o.duration ? units.of_time(*o.duration) / asked.period()
                             : o.periods.value_or(SimulateOptions::default_periods);
  asked.every = o.every ? units.of_time(*o.every) : asked.period() / SimulateOptions::samples_in_period;
  return {std::move(file), std::move(units), std::move(asked)};
}

}  // namespace stickslip::cli
