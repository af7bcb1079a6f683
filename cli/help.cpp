#include "cli/help.hpp"

#include <sstream>

namespace stickslip::cli {
namespace {

std::string worded(std::string text, const Wording& wording) {
  for (const auto& [name, words] : wording) {
    const std::string place = "{" + name + "}";
    for (std::size_t at = text.find(place); at != std::string::npos;
         at = text.find(place, at + words.size())) {
      text.replace(at, place.size(), words);
    }
  }
  return text;
}

// The first line, then entries up to an empty line, then the parts with headings.
CommandHelp read(const std::string& text) {
  CommandHelp help;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, help.words);
  std::getline(lines, line);
  CommandHelp::Entry * entry = nullptr;
  while (std::getline(lines, line) && !line.empty()) {
    if (entry != nullptr && line.starts_with("  ")) {
      entry->words += (entry->words.empty() ? "" : "\n") + line.substr(2);
      continue;
    }
    const std::size_t space = line.find(' ');
    entry = &help.entries[line.substr(0, space)];
    entry->type = space == std::string::npos ? "" : line.substr(space + 1);
  }
  std::string * part = nullptr;
  while (std::getline(lines, line)) {
    if (line == "DETAILS" || line == "EXAMPLES") {
      part = line == "DETAILS" ? &help.details : &help.examples;
    } else if (part != nullptr) {
      *part += line + "\n";
    }
  }
  while (help.details.ends_with('\n')) {
    help.details.pop_back();
  }
  return help;
}

}  // namespace

CommandHelp help_of(const std::string& command, const Wording& wording) {
  CommandHelp help = read(worded(help_texts().at(command + ".txt"), wording));
  help.entries.merge(read(worded(help_texts().at("common.txt"), wording)).entries);
  return help;
}

}  // namespace stickslip::cli
