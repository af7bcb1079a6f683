// The commands of the program: each describes its arguments to the parser and says what to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/error.hpp"

namespace stickslip::cli {

// What the chosen command does; empty until one is chosen.
using Action = std::function<ExitCode()>;

// Each adds one command to the program. Parsing sets the action, nothing else; the action throws Error.
void add_audit(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_latex(CLI::App& program, Action& action);
void add_orbits(CLI::App& program, Action& action);
void add_simulate(CLI::App& program, Action& action);

}  // namespace stickslip::cli
