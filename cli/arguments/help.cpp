#include "cli/arguments/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/arguments/typed_parameters.hpp"

namespace stickslip::cli {

namespace {

std::string worded(std::string text, const Wording& wording) {
  for (const auto& [name, words_of] : wording) {
    const std::string place = "{" + name + "}";
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at)) {
      const std::string words = words_of();
      text.replace(at, place.size(), words);
      at += words.size();
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

std::string examples_of(const CLI::App& command) {
  std::istringstream lines(help_of(command.get_name()).examples);
  std::string entries;
  for (std::string line; std::getline(lines, line);) {
    entries += line.starts_with("  ") ? fmt::format(".PP\n.RS\n.nf\n{}.fi\n.RE\n", roff(line.substr(2)))
                                      : ".PP\n" + roff(line);
  }
  return entries.empty() ? "" : ".SH EXAMPLES\n" + entries;
}

std::string files_of(const CLI::App& command) {
  if (command.get_option_no_throw("--params") == nullptr) {
    return "";
  }
  std::string entries;
  for (const model::MachineValue& value : model::machine_values) {
    entries += fmt::format(".TP\n\\fB{}\\fR\n{}", value.name, roff(value.words));
  }
  return fmt::format(
      ".SH FILES\nThe TOML file of \\fB\\-\\-params\\fR has lines such as\n.PP\n.RS\nchi = 0.5\n.RE\n.PP\n"
      "with the keys {}, which are those of the options, in the dimensionless data of the paper; or those of "
      "a machine in SI units, as it is, without damping and with one frequency of the load:\n{}",
      fmt::join(parameter_names, ", "), entries);
}

std::string page(const CLI::App& command, const std::string& name, const std::string& words,
                 const std::string& synopsis, const std::string& body) {
  std::string options;
  for (const CLI::Option * option : options_of(command)) {
    options += option_entry(*option);
  }
  return fmt::format(
      ".TH {} 1 \"\" stickslip\n.SH NAME\n{} \\- {}.SH SYNOPSIS\n{}{}.SH OPTIONS\n{}.SH "
      "DETAILS\n.nf\n{}.fi\n{}{}.SH SEE ALSO\nThe manual, in share/doc/stickslip/doc where the program is "
      "installed; it begins with index.md.\n",
      name, name, words, synopsis, body, options, roff(command.get_footer()), files_of(command),
      examples_of(command));
}

std::string completion(const CLI::App& program, const Completions& completions) {
  const auto words_of = [&completions](const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option * option : options_of(command)) {
      for (const std::string& name : option->get_lnames()) {
        words.push_back("--" + name);
      }
      const auto place = completions.find(option->get_positional() ? option->get_name(true) : "");
      if (place != completions.end()) {
        words.insert(words.end(), place->second.begin(), place->second.end());
      }
    }
    return fmt::format("{}", fmt::join(words, " "));
  };
  const auto line = [](const std::string& of, const std::string& words) {
    return fmt::format("    {}) words=\"{}\" ;;\n", of, words);
  };
  std::string names, cases, values;
  for (const auto& [option, words] : completions) {
    values += option.starts_with("-") ? line(option, fmt::format("{}", fmt::join(words, " "))) : "";
  }
  for (const CLI::App * command : commands_of(program)) {
    names += command->get_name() + " ";
    cases += line("1:" + command->get_name(), words_of(*command));
  }
  const std::string commands = line("0:*", names + words_of(program)) + cases;
  return worded(help_texts().at("completion.bash"),
                {{"commands", [&] { return commands; }}, {"values", [&] { return values; }}});
}

}  // namespace

std::vector<ManualFile> manual(const CLI::App& program, const Completions& completions) {
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
  files.push_back({name + ".1", page(program, name, help_of(name).words + "\n",
                                     fmt::format("\\fB{}\\fR COMMAND [OPTION]...\n", name),
                                     ".SH DESCRIPTION\n" + roff(program.get_description()) + list)});
  files.push_back({name + ".bash", completion(program, completions)});
  return files;
}

namespace {

// "--list" and "--json" of "--list excludes --json": the messages of CLI11 name options first.
std::pair<std::string, std::string> around(const std::string& message, std::string_view separator) {
  const std::size_t at = message.find(separator);
  return at == std::string::npos ? std::pair<std::string, std::string>()
                                 : std::pair(message.substr(0, at), message.substr(at + separator.size()));
}

// The arguments that a command does not have.
std::string strangers(const CLI::App& command) {
  const std::vector<std::string> all = command.remaining();
  const auto option =
      std::ranges::find_if(all, [](const std::string& word) { return word.starts_with("-"); });
  return option != all.end()
             ? fmt::format("there is no option {} of stickslip {}", *option, command.get_name())
             : fmt::format("stickslip {} does not know what to do with '{}'", command.get_name(),
                           fmt::join(all, "', '"));
}

// An option without its value, or given twice.
std::string wrong_count(const CLI::App& command, const CLI::ArgumentMismatch& error) {
  const std::string name = around(error.what(), ":").first;
  const CLI::Option * option = name.empty() ? nullptr : command.get_option_no_throw(name);
  if (option == nullptr) {
    return error.what();
  }
  if (option->count() > static_cast<std::size_t>(option->get_items_expected_min())) {
    return fmt::format("{} is given twice", name);
  }
  return fmt::format("{0} needs a value: {0} {1}", name, option->get_type_name());
}

std::string what_is_wrong(const CLI::App& command, const CLI::ParseError& error) {
  const std::string message = error.what();
  if (dynamic_cast<const CLI::ExtrasError *>(&error) != nullptr) {
    return strangers(command);
  }
  if (const auto * mismatch = dynamic_cast<const CLI::ArgumentMismatch *>(&error)) {
    return wrong_count(command, *mismatch);
  }
  if (dynamic_cast<const CLI::ExcludesError *>(&error) != nullptr) {
    const auto [one, other] = around(message, " excludes ");
    return fmt::format("{} and {} do not go together", one, other);
  }
  if (dynamic_cast<const CLI::RequiresError *>(&error) != nullptr) {
    const auto [one, other] = around(message, " requires ");
    return fmt::format("{0} is for {1}: give {1}, too", one, other);
  }
  return message;
}

}  // namespace

UsageError not_understood(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App *> commands = program.get_subcommands();
  const CLI::App& command = commands.empty() ? program : *commands.front();
  return UsageError(fmt::format("{}; see stickslip {}--help", what_is_wrong(command, error),
                                commands.empty() ? "" : command.get_name() + " "));
}

void require_command(const CLI::App& program) {
  const std::vector<std::string> strangers = program.remaining();
  std::vector<std::string> names;
  for (const CLI::App * command : commands_of(program)) {
    names.push_back(command->get_name());
  }
  const std::string last = names.back();
  names.pop_back();
  const std::string known =
      fmt::format("the commands are {} and {}; see stickslip --help", fmt::join(names, ", "), last);
  if (!strangers.empty()) {
    const std::string kind = strangers.front().starts_with("-") ? "option" : "command";
    throw UsageError(fmt::format("there is no {} {}: {}", kind, strangers.front(), known));
  }
  if (program.get_subcommands().empty()) {
    throw UsageError("a command is missing: " + known);
  }
}

}  // namespace stickslip::cli
