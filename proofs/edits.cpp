#include "proofs/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "proofs/abbreviations.hpp"

namespace stickslip::proofs {
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
    found.push_back({EditKind::sign, "sign of " + text(term), term.arguments().front()});
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
    found.push_back({EditKind::sign, "sign of " + text(term.arguments()[i]), term.with_arguments(arguments)});
  }
}

void factor_edits(const Term& term, TermEdits& found) {
  if (term.op() == Op::quotient) {
    found.push_back(
        {EditKind::factor, "without the divisor " + text(term.arguments()[1]), term.arguments()[0]});
  }
  if (term.op() != Op::product) {
    return;
  }
  for (std::size_t i = 0; i < term.arguments().size(); ++i) {
    Terms arguments = term.arguments();
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    if (const auto shorter = rebuilt(term, arguments)) {
      found.push_back({EditKind::factor, "without the factor " + text(term.arguments()[i]),
                       arguments.size() == 1 ? arguments.front() : *shorter});
    }
  }
}

// Names that differ only in their index.
std::vector<std::string> siblings(const std::string& name) {
  static const std::vector<std::vector<std::string>> families{
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
  for (const auto& family : families) {
    if (std::find(family.begin(), family.end(), name) != family.end()) {
      return family;
    }
  }
  return entry_siblings(name);
}

void name_edits(const Term& term, TermEdits& found) {
  if (term.op() != Op::symbol && term.op() != Op::function) {
    return;
  }
  const auto rename = [&](EditKind kind, const std::string& name) {
    found.push_back({kind, fmt::format("{} for {}", name, text(term)),
                     Term(Term::Node{term.op(), term.shape(), name, term.number(), term.arguments()})});
  };
  for (const std::string& name : siblings(term.name())) {
    if (name != term.name()) {
      rename(EditKind::index, name);
    }
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
                         fmt::format("{} exchanged with {}", text(arguments[j]), text(arguments[i])),
                         *other});
      }
    }
  }
}

TermEdits edits_of(const Term& term) {
  TermEdits found;
  sign_edits(term, found);
  factor_edits(term, found);
  name_edits(term, found);
  exchange_edits(term, found);
  if (term.op() == Op::power) {
    found.push_back({EditKind::exponent, "without the exponent of " + text(term), term.arguments().front()});
  }
  for (std::size_t i = 0; i < term.arguments().size(); ++i) {
    for (const TermEdit& edit : edits_of(term.arguments()[i])) {
      Terms arguments = term.arguments();
      arguments[i] = edit.term;
      if (const auto changed = rebuilt(term, arguments)) {
        found.push_back({edit.kind, edit.what, *changed});
      }
    }
  }
  return found;
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
  }
  return {};
}

std::vector<Edit> edits(const Statement& statement) {
  std::vector<Edit> result;
  for (const TermEdit& edit : edits_of(statement.left)) {
    result.push_back({edit.kind, edit.what, {edit.term, statement.right, statement.relation}});
  }
  for (const TermEdit& edit : edits_of(statement.right)) {
    result.push_back({edit.kind, edit.what, {statement.left, edit.term, statement.relation}});
  }
  return result;
}

}  // namespace stickslip::proofs
