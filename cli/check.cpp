// stickslip check: single statements, equations, sections.
#include <set>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "proofs/paper.hpp"
#include "report/json.hpp"
#include "report/summary.hpp"

namespace stickslip::cli {
namespace {

// What the words name: statements, and statuses, which are known only when everything is proved.
struct Wanted {
  std::set<std::string> ids;
  std::set<std::string> statuses;
};

Wanted wanted_by(const std::vector<proofs::Claim>& claims, const std::vector<std::string>& words) {
  Wanted wanted;
  for (const std::string& word : words) {
    if (proofs::is_status(word)) {
      wanted.statuses.insert(word);
    } else {
      wanted.ids.merge(proofs::ids_named(claims, word));
    }
  }
  return wanted;
}

proofs::Audit audit_of(const std::vector<proofs::Claim>& claims, const Wanted& wanted) {
  if (wanted.statuses.empty()) {
    return prove(claims, wanted.ids);
  }
  proofs::Audit audit = prove(claims, {});
  std::erase_if(audit.records, [&](const proofs::Record& record) {
    return !wanted.ids.contains(record.claim.id) && !wanted.statuses.contains(to_string(record.status));
  });
  return audit;
}

ExitCode list(const std::vector<proofs::Claim>& claims, const std::set<std::string>& ids) {
  std::vector<proofs::Claim> named;
  for (const proofs::Claim& claim : claims) {
    if (ids.empty() || ids.contains(claim.id)) {
      named.push_back(claim);
    }
  }
  print(report::terminal_list(named));
  return exit_decided;
}

std::string command_line(const CheckOptions& options) {
  std::string command = "stickslip check";
  for (const std::string& word : options.words) {
    command += " " + word;
  }
  return command;
}

}  // namespace

ExitCode run(const CheckOptions& options) {
  const Jobs limit = jobs(options.jobs);
  const std::vector<proofs::Claim> claims = proofs::paper();
  const Wanted wanted = wanted_by(claims, options.words);
  if (options.list && !wanted.statuses.empty()) {
    throw UsageError("--list proves nothing, so it knows no status: leave out '" + *wanted.statuses.begin() +
                     "'");
  }
  if (options.list) {
    return list(claims, wanted.ids);
  }
  const proofs::Audit audit = audit_of(claims, wanted);
  if (options.json) {
    print(report::to_text(report::to_json(audit, command_line(options))));
  } else if (options.explain) {
    print(report::terminal_explanations(audit, terminal_style()));
  } else {
    print(report::terminal_lines(audit, terminal_style()));
  }
  if (report::any_refuted(audit)) {
    return exit_refuted;
  }
  return report::all_decided(audit) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
