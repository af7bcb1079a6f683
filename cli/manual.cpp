#include "cli/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <sstream>

namespace stickslip::cli {
namespace {

// As roff reads it: a line must not begin with a dot or an apostrophe, a hyphen is to stay one.
std::string roff(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('.') || line.starts_with('\'')) {
      result += "\\&";
    }
    for (const char c : line) {
      result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    result += '\n';
  }
  return result;
}

std::vector<const CLI::App *> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App *) { return true; });
}

std::vector<const CLI::Option *> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option * option) { return !option->get_group().empty(); });
}

std::string option_entry(const CLI::Option& option) {
  const bool positional = option.get_positional();
  std::string name = roff(option.get_name(positional, !positional));
  name.pop_back();
  const std::string type = positional || option.get_type_size() == 0 ? "" : option.get_type_name();
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}", name, type.empty() ? "" : " \\fI" + type + "\\fR",
                     roff(option.get_description()));
}

std::string page(const CLI::App& command, const std::string& name, const std::string& words,
                 const std::string& synopsis, const std::string& body) {
  std::string options;
  for (const CLI::Option * option : options_of(command)) {
    options += option_entry(*option);
  }
  return fmt::format(
      ".TH {} 1 \"\" stickslip\n.SH NAME\n{} \\- {}.SH SYNOPSIS\n{}{}.SH OPTIONS\n{}.SH "
      "DETAILS\n.nf\n{}.fi\n",
      name, name, words, synopsis, body, options, roff(command.get_footer()));
}

std::string completion(const CLI::App& program) {
  const auto words_of = [](const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option * option : options_of(command)) {
      for (const std::string& name : option->get_lnames()) {
        words.push_back("--" + name);
      }
    }
    return fmt::format("{}", fmt::join(words, " "));
  };
  std::string names, cases;
  for (const CLI::App * command : commands_of(program)) {
    names += command->get_name() + " ";
    cases += fmt::format("    1:{}) words=\"{}\" ;;\n", command->get_name(), words_of(*command));
  }
  return fmt::format(
      "# Completion of stickslip in bash: commands, options, files.\n"
      "_stickslip() {{\n"
      "  local words\n"
      "  case $((COMP_CWORD > 1)):${{COMP_WORDS[1]}} in\n"
      "    0:*) words=\"{}{}\" ;;\n{}"
      "  esac\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"${{COMP_WORDS[COMP_CWORD]}}\")\n"
      "}}\n"
      "complete -o default -F _stickslip stickslip\n",
      names, words_of(program), cases);
}

}  // namespace

std::vector<ManualFile> manual(const CLI::App& program) {
  const std::string name = program.get_name();
  std::vector<ManualFile> files;
  std::string list = ".SH COMMANDS\n";
  for (const CLI::App * command : commands_of(program)) {
    const std::string of_command = fmt::format("{}-{}", name, command->get_name());
    const std::string words = roff(command->get_description());
    list += fmt::format(".TP\n\\fB{}\\fR(1)\n{}", of_command, words);
    files.push_back(
        {of_command + ".1", page(*command, of_command, words,
                                 fmt::format("\\fB{} {}\\fR [OPTION]...\n", name, command->get_name()), "")});
  }
  files.push_back({name + ".1", page(program, name, "audits a paper on dry-friction oscillators\n",
                                     fmt::format("\\fB{}\\fR COMMAND [OPTION]...\n", name),
                                     ".SH DESCRIPTION\n" + roff(program.get_description()) + list)});
  files.push_back({name + ".bash", completion(program)});
  return files;
}

}  // namespace stickslip::cli
