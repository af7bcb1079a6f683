// The program: what the arguments ask for, and what the exit code says.
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <string>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "report/versions.hpp"

namespace stickslip::cli {
namespace {

constexpr const char* about =
    "Decides, statement by statement, what is true in M. Pascal, New limit cycles of dry\n"
    "friction oscillators under harmonic load, Nonlinear Dynamics 70 (2012). Identities are\n"
    "proved for all parameters; printed numbers are compared with rigorous enclosures.";

constexpr const char* exit_codes =
    "stickslip COMMAND --help says more about a command.\n\n"
    "Exit codes: 0 asked and decided, 1 check met a refuted statement, 2 something is\n"
    "undecided, 64 the command line is not understood, 65 parameters outside the domain,\n"
    "70 fault of the program, 74 input or output failed, 130 interrupted.";

std::string versions() {
  std::string text = fmt::format("stickslip {}\n", report::program_version());
  for (const report::Component& library : report::libraries()) {
    text += fmt::format("  {} {}\n", library.name, library.version);
  }
  return text + fmt::format("  CLI11 {}\n", CLI11_VERSION);
}

// The arguments that the program, as opposed to its commands, was given beyond its own.
void require_command(const CLI::App& program, const Action& action) {
  const std::vector<std::string> strangers = program.remaining();
  const std::string known = "the commands are audit, check, latex, orbits and simulate; see stickslip --help";
  if (!strangers.empty()) {
    const std::string kind = strangers.front().starts_with("-") ? "option" : "command";
    throw UsageError(fmt::format("there is no {} {}: {}", kind, strangers.front(), known));
  }
  if (!action) {
    throw UsageError("a command is missing: " + known);
  }
}

ExitCode run(int argc, const char* const* argv) {
  Action action;
  CLI::App program(about, "stickslip");
  program.footer(exit_codes);
  program.set_version_flag("--version", versions, "Print the versions of the program and of its libraries");
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(16);
  add_audit(program, action);
  add_check(program, action);
  add_latex(program, action);
  add_orbits(program, action);
  add_simulate(program, action);
  program.allow_extras();
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForVersion&) {
    print(versions());
    return exit_decided;
  } catch (const CLI::Success&) {
    print(program.help());
    return exit_decided;
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}; see stickslip --help", error.what()));
  }
  require_command(program, action);
  return action();
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

int main(int argc, char** argv) {
  using namespace stickslip;
  std::signal(SIGPIPE, SIG_IGN);  // a failed write is reported by print()
  std::signal(SIGINT, cli::leave);
  try {
    return cli::run(argc, argv);
  } catch (const cli::ReaderGone& error) {
    return error.code();
  } catch (const Error& error) {
    cli::tell("stickslip: " + cli::sentence(error.what()));
    return error.code();
  } catch (const std::bad_alloc&) {
    cli::tell("stickslip: out of memory.");
  } catch (const std::exception& error) {
    cli::tell("stickslip: internal error: " + cli::sentence(error.what()));
  } catch (...) {
    cli::tell("stickslip: internal error of unknown kind.");
  }
  return exit_internal;
}
