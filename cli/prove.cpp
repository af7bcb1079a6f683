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
  with_own.claims.push_back(
      methods::own_claim({options.statement, options.assumptions, options.symbols}, paper.claims));
  const methods::Audit audit = prove(with_own.claims, {methods::own_id});
  print(answer(options, with_own, audit));
  if (audit.records.front().outcome.verdict.truth == Truth::refuted) {
    return exit_refuted;  // whatever is true in its place
  }
  if (!report::audit::all_decided(audit)) {
    return exit_undecided;
  }
  if (options.certificate.empty()) {
    return exit_decided;
  }
  CertifyOptions certify;
  certify.words = {methods::own_id};
  certify.out = options.certificate;
  return run(certify, with_own);
}

}  // namespace stickslip::cli
