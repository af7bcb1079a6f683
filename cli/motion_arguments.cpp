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
    "A machine with dashpots, more masses, friction that depends on the velocity or several loads\n"
    "stands in tables, [[mass]], [[spring]], ..., of the file of --params: doc/any_machine.md.\n\n"
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

constexpr const char * units_details =
    "si: say times, lengths, velocities and forces in SI units, and\ntake states in them, for a machine in "
    "SI "
    "units";

}  // namespace

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

void add_sources(CLI::App& command, GivenMachine& given, const PaperInHelp& paper) {
  command.add_option("--example", given.example, "Take the data of the paper's example " + paper.examples)
      ->type_name("NAME");
  command
      .add_option("--params", given.file.name,
                  "Take parameters from a TOML file with lines chi = 0.5;\noptions above replace them; or a "
                  "machine in SI units,\nsee doc/parameters.md")
      ->type_name("FILE");
}

void add_orbits(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<OrbitsOptions> c(program, request, "orbits", "List all periodic orbits of a family, proved");
  OrbitsOptions& o = c.options;
  c.app.footer(orbits_details + paper.families + words_details);
  c.add("FAMILY", o.family, "", paper.family_names + "; or a word such as OTS");
  add_parameters(c.app, o.parameters);
  c.add("--period", o.period, OrbitsOptions::most_periods_of_word,
        "For a word: periods of the load, 1 by default");
  c.add("--near", o.near, "X", "For a word: start at x1,x2,x1',x2', at load phase --phi or 0", state);
  add_sources(c.app, o, paper);
  c.add(
      "--digits", o.digits, OrbitsOptions::most_digits,
      fmt::format("Significant digits of each value: {} by default, {} at most; of a\nmachine in SI units by "
                  "default as many as its data deserve",
                  OrbitsOptions::default_digits, OrbitsOptions::most_digits));
  c.add_units(units_details);
  c.add("--cells", o.cells, OrbitsOptions::most_cells,
        "Let a search examine N cells before it leaves the rest open,\nin place of its own limit");
  c.add("--time", o.time, "T", "Let a search go on for T seconds, however many cells it takes", positive);
  c.add_jobs();
  c.app.add_flag("--all", o.all, "Also say all about formal solutions, which are not admissible");
  c.app.add_flag("--json", o.json, "Print the list as JSON");
  c.add("--plot", o.plot, "FILE",
        "Draw the admissible orbits, or all if none is, into FILE.svg,\n"
        "FILE.pdf or FILE.png: phase portraits and time histories");
  c.add("--out", o.out, "DIR",
        "Also write a report into DIR: index.html, orbits.pdf where there is\n"
        "TeX, orbits.tex and orbits.json. DIR is created if only its last\n"
        "part is missing");
  c.add("--certify", o.certify, "DIR",
        "Also write into DIR, for each admissible orbit, a proof for Coq that it\n"
        "exists, and is stable or not; `make -k -j` there has Coq check them");
}

void add_branch(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<BranchOptions> c(program, request, "branch",
                           "Follow orbits over one parameter, every change proved");
  BranchOptions& o = c.options;
  c.app.footer(branch_details + paper.families + branch_exits);
  c.add("FAMILY", o.family, "", paper.family_names);
  add_parameters(c.app, o.parameters);
  add_sources(c.app, o, paper);
  c.app
      .add_option("--along", o.along,
                  "The parameter that varies and its interval, such as omega 0.5..0.6,\nor load_frequency "
                  "7..8 of a machine in SI units")
      ->expected(2)
      ->type_name("NAME A..B");
  c.add_units("si: results are in SI units; those of a machine in SI units\nalways are");
  c.add("--at", o.at, "NUMBER",
        "The branches of the orbits that there are at this value of the\nparameter alone", exact_number);
  c.add("--period", o.period, OrbitsOptions::most_periods_of_word,
        "For a word: periods of the load, 1 by default");
  CLI::Option * orbit = c.add("--orbit", o.orbit, OrbitsOptions::most_orbits,
                              "For a word: orbit K of those that orbits WORD lists", "K");
  CLI::Option * near =
      c.add("--near", o.near, "X", "For a word: the orbit near x1,x2,x1',x2' at load phase 0", state);
  c.app.add_flag("--all", o.all, "For a word: orbits that are not admissible, too")
      ->excludes(orbit)
      ->excludes(near);
  orbit->excludes(near);
  c.add("--csv", o.csv, "FILE", "Also write an orbit of each part as a table");
  c.add("--plot", o.plot, "FILE", "Draw the bifurcation diagram into FILE.svg, FILE.pdf or FILE.png");
  c.add("--out", o.out, "DIR",
        "Also write a page into DIR, with the diagram and all tables:\nindex.html, branches.json, "
        "branches.csv. DIR is created if only\nits last part is missing");
  c.add_jobs();
  c.app.add_flag("--json", o.json, "Print the result as JSON");
}

void add_attractors(CLI::App& program, Request& request, const PaperInHelp& paper) {
  using Attracted = AttractorsOptions;
  Command<Attracted> c(program, request, "attractors", "Find what a machine does, and prove it");
  Attracted& o = c.options;
  c.app.footer(attractors_details);
  add_machine(c.app, o.parameters);
  add_sources(c.app, o, paper);
  c.add("--starts", o.starts, Attracted::most_starts,
        fmt::format("Random starts: {} by default", Attracted::default_starts));
  c.add("--seed", o.seed, Attracted::greatest_number, "Of the random starts: 1 by default");
  c.add("--most-periods", o.most_periods, Attracted::greatest_number,
        fmt::format("Periods of the load that a start is followed for at most:\n{} by default",
                    Attracted::default_most_periods));
  c.app
      .add_option(
          "--along", o.along,
          "At each of many values of a parameter, such as ur 0.1..0.5, of a\nmachine in SI units, "
          "load_frequency 2..4, or of one in tables,\nbelt.velocity 0.1..0.2: a table; --csv and --plot "
          "have the states\nonce a period of the load")
      ->expected(2)
      ->type_name("NAME A..B");
  c.add("--values", o.values, Attracted::most_values,
        fmt::format("Of the parameter, ends included: {} by default, with {} starts each",
                    Attracted::default_values, Attracted::default_starts_at_value));
  c.add("--plane", o.plane, "X,Y", "Starts in a plane, by two of x1, x2, x1', x2': what each ends on");
  c.add("--pixels", o.pixels, Attracted::most_pixels,
        fmt::format("N x N of them: {} by default", Attracted::default_pixels));
  c.add("--through", o.through, "X", "A state x1,x2,x1',x2' in the middle of the plane", state);
  c.add("--csv", o.csv, "FILE", "With --along and --plane: also write a table");
  c.add("--plot", o.plot, "FILE", "With --along and --plane: draw FILE.svg, FILE.pdf or FILE.png");
  c.add("--out", o.out, "DIR",
        "Also write a page into DIR, with pictures: index.html and\nattractors.json. DIR is "
        "created if only its last part is missing");
  c.add(
      "--digits", o.digits, OrbitsOptions::most_digits,
      fmt::format("Significant digits of each value in JSON: {} by default; of what is\nsaid about a machine "
                  "in SI units: as many as its data deserve",
                  OrbitsOptions::default_digits));
  c.add_units(units_details);
  c.add_jobs();
  c.app.add_flag("--json", o.json, "Print the result as JSON");
}

void add_simulate(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<SimulateOptions> c(program, request, "simulate", "Follow the motion under the friction law");
  SimulateOptions& o = c.options;
  c.app.footer(simulate_details);
  add_parameters(c.app, o.parameters);
  c.add("--example", o.example, "NAME",
        "Start where the orbit of the paper's example " + paper.examples + " begins");
  c.add("--params", o.file.name, "FILE",
        "Take parameters from a TOML file with lines chi = 0.5;\nor a machine in SI units, see "
        "doc/parameters.md");
  CLI::Option * orbit =
      c.add("--orbit", o.orbit, "FAMILY:K", "Start where orbit K of a family begins: " + paper.family_names);
  c.add("--state", o.state, "X", "Start at x1,x2,x1',x2'", state)->excludes(orbit);
  c.add("--perturb", o.perturb, "X", "Add these four numbers to the start", state);
  c.add("--periods", o.periods, "N",
        fmt::format("Periods of the load: {} by default", SimulateOptions::default_periods), positive);
  c.add("--time", o.duration, "TIME", "How long, in place of --periods", positive);
  c.add(
      "--every", o.every, "TIME",
      fmt::format("Time between two samples: by default {} in a period", SimulateOptions::samples_in_period),
      positive);
  c.add("--csv", o.csv, "FILE",
        "Write the samples, with r, u and the energy; -: on standard\noutput, in place of the report");
  c.add("--plot", o.plot, "FILE",
        "Draw phase portraits, speed and energy into FILE.svg, FILE.pdf or\nFILE.png");
  c.add_units(units_details);
  c.app.add_flag("--json", o.json, "Print the result as JSON");
}

}  // namespace stickslip::cli
