#include "cli/arguments.hpp"

#include <fmt/format.h>

#include "cli/command_line.hpp"
#include "core/error.hpp"

namespace stickslip::cli {
namespace {

constexpr const char * exit_codes =
    "stickslip COMMAND --help says more about a command.\n\n"
    "Exit codes: 0 asked and decided, 1 check met a refuted statement, 2 something is\n"
    "undecided, 64 the command line is not understood, 65 parameters outside the domain,\n"
    "70 fault of the program or out of memory, 74 input or output failed, 130 interrupted.";

bool is_omega(const std::string& word) {
  if (word != "chi" && word != "omega") {
    throw UsageError("in: '" + word + "' is neither chi nor omega");
  }
  return word == "omega";
}

// A file of claims among words that name claims: the first that ends so.
void take_file(std::vector<std::string>& words, std::string& file) {
  const auto found =
      std::ranges::find_if(words, [](const std::string& word) { return word.ends_with(".claims"); });
  if (found != words.end()) {
    file = *found;
    words.erase(found);
  }
}

void add_audit(CLI::App& program, AuditOptions& options, Request& request) {
  CLI::App * command = program.add_subcommand("audit", "Examine every statement of the paper and report");
  command->footer(
      "Prints a table of all statements with their status, then the findings with their\n"
      "reasons, then the printed numbers beside the proved ones.\n\n"
      "Exit code: 0 everything is decided, also if the paper has misprints;\n"
      "1 with --mutants: a wrong statement is proved;\n"
      "2 something is undecided;\n"
      "130 after Ctrl-C, which ends it: what is done is printed, and no report written.");
  command
      ->add_option("FILE", options.claims,
                   "A paper of your own: a file of claims, NAME.claims; the paper\nif none is given")
      ->type_name("");
  CLI::Option * out = add_text(*command, "--out", options.out, "DIR",
                               "Also write the report into DIR: pages for a browser that begin\n"
                               "with index.html, audit.pdf where there is TeX, audit.tex and\n"
                               "audit.json. DIR is created if only its last part is missing");
  add_jobs(*command, options.jobs);
  command->add_flag("--json", options.json, "Print the results as JSON instead of the table");
  CLI::Option * mutants = command->add_flag("--mutants", options.mutants,
                                            "Also put wrong statements to the proofs, made by single edits\n"
                                            "of all formulas, and say what became of them: takes minutes");
  add_text(*command, "--one-in", options.one_in, "N", "Take a random sample of them, one in N")
      ->needs(mutants);
  add_text(*command, "--seed", options.seed, "N", "The seed of that sample")->needs(mutants);
  add_text(*command, "--certificates", options.certificates, "DIR",
           "The directory in which script/certify had Coq check the\nproofs: say of each claim whether it is "
           "certified");
  command->callback([&options, &request, out] {
    if (!options.claims.empty() && !options.claims.ends_with(".claims")) {
      throw UsageError("stickslip audit does not know what to do with '" + options.claims +
                       "': a file of claims is called NAME.claims");
    }
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
                      "given.\nA file NAME.claims among them: its claims in the place of the paper's",
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
  command->callback([&options, &request] {
    take_file(options.words, options.claims);
    request = options;
  });
}

void add_prove(CLI::App& program, ProveOptions& options, Request& request) {
  CLI::App * command = program.add_subcommand("prove", "Prove or refute a statement of your own");
  command->footer(
      "The notation is that in which check prints statements:\n"
      "  stickslip prove \"H1(t)^2 - I = H2(t) H3(t)\"\n"
      "  stickslip prove \"Theta = tau + T\" \"omega Theta = 2 pi\" \"T = 2 pi/omega - tau\"\n"
      "  stickslip prove \"a^2 + b^2 >= 2 a b\" --symbols a,b\n"
      "Greek letters, subscripts, powers and relations may also be typed as such: \u03c9\u2081\u00b2 \u2264 "
      "\u03c9\u2082\u00b2.\n"
      "\n"
      "Exit code: 0 it is proved, perhaps under the hypotheses listed; 1 it is refuted;\n"
      "2 undecided.");
  command
      ->add_option(
          "STATEMENT", options.statement,
          "An equation or an inequality in the paper's symbols (check --list\nnames where they occur)")
      ->type_name("")
      ->required();
  command->add_option("ASSUMPTION", options.assumptions, "What it assumes")->type_name("");
  command->add_option("--symbols", options.symbols, "Names of further numbers, with commas between them")
      ->type_name("NAMES")
      ->delimiter(',');
  CLI::Option * explain = command->add_flag("--explain", options.explain, "Say all about its proof");
  add_text(*command, "--certificate", options.certificate, "DIR",
           "Write its proof for the proof assistant Coq");
  CLI::Option * json = command->add_flag("--json", options.json, "Print the result as JSON");
  explain->excludes(json);
  command->callback([&options, &request] { request = options; });
}

void add_certify(CLI::App& program, CertifyOptions& options, Request& request, const PaperInHelp& paper) {
  CLI::App * command = program.add_subcommand("certify", "Write proofs that the proof assistant Coq checks");
  command->footer(
      "Writes a file for each statement, with its theorem in full and the proof, what they stand\n"
      "on, and a Makefile: make -k -j in DIR has Coq check them. script/certify does all of it.\n\n"
      "Exit code: 0 every statement asked for that the kernel proves has a certificate;\n"
      "1 with --record: one is not accepted;\n"
      "2 one has none.");
  CLI::Option * ids =
      command
          ->add_option(
              "ID", options.words,
              fmt::format("What to certify: as for check ({}, {}, {}, ...); everything if\nnone is given",
                          paper.part, paper.equation(), paper.places.substr(0, paper.places.find(','))))
          ->type_name("");
  CLI::Option * out = add_text(
      *command, "--out", options.out, "DIR",
      "Where to: a new directory, an empty one, or one with\ncertificates, which are kept; files that "
      "are the same stay\nas they are");
  add_text(*command, "--record", options.record, "DIR",
           "Instead: look at what Coq said of the certificates in DIR,\nprint it, and write it to "
           "DIR/certificates.json")
      ->excludes(out)
      ->excludes(ids);
  command->callback([&options, &request] {
    take_file(options.words, options.claims);
    if (options.out.empty() && options.record.empty()) {
      throw UsageError("stickslip certify needs --out DIR, or --record DIR");
    }
    request = options;
  });
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
              fmt::format("What to print: a derived expression (H, Gamma, Q, ...), with its\nvalues where "
                          "parameters are given; or a statement as it is proved\n({}, {}, ...); all "
                          "derived expressions if none is given.\nAfter NAME.claims: statements of that file",
                          paper.equation(), paper.part))
          ->type_name("");
  CLI::Option * list = command->add_flag("--list", options.list, "List the names, with equation numbers");
  CLI::Option * bare = command->add_flag("--bare", options.bare,
                                         "The formulas alone, without headings and \\[ \\]: lines for an\n"
                                         "environment of your own, such as gather*");
  command
      ->add_flag(
          "--errata", options.errata,
          "A document with the errata of the paper and the hypotheses\nto be added, after proving everything")
      ->excludes(list);
  add_text(*command, "--theorem", options.theorem, "ID",
           "A result of the audit as a theorem, with the idea of its proof,\nafter proving it")
      ->excludes(list)
      ->excludes(command->get_option("--errata"));
  command
      ->add_option_function<std::string>(
          "--in", [&options](const std::string& word) { options.in_frequencies = is_omega(word); },
          "chi (the default): with chi, eta and the abbreviations omega_j,\nlambda_j; omega: with the "
          "natural "
          "frequencies alone")
      ->type_name("WORD");
  add_text(*command, "--orbit", options.orbit, "FAMILY:K",
           "The closed forms of orbit K of a family, phase by phase, with its\nnumbers, at the parameters "
           "below: " +
               paper.family_names)
      ->excludes(list)
      ->excludes(names)
      ->excludes(command->get_option("--errata"))
      ->excludes(command->get_option("--theorem"))
      ->excludes(command->get_option("--in"));
  for (const char * name : {"--list", "--errata", "--theorem", "--orbit"}) {
    bare->excludes(command->get_option(name));
  }
  add_parameters(*command, options.parameters);
  add_sources(*command, options.example, options.file.name, paper);
  add_text(*command, "--digits", options.digits, "N",
           fmt::format("Significant digits of numbers: {} by default", LatexOptions::default_digits));
  command->callback([&options, &request] {
    take_file(options.names, options.claims);  // a file goes with them, a name does not
    if (!options.names.empty() && (options.errata || !options.theorem.empty())) {
      throw UsageError(
          fmt::format("NAME and {} do not go together", options.errata ? "--errata" : "--theorem"));
    }
    request = options;
  });
}

}  // namespace

namespace {

// A statement that begins with a minus sign is no option: it is typed for the parser's other minus sign.
std::string as_statement(const std::string& word) {
  const bool is_option =
      !word.starts_with('-') || word.starts_with("--") || word.find_first_of("=<>!") == std::string::npos;
  return is_option ? word : "\u2212" + word.substr(1);
}

}  // namespace

Request parse(int argc, const char * const * argv, const PaperInHelp& paper) {
  AuditOptions audit;
  CheckOptions check;
  ProveOptions prove;
  CertifyOptions certify;
  LatexOptions latex;
  OrbitsOptions orbits;
  BranchOptions branch;
  AttractorsOptions attractors;
  AtlasOptions atlas;
  SimulateOptions simulate;
  Request request;
  CLI::App program(paper.about, "stickslip");
  program.footer(exit_codes);
  program.set_version_flag(
      "--version", [] { return std::string(); }, "Print the versions of the program and of its libraries");
  std::string directory_of_manual;
  program.add_option("--manual", directory_of_manual)->group("");
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(16);
  add_audit(program, audit, request);
  add_check(program, check, request, paper);
  add_prove(program, prove, request);
  add_certify(program, certify, request, paper);
  add_latex(program, latex, request, paper);
  add_orbits(program, orbits, request, paper);
  add_branch(program, branch, request, paper);
  add_attractors(program, attractors, request, paper);
  add_atlas(program, atlas, request, paper);
  add_simulate(program, simulate, request, paper);
  program.allow_extras();
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "prove") {
    std::ranges::transform(words, words.begin(), as_statement);
  }
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    program.parse(words);
  } catch (const CLI::CallForVersion&) {
    return VersionsWanted{};
  } catch (const CLI::Success&) {
    return HelpWanted{program.help()};
  } catch (const CLI::ParseError& error) {
    throw not_understood(program, error);
  }
  if (!directory_of_manual.empty()) {
    return ManualWanted{directory_of_manual, manual(program, paper.completions)};
  }
  require_command(program);
  return request;
}

}  // namespace stickslip::cli
