// The commands of the program. Each throws Error.
#pragma once

#include "cli/arguments.hpp"
#include "core/error.hpp"

namespace stickslip::cli {

[[nodiscard]] ExitCode run(const AuditOptions& options);
[[nodiscard]] ExitCode run(const CheckOptions& options);
[[nodiscard]] ExitCode run(const LatexOptions& options);
[[nodiscard]] ExitCode run(const OrbitsOptions& options);
[[nodiscard]] ExitCode run(const SimulateOptions& options);

}  // namespace stickslip::cli
