#include "cli/orbit_data.hpp"

#include <fmt/format.h>

#include "cli/numbers.hpp"
#include "core/error.hpp"
#include "proofs/methods/example_orbits.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::motion;
using namespace proofs::methods;

namespace {

void set(TypedParameters& parameters, const char * name, const std::optional<Rational>& value) {
  if (value) {
    parameters[name] = to_string(*value);
  }
}

TypedParameters parameters_of(const Example& example, const Family& family) {
  const ExactParameters& a = example.data;
  TypedParameters parameters;
  set(parameters, "chi", a.chi);
  set(parameters, "eta", a.eta);
  set(parameters, "us", a.us);
  set(parameters, "V", a.V);
  set(parameters, "omega", a.omega);
  set(parameters, "p", a.p);
  if (&family == example.family) {
    set(parameters, "phi", example.phi);
    set(parameters, "ur", example.ur);
  }
  return parameters;
}

// What the new parameters say goes before what the old ones say; phi and ur stand for one choice.
void replace(TypedParameters& old, const TypedParameters& with) {
  if (with.contains("phi") || with.contains("ur")) {
    old.erase("phi");
    old.erase("ur");
  }
  for (const auto& [name, text] : with) {
    old[name] = text;
  }
}

Range required_range(const TypedParameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) {
    throw UsageError(fmt::format(
        "the parameter {0} is missing: give --{0}, or all of them by --params or --example", name));
  }
  return parse_range(name, found->second);
}

std::optional<Range> optional_range(const TypedParameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? std::nullopt : std::optional(parse_range(name, found->second));
}

}  // namespace

OrbitQuestion question(const Paper& paper, const Family& family, const TypedParameters& typed,
                       const TypedParameters& from_file, const std::string& example, int digits) {
  TypedParameters all;
  if (!example.empty()) {
    all = parameters_of(example_named(paper.examples, example), family);
  }
  replace(all, from_file);
  replace(all, typed);
  return {&family,
          {required_range(all, "chi"), required_range(all, "eta"), required_range(all, "us"),
           required_range(all, "V"), required_range(all, "omega"), required_range(all, "p")},
          optional_range(all, "phi"),
          optional_range(all, "ur"),
          digits};
}

words::WordQuestion machine(const Paper& paper, const TypedParameters& typed,
                            const TypedParameters& from_file, const std::string& example, int digits) {
  constexpr int digits_of_ur = 17;
  TypedParameters given = from_file;
  replace(given, typed);
  if (given.contains("phi")) {
    throw UsageError(
        "phi is not given for a machine: its load is cos(omega t), and where in it an orbit begins is a "
        "result");
  }
  TypedParameters all;
  if (!example.empty()) {
    const Example& known = example_named(paper.examples, example);
    all = parameters_of(known, *known.family);
    if (!all.contains("ur") && !given.contains("ur")) {
      all["ur"] = to_text(printed_orbit(known).value("ur"), digits_of_ur).mid;
    }
  }
  replace(all, given);
  const auto exact = [&](const char * name) {
    (void)required_range(all, name);
    return exact_number(name, all.at(name));
  };
  return {
      {exact("chi"), exact("eta"), exact("us"), exact("V"), exact("omega"), exact("p")}, exact("ur"), digits};
}

}  // namespace stickslip::cli
