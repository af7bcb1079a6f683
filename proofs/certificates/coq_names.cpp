#include "proofs/certificates/coq_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

std::set<std::string> words(const std::string& text) {
  std::istringstream all(text);
  return {std::istream_iterator<std::string>(all), {}};
}

// Words of Coq and names of the prelude that a statement may use itself.
const std::set<std::string> taken = words(
    "R Z Mat Vec S O I PI cos sin as at by do else end exists fix for forall fun if in let "
    "match mod of return then using where with Set Prop Type True False not and or ex eq "
    "det mat dot ent minv mzero IZR finite nat list derivative derivative_m continuous_on "
    "continuous_on_m");
// What the certificates name themselves.
const std::vector<std::string> prefixes{"v_",     "hyp",    "by",         "truth",
                                        "Claim_", "claim_", "corrected_", "converse_"};
// Variables that have the name of a definition: where they stand, the definition would be hidden.
const std::set<std::string> defined_names{"chi", "eta"};

bool is_plain(const std::string& name) {
  return std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::none_of(prefixes.begin(), prefixes.end(),
                      [&](const std::string& prefix) { return name.starts_with(prefix); }) &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

std::string encoded(const std::string& name) {
  std::string text = "v_";
  for (const unsigned char c : name) {
    text += std::isalnum(c) != 0 ? std::string(1, static_cast<char>(c)) : fmt::format("_{:x}_", c);
  }
  return text;
}

}  // namespace

std::string identifier(const std::string& name) {
  if (!is_plain(name)) {
    return encoded(name);
  }
  return taken.contains(name) || defined_names.contains(name) ? name + "'" : name;
}

std::string definition_name(const Definition& definition) {
  const std::string& name = definition.name();
  return defined_names.contains(name) ? name : identifier(name);
}

Variable opened_variable(const Term& term) {
  Variable variable{term.name(), term.binds()};
  const auto in_use = [&] {
    return std::any_of(term.variables().begin(), term.variables().end(),
                       [&](const Variable& free) { return free.name == variable.name; });
  };
  while (in_use()) {
    variable.name += "_";
  }
  return variable;
}

namespace {

void collect(const Term& term, std::set<Term>& seen, std::vector<Definition>& found) {
  if (!seen.insert(term).second) {
    return;
  }
  for (const Term& part : term.parts()) {
    collect(part, seen, found);
  }
  if (term.kind() == Kind::defined &&
      std::find(found.begin(), found.end(), term.definition()) == found.end()) {
    collect(term.definition().body(), seen, found);
    if (std::find(found.begin(), found.end(), term.definition()) == found.end()) {
      found.push_back(term.definition());
    }
  }
}

bool is_binder(const Term& term) {
  return term.kind() == Kind::lambda || term.kind() == Kind::for_all || term.kind() == Kind::exists ||
         term.kind() == Kind::finite;
}

// As they are written.
void collect_variables(const Term& term, std::set<Term>& seen, std::set<std::string>& names) {
  if (!seen.insert(term).second) {
    return;
  }
  for (const Variable& variable : term.variables()) {
    names.insert(identifier(variable.name));
  }
  if (is_binder(term)) {
    const Variable variable = opened_variable(term);
    names.insert(identifier(variable.name));
    collect_variables(opened(term, variable), seen, names);
    return;
  }
  for (const Term& part : term.parts()) {
    collect_variables(part, seen, names);
  }
}

}  // namespace

std::string hidden_definition(const Term& term) {
  std::vector<Definition> definitions;
  collect_definitions(term, definitions);
  std::set<std::string> names;
  std::set<Term> seen;
  collect_variables(term, seen, names);
  const auto found = std::find_if(definitions.begin(), definitions.end(), [&](const Definition& definition) {
    return names.contains(definition_name(definition));
  });
  return found == definitions.end() ? "" : definition_name(*found);
}

void collect_definitions(const Term& term, std::vector<Definition>& found) {
  std::set<Term> seen;
  collect(term, seen, found);
}

}  // namespace stickslip::proofs::certificates
