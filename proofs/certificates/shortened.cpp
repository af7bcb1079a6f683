#include "proofs/certificates/shortened.hpp"

#include <algorithm>
#include <optional>

namespace stickslip::proofs::certificates {

using namespace kernel;

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
