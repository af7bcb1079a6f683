#include "proofs/certificates/coq_terms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "core/transformed.hpp"
#include "proofs/tactics/tactics.hpp"

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
  for (const char one : name) {
    const auto c = static_cast<unsigned char>(one);
    text += std::isalnum(c) != 0 ? std::string(1, one) : fmt::format("_{:x}_", c);
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

namespace {

// How tightly Coq binds what a text says: a number is 0, an application 10, a quantified formula 200.
enum Level {
  atom = 0,
  argument = 9,
  applied_level = 10,
  base = 29,
  power_level = 30,
  inverse_level = 35,
  factor = 39,
  product_level = 40,
  sum_level = 50,
  relation = 70,
  not_level = 75,
  and_level = 80,
  or_level = 85,
  implies_level = 99,
  any_level = 200
};

std::string text(const Term& term, int level);

std::string bracketed(int own, int level, const std::string& text) {
  return own > level ? "(" + text + ")" : text;
}

bool is_matrix(const Term& term) {
  return !term.type().is_scalar();
}

std::string joined(const std::vector<Term>& parts, const char * separator, int level) {
  const auto texts = transformed(parts, [&](const Term& part) { return text(part, level); });
  return fmt::format("{}", fmt::join(texts, separator));
}

std::string applied(const std::string& function, const std::vector<Term>& arguments, int level) {
  return arguments.empty()
             ? function
             : bracketed(applied_level, level, function + " " + joined(arguments, " ", argument));
}

std::string number(const Rational& value, int level) {
  const std::string numerator = value.get_num().get_str();
  const std::string shown = value < 0 ? "(" + numerator + ")" : numerator;
  return value.get_den() == 1 ? shown
                              : bracketed(product_level, level, shown + " / " + value.get_den().get_str());
}

bool is_minus(const Term& term) {
  return term.kind() == Kind::product && term.parts()[0] == Term(-1) &&
         term.parts()[0].kind() == Kind::number;
}

// a - b is a + (-1) b: the same symbols, read more easily.
std::string sum_text(const Term& term) {
  const bool matrices = is_matrix(term);
  std::string result;
  for (const Term& part : term.parts()) {
    if (result.empty()) {
      result = text(part, sum_level);
    } else if (is_minus(part)) {
      result += (matrices ? " -m " : " - ") + text(part.parts()[1], product_level);
    } else {
      result += (matrices ? " +m " : " + ") + text(part, product_level);
    }
  }
  return result;
}

std::string product_text(const Term& term, int level) {
  const Term &a = term.parts()[0], &b = term.parts()[1];
  const auto between = [&](const Term& left, const char * symbol, const Term& right) {
    return bracketed(product_level, level, text(left, product_level) + symbol + text(right, factor));
  };
  if (!is_matrix(a) && !is_matrix(b)) {
    return b.kind() == Kind::inverse ? between(a, " / ", b.parts()[0]) : between(a, " * ", b);
  }
  if (!is_matrix(a) || !is_matrix(b)) {
    return is_matrix(a) ? between(b, " *m ", a) : between(a, " *m ", b);
  }
  return is_matrix(term) ? between(a, " ** ", b) : applied("dot", {a, b}, level);
}

std::string matrix_text(const Term& term, int level) {
  std::vector<std::string> rows;
  for (int i = 0; i < term.row(); ++i) {
    std::vector<std::string> row;
    for (int j = 0; j < term.column(); ++j) {
      row.push_back(text(term.parts()[static_cast<std::size_t>(i * term.column() + j)], sum_level));
    }
    rows.push_back(fmt::format("⟦{}⟧", fmt::join(row, ", ")));
  }
  return bracketed(applied_level, level,
                   fmt::format("mat {} {} ⟦{}⟧", term.row(), term.column(), fmt::join(rows, ", ")));
}

std::string quantified(const char * quantifier, const Term& term, int level) {
  const Variable variable = opened_variable(term);
  return bracketed(any_level, level,
                   fmt::format("{} {} : {}, {}", quantifier, identifier(variable.name),
                               coq_type(variable.type), coq_statement(opened(term, variable))));
}

std::string function_text(const Term& term) {
  const Variable variable = opened_variable(term);
  return fmt::format("(fun {} : {} => {})", identifier(variable.name), coq_type(variable.type),
                     coq_statement(opened(term, variable)));
}

// A function with its shape, where its values are matrices.
std::string of_function(const std::string& name, const Term& term, int level) {
  const Type& type = term.parts()[0].type();
  const bool scalar = type.rows == 1 && type.columns == 1;
  return applied(name + (scalar ? "" : "_m"), term.parts(), level);
}

bool is_order(const Term& term) {
  return term.kind() == Kind::less || term.kind() == Kind::at_most;
}

std::string relation_symbol(const Term& term) {
  return term.kind() == Kind::equal ? " = " : term.kind() == Kind::less ? " < " : " <= ";
}

// a < t < b is a < t and t < b.
std::string conjunction_text(const Term& term, int level) {
  const std::vector<Term>& parts = term.parts();
  if (parts.size() == 2 && is_order(parts[0]) && is_order(parts[1]) &&
      parts[0].parts()[1] == parts[1].parts()[0]) {
    return bracketed(relation, level,
                     text(parts[0].parts()[0], sum_level) + relation_symbol(parts[0]) +
                         text(parts[0].parts()[1], sum_level) + relation_symbol(parts[1]) +
                         text(parts[1].parts()[1], sum_level));
  }
  return parts.empty() ? "True" : bracketed(and_level, level, joined(parts, " /\\ ", not_level));
}

std::string text(const Term& term, int level) {
  const std::vector<Term>& parts = term.parts();
  switch (term.kind()) {
    case Kind::variable:
      return identifier(term.name());
    case Kind::number:
      return number(term.value(), level);
    case Kind::pi:
      return "PI";
    case Kind::sum:
      return bracketed(sum_level, level, sum_text(term));
    case Kind::product:
      return product_text(term, level);
    case Kind::power:
      return bracketed(power_level, level, text(parts[0], base) + " ^ " + term.value().get_str());
    case Kind::inverse:
      return is_matrix(term) ? applied("minv", parts, level)
                             : bracketed(inverse_level, level, "/ " + text(parts[0], power_level));
    case Kind::cosine:
      return applied("cos", parts, level);
    case Kind::sine:
      return applied("sin", parts, level);
    case Kind::exponential:
      return applied("exp", parts, level);
    case Kind::matrix:
      return is_matrix(term) ? matrix_text(term, level) : text(parts[0], level);
    case Kind::entry:
      return is_matrix(parts[0]) ? applied(fmt::format("ent {} {}", term.row(), term.column()), parts, level)
                                 : text(parts[0], level);
    case Kind::defined:
      return applied(definition_name(term.definition()), parts, level);
    case Kind::lambda:
      return function_text(term);
    case Kind::apply:
      return applied(text(parts[0], argument), {parts[1]}, level);
    case Kind::equal:
    case Kind::less:
    case Kind::at_most:
      return bracketed(relation, level, joined(parts, relation_symbol(term).c_str(), sum_level));
    case Kind::conjunction:
      return conjunction_text(term, level);
    case Kind::disjunction:
      return parts.empty() ? "False" : bracketed(or_level, level, joined(parts, " \\/ ", not_level));
    case Kind::negation:
      return parts[0].kind() == Kind::equal
                 ? bracketed(relation, level, joined(parts[0].parts(), " <> ", sum_level))
                 : bracketed(not_level, level, "~ " + text(parts[0], argument));
    case Kind::implication:
      return bracketed(implies_level, level,
                       text(parts[0], or_level) + " -> " +
                           text(parts[1], level < any_level ? +implies_level : +any_level));
    case Kind::for_all:
      return quantified("forall", term, level);
    case Kind::exists:
      return quantified("exists", term, level);
    case Kind::derivative:
      return of_function("derivative", term, level);
    case Kind::continuous:
      return of_function("continuous_on", term, level);
    case Kind::finite:
      return bracketed(applied_level, level, "finite " + function_text(term));
    case Kind::inside_unit_circle:
      return applied("inside_unit_circle", parts, level);
    default:
      throw KernelError("a formula about " + to_string(term) + " has no form in Coq");
  }
}

}  // namespace

std::string coq_type(const Type& type) {
  const std::string values =
      type.rows == 1 && type.columns == 1 ? "R" : fmt::format("Mat {} {}", type.rows, type.columns);
  return type.sort == Sort::function ? "R -> " + values : values;
}

std::string any_value(const Type& type) {
  const std::string zero =
      type.rows == 1 && type.columns == 1 ? "0" : fmt::format("(mzero {} {})", type.rows, type.columns);
  return type.sort == Sort::function ? fmt::format("(fun _ : R => {})", zero) : zero;
}

std::string binders(const std::vector<Variable>& variables) {
  std::string text;
  for (std::size_t i = 0; i < variables.size();) {
    text += i == 0 ? "(" : " (";
    const Type& type = variables[i].type;
    for (; i < variables.size() && variables[i].type == type; ++i) {
      text += identifier(variables[i].name) + " ";
    }
    text += fmt::format(": {})", coq_type(type));
  }
  return text;
}

std::string coq(const Term& term) {
  return text(term, argument);
}

std::string coq_statement(const Term& term) {
  return text(term, any_level);
}

std::string coq_premise(const Term& term) {
  return text(term, or_level);
}

std::string coq_lines(const Term& formula) {
  std::vector<Variable> variables;
  Term body = formula;
  while (body.kind() == Kind::exists) {
    variables.push_back(opened_variable(body));
    body = opened(body, variables.back());
  }
  const std::string there_are = variables.empty() ? "" : fmt::format("exists {},\n  ", binders(variables));
  const std::size_t few = 2;  // which may read a < b < c
  return there_are + (body.kind() == Kind::conjunction && body.parts().size() > few
                          ? joined(body.parts(), " /\\\n  ", not_level)
                          : coq_statement(body));
}

std::string coq_definition(const Definition& definition) {
  const std::vector<Variable>& parameters = definition.parameters();
  const std::string type =
      definition.body().type() == truth_value
          ? "Prop"
          : coq_type(real_matrix(definition.body().type().rows, definition.body().type().columns));
  return fmt::format("Definition {}{}{} : {} :=\n  {}.\n", definition_name(definition),
                     parameters.empty() ? "" : " ", binders(parameters), type,
                     coq_statement(definition.body()));
}

Term difference(const Term& a, const Term& b) {
  return sum({a, Term(-1) * b});
}

std::optional<Theorem> identity(const Term& left, const Term& right, const Definitions& unfolded) {
  return tactics::attempt([&] { return Theorem::combination(equal(left, right), {}, unfolded); });
}

std::string nothing(const Type& type) {
  return any_value(real_matrix(type.rows, type.columns));
}

std::string names_of(const Definitions& definitions) {
  return fmt::format("{}", fmt::join(transformed(definitions, definition_name), " "));
}

std::string opening(const std::string& before, const Definitions& definitions, const std::string& after) {
  return definitions.empty() ? ""
                             : fmt::format("{}cbv beta delta [{}]{}", before, names_of(definitions), after);
}

}  // namespace stickslip::proofs::certificates
