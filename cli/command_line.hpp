// What the files of the command line share: each add_… adds a command, or options to one. Parsing a command
// fills its options and makes them the request.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/arguments.hpp"
#include "core/error.hpp"

namespace stickslip::cli {

// An option or a place that takes a text; `type` is what the help calls it.
CLI::Option * add_text(CLI::App& command, const char * name, std::string& text, const char * type,
                       const std::string& words);

// --chi, --eta, … for those of a machine, whose load is cos(omega t); the same and --phi; --example and
// --params.
void add_machine(CLI::App& command, TypedParameters& parameters);
void add_parameters(CLI::App& command, TypedParameters& parameters);
void add_sources(CLI::App& command, std::string& example, std::string& file, const PaperInHelp& paper);
void add_jobs(CLI::App& command, std::string& text);

void add_orbits(CLI::App& program, OrbitsOptions& options, Request& request, const PaperInHelp& paper);
void add_branch(CLI::App& program, BranchOptions& options, Request& request, const PaperInHelp& paper);
void add_attractors(CLI::App& program, AttractorsOptions& options, Request& request,
                    const PaperInHelp& paper);
void add_atlas(CLI::App& program, AtlasOptions& options, Request& request, const PaperInHelp& paper);
void add_simulate(CLI::App& program, SimulateOptions& options, Request& request, const PaperInHelp& paper);

// What is wrong with a command line that CLI11 refused, in a sentence.
[[nodiscard]] UsageError not_understood(const CLI::App& program, const CLI::ParseError& error);
// After it was parsed: throws UsageError unless there is a command, and no argument that the program, as
// opposed to its commands, does not have.
void require_command(const CLI::App& program);

}  // namespace stickslip::cli
