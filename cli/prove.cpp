// stickslip prove: a statement of one's own.
#include <fmt/format.h>

#include <string>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "proofs/methods/automatic.hpp"
#include "report/audit/json.hpp"
#include "report/audit/summary.hpp"

namespace stickslip::cli {

namespace methods = proofs::methods;

namespace {

std::string answer(const ProveOptions& options, const methods::Paper& paper, const methods::Audit& audit) {
  if (options.json) {
    const std::string command = fmt::format("stickslip prove '{}'", options.statement);
    return report::tools::to_text(report::audit::to_json(paper, audit, command));
  }
  return options.explain ? report::audit::terminal_explanations(paper, audit, terminal_style())
                         : report::audit::terminal_answer(audit.records.front(), terminal_style());
}

}  // namespace

ExitCode run(const ProveOptions& options, const methods::Paper& paper) {
  methods::Paper with_own = paper;
  with_own.claims.push_back(methods::own_claim({options.statement, options.assumptions, options.symbols}));
  const methods::Audit audit = prove(with_own.claims, {methods::own_id});
  print(answer(options, with_own, audit));
  // Refuted, whatever is true in its place.
  const ExitCode code = exit_of(audit, audit.records.front().outcome.verdict.truth == Truth::refuted);
  if (code != exit_decided || options.certificate.empty()) {
    return code;
  }
  CertifyOptions certify;
  certify.words = {methods::own_id};
  certify.out = options.certificate;
  return run(certify, with_own);
}

}  // namespace stickslip::cli
