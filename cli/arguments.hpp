// The arguments of the program, command by command, as they are typed.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "cli/manual.hpp"
#include "cli/typed_parameters.hpp"

namespace stickslip::cli {

struct AuditOptions {
  std::string claims;  // a file of claims; empty for the paper
  std::string out;
  std::string jobs;
  bool with_out = false;
  bool json = false;
  bool mutants = false;
  std::string one_in;        // of the mutants
  std::string seed;          // of that sample
  std::string certificates;  // a record, or its directory; empty if there is none
};

struct CheckOptions {
  std::string claims;  // likewise
  std::vector<std::string> words;
  std::string jobs;
  bool list = false;
  bool explain = false;
  bool json = false;
};

struct ProveOptions {
  std::string statement;
  std::vector<std::string> assumptions;
  std::vector<std::string> symbols;  // beside the paper's
  std::string certificate;           // a directory, or nothing
  bool explain = false;
  bool json = false;
};

struct CertifyOptions {
  std::string claims;
  std::vector<std::string> words;  // as those of check
  std::string out;
  std::string record;  // a directory whose certificates were checked; then the others are empty
};

struct LatexOptions {
  std::string claims;  // a file of claims; empty for the paper
  std::vector<std::string> names;
  bool in_frequencies = false;  // else with chi, eta and abbreviations
  bool bare = false;            // formulas alone
  bool list = false;
  bool errata = false;
  std::string theorem;  // the id of a result; empty if none is asked for
  std::string orbit;    // FAMILY:K; empty if none is asked for, and then all that follows
  TypedParameters parameters;
  GivenFile file;
  std::string example, digits;

  static constexpr int default_digits = 10;
};

struct OrbitsOptions {
  std::string family;  // or a word
  std::string period;  // of a word
  std::string near;
  bool with_near = false;
  TypedParameters parameters;
  GivenFile file;
  std::string units;
  std::string example;
  std::string digits;
  std::string plot;
  std::string jobs;
  std::string cells, time;  // limits of the search
  bool with_plot = false;
  std::string out;
  bool with_out = false;
  std::string certify;  // a directory, or nothing
  bool all = false;
  bool json = false;

  static constexpr int most_periods_of_word = 100000;
  static constexpr int default_digits = 20;
  static constexpr int most_digits = 2000;
  static constexpr int most_cells = 1000000000;
};

struct BranchOptions {
  std::string family;
  TypedParameters parameters;      // one of them an interval A..B, or
  std::vector<std::string> along;  // a parameter, or a value of the machine in the file, and A..B
  GivenFile file;
  std::string units, example, at, csv, plot, out, jobs;
  std::string period, orbit, near;  // of a word
  bool all = false;                 // likewise
  bool with_out = false;
  bool json = false;
};

struct AttractorsOptions {
  TypedParameters parameters;
  GivenFile file;
  std::string units, example, starts, seed, most_periods, digits, jobs;
  std::vector<std::string> along;  // a parameter and A..B, or nothing
  std::string values, plane, pixels, through, csv, plot, out;
  bool with_out = false;
  bool json = false;

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

struct AtlasOptions {
  std::string family;
  TypedParameters parameters;
  std::vector<std::pair<std::string, std::string>> along;  // parameters, or values of the machine, and A..B
  GivenFile file;
  std::string units, example, resolution, out, csv, plot, jobs, time_limit, verify, sample;
  bool resume = false, json = false;

  static constexpr int default_resolution = 8;
  static constexpr int most_resolution = 60;
  static constexpr int default_sample = 10000;
};

struct SimulateOptions {
  TypedParameters parameters;
  GivenFile file;
  std::string units, example, orbit, state, perturb, periods, every, csv, plot;
  bool with_csv = false, with_plot = false, json = false;

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

// What the help says of the paper that the program is about, and of the families of orbits.
struct PaperInHelp {
  std::string about;         // what the program does with it, in lines
  std::string places;        // "sec2, sec3, A1"
  std::string part;          // a statement that is part of an equation: "44.H"
  std::string examples;      // "S, O or P"
  std::string family_names;  // "symmetric, overshooting or nonsticking"
  std::string families;      // what each is given and what it finds, in lines
  Completions completions;

  [[nodiscard]] std::string equation() const { return part.substr(0, part.find('.')); }
};

// What the arguments ask for; argv[0] is the program's name. Runs nothing, prints nothing and touches no
// file. Throws UsageError.
[[nodiscard]] Request parse(int argc, const char * const * argv, const PaperInHelp& paper);

}  // namespace stickslip::cli
