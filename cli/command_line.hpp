// What the files of the command line share: each add_… adds a command, or options to one.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

#include "cli/arguments.hpp"
#include "core/error.hpp"

namespace stickslip::cli {

// A command and its options; parsing it fills these, `check` looks at them, and they are the request.
template <class Options>
struct Command {
  CLI::App& app;
  Options& options;

  Command(
      CLI::App& program, Request& request, const char * name, const char * words,
      const std::function<void(Options&)>& check = [](Options&) {})
      : Command(program.add_subcommand(name, words), std::make_shared<Options>(), request, check) {}

  // An option or a place for a text; `type` is what the help calls it.
  CLI::Option * add(const char * name, std::string& text, const char * type, const std::string& words) {
    return app.add_option(name, text, words)->type_name(type);
  }
  // One that may be left out, and what is read: a text, a number of a range, a state. `read` is given the
  // option's name without dashes and the text, and throws UsageError.
  template <class T, class Read>
  CLI::Option * add(const char * name, std::optional<T>& value, const char * type, const std::string& words,
                    const Read& read) {
    return app
        .add_option_function<std::string>(
            name,
            [&value, read, bare = std::string(name).substr(2)](const std::string& text) {
              value = read(bare, text);
            },
            words)
        ->type_name(type);
  }
  CLI::Option * add(const char * name, std::optional<std::string>& text, const char * type,
                    const std::string& words) {
    return add(name, text, type, words, [](const std::string&, const std::string& typed) { return typed; });
  }
  // A whole number from 1 to `most`.
  CLI::Option * add(const char * name, std::optional<int>& number, int most, const std::string& words,
                    const char * type = "N") {
    return add(name, number, type, words, [most](const std::string& bare, const std::string& text) {
      return whole_number(bare, text, most);
    });
  }
  void add_units(const std::string& words) {
    app.add_option_function<std::string>(
           "--units", [&si = options.si](const std::string& text) { si = is_si(text); }, words)
        ->type_name("UNITS");
  }
  void add_jobs() {
    add("--jobs", options.jobs, most_jobs,
        "Search and prove with at most N threads, all cores by default;\nthe results are the same");
  }

 private:
  // The options live as long as the command.
  Command(CLI::App * added, const std::shared_ptr<Options>& kept, Request& request,
          const std::function<void(Options&)>& check)
      : app(*added), options(*kept) {
    app.callback([kept, &request, check] {
      check(*kept);
      request = *kept;
    });
  }
};

// --chi, --eta, … for those of a machine, whose load is cos(omega t); the same and --phi; --example and
// --params.
void add_machine(CLI::App& command, TypedParameters& parameters);
void add_parameters(CLI::App& command, TypedParameters& parameters);
void add_sources(CLI::App& command, GivenMachine& given, const PaperInHelp& paper);

void add_orbits(CLI::App& program, Request& request, const PaperInHelp& paper);
void add_branch(CLI::App& program, Request& request, const PaperInHelp& paper);
void add_attractors(CLI::App& program, Request& request, const PaperInHelp& paper);
void add_atlas(CLI::App& program, Request& request, const PaperInHelp& paper);
void add_simulate(CLI::App& program, Request& request, const PaperInHelp& paper);

// What is wrong with a command line that CLI11 refused, in a sentence.
[[nodiscard]] UsageError not_understood(const CLI::App& program, const CLI::ParseError& error);
// After it was parsed: throws UsageError unless there is a command, and no argument that the program, as
// opposed to its commands, does not have.
void require_command(const CLI::App& program);

}  // namespace stickslip::cli
