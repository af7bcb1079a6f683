#include "cli/refusals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace stickslip::cli {
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
  for (const CLI::App * command : program.get_subcommands([](const CLI::App *) { return true; })) {
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
