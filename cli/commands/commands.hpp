// The commands of the program, about a paper. Each throws Error.
#pragma once

#include <filesystem>
#include <optional>

#include "cli/arguments/arguments.hpp"
#include "core/error.hpp"
#include "numeric/words/word_orbit.hpp"
#include "proofs/certificates/certificates.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

[[nodiscard]] ExitCode run(const AuditOptions& options, const proofs::methods::Paper& paper);
[[nodiscard]] ExitCode run(const CheckOptions& options, const proofs::methods::Paper& paper);
[[nodiscard]] ExitCode run(const ProveOptions& options, const proofs::methods::Paper& paper);
[[nodiscard]] ExitCode run(const CertifyOptions& options, const proofs::methods::Paper& paper);
[[nodiscard]] ExitCode run(const LatexOptions& options, const proofs::methods::Paper& paper);
[[nodiscard]] ExitCode run(const OrbitsOptions& options, const proofs::methods::Examples& examples);
[[nodiscard]] ExitCode run(const BranchOptions& options, const proofs::methods::Examples& examples);
[[nodiscard]] ExitCode run(const AttractorsOptions& options, const proofs::methods::Examples& examples);
// Of a machine in tables (cli/answers/machine_tables.hpp); nothing if the file is none.
[[nodiscard]] std::optional<ExitCode> run_in_tables(const AttractorsOptions& options);
[[nodiscard]] std::optional<ExitCode> run_in_tables(const OrbitsOptions& options);
[[nodiscard]] std::optional<ExitCode> run_in_tables(const BranchOptions& options);
[[nodiscard]] std::optional<ExitCode> run_in_tables(const SimulateOptions& options);
// With --plane; with --set.
struct GivenInTables;
[[nodiscard]] ExitCode run_plane(const GivenInTables& given, const AttractorsOptions& options);
[[nodiscard]] ExitCode run_box(const GivenInTables& given, const BranchOptions& options);
[[nodiscard]] ExitCode run_set(const GivenInTables& given, const SimulateOptions& options);
// Whether existence, all conditions and, where they hold, stability are decided.
[[nodiscard]] bool is_decided(const numeric::words::WordOrbit& orbit);
[[nodiscard]] ExitCode run(const AtlasOptions& options, const proofs::methods::Examples& examples);
[[nodiscard]] ExitCode run(const SimulateOptions& options, const proofs::methods::Examples& examples);

// Directories of certificates. Throws UsageError if the directory holds other things.
void require_certificates_only(const std::filesystem::path& directory);
// Only what differs, so that Coq need not look again at what it has seen; what is left of statements that are
// not among these goes.
void write_certificates(const std::filesystem::path& directory,
                        const proofs::certificates::Certificates& certificates);

}  // namespace stickslip::cli
