#include "proofs/checks/with_unknowns.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "proofs/checks/premises.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/sample.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::checks {
namespace {

using namespace symbols;
using namespace symbols::vocabulary;

// Numbers that have nothing to do with each other.
Ball free_value(const std::string& name) {
  if (name == "pi") {
    return Ball::pi();
  }
  long sum = 7;
  for (const char c : name) {
    sum = (31 * sum + c) % 1009;
  }
  return Ball(Rational(sum + 3, 500));
}

std::size_t place_of(const std::string& name) {
  return static_cast<std::size_t>(std::find(solved_for().begin(), solved_for().end(), name) -
                                  solved_for().begin());
}

Value<WithUnknowns> value_of(const Term& term, const Premises& premises = {}) {
  Sample<WithUnknowns> sample(premises.values, [](const std::string& name) {
    const std::size_t place = place_of(name);
    return place < solved_for().size() ? WithUnknowns::unknown(place) : WithUnknowns(free_value(name));
  });
  return evaluate<WithUnknowns>(term, sample.lookup());
}

TEST_CASE("what is linear in unknowns has their values by its constant and its slopes") {
  Premises premises;
  premises.values.emplace("tau1", tau + 2 * z10);
  const auto unknown = [](std::size_t place) { return Ball(Rational(static_cast<long>(place) + 1, 7)); };
  const Lookup<Ball> there = [&](const std::string& name) {
    const std::size_t place = place_of(name);
    return place < solved_for().size() ? unknown(place) : free_value(name);
  };
  for (const Term& term :
       {H(tau) * Z0 + F0 - H(tau) * F0, ZB - Z0 + delta0, -(E * (Z0 - F0)) / (1 + chi), (V - zdot10) * chi,
        component(1, H(omega * tau) * (ZB + delta0)), scalar("tau1") * omega, us / chi + d01 * eta,
        block(2, {z10, tau, 3, V - us}), derivative(cos(t) * Z0 + t * ZB), inverse(K) * z0, 0 * z10 + pi(),
        determinant(block(2, {omega, z1B, 2, chi}))}) {
    CAPTURE(text(term));
    const Value<Ball> sum = value_of(term, premises).unaryExpr([&](const WithUnknowns& entry) {
      Ball total = entry.at_zero;
      for (const auto& [place, value] : entry.at_one) {
        total += (value - entry.at_zero) * unknown(place);
      }
      return total;
    });
    Sample<Ball> sample(premises.values, there);
    const Value<Ball> expected = evaluate<Ball>(term, sample.lookup());
    REQUIRE(sum.rows() == expected.rows());
    REQUIRE(sum.cols() == expected.cols());
    for (Eigen::Index i = 0; i < sum.size(); ++i) {
      CHECK(sum.data()[i].overlaps(expected.data()[i]));
      CHECK((sum.data()[i].radius() * Ball(1L << 40) - Ball(1)).is_negative());
    }
  }
}

TEST_CASE("what has no unknown is the same everywhere, and a product of two is told where one of them is 1") {
  const Value<WithUnknowns> flown = value_of(H(tau) * F0);
  for (const WithUnknowns& entry : flown.reshaped()) {
    CHECK(entry.at_one.empty());
  }
  CHECK(value_of(delta0)(0, 0).at_one.size() == 1);  // us
  const WithUnknowns product = value_of((z10 + 2) * (z10 + 3))(0, 0);
  CHECK(product.at_zero.overlaps(Ball(6)));
  CHECK(product.at_one.at(place_of("z10")).overlaps(Ball(12)));
  CHECK_THROWS_AS((void)value_of(Z(tau)), NoValue);
}

}  // namespace
}  // namespace stickslip::proofs::checks
