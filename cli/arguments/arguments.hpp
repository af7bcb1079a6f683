// The arguments of the program, command by command, as they are typed.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "cli/arguments/help.hpp"
#include "cli/arguments/typed_parameters.hpp"

namespace stickslip::cli {

struct AuditOptions {
  std::string claims;  // a file of claims; empty for the paper
  std::optional<std::string> out;
  std::optional<int> jobs;
  bool json = false, mutants = false;
  std::optional<int> one_in, seed;     // of the mutants; of that sample
  std::string certificates;            // a record, or its directory; empty if there is none
  std::optional<std::string> compare;  // the JSON of an older audit
};

struct CheckOptions {
  std::string claims;  // likewise
  std::vector<std::string> words;
  std::optional<int> jobs;
  bool list = false, explain = false, json = false;
};

struct ProveOptions {
  std::string statement;
  std::vector<std::string> assumptions;
  std::vector<std::string> symbols;  // beside the paper's
  std::string certificate;           // a directory, or nothing
  bool explain = false, json = false;
};

struct CertifyOptions {
  std::string claims;
  std::vector<std::string> words;  // as those of check
  std::string out;
  std::string record;  // a directory whose certificates were checked; then the others are empty
};

// What commands about motions are given: a machine, and whether states and results are in SI units.
struct GivenMachine {
  TypedParameters parameters;
  GivenFile file;
  std::string example;
  bool si = false;
  std::set<std::string> typed;  // the names of all options that are given
};

struct LatexOptions : GivenMachine {
  std::string claims;  // a file of claims; empty for the paper
  std::vector<std::string> names;
  bool in_frequencies = false;  // else with chi, eta and abbreviations
  bool bare = false;            // formulas alone
  bool list = false, errata = false;
  std::string theorem;  // the id of a result; empty if none is asked for
  std::string orbit;    // FAMILY:K; empty if none is asked for, and then a machine and digits are for values
  std::optional<int> digits;

  static constexpr int default_digits = 10;
};

// Where results go beside standard output.
struct Outputs {
  std::optional<std::string> csv, plot, out;
  std::optional<int> jobs;
  bool json = false;
};

struct OrbitsOptions : GivenMachine, Outputs {
  std::string family;         // or a word, with:
  std::optional<int> period;  // of the load
  std::optional<State> near;
  std::optional<int> digits;
  std::optional<int> cells;    // limits of the search
  std::optional<double> time;  // in seconds
  std::string certify;         // a directory, or nothing
  bool all = false, neighbourhood = false;
  std::optional<std::string> basin;  // of S of a machine in tables

  static constexpr int most_periods_of_word = 100000;
  static constexpr int most_orbits = 1000000;
  static constexpr int default_digits = 20;
  static constexpr int most_digits = 2000;
  static constexpr int most_cells = 1000000000;
};

// Parameters, or values of the machine in the file, and A..B.
using Ranges = std::vector<std::pair<std::string, std::string>>;

struct BranchOptions : GivenMachine, Outputs {
  std::string family;        // one of the parameters is an interval A..B, or
  Ranges along;              // of several numbers for words of a machine in tables
  std::optional<int> parts;  // then
  std::optional<Rational> at;
  std::optional<int> period, orbit;  // of a word
  std::optional<State> near;
  bool all = false;                  // likewise
  std::optional<std::string> basin;  // of S of a machine in tables
  bool without_gaps = false;         // of words of one

  static constexpr int default_parts = 500;
  static constexpr int most_parts = 1000000;
};

struct AttractorsOptions : GivenMachine, Outputs {
  std::optional<int> starts, seed, most_periods, digits;
  Ranges along;  // one, or none
  std::optional<int> values, pixels;
  std::optional<std::string> plane;
  std::optional<State> through, window;  // half widths: two numbers
  bool neighbourhood = false;

  static constexpr int default_starts = 500;
  static constexpr int default_starts_at_value = 50;
  static constexpr int default_values = 41;
  static constexpr int most_values = 10000;
  static constexpr int default_pixels = 60;
  static constexpr int pixels_beside_starts = 40;  // of a report
  static constexpr int most_pixels = 1000;
  static constexpr int most_starts = 100000;
  static constexpr int greatest_number = 1000000000;  // of periods and seeds
  static constexpr int default_most_periods = 20000;
};

struct AtlasOptions : GivenMachine, Outputs {
  std::string family;
  Ranges along;
  std::optional<int> resolution, sample;
  std::optional<double> time_limit;  // in seconds
  std::string verify;
  bool resume = false;

  static constexpr int default_resolution = 8;
  static constexpr int most_resolution = 60;
  static constexpr int default_sample = 10000;
};

struct SimulateOptions : GivenMachine, Outputs {
  std::string orbit;
  std::optional<State> state, perturb, set;
  std::optional<double> periods, duration, every;  // one of the first two

  static constexpr double default_periods = 100;
  static constexpr double samples_in_period = 200;
};

struct HelpWanted {
  std::string text;
};
struct VersionsWanted {};
// What a package installs beside the program: --manual DIR, which the help does not name.
struct ManualWanted {
  std::string directory;
  std::vector<ManualFile> files;
};

using Request = std::variant<AuditOptions, CheckOptions, ProveOptions, CertifyOptions, LatexOptions,
                             OrbitsOptions, BranchOptions, AttractorsOptions, AtlasOptions, SimulateOptions,
                             HelpWanted, VersionsWanted, ManualWanted>;

// What the help says of the paper that the program is about, and of the families of orbits. What takes the
// claims of the paper is made where it is shown.
struct PaperInHelp {
  using Made = std::function<std::string()>;
  std::string about;                           // what the program does with it, in lines
  std::string examples;                        // "S, O or P"
  std::string family_names;                    // "symmetric, overshooting or nonsticking"
  std::string judged_names;                    // those that an atlas is made of
  std::string families;                        // what each is given and what it finds, in lines
  Made places = [] { return std::string(); };  // "sec2, sec3, A1"
  Made part = [] { return std::string(); };    // a statement that is part of an equation: "44.H"
  std::function<Completions()> completions = [] { return Completions(); };
};

// What the arguments ask for; argv[0] is the program's name. Runs nothing, prints nothing and touches no
// file. Throws UsageError.
[[nodiscard]] Request parse(int argc, const char * const * argv, const PaperInHelp& paper);

}  // namespace stickslip::cli
