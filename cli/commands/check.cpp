// stickslip check: single statements, equations, sections; below, prove and latex.
#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/answers/latex_text.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/output.hpp"
#include "core/error.hpp"
#include "proofs/methods/automatic.hpp"
#include "report/audit/json.hpp"
#include "report/audit/summary.hpp"

namespace stickslip::cli {

namespace methods = proofs::methods;

namespace {

// What the words name: statements, and statuses, which are known only when everything is proved.
struct Wanted {
  std::set<std::string> ids;
  std::set<std::string> statuses;
};

Wanted wanted_by(const std::vector<proofs::methods::Claim>& claims, const std::vector<std::string>& words) {
  Wanted wanted;
  for (const std::string& word : words) {
    if (proofs::methods::is_status(word)) {
      wanted.statuses.insert(word);
    } else {
      wanted.ids.merge(proofs::methods::ids_named(claims, word));
    }
  }
  return wanted;
}

proofs::methods::Audit audit_of(const std::vector<proofs::methods::Claim>& claims, const Wanted& wanted) {
  if (wanted.statuses.empty()) {
    return prove(claims, wanted.ids);
  }
  proofs::methods::Audit audit = prove(claims, {});
  std::erase_if(audit.records, [&](const proofs::methods::Record& record) {
    return !wanted.ids.contains(record.claim.id) && !wanted.statuses.contains(to_string(record.status));
  });
  return audit;
}

ExitCode list(const std::vector<proofs::methods::Claim>& claims, const std::set<std::string>& ids) {
  std::vector<proofs::methods::Claim> named;
  for (const proofs::methods::Claim& claim : claims) {
    if (ids.empty() || ids.contains(claim.id)) {
      named.push_back(claim);
    }
  }
  print(report::audit::terminal_list(named));
  return exit_decided;
}

std::string command_line(const CheckOptions& options) {
  std::string command = "stickslip check";
  for (const std::string& word : options.words) {
    command += " " + word;
  }
  return command;
}

std::string answer(const ProveOptions& options, const methods::Paper& paper, const methods::Audit& audit) {
  if (options.json) {
    const std::string command = fmt::format("stickslip prove '{}'", options.statement);
    return report::tools::to_text(report::audit::to_json({paper, audit}, command));
  }
  return options.explain ? report::audit::terminal_explanations({paper, audit}, terminal_style())
                         : report::audit::terminal_answer(audit.records.front(), terminal_style());
}

}  // namespace

ExitCode run(const CheckOptions& options, const proofs::methods::Paper& paper) {
  const Jobs limit = jobs(options.jobs);
  const std::vector<proofs::methods::Claim>& claims = paper.claims;
  const Wanted wanted = wanted_by(claims, options.words);
  if (options.list && !wanted.statuses.empty()) {
    throw UsageError("--list proves nothing, so it knows no status: leave out '" + *wanted.statuses.begin() +
                     "'");
  }
  if (options.list) {
    return list(claims, wanted.ids);
  }
  const proofs::methods::Audit audit = audit_of(claims, wanted);
  if (options.json) {
    print(report::tools::to_text(report::audit::to_json({paper, audit}, command_line(options))));
  } else if (options.explain) {
    print(report::audit::terminal_explanations({paper, audit}, terminal_style()));
  } else {
    print(report::audit::terminal_lines({paper, audit}, terminal_style()));
  }
  return exit_of(audit, report::audit::any_refuted(audit));
}

// stickslip prove: a statement of one's own.

ExitCode run(const ProveOptions& options, const methods::Paper& paper) {
  methods::Paper with_own = paper;
  with_own.claims.push_back(
      methods::own_claim({options.statement, options.assumptions, options.symbols, "--symbols "}));
  const methods::Audit audit = prove(with_own.claims, {methods::own_id});
  print(answer(options, with_own, audit));
  // Refuted, whatever is true in its place.
  const ExitCode code = exit_of(audit, audit.records.front().outcome.verdict.truth == Truth::refuted);
  if (options.certificate.empty()) {
    return code;
  }
  if (code != exit_decided && code != exit_refuted) {
    tell(fmt::format("stickslip: nothing is written to '{}': what is not decided has no certificate",
                     options.certificate));
    return code;
  }
  CertifyOptions certify;
  certify.words = {methods::own_id};
  certify.out = options.certificate;
  const ExitCode written = run(certify, with_own);
  return code == exit_decided ? written : code;
}

// stickslip latex: derived expressions, statements, theorems and orbits for papers.

ExitCode run(const LatexOptions& options, const proofs::methods::Paper& paper) {
  const LatexText made = [&] {
    std::optional<Progress> progress;
    if (!options.orbit.empty()) {
      progress.emplace("searching for orbits ...");
    }
    return latex_text(options, paper, prove);
  }();
  for (const std::string& sentence : made.left_out) {
    tell(sentence);
  }
  print(made.text);
  return exit_decided;
}

}  // namespace stickslip::cli
