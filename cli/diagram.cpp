// stickslip attractors --along and --plane.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <ranges>
#include <string>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "core/decimal.hpp"
#include "core/interruption.hpp"

namespace stickslip::cli {

using namespace numeric::attractors;
using Options = AttractorsOptions;
using report::orbits::Units;

namespace {

void require_sense(const Options& o) {
  if (!o.along.empty() && !o.plane.empty()) {
    throw UsageError("--along and --plane are two questions: give one of them");
  }
  const bool along = !o.along.empty();
  for (const auto& [name, text, fits] :
       {std::tuple("--values", &o.values, along), std::tuple("--pixels", &o.pixels, !along),
        std::tuple("--through", &o.through, !along), std::tuple("--starts", &o.starts, along),
        std::tuple("--seed", &o.seed, along)}) {
    if (!text->empty() && !fits) {
      throw UsageError(fmt::format("{} is not for {}", name, along ? "--along" : "--plane"));
    }
  }
}

// "A..B" with A < B.
std::pair<Rational, Rational> ends(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    throw UsageError(fmt::format("along: '{}' is no interval A..B, such as 0.1..0.5", text));
  }
  const Rational from = exact_number("along", text.substr(0, dots));
  const Rational to = exact_number("along", text.substr(dots + 2));
  if (from >= to) {
    throw UsageError(fmt::format("along: '{}' does not rise: A..B needs A < B", text));
  }
  return {from, to};
}

std::array<int, 2> plane(const std::string& text) {
  const auto& names = report::orbits::coordinates;
  const std::size_t comma = text.find(',');
  std::array<int, 2> across{};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name = comma == std::string::npos ? text
                             : k == 0                   ? text.substr(0, comma)
                                                        : text.substr(comma + 1);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() || comma == std::string::npos) {
      throw UsageError(fmt::format("plane: '{}' is not two of x1, x2, x1', x2', such as x1,x2", text));
    }
    across[k] = static_cast<int>(found - names.begin());
  }
  if (across[0] == across[1]) {
    throw UsageError(fmt::format("plane: '{}' names one coordinate twice", text));
  }
  return across;
}

// For --along by a value of a machine in SI units: the data taken at each.
std::function<numeric::DataTaken(const Rational&)> machine_along(const Options& o,
                                                                 const ParameterFile& file) {
  const std::string& name = o.along[0];
  if (!file.in_SI.contains(name)) {
    if (file.machine && std::ranges::find(parameter_names, name) == parameter_names.end()) {
      throw UsageError(fmt::format("along: '{}' is none of the parameters in {}: {}", name, file.name,
                                   fmt::join(std::views::keys(file.in_SI), ", ")));
    }
    return {};
  }
  if (o.json) {
    throw UsageError(fmt::format(
        "--json does not go with --along {}: the unit of length of JSON would change along it", name));
  }
  return [&file, name](const Rational& value) {
    TypedParameters there = file.in_SI;
    there[name] = to_string(value);
    return numeric::data_taken(machine_in_SI(there, file.name, FrictionAtRest::needed));
  };
}

}  // namespace

ExitCode run_diagram(const Options& o, const proofs::methods::Paper& paper) {
  require_sense(o);
  const ParameterFile file = read_parameters(o.file, o.parameters, o.example, FrictionAtRest::needed);
  const Units units = units_of(o.units, file, o.json);
  const auto whole = [](const char * name, const std::string& text, int most, int otherwise) {
    return whole_number(name, text, most, otherwise);
  };
  const AttractorQuestion machine_asked{
      machine(paper, o.parameters, file.parameters, o.example,
              whole("digits", o.digits, OrbitsOptions::most_digits, OrbitsOptions::default_digits)),
      whole("starts", o.starts, Options::most_starts, Options::default_starts_at_value),
      static_cast<std::uint64_t>(whole("seed", o.seed, Options::greatest_number, 1)),
      whole("most-periods", o.most_periods, Options::greatest_number, Options::default_most_periods)};
  const Jobs limit = jobs(o.jobs);
  if (!o.along.empty()) {
    const auto [from, to] = ends(o.along[1]);
    const long values = whole("values", o.values, Options::most_values, Options::default_values);
    if (values < 2) {
      throw UsageError("values: a diagram needs at least 2");
    }
    require_outputs(o);
    const Diagram diagram = [&] {
      const Interruptible scope;
      const Progress progress("following the starts ...");
      return diagram_of({machine_asked, o.along[0], from, to, values, machine_along(o, file)});
    }();
    write_outputs(o, diagram, file, units);
    return diagram.interrupted ? exit_interrupted : exit_decided;
  }
  BasinsQuestion question{machine_asked, plane(o.plane), {}, {}};
  if (o.pixels == "1") {
    throw UsageError("pixels: a picture needs at least 2");
  }
  const long pixels = whole("pixels", o.pixels, Options::most_pixels, Options::default_pixels);
  question.pixels = {pixels, pixels};
  if (!o.through.empty()) {
    question.through = units.of_state(four_numbers("through", o.through));
  }
  require_outputs(o);
  const Basins basins = [&] {
    const Interruptible scope;
    const Progress progress("following the starts ...");
    return basins_of(question);
  }();
  write_outputs(o, basins, file, units);
  return basins.interrupted ? exit_interrupted : exit_decided;
}

}  // namespace stickslip::cli
