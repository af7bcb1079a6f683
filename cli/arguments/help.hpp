// What the help says of the commands: the texts in cli/help/, one for each command, and common.txt for
// options that several have; completion.bash is what bash reads.
//
//   Write proofs that the proof assistant Coq checks      what the command does
//
//   --out DIR                                             an option or a place, and what its value is called;
//     Where to: a new directory                           then what it is for
//
//   DETAILS
//   Writes a file for each statement, ...
//
//   EXAMPLES                                              for the manual page: a sentence, and command lines
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace CLI {
class App;
}

namespace stickslip::cli {

// What stands in the texts for names in braces, {digits}.
using Wording = std::map<std::string, std::function<std::string()>>;

struct CommandHelp {
  struct Entry {
    std::string type, words;
  };
  std::string words;
  std::map<std::string, Entry> entries;  // by the names of options and places
  std::string details, examples;
};

// What is said of the command, which is to have a text.
[[nodiscard]] CommandHelp help_of(const std::string& command, const Wording& wording = {});

// All texts, by the names of their files.
[[nodiscard]] const std::map<std::string, std::string>& help_texts();

// Manual pages and completion, from the definition of the command line itself.

struct ManualFile {
  std::string name;  // "stickslip-orbits.1"
  std::string text;
};

// What may stand in a place, "FAMILY", or behind an option, "--example".
using Completions = std::map<std::string, std::vector<std::string>>;

// A page of section 1 for the program and for each of its commands, and what bash completes:
// stickslip.bash, with these words beside commands, options and files. Options that the help does not show
// are left out.
[[nodiscard]] std::vector<ManualFile> manual(const CLI::App& program, const Completions& completions);

// What is said to a command line that is not understood.

// What is wrong with a command line that CLI11 refused, in a sentence.
[[nodiscard]] UsageError not_understood(const CLI::App& program, const CLI::ParseError& error);
// After it was parsed: throws UsageError unless there is a command, and no argument that the program, as
// opposed to its commands, does not have.
void require_command(const CLI::App& program);

}  // namespace stickslip::cli
