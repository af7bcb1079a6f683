#include "proofs/methods/rewrite.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/letters.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

const Scalars in_lowest_terms = [](const Term& number) {
  Reader read;
  return proofs::tactics::quotient(read(number), 1);
};

proofs::methods::Polynomial poly(const Term& term) {
  return polynomial(term, in_lowest_terms);
}
proofs::methods::Polynomial rest(const Statement& statement) {
  return residual(statement, in_lowest_terms);
}

Rule rule(const Statement& premise, const Term& lead) {
  const auto solved = solve(rest(premise), poly(lead), {});
  REQUIRE(solved.has_value());
  return *solved;
}

}  // namespace

TEST_CASE("matrices do not commute, scalars do, I is one") {
  CHECK(poly(H1(t) * H2(t) - H2(t) * H1(t)).size() == 2);
  CHECK(poly(chi * H1(t) * eta - eta * chi * H1(t)).empty());
  CHECK(poly(I2 * H1(t) * I2 - H1(t)).empty());
  CHECK(poly(power(H1(t) - I2, 2) - H1(t) * H1(t) + 2 * H1(t) - I2).empty());
  CHECK(poly((H1(t) / 2 + H1(t) / 2) * d0 - H1(t) * d0).empty());
}

TEST_CASE("arguments are the same letter when they are the same time") {
  CHECK(poly(H(t + s) - H(s + t)).empty());
  CHECK(poly(H(t - t) - H(0)).empty());
  CHECK_FALSE(poly(H(t) - H(-t)).empty());
}

TEST_CASE("a premise is used from the left, and the trace says which and where") {
  const std::vector<Rule> rules{rule(equation(E * E, I4), E * E),
                                rule(equation(H(-t) * E, E * H(t)), H(-t) * E)};
  const Rewritten rewritten = rewrite(rest(equation(E * H(-t) * E, H(t))), rules);
  CHECK(rewritten.rest.empty());
  REQUIRE(rewritten.trace.size() == 2);
  CHECK(rewritten.trace[0].rule == 1);
  CHECK(rewritten.trace[0].before == Word{"E"});
  CHECK(rewritten.trace[1].rule == 0);
  const Rewritten squared = rewrite(rest(equation(E * E * E, E)), rules);
  REQUIRE(squared.trace.size() == 1);
  CHECK(squared.trace[0].rule == 0);
  CHECK(squared.trace[0].after == Word{"E"});
}

TEST_CASE("without its premise nothing follows") {
  CHECK_FALSE(rewrite(rest(equation(E * H(-t) * E, H(t))), {rule(equation(E * E, I4), E * E)}).rest.empty());
}

TEST_CASE("a premise is solved for what is asked, with its factor") {
  const Rule solved = rule(equation(2 * H(tau) * Z0 + F0, Z0), H(tau) * Z0);
  CHECK(rewrite(rest(equation(H(tau) * Z0, (Z0 - F0) / 2)), {solved}).rest.empty());
  CHECK_FALSE(solve(rest(equation(E * Z0, F0)), poly(H(t) * Z0), {}).has_value());
  CHECK_FALSE(solve(rest(equation(chi * E * Z0, F0)), poly(E * Z0), {}).has_value());  // chi might be zero
  CHECK_THROWS_AS((void)solve(rest(equation(E, H(t))), poly(E + H(t)), {}), InternalError);
}

TEST_CASE("rules that feed themselves are noticed") {
  CHECK_THROWS_AS((void)rewrite(poly(E * Z0), {rule(equation(E * Z0, H(t) * E * Z0), E * Z0)}),
                  proofs::kernel::KernelError);
}
