// What the help says of the commands: the texts in cli/help/, one for each command, and common.txt for
// options that several have.
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

#include <map>
#include <string>

namespace stickslip::cli {

// What stands in the texts for names in braces, {digits}.
using Wording = std::map<std::string, std::string>;

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

}  // namespace stickslip::cli
