// The commands about motions: orbits, attractors, simulate.
#include <fmt/format.h>

#include "cli/command_line.hpp"

namespace stickslip::cli {
namespace {

constexpr const char * orbits_details =
    "Searches the whole closed domain of the family and lists every orbit, each proved to\n"
    "exist, with every condition decided along the whole motion; what could not be decided\n"
    "is listed too.\n\n"
    "A number is a decimal or a fraction and is taken exactly: 0.1607, 2.5e-3, 1/3. With\n"
    "0.5+-1e-4 for some parameters, each orbit is proved for all values in the box.\n\n";

constexpr const char * words_details =
    "\nA word of S (slip), O (overshoot), T (stick), such as OTS, in place of a family: the\n"
    "orbits through these phases in --period N periods of the load, at --ur, that a\n"
    "simulation finds, from --near at t = 0 or from random starts; the load is cos(omega t).\n"
    "Each is proved. For up to four phases, OSOS aside, without --near all orbits are\n"
    "listed, in any order of the load's phases; for another word there may be more.\n"
    "S, O or T alone: whether motions stay in that phase for ever, and which.\n\n"
    "Exit code: 0 the list is complete, or not empty where it cannot be, and everything in it\n"
    "is decided, also if no orbit is admissible; 2 something is undecided or unresolved; 130\n"
    "after Ctrl-C, which ends the search: what it has found is still printed and written,\n"
    "marked as interrupted.";

constexpr const char * branch_details =
    "Gives one parameter as an interval A..B and follows the orbits over it, each proved to\n"
    "exist and to be the only one near it, as a function of the parameter. Of a machine in SI\n"
    "units that is one of the values in its file, --along load_frequency 7..8 or m1 3.9..4.1,\n"
    "or \"7..8\" or \"4+-5%\" in the file: all data that it moves follow it exactly, and results\n"
    "are in SI units. Every place where something changes is enclosed to 1e-10, named, and\n"
    "proved to be passed once: a fold, a condition that is lost, a multiplier that crosses the\n"
    "unit circle, a phase that lasts no time. What cannot be resolved is listed, with its reason.\n\n"
    "All branches are looked for, and that every orbit at any value of the interval is on one\n"
    "of them is proved; where that is not so is listed. With --at only the branches of the\n"
    "orbits at that value are followed.\n\n"
    "A word of S (slip), O (overshoot), T (stick) instead of a family, such as OTS: the branches\n"
    "of those of its admissible orbits at --ur in --period N periods of the load that are found\n"
    "at --at, by default the middle of the interval, of words of four and more phases by\n"
    "simulation; --all, --orbit K and --near follow others.\n\n";

constexpr const char * branch_exits =
    "\nExit code: 0 every change is proved and nothing is unresolved except next to resonances; 2\n"
    "something is; 130 after Ctrl-C.";

constexpr const char * attractors_details =
    "Follows many starts until they have settled, and says on what, and how many on each:\n"
    "periodic motions with their period, in periods of the load, and their word of S (slip),\n"
    "O (overshoot), T (stick); each of these is proved, and whether it is stable. What is\n"
    "quasi-periodic or irregular is distinguished by its largest Lyapunov exponent, which is a check,\n"
    "not a proof. A motion may also slide for ever, be stuck, or remain unsettled.\n"
    "Where omega is a natural frequency and pi p > 4 eta ur all grow without bound, which is proved;\n"
    "with a smaller load there motions are simulated, and none is proved.\n\n"
    "All parameters and --ur are given, or --example; the load is cos(omega t). At the data\n"
    "of an example whose ur is a result, ur is that result to 17 digits.\n\n"
    "Exit code: 0 each periodic motion is proved, and whether it is stable; 2 for some this is\n"
    "undecided; 130 after Ctrl-C.";

constexpr const char * simulate_details =
    "Follows x1, x2 under the friction law in closed form, in double; events are found with\n"
    "certainty, not by signs at the ends of steps. A simulation proves nothing.\n\n"
    "It starts at --state at t = 0, with all parameters, --phi and --ur given; or with\n"
    "--example where the orbit of an example begins, proved; or with --orbit FAMILY:K where\n"
    "orbit K begins of those that stickslip orbits FAMILY lists at the parameters given; plus\n"
    "--perturb. A state is four numbers x1,x2,x1',x2'.\n\n"
    "Samples are taken for --csv and --plot only, and written while the motion is followed:\n"
    "a file of any length needs no memory. Without them it is followed a hundred times as fast.\n\n"
    "Ctrl-C ends the simulation; what was computed is still written, with exit code 130.";

void add_parameter(CLI::App& command, TypedParameters& parameters, const std::string& name,
                   const std::string& description) {
  command
      .add_option_function<std::string>(
          "--" + name, [&parameters, name](const std::string& text) { parameters[name] = text; }, description)
      ->type_name("NUMBER");
}

void add_units(CLI::App& command, std::string& text) {
  add_text(command, "--units", text, "UNITS",
           "si: say times, lengths, velocities and forces in SI units, and\ntake states in them, for a "
           "machine in SI units");
}

}  // namespace

CLI::Option * add_text(CLI::App& command, const char * name, std::string& text, const char * type,
                       const std::string& words) {
  return command.add_option(name, text, words)->type_name(type);
}

void add_machine(CLI::App& command, TypedParameters& parameters) {
  add_parameter(command, parameters, "chi", "Stiffness ratio k2/(k1 + k2), 0 < chi < 1");
  add_parameter(command, parameters, "eta", "Mass ratio m1/m2 > 0");
  add_parameter(command, parameters, "us", "Slipping friction force > 0");
  add_parameter(command, parameters, "V", "Belt velocity; > 0 for orbits with a stick phase");
  add_parameter(command, parameters, "omega", "Frequency of the load > 0");
  add_parameter(command, parameters, "p", "Amplitude of the load >= 0");
  add_parameter(command, parameters, "ur", "Friction force at rest > us");
}

void add_parameters(CLI::App& command, TypedParameters& parameters) {
  add_machine(command, parameters);
  add_parameter(command, parameters, "phi", "Phase of the load, in radians");
}

void add_sources(CLI::App& command, std::string& example, std::string& file, const PaperInHelp& paper) {
  add_text(command, "--example", example, "NAME", "Take the data of the paper's example " + paper.examples);
  add_text(command, "--params", file, "FILE",
           "Take parameters from a TOML file with lines chi = 0.5;\noptions above replace them; or a "
           "machine in SI units,\nsee doc/parameters.md");
}

void add_jobs(CLI::App& command, std::string& text) {
  add_text(command, "--jobs", text, "N",
           "Search and prove with at most N threads, all cores by default;\nthe results are the same");
}

void add_orbits(CLI::App& program, OrbitsOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("orbits", "List all periodic orbits of a family, proved");
  command->footer(orbits_details + paper.families + words_details);
  const auto add = [&](const char * name, std::string& text, const char * type, const std::string& words) {
    return add_text(*command, name, text, type, words);
  };
  add("FAMILY", options.family, "", paper.family_names + "; or a word such as OTS");
  add_parameters(*command, options.parameters);
  add("--period", options.period, "N", "For a word: periods of the load, 1 by default");
  CLI::Option * near =
      add("--near", options.near, "X", "For a word: start at x1,x2,x1',x2', at load phase --phi or 0");
  add_sources(*command, options.example, options.file.name, paper);
  add("--digits", options.digits, "N",
      fmt::format("Significant digits of each value: {} by default, {} at most; of a\nmachine in SI units by "
                  "default as many as its data deserve",
                  OrbitsOptions::default_digits, OrbitsOptions::most_digits));
  add_units(*command, options.units);
  add("--cells", options.cells, "N",
      "Let a search examine N cells before it leaves the rest open,\nin place of its own limit");
  add("--time", options.time, "T", "Let a search go on for T seconds, however many cells it takes");
  add_jobs(*command, options.jobs);
  command->add_flag("--all", options.all, "Also say all about formal solutions, which are not admissible");
  command->add_flag("--json", options.json, "Print the list as JSON");
  CLI::Option * plot = add("--plot", options.plot, "FILE",
                           "Draw the admissible orbits, or all if none is, into FILE.svg,\n"
                           "FILE.pdf or FILE.png: phase portraits and time histories");
  CLI::Option * out = add("--out", options.out, "DIR",
                          "Also write a report into DIR: index.html, orbits.pdf where there is\n"
                          "TeX, orbits.tex and orbits.json. DIR is created if only its last\n"
                          "part is missing");
  add("--certify", options.certify, "DIR",
      "Also write into DIR, for each admissible orbit, a proof for Coq that it\n"
      "exists, and is stable or not; `make -k -j` there has Coq check them");
  command->callback([&options, &request, near, plot, out] {
    options.with_near = near->count() > 0;
    options.with_plot = plot->count() > 0;
    options.with_out = out->count() > 0;
    request = options;
  });
}

void add_branch(CLI::App& program, BranchOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command =
      program.add_subcommand("branch", "Follow orbits over one parameter, every change proved");
  command->footer(branch_details + paper.families + branch_exits);
  const auto add = [&](const char * name, std::string& text, const char * type, const std::string& words) {
    return add_text(*command, name, text, type, words);
  };
  add("FAMILY", options.family, "", paper.family_names);
  add_parameters(*command, options.parameters);
  add_sources(*command, options.example, options.file.name, paper);
  command
      ->add_option("--along", options.along,
                   "The parameter that varies and its interval, such as omega 0.5..0.6,\nor load_frequency "
                   "7..8 of a machine in SI units")
      ->expected(2)
      ->type_name("NAME A..B");
  add("--units", options.units, "UNITS",
      "si: results are in SI units; those of a machine in SI units\nalways are");
  add("--at", options.at, "NUMBER",
      "The branches of the orbits that there are at this value of the\nparameter alone");
  add("--period", options.period, "N", "For a word: periods of the load, 1 by default");
  CLI::Option * orbit =
      add("--orbit", options.orbit, "K", "For a word: orbit K of those that orbits WORD lists");
  CLI::Option * near =
      add("--near", options.near, "X", "For a word: the orbit near x1,x2,x1',x2' at load phase 0");
  command->add_flag("--all", options.all, "For a word: orbits that are not admissible, too")
      ->excludes(orbit)
      ->excludes(near);
  orbit->excludes(near);
  add("--csv", options.csv, "FILE", "Also write an orbit of each part as a table");
  add("--plot", options.plot, "FILE", "Draw the bifurcation diagram into FILE.svg, FILE.pdf or FILE.png");
  CLI::Option * out =
      add("--out", options.out, "DIR",
          "Also write a page into DIR, with the diagram and all tables:\nindex.html, branches.json, "
          "branches.csv. DIR is created if only\nits last part is missing");
  add_jobs(*command, options.jobs);
  command->add_flag("--json", options.json, "Print the result as JSON");
  command->callback([&options, &request, out] {
    options.with_out = out->count() > 0;
    request = options;
  });
}

void add_attractors(CLI::App& program, AttractorsOptions& options, Request& request,
                    const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("attractors", "Find what a machine does, and prove it");
  command->footer(attractors_details);
  add_machine(*command, options.parameters);
  const auto add = [&](const char * name, std::string& text, const char * type, const std::string& words) {
    return add_text(*command, name, text, type, words);
  };
  add_sources(*command, options.example, options.file.name, paper);
  add("--starts", options.starts, "N",
      fmt::format("Random starts: {} by default", AttractorsOptions::default_starts));
  add("--seed", options.seed, "N", "Of the random starts: 1 by default");
  add("--most-periods", options.most_periods, "N",
      fmt::format("Periods of the load that a start is followed for at most:\n{} by default",
                  AttractorsOptions::default_most_periods));
  command
      ->add_option(
          "--along", options.along,
          "At each of many values of a parameter, such as ur 0.1..0.5, or\nload_frequency 2..4 of a machine "
          "in SI units: a table; --csv and\n--plot have the states once a period of the load")
      ->expected(2)
      ->type_name("NAME A..B");
  add("--values", options.values, "N",
      fmt::format("Of the parameter, ends included: {} by default, with {} starts each",
                  AttractorsOptions::default_values, AttractorsOptions::default_starts_at_value));
  add("--plane", options.plane, "X,Y", "Starts in a plane, by two of x1, x2, x1', x2': what each ends on");
  add("--pixels", options.pixels, "N",
      fmt::format("N x N of them: {} by default", AttractorsOptions::default_pixels));
  add("--through", options.through, "X", "A state x1,x2,x1',x2' in the middle of the plane");
  add("--csv", options.csv, "FILE", "With --along and --plane: also write a table");
  add("--plot", options.plot, "FILE", "With --along and --plane: draw FILE.svg, FILE.pdf or FILE.png");
  CLI::Option * out =
      add("--out", options.out, "DIR",
          "Also write a page into DIR, with pictures: index.html and\nattractors.json. DIR is "
          "created if only its last part is missing");
  add("--digits", options.digits, "N",
      fmt::format("Significant digits of each value in JSON: {} by default; of what is\nsaid about a machine "
                  "in SI units: as many as its data deserve",
                  OrbitsOptions::default_digits));
  add_units(*command, options.units);
  add_jobs(*command, options.jobs);
  command->add_flag("--json", options.json, "Print the result as JSON");
  command->callback([&options, &request, out] {
    options.with_out = out->count() > 0;
    request = options;
  });
}

void add_simulate(CLI::App& program, SimulateOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("simulate", "Follow the motion under the friction law");
  command->footer(simulate_details);
  add_parameters(*command, options.parameters);
  const auto add = [&](const char * name, std::string& text, const char * type, const std::string& words) {
    return add_text(*command, name, text, type, words);
  };
  add("--example", options.example, "NAME",
      "Start where the orbit of the paper's example " + paper.examples + " begins");
  add("--params", options.file.name, "FILE",
      "Take parameters from a TOML file with lines chi = 0.5;\nor a machine in SI units, see "
      "doc/parameters.md");
  CLI::Option * orbit = add("--orbit", options.orbit, "FAMILY:K",
                            "Start where orbit K of a family begins: " + paper.family_names);
  add("--state", options.state, "X", "Start at x1,x2,x1',x2'")->excludes(orbit);
  add("--perturb", options.perturb, "X", "Add these four numbers to the start");
  add("--periods", options.periods, "N",
      fmt::format("Periods of the load: {} by default", SimulateOptions::default_periods));
  add("--every", options.every, "TIME",
      fmt::format("Time between two samples: by default {} in a period", SimulateOptions::samples_in_period));
  CLI::Option * csv =
      add("--csv", options.csv, "FILE",
          "Write the samples, with r, u and the energy; -: on standard\noutput, in place of the report");
  CLI::Option * plot = add("--plot", options.plot, "FILE",
                           "Draw phase portraits, speed and energy into FILE.svg, FILE.pdf or\nFILE.png");
  add_units(*command, options.units);
  command->add_flag("--json", options.json, "Print the result as JSON");
  command->callback([&options, &request, csv, plot] {
    options.with_csv = csv->count() > 0;
    options.with_plot = plot->count() > 0;
    request = options;
  });
}

}  // namespace stickslip::cli
