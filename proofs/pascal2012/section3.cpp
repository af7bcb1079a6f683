// Section 3: the closed-form phases, (5)-(10). A phase begins at t = 0.
#include "proofs/methods/derivations.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;
using namespace symbolic::algebra;

namespace {

using namespace symbols::vocabulary;
using namespace half_period;

const Term x1 = scalar("x1"), x2 = scalar("x2"), pull = chi * (x2 - x1) - p / eta * cos(omega * t + phi);
const Assumption below{"4.below", {pull, ur, Relation::less}},
    above{"4.above", {pull, -ur, Relation::greater}}, holds{"4.ur", {eta * ur, 0, Relation::greater}};

}  // namespace

std::vector<Claim> section3() {
  const Term slip = H(t) * (Z0 - F0) + F(t);
  const Assumption from_0 = not_before(t, 0), to_tau = not_after(t, tau);
  return {
      {.id = "5.F",
       .kind = Kind::definition,
       .printed = {equation(F(t), column({R(t), derivative(R(t))})), equation(R(t), Q * cos(omega * t + phi)),
                   equation(F0, F(0))},
       .words = "the forced response $F = (R, R')$ with $R(t) = Q cos(omega t + phi)$",
       .prove = by_normal_form()},
      {.id = "5",
       .kind = Kind::step,
       .printed = {equation(Z(t), slip)},
       .words = "slip with $x2' < V$, $u = u_s$: the motion that starts at $Z_0$",
       .assumptions = {slips_below, begins, from_0, to_tau},
       .prove = by_differential_equation({"2.slip", "6.Z0", H, F(t)})},
      {.id = "6.H",
       .kind = Kind::definition,
       .printed = {equation(H(t), block(2, {H1(t), H2(t), H3(t), H1(t)}))},
       .words = "$H(t)$ is the flow of $x'' + K x = 0$: the exponential of its first-order system",
       .prove = by_derivation(
           "$H(t)$ equals the matrix exponential, found from the resolvent of the first-order system",
           [] {
             return std::vector<Derived>{{slip_exponential(), H(t)}};
           }),
       .parts = {"$H(t)$ is made of the blocks of (38); that it is the flow is what 38.ode and (5) say"}},
      {.id = "6.d0",
       .kind = Kind::definition,
       .printed = {equation(d01, us / (1 - chi)), equation(d02, d01 / chi)},
       .words = "$d_0$ is the equilibrium under the friction $+u_s$: $K d_0 = (0, eta u_s)$",
       .prove = by_normal_form({equation(K * d0, column({0, eta * us}))})},
      {.id = "7",
       .kind = Kind::step,
       .printed = {equation(
                       q1, chi * p /
                               ((power(omega, 2) - power(omega1, 2)) * (power(omega, 2) - power(omega2, 2)))),
                   equation(q2, q1 * (1 - power(omega, 2)) / chi)},
       .words = "$Q$ is the amplitude of the forced response: $(K - omega^2 I) Q = (0, p)$",
       .prove = by_derivation("the linear system $(K - omega^2 I) Q = (0, p)$ solved by elimination",
                              [] {
                                return std::vector<Derived>{{forced_amplitudes(), Q}};
                              })},
      {.id = "7.resonance",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(block(1, {eta, lambda1}) * (K - power(omega1, 2) * I2), zero(1, 2)),
                   equation(block(1, {eta, lambda1}) * column({0, p}), lambda1 * p),
                   equation(block(1, {eta, lambda2}) * (K - power(omega2, 2) * I2), zero(1, 2)),
                   equation(block(1, {eta, lambda2}) * column({0, p}), lambda2 * p)},
       .words = "where $omega = omega_j$ there is no $Q$ unless $p = 0$: this row, multiplied from the left, "
                "makes $(K - omega^2 I) Q = (0, p)$ say $0 = lambda_j p$",
       .prove = by_normal_form(),
       .parts = {"the row $(eta, lambda_1)$ times $K - omega_1^2 I$ is zero",
                 "the row $(eta, lambda_1)$ times $(0, p)$ is $lambda_1 p$",
                 "the row $(eta, lambda_2)$ times $K - omega_2^2 I$ is zero",
                 "the row $(eta, lambda_2)$ times $(0, p)$ is $lambda_2 p$"}},
      {.id = "8.L",
       .kind = Kind::definition,
       .printed = {equation(L(t), column({H1(t) - I2, H3(t)}))},
       .words = "$L(t) d_0$ is what $H(t)$ adds to the constant $(d_0, 0)$",
       .prove = by_normal_form({equation(L(t) * d0, (H(t) - I4) * column({d0, zero(2, 1)}))}),
       .parts = {"$L(t)$ is $H_1(t) - I$ above $H_3(t)$"}},
      {.id = "8",
       .kind = Kind::step,
       .printed = {equation(Z(t), slip + 2 * L(t) * d0)},
       .words = "slip with $x2' > V$, $u = -u_s$ (overshooting): the motion that starts at $Z_0$",
       .assumptions = {slips_above_belt(0, tau), begins, from_0, to_tau},
       .prove = by_differential_equation({"2.overshoot", "6.Z0", H, F(t) - 2 * delta0})},
      {.id = "9", .kind = Kind::model, .words = "stick, $x2' = V$: $x1'' + x1 - chi x2 = 0$, $x2'' = 0$"},
      {.id = "9.z",
       .kind = Kind::step,
       .printed = {equation(d01 - chi * d02, 0)},
       .words = "(9) keeps its form for $z = x - d_0$",
       .prove = by_normal_form()},
      {.id = "10.Gamma",
       .kind = Kind::definition,
       .printed = {equation(Gamma(t), block(2, {Gamma1(t), Gamma2(t), Gamma3(t), Gamma1(t)}))},
       .words = "$Gamma(t)$ is the flow of (9): the exponential of its first-order system",
       .prove = by_derivation(
           "$Gamma(t)$ equals the matrix exponential, found from the resolvent of the first-order system",
           [] {
             return std::vector<Derived>{{stick_exponential(), Gamma(t)}};
           }),
       .parts = {"$Gamma(t)$ is made of the blocks of (41); that it is the flow is what 41.ode and (10) "
                 "say"}},
      {.id = "10",
       .kind = Kind::step,
       .printed = {equation(Z(t), Gamma(t) * Z0)},
       .words = "stick: the motion that starts at $Z_0$",
       .assumptions = {sticks(0, tau), begins, from_0, to_tau},
       .prove = by_differential_equation({"9.stick", "6.Z0", Gamma, zero(4, 1)})},
      {.id = "10.belt",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(block(1, {0, 0, 0, 1}) * Gamma(t) * Z0, zdot20)},
       .words = "during stick the velocity of the second mass stays that of the belt",
       .prove = by_normal_form()},
      {.id = "11",
       .kind = Kind::condition,
       .printed = {{abs(chi * eta * (x2 - x1) - p * cos(omega * t + phi)), eta * ur, Relation::less}},
       .words = "the stick lasts while $|r| < u_r$ of (4)",
       .assumptions = {below, above, holds},
       .prove = by_positive_combination(
           {{.positive = {{power(eta, 2), {{assuming("4.below")}, {assuming("4.above")}}}}}},
           assuming("4.ur"))},
  };
}

}  // namespace stickslip::proofs::pascal2012
