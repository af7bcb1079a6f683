// stickslip latex: derived expressions for papers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "proofs/paper.hpp"
#include "proofs/prover.hpp"
#include "report/pages.hpp"
#include "symbolic/objects.hpp"

namespace stickslip::cli {
namespace {

// The ids that a name stands for. Throws UsageError.
std::set<std::string> named(const std::vector<proofs::Claim>& claims, const std::string& name) {
  try {
    return proofs::ids_named(claims, name);
  } catch (const UsageError&) {
    throw UsageError(fmt::format(
        "there is no derived expression or statement {}: stickslip latex --list names the former, "
        "stickslip check --list the latter",
        name));
  }
}

// The statements with these ids in the form that is proved, each after a comment that says what is known of
// it; a refuted one is only spoken of.
std::string statements(const std::vector<proofs::Claim>& claims, const std::set<std::string>& ids) {
  std::string result;
  for (const proofs::Record& record : prove(claims, ids).records) {
    result += fmt::format("% ({}) {}\n", record.claim.id, proofs::describe(record.status));
    if (record.status == proofs::Status::refuted) {
      continue;
    }
    std::vector<std::string> lines;
    for (const proofs::Statement& statement : proofs::proved_form(record)) {
      lines.push_back(proofs::latex(statement));
    }
    if (!lines.empty()) {
      result += fmt::format("\\begin{{gather*}}\n{}\n\\end{{gather*}}\n", fmt::join(lines, " \\\\\n"));
    }
  }
  return result;
}

// What the names ask for, or all objects. They are looked up first, so that an unknown one prints nothing.
std::string formulas(const LatexOptions& options) {
  const symbolic::Unknowns unknowns =
      options.in_frequencies ? symbolic::Unknowns::omega : symbolic::Unknowns::chi;
  const std::vector<proofs::Claim> claims = proofs::paper();
  std::vector<std::function<std::string()>> parts;
  bool any_statement = false;
  for (const std::string& name : options.names) {
    if (const symbolic::Object* object = symbolic::find_object(name)) {
      parts.emplace_back([=] { return symbolic::displayed(*object, unknowns); });
    } else {
      parts.emplace_back([&claims, ids = named(claims, name)] { return statements(claims, ids); });
      any_statement = true;
    }
  }
  if (parts.empty()) {
    for (const symbolic::Object& object : symbolic::objects()) {
      parts.emplace_back([&object, unknowns] { return symbolic::displayed(object, unknowns); });
    }
  }
  std::string result;
  for (const auto& part : parts) {
    result += (result.empty() ? "" : "\n") + part();
  }
  return result + (any_statement ? symbolic::meanings(unknowns) : "");
}

}  // namespace

ExitCode run(const LatexOptions& options) {
  print(options.errata ? report::errata(prove(proofs::paper(), {}))
        : options.list ? symbolic::list_of_objects()
                       : formulas(options));
  return exit_decided;
}

}  // namespace stickslip::cli
