#include "cli/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/error.hpp"

namespace stickslip::cli {
namespace {

constexpr const char * exit_codes =
    "stickslip COMMAND --help says more about a command.\n\n"
    "Exit codes: 0 asked and decided, 1 check met a refuted statement, 2 something is\n"
    "undecided, 64 the command line is not understood, 65 parameters outside the domain,\n"
    "70 fault of the program or out of memory, 74 input or output failed, 130 interrupted.";

constexpr const char * orbits_details =
    "Searches the whole closed domain of the family and lists every orbit, each proved to\n"
    "exist, with every condition decided along the whole motion; what could not be decided\n"
    "is listed too.\n\n"
    "A number is a decimal or a fraction and is taken exactly: 0.1607, 2.5e-3, 1/3. With\n"
    "0.5+-1e-4 for some parameters, each orbit is proved for all values in the box.\n\n"
    "symmetric     ur and phi are results and are not given.\n"
    "overshooting  exactly one of --phi and --ur is given; the other is a result.\n"
    "nonsticking   phi is a result; without --ur the largest admissible one is, ur_max,\n"
    "              and \"admissible\" speaks of all other conditions.\n\n"
    "A word of S (slip), O (overshoot), T (stick), such as OTS, in place of a family: the\n"
    "orbits through these phases in --period N periods of the load, at --ur, that a\n"
    "simulation finds, from --near at t = 0 or from random starts; the load is cos(omega t).\n"
    "Each is proved. For ST without --near the list is complete, for V > 0; for another word\n"
    "it never is.\n\n"
    "Exit code: 0 the list is complete, or not empty where it cannot be, and everything in it\n"
    "is decided, also if no orbit is admissible; 2 something is undecided or unresolved; 130\n"
    "after Ctrl-C, which ends the search: what it has found is still printed and written,\n"
    "marked as interrupted.";

constexpr const char * attractors_details =
    "Follows many starts until they have settled, and says on what, and how many on each:\n"
    "periodic motions with their period, in periods of the load, and their word of S (slip),\n"
    "O (overshoot), T (stick); each of these is proved, and whether it is stable. What is\n"
    "quasi-periodic or irregular is told by its largest Lyapunov exponent, which is a check\n"
    "and no proof. A motion may also slide for ever, be stuck, or remain unsettled.\n\n"
    "All parameters and --ur are given, or --example; the load is cos(omega t). At the data\n"
    "of an example whose ur is a result, ur is that result to 17 digits.\n\n"
    "Exit code: 0 each periodic motion is proved, and stable or not; 2 for some that is\n"
    "undecided; 130 after Ctrl-C.";

constexpr const char * simulate_details =
    "Follows x1, x2 under the friction law in closed form, in double; events are found with\n"
    "certainty, not by signs at the ends of steps. A simulation proves nothing.\n\n"
    "It starts at --state at t = 0, with all parameters, --phi and --ur given; or with\n"
    "--example where the orbit of an example begins, proved, plus --perturb. A state is four\n"
    "numbers x1,x2,x1',x2'.\n\n"
    "Ctrl-C ends the simulation; what was computed is still written, with exit code 130.";

void add_parameter(CLI::App& command, TypedParameters& parameters, const std::string& name,
                   const std::string& description) {
  command
      .add_option_function<std::string>(
          "--" + name, [&parameters, name](const std::string& text) { parameters[name] = text; }, description)
      ->type_name("NUMBER");
}

// Options --chi, --eta, … for those of a machine, whose load is cos(omega t).
void add_machine(CLI::App& command, TypedParameters& parameters) {
  add_parameter(command, parameters, "chi", "Stiffness ratio k2/(k1 + k2), 0 < chi < 1");
  add_parameter(command, parameters, "eta", "Mass ratio m1/m2 > 0");
  add_parameter(command, parameters, "us", "Slipping friction force > 0");
  add_parameter(command, parameters, "V", "Belt velocity; > 0 for orbits with a stick phase");
  add_parameter(command, parameters, "omega", "Frequency of the load > 0");
  add_parameter(command, parameters, "p", "Amplitude of the load >= 0");
  add_parameter(command, parameters, "ur", "Friction force at rest > us");
}

// The same and --phi.
void add_parameters(CLI::App& command, TypedParameters& parameters) {
  add_machine(command, parameters);
  add_parameter(command, parameters, "phi", "Phase of the load");
}

void add_units(CLI::App& command, std::string& text) {
  command
      .add_option("--units", text,
                  "si: say times, lengths, velocities and forces in SI units, for a\nmachine in SI units")
      ->type_name("UNITS");
}

void add_jobs(CLI::App& command, std::string& text) {
  command
      .add_option("--jobs", text,
                  "Search and prove with at most N threads, all cores by default;\nthe results are the same")
      ->type_name("N");
}

bool is_omega(const std::string& word) {
  if (word != "chi" && word != "omega") {
    throw CLI::ValidationError("--in", "'" + word + "' is neither chi nor omega");
  }
  return word == "omega";
}

// Each adds one command: parsing it fills its options and makes them the request.
void add_audit(CLI::App& program, AuditOptions& options, Request& request) {
  CLI::App * command = program.add_subcommand("audit", "Examine every statement of the paper and report");
  command->footer(
      "Prints a table of all statements with their status, then the findings with their\n"
      "reasons, then the printed numbers beside the proved ones.\n\n"
      "Exit code: 0 everything is decided, also if the paper has misprints;\n"
      "1 with --mutants: a wrong statement is proved;\n"
      "2 something is undecided.");
  CLI::Option * out = command->add_option("--out", options.out,
                                          "Also write the report into DIR: pages for a browser that begin\n"
                                          "with index.html, audit.pdf where there is TeX, audit.tex and\n"
                                          "audit.json. DIR is created if only its last part is missing");
  out->type_name("DIR");
  add_jobs(*command, options.jobs);
  command->add_flag("--json", options.json, "Print the results as JSON instead of the table");
  CLI::Option * mutants = command->add_flag("--mutants", options.mutants,
                                            "Also put wrong statements to the proofs, made by single edits\n"
                                            "of all formulas, and say what became of them: takes minutes");
  command->add_option("--one-in", options.one_in, "Take a random sample of them, one in N")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->needs(mutants);
  command->add_option("--seed", options.seed, "The seed of that sample")->type_name("N")->needs(mutants);
  command->callback([&options, &request, out] {
    options.with_out = out->count() > 0;
    request = options;
  });
}

void add_check(CLI::App& program, CheckOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("check", "Prove single statements, equations or sections");
  command->footer(
      "Exit code: 0 every statement asked for holds, possibly corrected or under the hypotheses\n"
      "listed;\n"
      "1 one of them is refuted;\n"
      "2 none is refuted, one is undecided.");
  command
      ->add_option(
          "ID", options.words,
          fmt::format("What to check: a statement ({}), an equation with all its\nparts ({}), a "
                      "place in the paper\n({}),\na kind (theorem, condition, ...), an origin "
                      "(paper, new,\n...), a status (refuted, digits_off, ...); everything if none is "
                      "given",
                      paper.part, paper.equation(), paper.places))
      ->type_name("");
  CLI::Option * list =
      command->add_flag("--list", options.list, "Only list the statements, without proving them");
  command->add_flag(
      "--explain", options.explain,
      "Say all about each: formula, assumptions, proof, hypotheses,\nwhat it uses and what uses it");
  add_jobs(*command, options.jobs);
  CLI::Option * json = command->add_flag("--json", options.json, "Print the results as JSON");
  list->excludes(json);
  command->callback([&options, &request] { request = options; });
}

void add_latex(CLI::App& program, LatexOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("latex", "Print derived expressions as LaTeX");
  command->footer(
      "Displayed equations for a document with the amsmath package: stickslip latex H > H.tex\n"
      "Every formula is printed from the one that the proofs are about; two runs print the\n"
      "same characters.");
  CLI::Option * names =
      command
          ->add_option(
              "NAME", options.names,
              fmt::format("What to print: a derived expression (H, Gamma, Q, ...) or a\nstatement as it is "
                          "proved ({}, {}, ...); all derived\nexpressions if none is given",
                          paper.equation(), paper.part))
          ->type_name("");
  CLI::Option * list = command->add_flag("--list", options.list, "List the names, with equation numbers");
  command
      ->add_flag(
          "--errata", options.errata,
          "A document with the errata of the paper and the hypotheses\nto be added, after proving everything")
      ->excludes(list)
      ->excludes(names);
  command
      ->add_option("--theorem", options.theorem,
                   "A result of the audit as a theorem, with the idea of its proof,\nafter proving it")
      ->type_name("ID")
      ->excludes(list)
      ->excludes(names)
      ->excludes(command->get_option("--errata"));
  command
      ->add_option_function<std::string>(
          "--in", [&options](const std::string& word) { options.in_frequencies = is_omega(word); },
          "chi (the default): with chi, eta and the abbreviations omega_j,\nlambda_j; omega: with the "
          "natural "
          "frequencies alone")
      ->type_name("WORD");
  command->callback([&options, &request] { request = options; });
}

void add_orbits(CLI::App& program, OrbitsOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("orbits", "List all periodic orbits of a family, proved");
  command->footer(orbits_details);
  command->add_option("FAMILY", options.family, "symmetric, overshooting, nonsticking, or a word such as OTS")
      ->type_name("");
  add_parameters(*command, options.parameters);
  command->add_option("--period", options.period, "Of a word: periods of the load, 1 by default")
      ->type_name("N");
  CLI::Option * near = command->add_option("--near", options.near, "Of a word: start at x1,x2,x1',x2'");
  near->type_name("X");
  command->add_option("--example", options.example, "Take the data of the paper's example " + paper.examples)
      ->type_name("NAME");
  command
      ->add_option("--params", options.file,
                   "Take parameters from a TOML file with lines chi = 0.5;\noptions above replace them; or a "
                   "machine in SI units,\nas the README says")
      ->type_name("FILE");
  command
      ->add_option("--digits", options.digits,
                   fmt::format("Significant digits of each value: {} by default, {} at most",
                               OrbitsOptions::default_digits, OrbitsOptions::most_digits))
      ->type_name("N");
  add_units(*command, options.units);
  add_jobs(*command, options.jobs);
  command->add_flag("--json", options.json, "Print the list as JSON");
  CLI::Option * plot = command->add_option("--plot", options.plot,
                                           "Draw the admissible orbits, or all if none is, into FILE.svg or\n"
                                           "FILE.pdf: phase portraits and time histories");
  plot->type_name("FILE");
  CLI::Option * out =
      command->add_option("--out", options.out,
                          "Also write a report into DIR: index.html, orbits.pdf where there is\n"
                          "TeX, orbits.tex and orbits.json. DIR is created if only its last\n"
                          "part is missing");
  out->type_name("DIR");
  command->callback([&options, &request, near, plot, out] {
    options.with_near = near->count() > 0;
    options.with_plot = plot->count() > 0;
    options.with_out = out->count() > 0;
    request = options;
  });
}

void add_attractors(CLI::App& program, AttractorsOptions& options, Request& request,
                    const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("attractors", "Find what a machine does, and prove it");
  command->footer(attractors_details);
  add_machine(*command, options.parameters);
  const auto add = [&](const char * name, std::string& value, const char * type, const std::string& words) {
    command->add_option(name, value, words)->type_name(type);
  };
  add("--example", options.example, "NAME", "Take the data of the paper's example " + paper.examples);
  add("--params", options.file, "FILE",
      "Take parameters from a TOML file with lines chi = 0.5;\noptions above replace them; or a machine in "
      "SI units,\nas the README says");
  add("--starts", options.starts, "N",
      fmt::format("Random starts: {} by default", AttractorsOptions::default_starts));
  add("--seed", options.seed, "N", "Of the random starts: 1 by default");
  add("--most-periods", options.most_periods, "N",
      fmt::format("Periods of the load that a start is followed for at most:\n{} by default",
                  AttractorsOptions::default_most_periods));
  add("--digits", options.digits, "N",
      fmt::format("Significant digits of each value in JSON: {} by default", OrbitsOptions::default_digits));
  add_units(*command, options.units);
  add_jobs(*command, options.jobs);
  command->add_flag("--json", options.json, "Print the result as JSON");
  command->callback([&options, &request] { request = options; });
}

void add_simulate(CLI::App& program, SimulateOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("simulate", "Follow the motion under the friction law");
  command->footer(simulate_details);
  add_parameters(*command, options.parameters);
  const auto add = [&](const char * name, std::string& value, const char * type, const std::string& words) {
    command->add_option(name, value, words)->type_name(type);
  };
  add("--example", options.example, "NAME",
      "Start where the orbit of the paper's example " + paper.examples + " begins");
  add("--params", options.file, "FILE",
      "Take parameters from a TOML file with lines chi = 0.5;\nor a machine in SI units, as the README says");
  add("--state", options.state, "X", "Start at x1,x2,x1',x2'");
  add("--perturb", options.perturb, "X", "Add these four numbers to the start");
  add("--periods", options.periods, "N",
      fmt::format("Periods of the load: {} by default", SimulateOptions::default_periods));
  add("--every", options.every, "TIME",
      fmt::format("Time between two samples: by default {} in a period", SimulateOptions::samples_in_period));
  add("--csv", options.csv, "FILE", "Write the samples, with r, u and the energy");
  add("--plot", options.plot, "FILE", "Draw phase portraits, speed and energy into FILE.svg or FILE.pdf");
  command->callback([&options, &request] { request = options; });
}

// The arguments that the program, as opposed to its commands, was given beyond its own.
void require_command(const CLI::App& program) {
  const std::vector<std::string> strangers = program.remaining();
  const std::string known =
      "the commands are audit, check, latex, orbits, attractors and simulate; see stickslip --help";
  if (!strangers.empty()) {
    const std::string kind = strangers.front().starts_with("-") ? "option" : "command";
    throw UsageError(fmt::format("there is no {} {}: {}", kind, strangers.front(), known));
  }
  if (program.get_subcommands().empty()) {
    throw UsageError("a command is missing: " + known);
  }
}

}  // namespace

Request parse(int argc, const char * const * argv, const PaperInHelp& paper) {
  AuditOptions audit;
  CheckOptions check;
  LatexOptions latex;
  OrbitsOptions orbits;
  AttractorsOptions attractors;
  SimulateOptions simulate;
  Request request;
  CLI::App program(paper.about, "stickslip");
  program.footer(exit_codes);
  program.set_version_flag(
      "--version", [] { return std::string(); }, "Print the versions of the program and of its libraries");
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(16);
  add_audit(program, audit, request);
  add_check(program, check, request, paper);
  add_latex(program, latex, request, paper);
  add_orbits(program, orbits, request, paper);
  add_attractors(program, attractors, request, paper);
  add_simulate(program, simulate, request, paper);
  program.allow_extras();
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForVersion&) {
    return VersionsWanted{};
  } catch (const CLI::Success&) {
    return HelpWanted{program.help()};
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}; see stickslip --help", error.what()));
  }
  require_command(program);
  return request;
}

}  // namespace stickslip::cli
