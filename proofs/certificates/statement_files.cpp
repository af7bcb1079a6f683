#include "proofs/certificates/statement_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// A comment in lines that fit a screen.
std::string in_lines(const std::string& text) {
  constexpr std::size_t width = 110;
  std::istringstream words(text);
  std::string result = "(*", line = result;
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > width) {
      result += "\n  ";
      line = "  ";
    }
    result += " " + word;
    line += " " + word;
  }
  return result + " *)\n";
}

const char * const how_to_read =
    "(* What is certified. Final.v has Coq check that the theorem of each name, in its claim's own file, "
    "says\n"
    "   what stands here under that name. First the definitions: each \"name_is\" is checked by Coq as "
    "well.\n"
    "   Of the prelude these have to be understood:\n"
    "     Mat r c, mat r c [[a, b], ...]   a matrix of r rows and c columns, and one by its rows\n"
    "     ent i j A                        its entry in row i and column j, counted from 0\n"
    "     A +m B, A -m B, A ** B, s *m A, minv A   sum, difference, product, multiple, inverse by cofactors\n"
    "     derivative f p v                 f has the derivative v at p (Coquelicot's is_derive)\n"
    "     continuous_on f a b              f restricted to the closed interval from a to b is continuous\n"
    "     derivative_m, continuous_on_m    the same of each entry of a function whose values are matrices\n"
    "     finite A                         finitely many real numbers have the property A\n"
    "     inside_unit_circle c             each complex zero of c0 + c1 z + c2 z^2 + ... has a modulus below "
    "1\n"
    "   1/0 is 0 in Coq 8.16; no proof makes use of it. *)\n";

// "Definition H1_is : H1 = (fun (t omega1 omega2 : R) => …) := eq_refl."
std::string restated(const Definition& definition) {
  const std::string name = definition_name(definition), body = coq_statement(definition.body());
  const std::vector<Variable>& parameters = definition.parameters();
  return fmt::format("Definition {}_is : {} =\n  ({}) := eq_refl.\n", name, name,
                     parameters.empty() ? body : fmt::format("fun {} =>\n   {}", binders(parameters), body));
}

}  // namespace

std::vector<Definition> definitions_of(const Records& records) {
  std::vector<Definition> result;
  for (const methods::Record * record : records) {
    for (const NamedTheorem& one : named_theorems(*record)) {
      collect_definitions(one.theorem, result);
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (definition_name(result[i]) == definition_name(result[j])) {
        throw KernelError("two definitions have the name " + result[i].name());
      }
    }
  }
  return result;
}

std::string definitions_file(const Records& records) {
  std::string text =
      "(* The definitions that the statements speak of. *)\nFrom Stickslip Require Import Calculus.\nOpen "
      "Scope R_scope.\n";
  for (const Definition& definition : definitions_of(records)) {
    text += "\n" + coq_definition(definition);
  }
  return text;
}

std::string statements_file(const Records& records, const std::vector<Definition>& abbreviations) {
  std::vector<Definition> short_names;
  for (const Definition& one : abbreviations) {
    short_names.emplace_back(one.name(), one.parameters(), shortened(one.body(), short_names));
  }
  std::vector<Formula> said;
  const auto shorter = [&](const Formula& formula) {
    const Formula result = shortened(formula, short_names);
    said.push_back(hidden_definition(result).empty() ? result : formula);
    return said.back();
  };
  std::string statements;
  for (const methods::Record * record : records) {
    for (const NamedTheorem& one : named_theorems(*record)) {
      const Stated full = stated(one.theorem);
      statements += "\n" + in_lines(one.about) + fmt::format("Definition {} : Prop :=\n", one.name);
      if (!full.variables.empty()) {
        statements += fmt::format("  forall {},\n", binders(full.variables));
      }
      for (const Formula& hypothesis : full.hypotheses) {
        statements += fmt::format("  {} ->\n", coq_premise(shorter(hypothesis)));
      }
      statements += fmt::format("  {}.\n", coq_lines(shorter(one.theorem.conclusion())));
    }
  }
  std::string names;
  const Definitions used = tactics::definitions_in(said);
  for (const Definition& one : short_names) {
    names += used.contains(one) ? "\n" + coq_definition(one) : "";
  }
  std::string definitions;
  for (const Definition& one : definitions_of(records)) {
    definitions += "\n" + restated(one);
  }
  return fmt::format(
      "{}From Stickslip Require Import Calculus Definitions.\nOpen Scope R_scope.\n{}{}{}\n(* The "
      "statements. "
      "*)\n{}",
      how_to_read, definitions, names.empty() ? "" : "\n(* Abbreviations. *)\n", names, statements);
}

std::string final_file(const std::vector<Proved>& proved) {
  std::string files, checks, all;
  for (const Proved& one : proved) {
    files += fmt::format("From Stickslip Require {}.\n", one.file);
    for (const std::string& name : one.theorems) {
      const std::string typed =
          fmt::format("(Stickslip.{}.{} : Stickslip.Statements.{})", one.file, name, name);
      checks += fmt::format("Check {}.\n", typed);
      all += fmt::format("apply (Stickslip.Matrices.and_also {}).\n", typed);
    }
  }
  return "From Stickslip Require Matrices Statements.\n" + files + checks +
         "Lemma every : Stickslip.Matrices.proved.\nProof.\n" + all +
         "exact Stickslip.Matrices.no_more.\nQed.\nPrint Assumptions every.\n";
}

std::string makefile(const std::vector<Certificate>& certificates,
                     const std::map<std::string, std::size_t>& sizes) {
  // The longest first, so that in the end no process waits for another.
  std::vector<std::pair<std::size_t, std::string>> asked;
  std::set<std::string> names;
  for (const Certificate& certificate : certificates) {
    if (certificate.asked && names.insert(certificate.name).second) {
      asked.emplace_back(sizes.at(certificate.name), certificate.name);
    }
  }
  std::ranges::sort(asked, std::greater{});
  std::string text = "ASKED =";
  for (const auto& [size, name] : asked) {
    text += " " + name;
  }
  text += "\n" + make_rules().front().second;
  names.clear();
  for (const Certificate& certificate : certificates) {
    if (!names.insert(certificate.name).second) {
      continue;
    }
    text += fmt::format("{}.vo: Inverses.vo Zeros.vo Stability.vo Auxiliary.vo", certificate.name);
    for (const std::string& import : certificate.imports) {
      text += fmt::format(" {}.vo", import);
    }
    text += "\n";
  }
  return text + "Final.vo: Statements.vo $(ASKED:=.vo)\n";
}

namespace {

// Arguments with which the body may be the term: a proposal.
bool propose(const Term& body, const Variables& parameters, const Term& term, Substitution& arguments) {
  if (body.kind() == Kind::variable && parameters.contains({body.name(), body.type()})) {
    return term.is_closed() && term.type() == body.type() &&
           arguments.emplace(Variable{body.name(), body.type()}, term).first->second == term;
  }
  return body.kind() == term.kind() && body.type() == term.type() &&
         body.parts().size() == term.parts().size() &&
         std::ranges::equal(body.parts(), term.parts(), [&](const Term& a, const Term& b) {
           return propose(a, parameters, b, arguments);
         });
}

// The definition applied so that it unfolds to the term.
std::optional<Term> folded(const Definition& definition, const Term& term) {
  const Variables parameters(definition.parameters().begin(), definition.parameters().end());
  Substitution arguments;
  if (!propose(definition.body(), parameters, term, arguments)) {
    return std::nullopt;
  }
  std::vector<Term> values;
  for (const Variable& parameter : definition.parameters()) {
    const auto value = arguments.find(parameter);
    if (value == arguments.end()) {
      return std::nullopt;
    }
    values.push_back(value->second);
  }
  return definition.unfolded(values) == term ? std::optional(definition(values)) : std::nullopt;
}

// The first part, from outside, that the definition stands for, and how.
std::optional<std::pair<Term, Term>> found(const Definition& definition, const Term& term) {
  if (const auto whole = folded(definition, term)) {
    return std::pair{term, *whole};
  }
  for (const Term& part : term.parts()) {
    if (const auto inside = found(definition, part)) {
      return inside;
    }
  }
  return std::nullopt;
}

}  // namespace

Term shortened(const Term& term, const std::vector<Definition>& abbreviations) {
  Term result = term;
  for (const Definition& definition : abbreviations) {
    while (const auto one = found(definition, result)) {
      result = replaced(result, one->first, one->second);
    }
  }
  return result;
}

}  // namespace stickslip::proofs::certificates
