// What is said to a command line that is not understood.
#pragma once

#include <CLI/CLI.hpp>

#include "core/error.hpp"

namespace stickslip::cli {

// What is wrong with a command line that CLI11 refused, in a sentence.
[[nodiscard]] UsageError not_understood(const CLI::App& program, const CLI::ParseError& error);
// After it was parsed: throws UsageError unless there is a command, and no argument that the program, as
// opposed to its commands, does not have.
void require_command(const CLI::App& program);

}  // namespace stickslip::cli
