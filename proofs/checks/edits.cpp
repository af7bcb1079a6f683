#include "proofs/checks/edits.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "core/error.hpp"
#include "proofs/symbols/table.hpp"

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

// The same with another name.
Term renamed(const Term& term, const std::string& name) {
  return Term(Term::Node{term.op(), term.shape(), name, term.number(), term.arguments()});
}

// The name of sin for a cos, of cos for a sin; empty for every other term.
std::string cofunction(const Term& term) {
  const bool trigonometric = term.op() == Op::function && (term.name() == "cos" || term.name() == "sin");
  return !trigonometric ? "" : term.name() == "cos" ? "sin" : "cos";
}

// What the table of symbols says of a name that has a row; nothing of any other term.
const Symbol& about(const Term& term) {
  static const Symbol nothing{};
  const Symbol * symbol = symbol_table().find(term);
  return symbol == nullptr ? nothing : *symbol;
}

void name_edits(const Term& term, TermEdits& found) {
  const Symbol& symbol = about(term);
  const auto rename = [&](EditKind kind, const std::string& name) {
    found.push_back({kind, fmt::format("${}$ for ${}$", name, text(term)), renamed(term, name)});
  };
  for (const std::string& name : symbol.other_indices) {
    rename(EditKind::index, name);
  }
  for (const std::string& name : symbol.other_letters) {
    rename(EditKind::letter, name);
  }
  if (!symbol.rate_of.empty()) {
    rename(EditKind::prime, symbol.rate_of);
  }
  if (symbol.is_duration) {
    found.push_back({EditKind::period, fmt::format("half of ${}$", term.name()), term / 2});
  }
  if (!cofunction(term).empty()) {
    rename(EditKind::function, cofunction(term));
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

void other_name(const Term& term, EditKind kind, const std::vector<std::string>& names, TermEdits& found) {
  if (!names.empty()) {
    const Term other = renamed(term, names.front());
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
    other_name(term, EditKind::index, about(term).other_indices, found);
    other_name(term, EditKind::letter, about(term).other_letters, found);
  }
  if (about(term).is_duration) {
    found.push_back({EditKind::period, "as two halves", term / 2 + term / 2});
  }
  if (!cofunction(term).empty()) {
    const Term rest = pi() / 2 - term.arguments().front();
    found.push_back(
        {EditKind::function, "of the complement", renamed(term.with_arguments({rest}), cofunction(term))});
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
    result.push_back(
        {edit.kind, edit.what, {edit.term, statement.right, statement.relation, statement.during}});
  }
  for (const TermEdit& edit : everywhere(statement.right, here)) {
    result.push_back(
        {edit.kind, edit.what, {statement.left, edit.term, statement.relation, statement.during}});
  }
  return result;
}

}  // namespace

std::string to_string(EditKind kind) {
  static constexpr std::array names{"sign",     "factor", "index", "exchange", "function",
                                    "exponent", "letter", "prime", "period"};
  return names.at(static_cast<std::size_t>(kind));
}

std::vector<Edit> edits(const Statement& statement) {
  return everywhere(statement, edits_here);
}

std::vector<Edit> rewritings(const Statement& statement) {
  return everywhere(statement, rewritings_here);
}

}  // namespace stickslip::proofs::checks
