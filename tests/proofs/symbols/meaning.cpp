#include "proofs/symbols/meaning.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "proofs/symbols/point.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "symbolic/algebra/decide.hpp"

using namespace stickslip;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;
using GiNaC::ex;

namespace {

const std::vector<Coordinate> point{
    {"omega1", Rational(3, 5)}, {"omega2", Rational(11, 5)}, {"t", Rational(7, 10)},
    {"s", Rational(2, 5)},      {"tau", Rational(9, 5)},     {"omega", Rational(4, 5)},
    {"phi", Rational(1, 5)},    {"us", Rational(1, 10)},     {"p", Rational(3, 10)},
    {"z10", Rational(1)},       {"z20", Rational(2)},        {"zdot10", Rational(1, 3)},
    {"zdot20", Rational(1, 7)}};

// The same term by both engines: GiNaC and then balls, and the model's templates over balls (and jets)
// directly.
void both_engines_agree(const Term& term) {
  CAPTURE(text(term));
  const Value<Ball> direct = evaluate<Ball>(term, at_point(point));
  const Value<ex> symbolic_value = evaluate<ex>(term, symbolically());
  REQUIRE(direct.rows() == symbolic_value.rows());
  for (Eigen::Index i = 0; i < direct.size(); ++i) {
    const ex entry = symbolic_value(i);
    const Ball other =
        symbolic::algebra::evaluate(entry, values_at(point, symbolic::algebra::symbols_of(entry)));
    CHECK(direct(i).is_finite());
    CHECK(direct(i).overlaps(other));
    CHECK((direct(i) - other).radius().approximate() < 1e-25);
  }
}

}  // namespace

TEST_CASE("every symbol of the vocabulary means the same to both engines") {
  for (const Term& term : {H(t),
                           H1(t),
                           H2(t),
                           H3(t),
                           B1(t),
                           B2(t),
                           B3(t),
                           Gamma(t),
                           Gamma1(t),
                           Gamma2(t),
                           Gamma3(t),
                           gamma1(t),
                           gamma2(t),
                           gamma3(t),
                           F(t),
                           R(t),
                           L(t),
                           E,
                           I2,
                           I4,
                           K,
                           Lambda,
                           Sigma,
                           d0,
                           Q,
                           psi1,
                           psi2,
                           F0,
                           Z0,
                           chi,
                           eta,
                           lambda1,
                           lambda2,
                           cos(omega * t),
                           sin(omega * t),
                           tan(omega * t),
                           pi()}) {
    both_engines_agree(term);
  }
}

TEST_CASE("every operation means the same to both engines") {
  for (const Term& term :
       {H(t) * (Z0 - F0) + F(t) + 2 * L(t) * d0, derivative(F(t)), derivative(derivative(H(t) * Z0)),
        determinant(H(t)), inverse(H2(t)) * H1(t), power(H1(t - s), 3), -H1(t) / omega,
        derivative(sin(omega * t) * t), block(2, {H1(t), zero(2, 2), H2(t), I2}), derivative(B2(2 * t))}) {
    both_engines_agree(term);
  }
}

TEST_CASE("a motion has no meaning by itself, and no third derivative is taken by jets") {
  CHECK_THROWS_AS((void)evaluate<ex>(Z(t), symbolically()), InternalError);
  CHECK_THROWS_AS((void)evaluate<Ball>(derivative(derivative(derivative(sin(t)))), at_point(point)),
                  InternalError);
}

TEST_CASE("terms know which claims define what they speak of") {
  CHECK(definitions_in(H1(t) * d0 + t * Q) == std::set<std::string>{"38"});
  CHECK(definitions_in(Gamma(t) * Z0 - F0) == std::set<std::string>{"10.Gamma", "5.F"});
}
