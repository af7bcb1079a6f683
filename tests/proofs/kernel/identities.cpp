// What must be provable.
#include <algorithm>

#include "tests/proofs/kernel/refuses.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::paper;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

namespace {

const Formula modes_differ = differ(Term(lambda1) - lambda2, 0);

// 0 < omega1 < 1 < omega2.
Domain frequencies() {
  return {above(0, omega1), below(omega1, 1), above(1, omega2)};
}

Formulas hypotheses_of(const Domain& domain) {
  Formulas all;
  for (const Theorem& theorem : domain) {
    all.insert(theorem.hypotheses().begin(), theorem.hypotheses().end());
  }
  return all;
}

bool is_part(const Formulas& some, const Formulas& all) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

Domain with(Domain domain, const Theorem& more) {
  domain.push_back(more);
  return domain;
}

const Variable K{"K", {Sort::real, 2, 2}};

// [[0, I], [-K, 0]]
Term first_order() {
  std::vector<Term> entries;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      entries.push_back(i < 2 ? Term(j == i + 2 ? 1 : 0) : j < 2 ? -entry(K, i - 2, j) : Term(0));
    }
  }
  return matrix(4, 4, entries);
}

}  // namespace

TEST_CASE("(40) holds where lambda1 and lambda2 differ and no frequency is zero") {
  const Theorem theorem =
      by_normal_form(equal(H1(t) * H1(t) - identity(2), H2(t) * H3(t)), {H1_of, H2_of, H3_of}, frequencies());
  CHECK(theorem.hypotheses().size() == 3);
  CHECK(theorem.hypotheses().contains(modes_differ));
}

TEST_CASE("H is a group, and so is Gamma") {
  const Domain domain = with(frequencies(), Theorem::assume(modes_differ));
  const Theorem theorem = by_normal_form(equal(H(Term(t) + s), H(t) * H(s)), {H_of}, domain);
  CHECK(is_part(theorem.hypotheses(), hypotheses_of(domain)));
  const auto Gamma = [](const Term& time) { return Gamma_of({time, chi}); };
  const Theorem stick = by_normal_form(equal(Gamma(Term(t) + s), Gamma(t) * Gamma(s)), {Gamma_of});
  CHECK(stick.hypotheses().empty());
}

TEST_CASE("(59), (58) from it, and arguments equal by normal form are one") {
  const Domain domain = with(frequencies(), Theorem::assume(modes_differ));
  const Theorem theorem =
      by_normal_form(equal((H(t) * E - identity(4)) * (H(t) + E), zero(real_matrix(4, 4))), {H_of}, domain);
  CHECK(is_part(theorem.hypotheses(), hypotheses_of(domain)));
  CHECK(Theorem::combination(equal(H(Term(t) + s - t), H(s))).hypotheses().empty());
  CHECK(Theorem::combination(equal(cos(2 * t), 2 * power(cos(t), 2) - 1)).hypotheses().empty());
  CHECK(Theorem::combination(equal(sin(Term(t) + pi()), -sin(t))).hypotheses().empty());
  CHECK(Theorem::combination(equal(cos(pi() / omega * omega), -1)).hypotheses() ==
        Formulas{differ(omega, 0)});
}

TEST_CASE("(5) follows from the equation of motion on any [a, b], for any modes and response to the load") {
  const Variable Z{"Z", function_of_time(4)}, a{"a"}, b{"b"};
  const Term psi = Term(omega) * t + phi;
  const Term Z_t = apply(Z, t);
  const Formula rate =
      for_all(t, implies(between(a, t, b),
                         derivative(Z, t, first_order() * Z_t + matrix(4, 1, {0, 0, 0, p}) * cos(psi))));
  const Motion motion{Theorem::assume(continuous(Z, a, b)), Theorem::assume(rate)};
  // (39) and (7): K Lambda = Lambda Omega², (K - omega² I) Q = (0, p).
  const Term Lambda = matrix(2, 2, {1, 1, lambda1, lambda2});
  const Theorem modes =
      Theorem::assume(equal(K * Lambda, Lambda * matrix(2, 2, {power(omega1, 2), 0, 0, power(omega2, 2)})));
  const Theorem response =
      Theorem::assume(equal((Term(K) - power(omega, 2) * identity(2)) * Q, matrix(2, 1, {0, p})));
  const Term upper = matrix(2, 4, {1, 0, 0, 0, 0, 1, 0, 0}), lower = matrix(4, 2, {0, 0, 0, 0, 1, 0, 0, 1});
  const Term back = H(Term(a) - t) * lower;
  const std::vector<Multiple> because{{modes, -back, inverse(Lambda) * upper * (Z_t - F(t))},
                                      {response, -back, cos(psi)}};
  const Domain domain = with(frequencies(), Theorem::assume(modes_differ));
  const Theorem theorem =
      by_differential_equation(motion, Z, lambda(t, H(t)), lambda(t, F(t)), t, because, {H_of, F_of}, domain);
  CHECK(theorem.conclusion() ==
        for_all(t, implies(within(a, t, b), equal(Z_t, H(Term(t) - a) * (apply(Z, a) - F(a)) + F(t)))));
  Formulas expected = hypotheses_of(domain);
  expected.insert({continuous(Z, a, b), rate, modes.conclusion(), response.conclusion()});
  expected.erase(less(omega1, 1));
  CHECK(theorem.hypotheses() == expected);
  // Without the equation of motion, the modes or the response there is no such theorem.
  REFUSES(by_differential_equation(motion, Z, lambda(t, H(t)), lambda(t, F(t)), t, {because[1]}, {H_of, F_of},
                                   domain));
  REFUSES(by_differential_equation(motion, Z, lambda(t, H(t)), lambda(t, F(t)), t, {because[0]}, {H_of, F_of},
                                   domain));
}

TEST_CASE("Slip part of (16): necessary, from (5) at tau and (13)") {
  const Variable Z{"Z", function_of_time(4)};
  const Term z0 = matrix(2, 1, {entry(apply(Z, 0), 0), entry(apply(Z, 0), 1)});
  const Term v0 = matrix(2, 1, {entry(apply(Z, 0), 2), entry(apply(Z, 0), 3)});
  const Theorem slip = Theorem::assume(equal(apply(Z, tau), H(tau) * (apply(Z, 0) - F(0)) + F(tau)));
  const Theorem ends = Theorem::assume(equal(apply(Z, tau), E * apply(Z, 0)));
  const Theorem lag = Theorem::assume(equal(phi, (pi() - Term(omega) * tau) / 2));
  const Term s0 = sin(Term(omega) * tau / 2), c0 = cos(Term(omega) * tau / 2);
  const Formula claim =
      equal((H1(tau) + identity(2)) * (z0 - Q * s0) + H2(tau) * (v0 + Q * (Term(omega) * c0)),
            zero(real_matrix(2, 1)));
  // With phi replaced, the upper rows of (5) - (13).
  const Term upper = matrix(2, 4, {1, 0, 0, 0, 0, 1, 0, 0});
  const Theorem theorem = by_combination(
      claim, {{by_rewriting(ends, Theorem::reflexive(0)), upper}, {by_rewriting(slip, lag), -upper}},
      {H_of, H1_of, H2_of, F_of}, with(frequencies(), Theorem::assume(modes_differ)));
  CHECK(theorem.hypotheses().contains(ends.conclusion()));
  CHECK(theorem.hypotheses().contains(slip.conclusion()));
  CHECK(theorem.hypotheses().contains(lag.conclusion()));
  CHECK_FALSE(theorem.hypotheses().contains(differ(omega, 0)));
}

TEST_CASE("33.V needs 1 - omega = 0 excluded, and says so") {
  // (1 - omega)(1 + omega) V = 0 as the rows of (33) give it; V = 0 divides.
  const Theorem premise = Theorem::assume(equal((1 - power(omega, 2)) * V, 0));
  const Theorem theorem =
      by_combination(equal(V, 0), {{premise, 1 / (1 - power(omega, 2))}}, {}, {above(0, omega)});
  CHECK(theorem.hypotheses().contains(differ(Term(omega) - 1, 0)));
  CHECK(theorem.hypotheses().contains(less(0, omega)));
  CHECK(theorem.hypotheses().size() == 3);
}

TEST_CASE("The mean value theorem on [a, b], with a < b") {
  const Variable a{"a"}, b{"b"};
  const Theorem rate = Theorem::differentiate(lambda(t, sin(t)), t);
  const Theorem everywhere = for_every(t, between(a, t, b), rate);
  const Theorem smooth = Theorem::continuity(lambda(t, sin(t)), a, b);
  const Theorem theorem = Theorem::mean_value(smooth, everywhere, Theorem::assume(less(a, b)));
  CHECK(theorem.hypotheses() == Formulas{less(a, b)});
  const Variable c{"c"};
  const Formula inside = opened(theorem.conclusion(), c);
  CHECK(inside.parts()[0] == between(a, c, b));
  CHECK(inside.parts()[1].parts()[0] == sin(b) - sin(a));
}

TEST_CASE("A5.cos needs 25.slip: what is divided by is a hypothesis that 25.slip gives") {
  const Variable zB{"z2B"}, z0{"z20"}, cB{"cosB"}, c0{"cos0"}, q2{"q2"};
  // (z2B - z20)(cosB + cos0) = 0, and 25.slip: z2B < z20.
  const Theorem premise = Theorem::assume(equal((Term(zB) - z0) * (Term(cB) + c0), 0));
  const Theorem bare = Theorem::combination(equal(cB, -c0), {{premise, 1 / (Term(zB) - z0)}});
  CHECK(bare.hypotheses().contains(differ(Term(zB) - z0, 0)));
  const Theorem slip = Theorem::assume(less(zB, z0));
  const Theorem below_zero = Theorem::order(less(Term(zB) - z0, 0), {{{slip}}});
  const Theorem theorem = Theorem::cut(different(below_zero), bare);
  CHECK(theorem.hypotheses() == Formulas{premise.conclusion(), slip.conclusion()});
}

TEST_CASE("(70), one mode: the sum of two cotangents") {
  const Variable w{"w"}, alpha{"alpha"}, beta{"beta"};
  const Theorem theorem =
      Theorem::combination(equal(Term(w) * (cos(alpha) / sin(alpha) + cos(beta) / sin(beta)),
                                 Term(w) * sin(Term(alpha) + beta) / (sin(alpha) * sin(beta))));
  CHECK(theorem.hypotheses() ==
        Formulas{differ(sin(alpha), 0), differ(sin(beta), 0), differ(sin(alpha) * sin(beta), 0)});
  CHECK(nonzero(theorem, {}).hypotheses() == Formulas{differ(sin(alpha), 0), differ(sin(beta), 0)});
}

TEST_CASE("(67) with its range: sin tau = 0 inside (0, 2 pi) gives pi") {
  const Theorem equation = Theorem::assume(equal(sin(tau), 0));
  const Theorem lower = Theorem::assume(less(Term(0) * pi(), tau));
  const Theorem upper = Theorem::assume(less(tau, Term(2) * pi()));
  const Theorem theorem = Theorem::zeros_between(equation, lower, upper);
  CHECK(theorem.conclusion() == any({equal(tau, Term(1) * pi())}));
  CHECK(theorem.hypotheses().size() == 3);
}

TEST_CASE("Signs, a zero, and a stable polynomial, in balls") {
  CHECK(Theorem::sign(less(sin(Term(1)), cos(Term(1)) + 1)).hypotheses().empty());
  CHECK(Theorem::sign(differ(cos(Term(1)), 0)).hypotheses().empty());
  const Theorem on_box = Theorem::sign(less(0, cos(t)), {{t, {0, Rational(3, 2)}}});
  CHECK(on_box.hypotheses() == Formulas{at_most(0, t), at_most(t, Rational(3, 2))});
  const Variable X{"X", {Sort::real, 2, 1}}, x{"x"};
  const Term x0 = entry(X, 0), x1 = entry(X, 1);
  const Theorem circle = Theorem::one_zero(X, matrix(2, 1, {power(x0, 2) + power(x1, 2) - 1, x0 - x1}),
                                           {{Rational(1, 2), 1}, {Rational(1, 2), 1}});
  CHECK(circle.hypotheses().empty());
  const Theorem root = Theorem::one_zero(x, sin(x), {{3, Rational(33, 10)}});
  CHECK(root.conclusion().parts().size() == 2);
  CHECK(Theorem::jury(matrix(3, 1, {Rational(1, 4), Rational(-1, 2), 1})).hypotheses().empty());
}

TEST_CASE("Inequalities: squares, products, and strictness") {
  const Theorem square = Theorem::order(at_most(0, power(t, 2)), {{{}, 1, t}});
  CHECK(square.hypotheses().empty());
  const Theorem sine = Theorem::order(at_most(power(sin(t), 2), 1), {{{}, 1, cos(t)}});
  CHECK(sine.hypotheses().empty());
  const Theorem product =
      Theorem::order(less(0, Term(t) * s), {{{Theorem::assume(less(0, t)), Theorem::assume(less(0, s))}}});
  CHECK(product.hypotheses().size() == 2);
}
