#include <algorithm>

#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

// The number m of a bound that is written m*pi.
Rational multiple_of_pi(const Term& bound) {
  require(
      bound.kind() == Kind::product && bound.parts()[0].kind() == Kind::number && bound.parts()[1] == pi(),
      "a bound is written as a number times pi");
  return bound.parts()[0].value();
}

}  // namespace

Theorem Theorem::zeros_between(const Theorem& equation, const Theorem& lower, const Theorem& upper) {
  const auto [function, value] = sides(equation, Kind::equal);
  require((function.kind() == Kind::sine || function.kind() == Kind::cosine) && value == Term(0),
          "the equation is sin x = 0 or cos x = 0");
  const Term& x = function.parts()[0];
  const auto [from, above] = sides(lower, Kind::less);
  const auto [below, to] = sides(upper, Kind::less);
  require(above == x && below == x, "the bounds are of another number");
  const Rational offset = function.kind() == Kind::sine ? Rational(0) : Rational(1, 2);
  const Rational first = multiple_of_pi(from), last = multiple_of_pi(to);
  require(last - first <= 1000, "more than 1000 zeros lie between the bounds");
  mpz_class k;  // the largest with k + offset <= first
  const Rational start = first - offset;
  mpz_fdiv_q(k.get_mpz_t(), start.get_num_mpz_t(), start.get_den_mpz_t());
  std::vector<Formula> cases;
  for (Rational zero = k + 1 + offset; zero < last; zero += 1) {
    cases.push_back(equal(x, Term(zero) * pi()));
  }
  return {{.rule = "zeros_between", .premises = {equation, lower, upper}},
          hypotheses_of({equation, lower, upper}),
          any(cases)};
}

Theorem Theorem::sine_is_positive(const Term& x) {
  return {{.rule = "sine_is_positive", .data = {x}}, {}, implies(between(0, x, pi()), less(0, sin(x)))};
}

}  // namespace stickslip::proofs::kernel
