#include "proofs/symbols/table.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "symbolic/typeset/names.hpp"

using namespace stickslip;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

// The symbol as a term; a function of time at t.
Term term_of(const Symbol& symbol, const std::string& name) {
  return Term(Term::Node{symbol.of_time ? Op::function : Op::symbol, symbol.shape, name, 0,
                         symbol.of_time ? std::vector<Term>{t} : std::vector<Term>{}});
}

void names_without_row(const Term& term, std::set<std::string>& names) {
  const bool is_name = term.op() == Op::symbol || term.op() == Op::function;
  if (is_name && symbol_table().find(term) == nullptr) {
    names.insert(text(term));
  }
  for (const Term& argument : term.arguments()) {
    names_without_row(argument, names);
  }
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::count(names.begin(), names.end(), name) == 1;
}

}  // namespace

TEST_CASE("every symbol that a claim uses, or that stands for one in the table, has a row") {
  std::set<std::string> missing;
  const auto look = [&](const Statement& statement) {
    names_without_row(statement.left, missing);
    names_without_row(statement.right, missing);
  };
  for (const proofs::methods::Claim& claim : proofs::pascal2012::paper().claims) {
    std::for_each(claim.printed.begin(), claim.printed.end(), look);
    std::for_each(claim.corrected.begin(), claim.corrected.end(), look);
    for (const proofs::methods::Assumption& assumption : claim.assumptions) {
      look(assumption.statement);
    }
  }
  for (const Symbol& symbol : symbol_table()) {
    names_without_row(symbol.value.value_or(0), missing);
  }
  CAPTURE(fmt::format("{}", fmt::join(missing, ", ")));
  CHECK(missing.empty());
}

TEST_CASE("a misprint can be made both ways, and leaves a formula with meaning") {
  for (const Symbol& symbol : symbol_table()) {
    CAPTURE(symbol.name);
    for (const auto column : {&Symbol::other_indices, &Symbol::other_letters}) {
      CHECK_FALSE(has(symbol.*column, symbol.name));
      for (const std::string& name : symbol.*column) {
        CAPTURE(name);
        const Symbol * other = symbol_table().find(term_of(symbol, name));
        REQUIRE(other != nullptr);
        CHECK(has(symbol.*column, name));
        CHECK(has(other->*column, symbol.name));
      }
    }
  }
  CHECK(symbol_table().find(H1(t))->other_indices == std::vector<std::string>{"H2", "H3"});
  CHECK(symbol_table().find(ZB)->other_letters == std::vector<std::string>{"Z0", "ZC"});
  CHECK(symbol_table().find(Entries{"Gamma"}(1, 1))->other_indices.size() == 6);
  CHECK(symbol_table().find(Entries{"h"}(1, 1))->other_indices.size() == 8);
}

TEST_CASE("what a symbol stands for and what it is the rate of have its shape") {
  for (const Symbol& symbol : symbol_table()) {
    CAPTURE(symbol.name);
    CHECK((!symbol.value || symbol.value->shape() == symbol.shape));
    CHECK((symbol.rate_of.empty() || symbol_table().find(term_of(symbol, symbol.rate_of)) != nullptr));
    CHECK((!symbol.is_duration || symbol.shape.is_scalar()));
  }
  CHECK(text(*symbol_table().find(xi2)->value) == "ZbarB - FB + E*(Zbar0 - F0)");
  CHECK(symbol_table().find(zdot0)->rate_of == "z0");
}

TEST_CASE("the claims that define symbols are claims, and terms know which define what they speak of") {
  const std::vector<proofs::methods::Claim> paper = proofs::pascal2012::paper().claims;
  for (const Symbol& symbol : symbol_table()) {
    for (const std::string& id : {symbol.defined_in, symbol.formula_in}) {
      CAPTURE(symbol.name);
      CHECK((id.empty() ||
             std::any_of(paper.begin(), paper.end(), [&](const auto& claim) { return claim.id == id; })));
    }
  }
  CHECK(definitions_in(H1(t) * d0 + t * Q) == std::set<std::string>{"38"});
  CHECK(definitions_in(Gamma(t) * Z0 - F0) == std::set<std::string>{"10.Gamma", "5.F"});
  CHECK(definitions_in(Entries{"Htilde"}(1, 3) * scalar("phiB")) == std::set<std::string>{"51.phi", "6.H"});
}

TEST_CASE("every name is set as one letter with accents and an index, but for a few words") {
  std::set<std::string> upright;
  for (const Symbol& symbol : symbol_table()) {
    if (symbolic::typeset::latex_name(symbol.name).starts_with("\\mathrm")) {
      upright.insert(symbol.name);
    }
  }
  CHECK(upright == std::set<std::string>{"abs", "cos", "exp", "sign", "sin", "sqrt", "tan"});
}

TEST_CASE("no symbol stands twice in a table, and other terms have no row") {
  CHECK_THROWS_AS(Symbols({{.name = "tau"}, {.name = "tau"}}), InternalError);
  CHECK_NOTHROW(Symbols({{.name = "delta"}, {.name = "delta", .of_time = true}}));
  CHECK(symbol_table().find(tau + tau1) == nullptr);
  CHECK(symbol_table().find(scalar("H1")) == nullptr);
}
