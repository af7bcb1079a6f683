#include "proofs/checks/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "proofs/symbols/abbreviations.hpp"

namespace stickslip::proofs::checks {

using namespace symbols;

namespace {

struct TermEdit {
  EditKind kind;
  std::string what;
  Term term;
};

using TermEdits = std::vector<TermEdit>;
using Terms = std::vector<Term>;

Term opposite(const Term& term) {
  return term.op() == Op::negate ? term.arguments().front() : -term;
}

// The term over other arguments, unless their shapes do not fit.
std::optional<Term> rebuilt(const Term& term, Terms arguments) {
  try {
    Term result = term.with_arguments(std::move(arguments));
    return result.shape() == term.shape() ? std::optional(result) : std::nullopt;
  } catch (const InternalError&) {
    return std::nullopt;
  }
}

void sign_edits(const Term& term, TermEdits& found) {
  if (term.op() == Op::negate) {
    found.push_back({EditKind::sign, "sign of $" + text(term) + "$", term.arguments().front()});
  }
  if (term.op() != Op::sum) {
    return;
  }
  for (std::size_t i = 0; i < term.arguments().size(); ++i) {
    if (term.arguments()[i].op() == Op::negate) {
      continue;  // its own edit
    }
    Terms arguments = term.arguments();
    arguments[i] = opposite(arguments[i]);
    found.push_back(
        {EditKind::sign, "sign of $" + text(term.arguments()[i]) + "$", term.with_arguments(arguments)});
  }
}

void factor_edits(const Term& term, TermEdits& found) {
  if (term.op() == Op::quotient) {
    found.push_back(
        {EditKind::factor, "without the divisor $" + text(term.arguments()[1]) + "$", term.arguments()[0]});
  }
  if (term.op() != Op::product) {
    return;
  }
  for (std::size_t i = 0; i < term.arguments().size(); ++i) {
    Terms arguments = term.arguments();
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    if (const auto shorter = rebuilt(term, arguments)) {
      found.push_back({EditKind::factor, "without the factor $" + text(term.arguments()[i]) + "$",
                       arguments.size() == 1 ? arguments.front() : *shorter});
    }
  }
}

using Families = std::vector<std::vector<std::string>>;

// The other names of the family to which the name belongs.
std::vector<std::string> others_in(const Families& families, const std::string& name) {
  for (const auto& family : families) {
    if (std::find(family.begin(), family.end(), name) != family.end()) {
      std::vector<std::string> others = family;
      std::erase(others, name);
      return others;
    }
  }
  return {};
}

// Names that differ only in their index.
std::vector<std::string> siblings(const std::string& name) {
  static const Families families{
      {"H1", "H2", "H3"},
      {"B1", "B2", "B3"},
      {"Gamma1", "Gamma2", "Gamma3"},
      {"gamma1", "gamma2", "gamma3"},
      {"omega1", "omega2"},
      {"lambda1", "lambda2"},
      {"q1", "q2"},
      {"d01", "d02"},
      {"psi1", "psi2"},
      {"z10", "z20"},
      {"zdot10", "zdot20"},
      {"us", "ur"},
      {"tau", "tau1"},
      {"phi1", "phi2"},
      {"a1", "a2"},
      {"b1", "b2"},
      {"rho1", "rho2"},
      {"xi1", "xi2"},
      {"X1", "X2"},
      {"Y1", "Y2"},
      {"P1", "P2"},
      {"a_1", "a_2", "a_3", "a_4", "a_5"},
      {"b_1", "b_2", "b_3", "b_4", "b_5"},
      {"c_1", "c_2", "c_3", "c_4", "c_5"},
      {"d_1", "d_2", "d_3", "d_4", "d_5"},
      {"Delta", "Delta1", "Delta2", "Delta3"},
      {"phiB", "phiC"},
  };
  const std::vector<std::string> others = others_in(families, name);
  return others.empty() ? entry_siblings(name) : others;
}

// Names of other things of the same shape.
std::vector<std::string> other_letters(const std::string& name) {
  static const Families families{{"H", "Gamma"},     {"H1", "Gamma1"},
                                 {"H2", "Gamma2"},   {"H3", "Gamma3"},
                                 {"F0", "FB"},       {"z0", "zB"},
                                 {"Z0", "ZB", "ZC"}, {"zdot0", "zdotB"},
                                 {"Zbar0", "ZbarB"}, {"zbar0", "zbarB"},
                                 {"Q", "d0"},        {"X0", "XB"},
                                 {"x0", "xB"},       {"zdot20", "zdot2B", "zdot2C"},
                                 {"B1", "gamma1"},   {"B2", "gamma2"},
                                 {"B3", "gamma3"},   {"cos", "tan"}};
  return others_in(families, name);
}

// The quantity whose rate of change it is.
std::optional<std::string> without_prime(const std::string& name) {
  static const std::vector<std::string> known{"zdot0",  "zdotB",  "zdot10", "zdot20",
                                              "zdot1B", "zdot2B", "zdot1C", "zdot2C"};
  return std::find(known.begin(), known.end(), name) == known.end()
             ? std::nullopt
             : std::optional("z" + name.substr(std::string("zdot").size()));
}

bool is_duration(const std::string& name) {
  return name == "T" || name == "Theta" || name == "tau" || name == "tau1";
}

void name_edits(const Term& term, TermEdits& found) {
  if (term.op() != Op::symbol && term.op() != Op::function) {
    return;
  }
  const auto rename = [&](EditKind kind, const std::string& name) {
    found.push_back({kind, fmt::format("${}$ for ${}$", name, text(term)),
                     Term(Term::Node{term.op(), term.shape(), name, term.number(), term.arguments()})});
  };
  for (const std::string& name : siblings(term.name())) {
    rename(EditKind::index, name);
  }
  for (const std::string& name : other_letters(term.name())) {
    rename(EditKind::letter, name);
  }
  if (const auto name = without_prime(term.name())) {
    rename(EditKind::prime, *name);
  }
  if (is_duration(term.name())) {
    found.push_back({EditKind::period, fmt::format("half of ${}$", term.name()), term / 2});
  }
  if (term.op() == Op::function && (term.name() == "cos" || term.name() == "sin")) {
    rename(EditKind::function, term.name() == "cos" ? "sin" : "cos");
  }
}

void exchange_edits(const Term& term, TermEdits& found) {
  if (term.op() != Op::block) {
    return;
  }
  for (std::size_t i = 0; i < term.arguments().size(); ++i) {
    for (std::size_t j = i + 1; j < term.arguments().size(); ++j) {
      Terms arguments = term.arguments();
      if (equal(arguments[i], arguments[j])) {
        continue;
      }
      std::swap(arguments[i], arguments[j]);
      if (const auto other = rebuilt(term, arguments)) {
        found.push_back({EditKind::exchange,
                         fmt::format("${}$ exchanged with ${}$", text(arguments[j]), text(arguments[i])),
                         *other});
      }
    }
  }
}

// Every edit of the term itself.
TermEdits edits_here(const Term& term) {
  TermEdits found;
  sign_edits(term, found);
  factor_edits(term, found);
  name_edits(term, found);
  exchange_edits(term, found);
  if (term.op() == Op::power) {
    found.push_back(
        {EditKind::exponent, "without the exponent of $" + text(term) + "$", term.arguments().front()});
  }
  if (term.op() == Op::derivative) {
    found.push_back({EditKind::prime, "without the derivative of $" + text(term.arguments().front()) + "$",
                     term.arguments().front()});
  }
  return found;
}

// The term of a name, to be written beside another of its shape.
Term named(const Term& term, const std::string& name) {
  return Term(Term::Node{term.op(), term.shape(), name, term.number(), term.arguments()});
}

void other_name(const Term& term, EditKind kind, const std::vector<std::string>& names, TermEdits& found) {
  if (!names.empty()) {
    const Term other = named(term, names.front());
    found.push_back({kind, text(other) + " added and taken away", other + (term - other)});
  }
}

// One other way to write the term itself for each kind of edit that it allows.
TermEdits rewritings_here(const Term& term) {
  TermEdits found;
  if (term.op() == Op::sum || term.op() == Op::negate) {
    found.push_back({EditKind::sign, "two signs more", -(-term)});
  }
  if (term.op() == Op::product || term.op() == Op::quotient) {
    found.push_back({EditKind::factor, "doubled and halved", (2 * term) / 2});
  }
  if (term.op() == Op::symbol || (term.op() == Op::function && !term.shape().is_scalar())) {
    other_name(term, EditKind::index, siblings(term.name()), found);
    other_name(term, EditKind::letter, other_letters(term.name()), found);
  }
  if (term.op() == Op::symbol && is_duration(term.name())) {
    found.push_back({EditKind::period, "as two halves", term / 2 + term / 2});
  }
  if (term.op() == Op::function && (term.name() == "cos" || term.name() == "sin")) {
    const Term rest = pi() / 2 - term.arguments().front();
    found.push_back({EditKind::function, "of the complement", term.name() == "cos" ? sin(rest) : cos(rest)});
  }
  if (term.op() == Op::power && term.number() == 2) {
    found.push_back(
        {EditKind::exponent, "as a product", term.arguments().front() * term.arguments().front()});
  }
  if (term.op() == Op::block) {
    found.push_back(
        {EditKind::exchange, "a zero matrix added", term + zero(term.shape().rows, term.shape().columns)});
  }
  if (term.op() == Op::derivative) {
    found.push_back({EditKind::prime, "of the double, halved", derivative(2 * term.arguments().front()) / 2});
  }
  return found;
}

// What `here` gives at every place of the term.
TermEdits everywhere(const Term& term, TermEdits (*here)(const Term&)) {
  TermEdits found = here(term);
  for (std::size_t i = 0; i < term.arguments().size(); ++i) {
    for (const TermEdit& edit : everywhere(term.arguments()[i], here)) {
      Terms arguments = term.arguments();
      arguments[i] = edit.term;
      if (const auto changed = rebuilt(term, arguments)) {
        found.push_back({edit.kind, edit.what, *changed});
      }
    }
  }
  return found;
}

std::vector<Edit> everywhere(const Statement& statement, TermEdits (*here)(const Term&)) {
  std::vector<Edit> result;
  for (const TermEdit& edit : everywhere(statement.left, here)) {
    result.push_back({edit.kind, edit.what, {edit.term, statement.right, statement.relation}});
  }
  for (const TermEdit& edit : everywhere(statement.right, here)) {
    result.push_back({edit.kind, edit.what, {statement.left, edit.term, statement.relation}});
  }
  return result;
}

}  // namespace

std::string to_string(EditKind kind) {
  switch (kind) {
    case EditKind::sign:
      return "sign";
    case EditKind::factor:
      return "factor";
    case EditKind::index:
      return "index";
    case EditKind::exchange:
      return "exchange";
    case EditKind::function:
      return "function";
    case EditKind::exponent:
      return "exponent";
    case EditKind::letter:
      return "letter";
    case EditKind::prime:
      return "prime";
    case EditKind::period:
      return "period";
  }
  return {};
}

const std::vector<EditKind>& edit_kinds() {
  static const std::vector<EditKind> all{EditKind::sign,     EditKind::factor,   EditKind::index,
                                         EditKind::exchange, EditKind::function, EditKind::exponent,
                                         EditKind::letter,   EditKind::prime,    EditKind::period};
  return all;
}

std::vector<Edit> edits(const Statement& statement) {
  return everywhere(statement, edits_here);
}

std::vector<Edit> rewritings(const Statement& statement) {
  return everywhere(statement, rewritings_here);
}

}  // namespace stickslip::proofs::checks
