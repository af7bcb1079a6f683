// stickslip audit: every statement of the paper.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "cli/arguments/typed_parameters.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/output.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "proofs/checks/mutants.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/audit/comparison.hpp"
#include "report/audit/json.hpp"
#include "report/audit/mutants.hpp"
#include "report/audit/pages.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/page.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

using namespace proofs::methods;

namespace {

// On a thread of its own where there may be several, else when it is asked for.
std::future<report::audit::Figures> figures_of(const Paper& paper, bool with_pictures) {
  const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::async(threads > 1 ? std::launch::async : std::launch::deferred,
                    [&paper, with_pictures] { return report::audit::figures_of(paper, with_pictures); });
}

std::optional<proofs::checks::Gate> gate_of(const AuditOptions& options, const Paper& paper,
                                            const proofs::checks::Sampling& sampling) {
  if (!options.mutants) {
    return std::nullopt;
  }
  Progress line("making wrong statements ...");
  struct Stopped {};
  try {
    return proofs::checks::mutant_gate(
        paper.claims, {}, sampling, [&line](const std::string& id, std::size_t done, std::size_t all) {
          if (interrupted()) {
            throw Stopped();
          }
          line.show(fmt::format("wrong statements of {} ({} of {})", id, done, all));
        });
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

std::string command_of(const AuditOptions& options) {
  return options.mutants ? "stickslip audit --mutants" : "stickslip audit";
}

// What was examined, all of it unless that was interrupted.
struct Examined {
  proofs::methods::Audit audit;
  std::optional<proofs::checks::Gate> gate;
  bool interrupted = false;
};

Examined examine(const AuditOptions& options, const Paper& paper, const proofs::checks::Sampling& sampling) {
  const Interruptible scope;
  Examined examined{prove(paper.claims, {}), {}, false};
  if (!interrupted()) {
    examined.gate = gate_of(options, paper, sampling);
  }
  examined.interrupted = interrupted();
  return examined;
}

// Without a report in a directory: it would be taken for a whole one.
ExitCode print_interrupted(const Examined& examined, const AuditOptions& options, const Paper& paper) {
  const proofs::methods::Audit& audit = examined.audit;
  if (options.json) {
    report::tools::Json json = report::audit::to_json({paper, audit}, command_of(options));
    json["interrupted"] = true;
    print(report::tools::to_text(json));
  } else {
    const std::string also = options.mutants ? "; wrong statements are not listed" : "";
    print(report::audit::terminal_report({paper, audit}, terminal_style()) +
          fmt::format("Interrupted: {} of {} claims were examined{}.\n", audit.records.size(),
                      paper.claims.size(), also));
  }
  return exit_interrupted;
}

// A wrong statement is proved.
bool any_survived(const std::optional<proofs::checks::Gate>& gate) {
  return gate && std::ranges::any_of(gate->mutants, [](const proofs::checks::Mutant& mutant) {
           return mutant.fate == proofs::checks::Fate::survived;
         });
}

namespace fs = std::filesystem;

// The record of certificates: in the directory, if one was named.
fs::path record_of(const AuditOptions& options) {
  const fs::path path(options.certificates);
  if (path.empty()) {
    return path;
  }
  if (!fs::exists(path / report::audit::certificate_record)) {
    throw InputOutputError(fmt::format("--certificates '{}' has no {}; script/certify makes it",
                                       options.certificates, report::audit::certificate_record));
  }
  return path / report::audit::certificate_record;
}

}  // namespace

ExitCode run(const AuditOptions& options, const Paper& paper) {
  const Jobs limit = jobs(options.jobs);
  const proofs::checks::Sampling sampling{static_cast<unsigned>(options.seed.value_or(0)),
                                          static_cast<unsigned>(options.one_in.value_or(1))};
  const fs::path record = record_of(options);
  std::optional<report::tools::Json> older;
  if (options.compare) {
    older = report::audit::read_audit(*options.compare);
  }
  if (options.out) {
    report::tools::require_writable(*options.out);
    report::orbits::require_page_tools();
  }
  std::future<report::audit::Figures> drawn;
  if (options.out || options.json || older) {
    drawn = figures_of(paper, options.out.has_value());
  }
  const Examined examined = examine(options, paper, sampling);
  if (examined.interrupted) {
    return print_interrupted(examined, options, paper);
  }
  const proofs::methods::Audit& audit = examined.audit;
  const std::optional<proofs::checks::Gate>& gate = examined.gate;
  const report::audit::Certification certificates =
      report::audit::certification(audit, record, paper.abbreviations);
  const report::audit::Figures figures = drawn.valid() ? drawn.get() : report::audit::Figures{};
  report::audit::Report made;
  if (options.out) {
    const Progress progress("making the pages ...");
    made = report::audit::pages({paper, audit}, figures, gate, certificates);
    report::tools::write_files(*options.out, made.files);
  }
  bool same = true;
  if (options.json || older) {
    const report::tools::Json json =
        report::audit::to_json({paper, audit}, command_of(options), figures.examples, gate, certificates);
    if (older) {
      const report::audit::Comparison comparison = report::audit::compare(*older, json);
      same = comparison.is_same();
      print(report::audit::to_text(comparison));
    } else {
      print(report::tools::to_text(json));
    }
  } else {
    print(report::audit::terminal_report({paper, audit}, terminal_style(), certificates) +
          (gate ? "\n" + report::audit::terminal_mutants(*gate, terminal_style()) : ""));
  }
  if (options.out) {
    tell(report_line(*options.out, "audit", made));
  }
  return exit_of(audit, any_survived(gate) || !same);
}

}  // namespace stickslip::cli
