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

Theorem Theorem::zeros_of_sine(const Term& x) {
  const Variable k = fresh(integer_number, {x});
  return {{.rule = "zeros_of_sine", .data = {x}},
          {},
          implies(equal(sin(x), 0), exists(k, equal(x, Term(k) * pi())))};
}

Theorem Theorem::sine_is_positive(const Term& x) {
  return {{.rule = "sine_is_positive", .data = {x}}, {}, implies(between(0, x, pi()), less(0, sin(x)))};
}

Theorem Theorem::integer_gap(const Term& m, const Term& n) {
  require(m.type() == integer_number && n.type() == integer_number, "only integers have gaps");
  return {{.rule = "integer_gap", .data = {m, n}}, {}, any({at_most(m, n), at_most(n + 1, m)})};
}

Theorem Theorem::induction(const Formula& claim, const Theorem& start, const Theorem& step) {
  require(claim.kind() == Kind::for_all && claim.binds() == integer_number, "induction is over the integers");
  const Variable k = fresh(integer_number, {claim});
  const Formula here = opened(claim, k);
  const auto leads_to = [&](const Term& next) { return implies(here, opened(claim, next)); };
  require(start.conclusion() == opened(claim, 0), "the induction does not start at 0");
  require(step.conclusion() == for_all(k, all({leads_to(Term(k) + 1), leads_to(Term(k) - 1)})),
          "the induction does not step up and down");
  return {
      {.rule = "induction", .premises = {start, step}, .data = {claim}}, hypotheses_of({start, step}), claim};
}

}  // namespace stickslip::proofs::kernel
