// The arguments of the program, command by command, as they are typed.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "cli/typed_parameters.hpp"

namespace stickslip::cli {

struct AuditOptions {
  std::string out;
  std::string jobs;
  bool with_out = false;
  bool json = false;
  bool mutants = false;
  unsigned one_in = 1;  // of the mutants
  unsigned seed = 0;    // of that sample
};

struct CheckOptions {
  std::vector<std::string> words;
  std::string jobs;
  bool list = false;
  bool explain = false;
  bool json = false;
};

struct LatexOptions {
  std::vector<std::string> names;
  bool in_frequencies = false;  // else with chi, eta and abbreviations
  bool list = false;
  bool errata = false;
  std::string theorem;  // the id of a result; empty if none is asked for
};

struct OrbitsOptions {
  std::string family;  // or a word
  std::string period;  // of a word
  std::string near;
  bool with_near = false;
  TypedParameters parameters;
  std::string file;
  std::string units;
  std::string example;
  std::string digits;
  std::string plot;
  std::string jobs;
  bool with_plot = false;
  std::string out;
  bool with_out = false;
  bool json = false;

  static constexpr int default_digits = 20;
  static constexpr int most_digits = 2000;
};

struct AttractorsOptions {
  TypedParameters parameters;
  std::string file, units, example, starts, seed, most_periods, digits, jobs;
  bool json = false;

  static constexpr int default_starts = 500;
  static constexpr int most_starts = 100000;
  static constexpr int greatest_number = 1000000000;  // of periods and seeds
  static constexpr int default_most_periods = 20000;
};

struct SimulateOptions {
  TypedParameters parameters;
  std::string file, example, state, perturb, periods, every, csv, plot;

  static constexpr double default_periods = 100;
  static constexpr double samples_in_period = 200;
};

struct HelpWanted {
  std::string text;
};
struct VersionsWanted {};

using Request = std::variant<AuditOptions, CheckOptions, LatexOptions, OrbitsOptions, AttractorsOptions,
                             SimulateOptions, HelpWanted, VersionsWanted>;

// What the help says of the paper that the program is about.
struct PaperInHelp {
  std::string about;     // what the program does with it, in lines
  std::string places;    // "sec2, sec3, A1"
  std::string part;      // a statement that is part of an equation: "44.H"
  std::string examples;  // "S, O or P"

  [[nodiscard]] std::string equation() const { return part.substr(0, part.find('.')); }
};

// What the arguments ask for; argv[0] is the program's name. Runs nothing, prints nothing and touches no
// file. Throws UsageError.
[[nodiscard]] Request parse(int argc, const char * const * argv, const PaperInHelp& paper);

}  // namespace stickslip::cli
