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

// A file of claims among words that name claims: the first that ends so.
void take_file(std::vector<std::string>& words, std::string& file) {
  const auto found =
      std::ranges::find_if(words, [](const std::string& word) { return word.ends_with(".claims"); });
  if (found != words.end()) {
    file = *found;
    words.erase(found);
  }
}

void add_audit(CLI::App& program, Request& request, const PaperInHelp& /*paper*/) {
  Command<AuditOptions> c(program, request, "audit", "Examine every statement of the paper and report",
                          [](AuditOptions& o) {
                            if (!o.claims.empty() && !o.claims.ends_with(".claims")) {
                              throw UsageError("stickslip audit does not know what to do with '" + o.claims +
                                               "': a file of claims is called NAME.claims");
                            }
                          });
  AuditOptions& o = c.options;
  c.app.footer(
      "Prints a table of all statements with their status, then the findings with their\n"
      "reasons, then the printed numbers beside the proved ones.\n\n"
      "Exit code: 0 everything is decided, also if the paper has misprints;\n"
      "1 with --mutants: a wrong statement is proved;\n"
      "2 something is undecided;\n"
      "130 after Ctrl-C, which ends it: what is done is printed, and no report written.");
  c.add("FILE", o.claims, "",
        "A paper of your own: a file of claims, NAME.claims; the paper\nif none is given");
  c.add("--out", o.out, "DIR",
        "Also write the report into DIR: pages for a browser that begin\n"
        "with index.html, audit.pdf where there is TeX, audit.tex and\n"
        "audit.json. DIR is created if only its last part is missing");
  c.add_jobs();
  c.app.add_flag("--json", o.json, "Print the results as JSON instead of the table");
  CLI::Option * mutants = c.app.add_flag("--mutants", o.mutants,
                                         "Also put wrong statements to the proofs, made by single edits\n"
                                         "of all formulas, and say what became of them: takes minutes");
  constexpr int most = AttractorsOptions::greatest_number;
  c.add("--one-in", o.one_in, most, "Take a random sample of them, one in N")->needs(mutants);
  c.add("--seed", o.seed, most, "The seed of that sample")->needs(mutants);
  c.add("--certificates", o.certificates, "DIR",
        "The directory in which script/certify had Coq check the\nproofs: say of each claim whether it is "
        "certified");
}

void add_check(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<CheckOptions> c(program, request, "check", "Prove single statements, equations or sections",
                          [](CheckOptions& o) { take_file(o.words, o.claims); });
  CheckOptions& o = c.options;
  c.app.footer(
      "Exit code: 0 every statement asked for holds, possibly corrected or under the hypotheses\n"
      "listed;\n"
      "1 one of them is refuted;\n"
      "2 none is refuted, one is undecided.");
  c.app
      .add_option(
          "ID", o.words,
          fmt::format("What to check: a statement ({}), an equation with all its\nparts ({}), a "
                      "place in the paper\n({}),\na kind (theorem, condition, ...), an origin "
                      "(paper, new,\n...), a status (refuted, digits_off, ...); everything if none is "
                      "given.\nA file NAME.claims among them: its claims in the place of the paper's",
                      paper.part, paper.equation(), paper.places))
      ->type_name("");
  CLI::Option * list = c.app.add_flag("--list", o.list, "Only list the statements, without proving them");
  c.app.add_flag(
      "--explain", o.explain,
      "Say all about each: formula, assumptions, proof, hypotheses,\nwhat it uses and what uses it");
  c.add_jobs();
  list->excludes(c.app.add_flag("--json", o.json, "Print the results as JSON"));
}

void add_prove(CLI::App& program, Request& request, const PaperInHelp& /*paper*/) {
  Command<ProveOptions> c(program, request, "prove", "Prove or refute a statement of your own");
  ProveOptions& o = c.options;
  c.app.footer(
      "The notation is that in which check prints statements:\n"
      "  stickslip prove \"H1(t)^2 - I = H2(t) H3(t)\"\n"
      "  stickslip prove \"Theta = tau + T\" \"omega Theta = 2 pi\" \"T = 2 pi/omega - tau\"\n"
      "  stickslip prove \"a^2 + b^2 >= 2 a b\" --symbols a,b\n"
      "Greek letters, subscripts, powers and relations may also be typed as such: \u03c9\u2081\u00b2 \u2264 "
      "\u03c9\u2082\u00b2.\n"
      "\n"
      "Exit code: 0 it is proved, perhaps under the hypotheses listed; 1 it is refuted;\n"
      "2 undecided.");
  c.add("STATEMENT", o.statement, "",
        "An equation or an inequality in the paper's symbols (check --list\nnames where they occur)")
      ->required();
  c.app.add_option("ASSUMPTION", o.assumptions, "What it assumes")->type_name("");
  c.app.add_option("--symbols", o.symbols, "Names of further numbers, with commas between them")
      ->type_name("NAMES")
      ->delimiter(',');
  CLI::Option * explain = c.app.add_flag("--explain", o.explain, "Say all about its proof");
  c.add("--certificate", o.certificate, "DIR", "Write its proof for the proof assistant Coq");
  explain->excludes(c.app.add_flag("--json", o.json, "Print the result as JSON"));
}

void add_certify(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<CertifyOptions> c(program, request, "certify", "Write proofs that the proof assistant Coq checks",
                            [](CertifyOptions& o) {
                              take_file(o.words, o.claims);
                              if (o.out.empty() && o.record.empty()) {
                                throw UsageError("stickslip certify needs --out DIR, or --record DIR");
                              }
                            });
  CertifyOptions& o = c.options;
  c.app.footer(
      "Writes a file for each statement, with its theorem in full and the proof, what they stand\n"
      "on, and a Makefile: make -k -j in DIR has Coq check them. script/certify does all of it.\n\n"
      "Exit code: 0 every statement asked for that the kernel proves has a certificate;\n"
      "1 with --record: one is not accepted;\n"
      "2 one has none.");
  CLI::Option * ids =
      c.app
          .add_option(
              "ID", o.words,
              fmt::format("What to certify: as for check ({}, {}, {}, ...); everything if\nnone is given",
                          paper.part, paper.equation(), paper.places.substr(0, paper.places.find(','))))
          ->type_name("");
  CLI::Option * out = c.add("--out", o.out, "DIR",
                            "Where to: a new directory, an empty one, or one with\ncertificates, which are "
                            "kept; files that are the same stay\nas they are");
  c.add("--record", o.record, "DIR",
        "Instead: look at what Coq said of the certificates in DIR,\nprint it, and write it to "
        "DIR/certificates.json")
      ->excludes(out)
      ->excludes(ids);
}

void add_latex(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<LatexOptions> c(
      program, request, "latex", "Print derived expressions as LaTeX", [](LatexOptions& o) {
        take_file(o.names, o.claims);  // a file goes with them, a name does not
        if (!o.names.empty() && (o.errata || !o.theorem.empty())) {
          throw UsageError(
              fmt::format("NAME and {} do not go together", o.errata ? "--errata" : "--theorem"));
        }
      });
  LatexOptions& o = c.options;
  c.app.footer(
      "Displayed equations for a document with the amsmath package: stickslip latex H > H.tex\n"
      "Every formula is printed from the one that the proofs are about; two runs print the\n"
      "same characters.");
  CLI::Option * names =
      c.app
          .add_option(
              "NAME", o.names,
              fmt::format("What to print: a derived expression (H, Gamma, Q, ...), with its\nvalues where "
                          "parameters are given; or a statement as it is proved\n({}, {}, ...); all "
                          "derived expressions if none is given.\nAfter NAME.claims: statements of that file",
                          paper.equation(), paper.part))
          ->type_name("");
  CLI::Option * list = c.app.add_flag("--list", o.list, "List the names, with equation numbers");
  CLI::Option * bare = c.app.add_flag("--bare", o.bare,
                                      "The formulas alone, without headings and \\[ \\]: lines for an\n"
                                      "environment of your own, such as gather*");
  CLI::Option * errata =
      c.app.add_flag("--errata", o.errata,
                     "A document with the errata of the paper and the hypotheses\nto be added, after proving "
                     "everything");
  CLI::Option * theorem =
      c.add("--theorem", o.theorem, "ID",
            "A result of the audit as a theorem, with the idea of its proof,\nafter proving it");
  CLI::Option * in =
      c.app
          .add_option_function<std::string>(
              "--in",
              [&o](const std::string& word) {
                if (word != "chi" && word != "omega") {
                  throw UsageError("in: '" + word + "' is neither chi nor omega");
                }
                o.in_frequencies = word == "omega";
              },
              "chi (the default): with chi, eta and the abbreviations omega_j,\nlambda_j; omega: with the "
              "natural "
              "frequencies alone")
          ->type_name("WORD");
  CLI::Option * orbit =
      c.add("--orbit", o.orbit, "FAMILY:K",
            "The closed forms of orbit K of a family, phase by phase, with its\nnumbers, at the parameters "
            "below: " +
                paper.family_names);
  errata->excludes(list);
  theorem->excludes(list)->excludes(errata);
  orbit->excludes(list)->excludes(names)->excludes(errata)->excludes(theorem)->excludes(in);
  bare->excludes(list)->excludes(errata)->excludes(theorem)->excludes(orbit);
  add_parameters(c.app, o.parameters);
  add_sources(c.app, o, paper);
  c.add("--digits", o.digits, OrbitsOptions::most_digits,
        fmt::format("Significant digits of numbers: {} by default", LatexOptions::default_digits));
}

// A statement that begins with a minus sign is no option: it is typed for the parser's other minus sign.
std::string as_statement(const std::string& word) {
  const bool is_option =
      !word.starts_with('-') || word.starts_with("--") || word.find_first_of("=<>!") == std::string::npos;
  return is_option ? word : "\u2212" + word.substr(1);
}

}  // namespace

Request parse(int argc, const char * const * argv, const PaperInHelp& paper) {
  Request request;
  CLI::App program(paper.about, "stickslip");
  program.footer(exit_codes);
  program.set_version_flag(
      "--version", [] { return std::string(); }, "Print the versions of the program and of its libraries");
  std::string directory_of_manual;
  program.add_option("--manual", directory_of_manual)->group("");
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(16);
  for (const auto add : {add_audit, add_check, add_prove, add_certify, add_latex, add_orbits, add_branch,
                         add_attractors, add_atlas, add_simulate}) {
    add(program, request, paper);
  }
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
