// The program: what the arguments ask for, and what the exit code says.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/Version.hpp>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/answers/machine_file.hpp"
#include "cli/commands/cluster.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/output.hpp"
#include "numeric/families/family.hpp"
#include "numeric/orbits.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/parse.hpp"
#include "proofs/text/claims_file.hpp"
#include "report/schemas.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"
#include "symbolic/objects/objects.hpp"

namespace stickslip::cli {

using namespace proofs::methods;

namespace {

std::string versions() {
  std::string text = fmt::format("stickslip {}\n", report::tools::program_version());
  for (const report::tools::Component& library : report::tools::libraries()) {
    text += fmt::format("  {} {}\n", library.name, library.version);
  }
  return text + fmt::format("  CLI11 {}\n", CLI11_VERSION);
}

constexpr std::size_t width_of_help = 88;

// The paper that this program is about.
const Paper& paper() {
  return proofs::pascal2012::paper();
}

// What is given for an orbit of the family besides the data, and what is a result.
std::string datum_and_results(const numeric::Family& family) {
  const bool takes_phi = family.why_no_phi.empty(), takes_ur = family.why_no_ur.empty();
  if (takes_phi && takes_ur) {
    return "exactly one of --phi and --ur is given; the other is a result.";
  }
  if (!family.why_datum.empty()) {
    return takes_ur ? "--ur is given; phi is a result." : "--phi is given; ur is a result.";
  }
  return takes_ur ? "phi is a result; without --ur the largest admissible one is, ur_max, and "
                    "\"admissible\" speaks of all other conditions."
                  : "phi is a result, and so is ur.";
}

std::string given_and_found(const numeric::Family& family) {
  const char * belt = family.belt > 0 ? "V > 0; " : family.belt < 0 ? "V < 0; " : "";
  return belt + datum_and_results(family);
}

std::string families() {
  std::vector<report::tools::Row> rows;
  for (const numeric::Family * family : numeric::all_families()) {
    rows.push_back({{family->name}, {given_and_found(*family)}});
  }
  std::string lines = report::tools::columns_of(rows, width_of_help);
  lines.pop_back();  // the end of the last one
  return lines;
}

Completions completions() {
  Completions found;
  for (const numeric::Family * family : numeric::all_families()) {
    found["FAMILY"].push_back(family->name);
  }
  for (const symbolic::objects::Object& object : symbolic::objects::objects()) {
    found["NAME"].push_back(object.name);
  }
  for (const Claim& claim : paper().claims) {
    found["ID"].push_back(claim.id);
    found["NAME"].push_back(claim.id);
  }
  for (const Section& section : paper().sections) {
    found["ID"].push_back(section.id);
  }
  for (const Example& example : proofs::pascal2012::printed_examples()) {
    found["--example"].push_back(example.name);
  }
  for (const Result& result : paper().results) {
    found["--theorem"].push_back(result.id);
  }
  return found;
}

PaperInHelp in_help() {
  const Bibliography& source = proofs::pascal2012::bibliography();
  const std::string about = fmt::format(
      "Decides, statement by statement, what is true in {}, {}, {}. Identities are proved for all "
      "parameters; printed numbers are compared with rigorous enclosures.",
      source.author, source.title, source.journal);
  return {report::tools::enumerated(report::tools::wrapped(about, width_of_help), std::identity(), "\n"),
          names_of(proofs::pascal2012::printed_examples()),
          numeric::families::names_of_families(),
          numeric::families::names_of_judged_families(),
          families(),
          [] { return report::tools::enumerated(paper().sections, &Section::id); },
          [] { return id_of_a_part(paper().claims); },
          completions};
}

ExitCode run(const HelpWanted& help, const Examples& /*examples*/) {
  print(help.text);
  return exit_decided;
}
ExitCode run(const VersionsWanted& /*versions*/, const Examples& /*examples*/) {
  print(versions());
  return exit_decided;
}

ExitCode run(const ManualWanted& manual, const Examples& /*examples*/) {
  std::vector<report::tools::File> files = report::schemas();
  for (const ManualFile& file : manual.files) {
    files.push_back({file.name, file.text});
  }
  report::tools::write_files(manual.directory, files);
  return exit_decided;
}

// Of a paper as text, what its names mean counts while it is asked about.
ExitCode answer_about_file(const auto& asked) {
  const Paper own = proofs::text::read_claims(report::tools::read_file(asked.claims), asked.claims, paper());
  const proofs::symbols::InVocabulary scope(own.vocabulary);
  return run(asked, own);
}

// What is about motions takes the paper's examples alone.
ExitCode answer_about_paper(const auto& asked) {
  if constexpr (requires { run(asked, proofs::pascal2012::printed_examples()); }) {
    return run(asked, proofs::pascal2012::printed_examples());
  } else {
    return run(asked, paper());
  }
}

ExitCode answer(const Request& request) {
  const auto answer_to = [](const auto& asked) {
    if constexpr (requires { asked.claims; }) {
      if (!asked.claims.empty()) {
        return answer_about_file(asked);
      }
    }
    if constexpr (requires { asked.file; }) {
      try {
        return answer_about_paper(asked);
      } catch (const DomainError& error) {
        throw in_keys_of(asked.file, error);
      }
    } else {
      return answer_about_paper(asked);
    }
  };
  return std::visit(answer_to, request);
}

// Ends with a full stop, as a sentence does.
std::string sentence(std::string words) {
  if (!words.ends_with('.')) {
    words += '.';
  }
  return words;
}

extern "C" void leave(int /*signal*/) {
  ::_exit(exit_interrupted);
}

}  // namespace
}  // namespace stickslip::cli

int main(int argc, char ** argv) {
  using namespace stickslip;
  // A failed write is reported where it is made.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGINT, cli::leave);
  cli::end_in_words_without_memory();
  try {
    return cli::answer(cli::parse(argc, argv, cli::in_help()));
  } catch (const cli::ReaderGone& error) {
    return error.code();
  } catch (const Error& error) {
    if (!cli::is_silent_copy()) {
      cli::tell("stickslip: " + cli::sentence(error.what()));
      if (const auto * unread = dynamic_cast<const proofs::symbols::ParseError *>(&error)) {
        cli::tell(unread->excerpt());
      }
    }
    return error.code();
  } catch (const std::bad_alloc&) {
    cli::tell(cli::out_of_memory);
  } catch (const std::exception& error) {
    const auto * system = dynamic_cast<const std::system_error *>(&error);
    // oneTBB has no type of its own for a thread that cannot be started.
    const bool threads = (system && system->code() == std::errc::resource_unavailable_try_again) ||
                         std::string_view(error.what()).starts_with("pthread_create");
    cli::tell(threads ? std::string(cli::out_of_memory) + " No thread can be started."
                      : "stickslip: internal error: " + cli::sentence(error.what()));
  } catch (...) {
    cli::tell("stickslip: internal error of unknown kind.");
  }
  return exit_internal;
}
