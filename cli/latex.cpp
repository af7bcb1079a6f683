// stickslip latex: derived expressions for papers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "proofs/methods/prover.hpp"
#include "report/audit/pages.hpp"
#include "symbolic/objects/objects.hpp"

namespace stickslip::cli {
namespace {

// The ids that a name stands for. Throws UsageError.
std::set<std::string> named(const std::vector<proofs::methods::Claim>& claims, const std::string& name) {
  try {
    return proofs::methods::ids_named(claims, name);
  } catch (const UsageError&) {
    throw UsageError(fmt::format(
        "there is no derived expression or statement {}: stickslip latex --list names the former, "
        "stickslip check --list the latter",
        name));
  }
}

// The statements with these ids in the form that is proved, each after a comment that says what is known of
// it; a refuted one is only spoken of.
std::string statements(const std::vector<proofs::methods::Claim>& claims, const std::set<std::string>& ids) {
  std::string result;
  for (const proofs::methods::Record& record : prove(claims, ids).records) {
    result += fmt::format("% ({}) {}\n", record.claim.id, proofs::methods::facts(record.status).meaning);
    if (record.status == proofs::methods::Status::refuted) {
      continue;
    }
    std::vector<std::string> lines;
    for (const proofs::symbols::Statement& statement : proofs::methods::proved_form(record)) {
      lines.push_back(proofs::symbols::latex(statement));
    }
    if (!lines.empty()) {
      result += fmt::format("\\begin{{gather*}}\n{}\n\\end{{gather*}}\n", fmt::join(lines, " \\\\\n"));
    }
  }
  return result;
}

// What the names ask for, or all objects. They are looked up first, so that an unknown one prints nothing.
std::string formulas(const LatexOptions& options, const std::vector<proofs::methods::Claim>& claims) {
  const symbolic::objects::Unknowns unknowns =
      options.in_frequencies ? symbolic::objects::Unknowns::omega : symbolic::objects::Unknowns::chi;
  std::vector<std::function<std::string()>> parts;
  bool any_statement = false;
  for (const std::string& name : options.names) {
    if (const symbolic::objects::Object * object = symbolic::objects::find_object(name)) {
      parts.emplace_back([=] { return symbolic::objects::displayed(*object, unknowns); });
    } else {
      parts.emplace_back([&claims, ids = named(claims, name)] { return statements(claims, ids); });
      any_statement = true;
    }
  }
  if (parts.empty()) {
    for (const symbolic::objects::Object& object : symbolic::objects::objects()) {
      parts.emplace_back([&object, unknowns] { return symbolic::objects::displayed(object, unknowns); });
    }
  }
  std::string result;
  for (const auto& part : parts) {
    result += (result.empty() ? "" : "\n") + part();
  }
  return result + (any_statement ? symbolic::objects::meanings(unknowns) : "");
}

}  // namespace

namespace {

// A result of the audit, after the proofs of its claims. Throws UsageError naming those that there are.
std::string theorem(const proofs::methods::Paper& paper, const std::string& id) {
  std::vector<std::string> known;
  for (const proofs::methods::Result& result : paper.results) {
    if (result.id == id) {
      const std::set<std::string> claims(result.claims.begin(), result.claims.end());
      return report::audit::theorem(paper, prove(paper.claims, claims), id);
    }
    known.push_back(result.id);
  }
  throw UsageError(fmt::format("there is no result '{}': there are {}", id, fmt::join(known, ", ")));
}

}  // namespace

ExitCode run(const LatexOptions& options, const proofs::methods::Paper& paper) {
  if (!options.theorem.empty()) {
    print(theorem(paper, options.theorem));
    return exit_decided;
  }
  print(options.errata ? report::audit::errata(paper, prove(paper.claims, {}))
        : options.list ? symbolic::objects::list_of_objects()
                       : formulas(options, paper.claims));
  return exit_decided;
}

}  // namespace stickslip::cli
