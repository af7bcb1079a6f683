#include "cli/answers/latex_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "cli/answers/orbit_data.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "proofs/methods/prover.hpp"
#include "report/audit/pages.hpp"
#include "report/orbits/object_values.hpp"
#include "report/tools/prose.hpp"
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

// "\paragraph{First block of $H$ (38)}" for the sentence and the number of the paper's equation.
std::string heading(const std::string& sentence, const std::string& number) {
  return fmt::format("\\paragraph{{{} {}}}\n", report::tools::capitalised(report::tools::prose_tex(sentence)),
                     number);
}

constexpr const char * new_line = " \\\\\n";

// The lines of a statement in the form that is proved.
std::vector<std::string> lines_of(const proofs::methods::Record& record) {
  std::vector<std::string> lines;
  for (const proofs::symbols::Statement& statement : proofs::methods::proved_form(record)) {
    lines.push_back(proofs::symbols::latex(statement));
  }
  return lines;
}

// The statements with these ids in the form that is proved, each after a comment that says what is known of
// it; a refuted one is only spoken of.
std::string statements(const std::vector<proofs::methods::Claim>& claims, const std::set<std::string>& ids,
                       const Prove& prove) {
  std::string result;
  for (const proofs::methods::Record& record : prove(claims, ids).records) {
    result += fmt::format("% ({}) {}\n", record.claim.id, proofs::methods::facts(record.status).meaning);
    if (record.status == proofs::methods::Status::refuted) {
      continue;
    }
    if (const std::vector<std::string> lines = lines_of(record); !lines.empty()) {
      result += heading(record.claim.words, fmt::format("({})", record.claim.id));
      result += fmt::format("\\begin{{gather*}}\n{}\n\\end{{gather*}}\n", fmt::join(lines, new_line));
    }
  }
  return result;
}

// Their formulas alone. Throws UsageError naming one that is not proved, and if there is no formula at all.
std::vector<std::string> bare_statements(const std::vector<proofs::methods::Claim>& claims,
                                         const std::set<std::string>& ids, const Prove& prove) {
  std::vector<std::string> all;
  for (const proofs::methods::Record& record : prove(claims, ids).records) {
    using proofs::methods::Status;
    if (record.status == Status::refuted || record.status == Status::undecided) {
      throw UsageError(fmt::format("bare: {} is {}: there is no proved formula to print", record.claim.id,
                                   proofs::methods::facts(record.status).meaning));
    }
    const std::vector<std::string> lines = lines_of(record);
    all.insert(all.end(), lines.begin(), lines.end());
  }
  if (all.empty()) {
    throw UsageError(fmt::format("bare: {} is in words, without a formula", fmt::join(ids, ", ")));
  }
  return all;
}

std::string derived(const symbolic::objects::Object& object, symbolic::objects::Unknowns unknowns) {
  return heading(object.title, object.number) + symbolic::objects::displayed(object, unknowns);
}

symbolic::objects::Unknowns unknowns_of(const LatexOptions& options) {
  return options.in_frequencies ? symbolic::objects::Unknowns::omega : symbolic::objects::Unknowns::chi;
}

bool gives_parameters(const LatexOptions& options) {
  return !options.parameters.empty() || !options.file.empty() || !options.example.empty();
}

int digits_of(const LatexOptions& options) {
  return options.digits.value_or(LatexOptions::default_digits);
}

// What is added to an expression: its values at the parameters that are given, if any are. Throws UsageError
// for intervals, and naming all parameters that the expressions asked for need and that are missing.
std::function<std::string(const symbolic::objects::Object&)> values(
    const LatexOptions& options, const proofs::methods::Paper& paper,
    const std::vector<const symbolic::objects::Object *>& asked) {
  if (!gives_parameters(options)) {
    return [](const symbolic::objects::Object&) { return std::string(); };
  }
  const TypedParameters typed =
      given_parameters(paper.examples, read_parameters(options, FrictionAtRest::optional));
  report::orbits::GivenParameters given;
  for (const auto& [name, text] : typed) {
    given[name] = exact_number(name, text);
  }
  require_given(typed, report::orbits::parameters_of(asked));
  return [given, digits = digits_of(options)](const symbolic::objects::Object& object) {
    return report::orbits::values_latex(object, given, digits);
  };
}

// What the names ask for, or all objects. They are looked up first, so that an unknown one prints nothing.
std::string formulas(const LatexOptions& options, const proofs::methods::Paper& paper, const Prove& prove) {
  const std::vector<proofs::methods::Claim>& claims = paper.claims;
  std::vector<std::string> names = options.names;
  if (names.empty()) {
    std::ranges::transform(symbolic::objects::objects(), std::back_inserter(names),
                           &symbolic::objects::Object::name);
  }
  std::vector<const symbolic::objects::Object *> asked;
  std::ranges::transform(names, std::back_inserter(asked), symbolic::objects::find_object);
  std::erase(asked, nullptr);
  const auto at_parameters = values(options, paper, asked);
  const symbolic::objects::Unknowns unknowns = unknowns_of(options);
  std::vector<std::function<std::string()>> parts;
  bool any_statement = false;
  for (const std::string& name : names) {
    if (const symbolic::objects::Object * object = symbolic::objects::find_object(name)) {
      parts.emplace_back([=] { return derived(*object, unknowns) + at_parameters(*object); });
    } else {
      if (gives_parameters(options)) {
        throw UsageError(
            fmt::format("{} is a statement, for all parameters: values are those of derived "
                        "expressions, which stickslip latex --list names",
                        name));
      }
      parts.emplace_back([&, ids = named(claims, name)] { return statements(claims, ids, prove); });
      any_statement = true;
    }
  }
  std::string result;
  for (const auto& part : parts) {
    result += (result.empty() ? "" : "\n") + part();
  }
  return result + (any_statement ? symbolic::objects::meanings(unknowns) : "");
}

// The same formulas one below the other, without what is said about them.
std::string bare_formulas(const LatexOptions& options, const proofs::methods::Paper& paper,
                          const Prove& prove) {
  if (options.names.empty()) {
    throw UsageError(
        "--bare needs the name of an expression or a statement: stickslip latex --list names "
        "the former, stickslip check --list the latter");
  }
  if (gives_parameters(options)) {
    throw UsageError("--bare is for formulas without values: leave the parameters out");
  }
  std::vector<std::string> lines;
  for (const std::string& name : options.names) {
    if (const symbolic::objects::Object * object = symbolic::objects::find_object(name)) {
      lines.push_back(symbolic::objects::bare(*object, unknowns_of(options)));
    } else {
      std::ranges::copy(bare_statements(paper.claims, named(paper.claims, name), prove),
                        std::back_inserter(lines));
    }
  }
  return fmt::format("{}\n", fmt::join(lines, new_line));
}

// A result of the audit, after the proofs of its claims. Throws UsageError naming those that there are.
std::string theorem(const proofs::methods::Paper& paper, const std::string& id, const Prove& prove) {
  std::vector<std::string> known;
  for (const proofs::methods::Result& result : paper.results) {
    if (result.id == id) {
      const std::set<std::string> claims(result.claims.begin(), result.claims.end());
      return report::audit::theorem({paper, prove(paper.claims, claims)}, id);
    }
    known.push_back(result.id);
  }
  throw UsageError(fmt::format("there is no result '{}': there are {}", id, fmt::join(known, ", ")));
}

LatexText orbit(const proofs::methods::Paper& paper, const LatexOptions& options) {
  const int digits = digits_of(options);
  ParameterFile file = read_parameters(options, FrictionAtRest::optional);
  const NamedOrbit named =
      named_orbit(options.orbit, paper.examples, file, std::max(digits + 2, OrbitsOptions::default_digits));
  return {report::orbits::orbit_latex(named.list, named.index, digits), file.left_out};
}

}  // namespace

LatexText latex_text(const LatexOptions& options, const proofs::methods::Paper& paper, const Prove& prove) {
  if (!options.orbit.empty()) {
    return orbit(paper, options);
  }
  const bool names_expressions = options.theorem.empty() && !options.errata && !options.list;
  if (gives_parameters(options) && !names_expressions) {
    throw UsageError("parameters are for derived expressions and --orbit: theorems and errata have none");
  }
  if (options.digits && !gives_parameters(options)) {
    throw UsageError("--digits is for values: it needs parameters");
  }
  if (!options.theorem.empty()) {
    return {theorem(paper, options.theorem, prove)};
  }
  return {options.errata ? report::audit::errata({paper, prove(paper.claims, {})})
          : options.list ? symbolic::objects::list_of_objects()
          : options.bare ? bare_formulas(options, paper, prove)
                         : formulas(options, paper, prove)};
}

}  // namespace stickslip::cli
