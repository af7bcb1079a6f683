// Appendix 5: two transitions per period, V = 0, tau not assumed to be Theta/2, (55)-(70).
#include "proofs/pascal2012/appendix5.hpp"

#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace two_slips;

const Assumption from_0 = not_before(t, 0), to_tau = not_after(t, tau);

// (55)-(57): the motion in z and z + 2 d_0, and xi_1, xi_2.
std::vector<Claim> motion() {
  return {
      {.id = "55.bar",
       .kind = Kind::definition,
       .printed = {equation(Zbar(t), Z(t) + 2 * delta0), equation(Zbar0, Z0 + 2 * delta0),
                   equation(ZbarB, ZB + 2 * delta0), equation(zbar0, z0 + 2 * d0),
                   equation(zbarB, zB + 2 * d0)},
       .words = "the state seen from the place of rest under the friction $-u_s$",
       .prove = by_definition()},
      {.id = "55.B",
       .kind = Kind::step,
       .printed = {equation(Zbar(tau), ZbarB), equation(Zbar(0), Zbar0)},
       .words = "its values at $tau$ and at 0",
       .assumptions = {begins, named_B},
       .prove = by_rewriting({from("55.bar").at("t", tau).solved_for(Zbar(tau)),
                              from("55.bar").at("t", 0).solved_for(Zbar(0)), from("55.bar").solved_for(ZbarB),
                              from("55.bar").solved_for(Zbar0), assuming("28.ZB"), assuming("6.Z0")})},
      {.id = "55",
       .kind = Kind::step,
       .printed = {equation(Zbar(t), H(t - tau) * (ZbarB - FB) + F(t))},
       .words = "the overshooting slip, $tau < t < Theta$",
       .assumptions = {overshoots, named_B, not_before(t, tau), not_after(t, Theta)},
       .prove = by_rewriting({from("55.bar").solved_for(Zbar(t)), from("55.bar").solved_for(ZbarB),
                              from("27"), from("52.L").at("t", t - tau)})},
      {.id = "56.F",
       .kind = Kind::definition,
       .printed = {equation(FB, F(tau))},
       .words = "$F_B$ is the forced response at $tau$",
       .prove = by_normal_form()},
      {.id = "56",
       .kind = Kind::step,
       .printed = {equation(Zbar0, H(tau1) * (ZbarB - FB) + F0)},
       .words = "the motion has the period $Theta$",
       .assumptions = cycle,
       .prove = by_rewriting({from("55.bar").solved_for(Zbar0), from("55.bar").solved_for(ZbarB),
                              assuming("28.closes").solved_for(Z0), from("27").at("t", Theta),
                              from("52.L").at("t", Theta - tau), from("28.Theta")})},
      {.id = "56.B",
       .kind = Kind::step,
       .printed = {equation(ZB, H(tau) * (Z0 - F0) + FB)},
       .words = "the end of the first slip, by (5)",
       .assumptions = {begins, slips_below, slip_takes_time, named_B},
       .prove = by_rewriting(
           {assuming("28.ZB").solved_for(ZB), from("5").at("t", tau), from("56.F").solved_for(FB)})},
      {.id = "57.xi",
       .kind = Kind::definition,
       .printed = {equation(xi1, ZB - FB + E * (Z0 - F0)), equation(xi2, ZbarB - FB + E * (Zbar0 - F0))},
       .words = "$xi_1$ and $xi_2$ measure how far both slips are from symmetry in time",
       .prove = by_definition()},
      {.id = "57",
       .kind = Kind::step,
       .printed = {equation(xi1, (H(tau) + E) * (Z0 - F0)), equation(xi2, (H(-tau1) + E) * (Zbar0 - F0))},
       .words = "$xi_1$ and $xi_2$ from the state at $t = 0$",
       .assumptions = cycle,
       .prove = by_rewriting({from("57.xi"), from("56.B"), from("56"), from("38.inverse").at("t", tau1)})},
  };
}

// (58)-(61): what xi_1 and xi_2 satisfy.
std::vector<Claim> relations() {
  return {
      {.id = "58.inverse",
       .kind = Kind::identity,
       .printed = {equation(inverse(H(t)), H(-t))},
       .words = "the inverse of $H(t)$ is $H(-t)$",
       .prove = by_inverse(from("38.inverse"))},
      {.id = "58",
       .kind = Kind::identity,
       .printed = {equation(H(t) * E, E * inverse(H(t))), equation(E * inverse(H(t)), E * H(-t))},
       .words = "$H(t)E = E H(t)^{-1} = E H(-t)$",
       .prove = by_rewriting({from("58.inverse"), from("38.reversal").at("t", -t)})},
      {.id = "59",
       .kind = Kind::identity,
       .printed = {equation((H(t) * E - I4) * (H(t) + E), zero(4, 4)),
                   equation((H(-t) * E - I4) * (H(-t) + E), zero(4, 4))},
       .words = "$(H(t)E - I)(H(t) + E) = 0$, for $t$ and $-t$",
       .prove = by_rewriting(
           {from("13.E"), from("38.reversal"), from("38.reversal").at("t", -t), from("38.inverse")})},
      {.id = "60",
       .kind = Kind::step,
       .printed = {equation((H(tau) * E - I4) * xi1, zero(4, 1)),
                   equation((H(-tau1) * E - I4) * xi2, zero(4, 1))},
       .words = "(57) and (59)",
       .assumptions = cycle,
       .prove = by_rewriting({from("57"), from("59").at("t", tau).solved_for(H(tau) * E * H(tau)),
                              from("59").at("t", tau1).solved_for(H(-tau1) * E * H(-tau1))})},
      {.id = "61.E",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(E * delta0, -delta0)},
       .words = "$E$ turns the place of rest round",
       .prove = by_normal_form()},
      {.id = "61",
       .kind = Kind::identity,
       .printed = {equation(xi1 - xi2, ZB - ZbarB + E * (Z0 - Zbar0)), equation(xi1 - xi2, zero(4, 1))},
       .words = "$xi_1 = xi_2$: the shift by $2 d_0$ at both ends cancels",
       .prove = by_rewriting({from("57.xi"), from("55.bar").solved_for(Zbar0),
                              from("55.bar").solved_for(ZbarB), from("61.E")})},
  };
}

// (62)-(65): xi_1 = xi_2 = 0 by the route of the paper, through P.
std::vector<Claim> through_P() {
  const Term w = z0 - Q * cos(phi), w_bar = zbar0 - Q * cos(phi), speed = zdot0 + Q * omega * sin(phi);
  return {
      {.id = "62",
       .kind = Kind::step,
       .printed = {equation(X1, (H1(tau) - I2) * w + H2(tau) * speed),
                   equation(Y1, H3(tau) * w + (H1(tau) + I2) * speed),
                   equation(X2, (H1(tau1) - I2) * w_bar - H2(tau1) * speed),
                   equation(Y2, -H3(tau1) * w_bar + (H1(tau1) + I2) * speed)},
       .words = "$xi_1$ and $xi_2$ by blocks",
       .assumptions = cycle,
       .prove = by_combination({{{from("57"), 0, top}},
                                {{from("57"), 0, bottom}},
                                {{from("57"), 1, top}},
                                {{from("57"), 1, bottom}}})},
      {.id = "63.P",
       .kind = Kind::definition,
       .printed = {equation(P1, inverse(H2(tau)) * (H1(tau) + I2)),
                   equation(P2, -inverse(H2(tau1)) * (H1(tau1) + I2))},
       .words = "$P_1$ and $P_2$ need $det H_2 != 0$ at the unknown times $tau$ and $tau_1$",
       .prove = by_normal_form()},
      {.id = "63",
       .kind = Kind::step,
       .printed = {equation(Y1, P1 * X1), equation(Y2, P2 * X2)},
       .words = "the upper rows of (60)",
       .assumptions = cycle,
       .prove = by_combination({{{from("57"), 0, bottom}, {from("57"), 0, -P1 * top}},
                                {{from("57"), 1, bottom}, {from("57"), 1, -P2 * top}}})},
      {.id = "64.P",
       .kind = Kind::definition,
       .printed = {equation(P, P1 - P2)},
       .words = "$P$",
       .prove = by_normal_form()},
      {.id = "61.blocks",
       .kind = Kind::step,
       .printed = {equation(X1, X2), equation(Y1, Y2)},
       .words = "(61) by blocks",
       .prove = by_combination({{{from("61"), 1, top}}, {{from("61"), 1, bottom}}})},
      {.id = "64",
       .kind = Kind::step,
       .printed = {equation(X1, X2), equation(P * X1, zero(2, 1))},
       .words = "(61) and (63)",
       .assumptions = cycle,
       .prove =
           by_rewriting({from("64.P"), from("61.blocks").solved_for(X2), from("61.blocks").solved_for(Y2),
                         from("63").solved_for(P1 * X1), from("63").solved_for(P2 * X1)})},
      {.id = "64.back",
       .kind = Kind::step,
       .printed = {equation(Y2, P2 * X2)},
       .words = "conversely (64) with the first of (63) gives the second",
       .assumptions = {{"63", equation(Y1, P1 * X1)}, {"64", equation(P * X1, zero(2, 1))}},
       .prove = by_combination(
           {{{from("61.blocks"), 1, -1}, {assuming("63")}, {from("61.blocks"), 0, P2}, {assuming("64")}}})},
      {.id = "65",
       .kind = Kind::step,
       .printed = {equation(X1, zero(2, 1)), equation(X2, zero(2, 1)), equation(Y1, zero(2, 1)),
                   equation(Y2, zero(2, 1))},
       .words = "$xi_1 = xi_2 = 0$, if $det P$ is not zero and $P$ exists (63.P); 65.sharp needs neither",
       .assumptions = cycle_and({regular_P}),
       .prove = by_rewriting({from("64").divided_by(P).solved_for(X1), from("64").solved_for(X2),
                              from("63").solved_for(Y1), from("63").solved_for(Y2)})},
  };
}

// (66)-(69): what follows from xi_1 = xi_2 = 0.
std::vector<Claim> symmetry() {
  const Term turned = sin(phi + omega * tau / 2);
  const Assumption first_case{"67.case1", equation(turned, 0)};
  const Assumption second_case{"67.case2", equation(cos(omega * tau / 2), 0)};
  const Assumption turns_over{"67.sin", equation(sin(phiB), -sin(phi))};
  const std::vector<Assumption> moving = cycle_and({off_resonance, starts_with_belt, meets_belt, at_rest});
  return {
      {.id = "66",
       .kind = Kind::step,
       .printed = {equation(zB - Q * cos(phiB), z0 - Q * cos(phi)),
                   equation(zdotB + Q * omega * sin(phiB), -(zdot0 + Q * omega * sin(phi))),
                   equation(zbarB - Q * cos(phiB), zbar0 - Q * cos(phi))},
       .words = "$xi_1 = xi_2 = 0$, $phi_B = omega tau + phi$; the paper names (56) and (64), what is used "
                "are (57) and (65)",
       .assumptions = cycle_and({off_resonance}),
       .prove = by_combination({{{from("57.xi"), 0, -top}, {from("65.sharp"), 0}},
                                {{from("57.xi"), 0, -bottom}, {from("65.sharp"), 1}},
                                {{from("57.xi"), 1, -top}, {from("65.sharp"), 2}}})},
      {.id = "67",
       .kind = Kind::step,
       .printed = {equation(zdotB, -Q * omega * sin(phiB) - (zdot0 + Q * omega * sin(phi)))},
       .words = "the second of (66)",
       .assumptions = cycle_and({off_resonance}),
       .prove = by_combination({{{from("66"), 1}}})},
      {.id = "67.sin",
       .kind = Kind::step,
       .printed = {equation(sin(phiB), -sin(phi))},
       .words = "its second row, as $x2' = V = 0$ at both ends",
       .assumptions = moving,
       .prove = by_combination({{{from("67"), 0, second_row / (q2 * omega)}}})},
      {.id = "67.cases",
       .kind = Kind::identity,
       .printed = {equation(sin(phiB) + sin(phi), 2 * turned * cos(omega * tau / 2)),
                   equation(cos(phiB) - cos(phi), -2 * turned * sin(omega * tau / 2))},
       .words = "two cases, whatever the multiple of $2 pi$: $sin(phi + omega tau/2) = 0$ ($phi = -omega "
                "tau/2 + k pi$, the paper has $k = 0$), or $cos(omega tau/2) = 0$",
       .prove = by_normal_form()},
      {.id = "67.branch",
       .kind = Kind::step,
       .printed = {equation((phi + omega * tau / 2) * cos(omega * tau / 2), 0)},
       .words = "either $phi = -omega tau/2$, or $cos(omega tau/2) = 0$, which is $tau = pi/omega$",
       .assumptions = {turns_over},
       .prove =
           by_counterexample({.point = {{"omega", Rational(1, 2)}, {"tau", Rational(1)}},
                              .values = {equation(phi, pi() - omega * tau / 2)},
                              .true_there = {turns_over.statement},
                              .false_there = {equation((phi + omega * tau / 2) * cos(omega * tau / 2), 0)}}),
       .corrected = {equation(turned * cos(omega * tau / 2), 0)},
       .prove_corrected =
           by_combination({{{from("67.cases"), 0, -Term(1) / 2}, {assuming("67.sin"), 0, Term(1) / 2}}})},
      {.id = "67.first",
       .kind = Kind::step,
       .printed = {equation(zB, z0)},
       .words = "the first case, for every $k$: the slip ends where it began",
       .assumptions = cycle_and({off_resonance, first_case}),
       .prove =
           by_combination({{{from("66"), 0}, {assuming("67.case1"), 0, -2 * sin(omega * tau / 2) * Q}}})},
      {.id = "67.opposite",
       .kind = Kind::step,
       .printed = {equation(zdotB, -zdot0)},
       .words = "and with the opposite velocities",
       .assumptions = cycle_and({off_resonance, first_case}),
       .prove = by_combination(
           {{{from("67")}, {assuming("67.case1"), 0, -2 * omega * cos(omega * tau / 2) * Q}}})},
      {.id = "67.impossible",
       .kind = Kind::step,
       .printed = {{0, 0, Relation::greater}},
       .words = "the first case is impossible: $x2' < 0$ on $(0, tau)$ takes the second mass down",
       .assumptions = cycle_and({off_resonance, first_case, falls}),
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("25.slip")}}}}, .equations = {{from("67.first"), 0, second_row}}}})},
      {.id = "67.second",
       .kind = Kind::step,
       .printed = {equation(tau, pi() / omega)},
       .words = "the second case, $0 < tau < Theta$: $tau = pi/omega = tau_1$, and no other value",
       .assumptions = {period, second_case, slip_takes_time, {"Theta.after", {tau, Theta, Relation::less}}},
       .prove = by_zero_of_cosine({omega * tau / 2, assuming("67.case2"), 0, 1})},
      {.id = "68",
       .kind = Kind::step,
       .printed = {equation(zB + zbarB + 2 * Q * cos(phi), H1(tau) * (z0 + zbar0 - 2 * Q * cos(phi))),
                   equation(xB + Q * cos(phi), H1(tau) * (x0 - Q * cos(phi))),
                   equation(xB + Q * cos(phi), x0 - Q * cos(phi))},
       .words = "both slips together, with $tau = tau_1 = pi/omega$",
       .assumptions = halves_and({}),
       .prove = by_combination({{{from("56.B"), 0, top}, {from("56"), 0, -top * H(-tau1)}},
                                {{from("56.B"), 0, top / 2}, {from("56"), 0, -top * H(-tau1) / 2}},
                                {{from("66"), 0}}})},
      {.id = "69",
       .kind = Kind::theorem,
       .printed = {equation(x0, Q * cos(phi)), equation(xB, -Q * cos(phi)), equation(xB, -x0)},
       .words =
           "the places at both ends, if $det(H_1 - I)$ is not zero, which off resonance it is not (69.det)",
       .assumptions = halves_and({regular_H1}),
       .prove =
           by_combination({{{from("68"), 2, inverse(H1(tau) - I2)}, {from("68"), 1, -inverse(H1(tau) - I2)}},
                           {{from("68"), 2},
                            {from("68"), 2, inverse(H1(tau) - I2)},
                            {from("68"), 1, -inverse(H1(tau) - I2)}},
                           {{from("68"), 2},
                            {from("68"), 2, 2 * inverse(H1(tau) - I2)},
                            {from("68"), 1, -2 * inverse(H1(tau) - I2)}}})},
      {.id = "69.det",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(determinant(H1(tau) - I2),
                            4 * power(sin(omega1 * tau / 2), 2) * power(sin(omega2 * tau / 2), 2)),
                   equation(power(sin(omega1 * pi() / omega) * sin(omega2 * pi() / omega), 2),
                            determinant(H1(pi() / omega) - I2) *
                                power(2 * cos(omega1 * pi() / (2 * omega)) * cos(omega2 * pi() / (2 * omega)),
                                      2))},
       .words = "$det(H_1 - I)$ divides what is not zero off resonance: its hypothesis is superfluous",
       .prove = by_normal_form()},
      {.id = "69.X",
       .kind = Kind::theorem,
       .printed = {equation(XB, -X0)},
       .words = "opposite states at both ends",
       .assumptions = halves_and({regular_H1}),
       .prove = by_combination(
           {{{from("69"), 2, column({I2, zero(2, 2)})}, {from("67"), 0, column({zero(2, 2), I2})}}})},
      {.id = "69.motion",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .printed = {equation(X(t), -X(t + tau))},
       .words = "half a period later the motion is the opposite one, as in Appendix 4",
       .assumptions = halves_and({regular_H1, from_0, to_tau}),
       .prove = by_rewriting(
           {from("52").solved_for(X(t)), from("52").solved_for(X(t + tau)), from("69.X"), from("53.F")})},
  };
}

// (70): when det P is zero.
std::vector<Claim> resonance() {
  return {
      {.id = "70.rho",
       .kind = Kind::definition,
       .printed = {equation(rho1, omega1 * sin(omega1 * tau / 2 + omega1 * tau1 / 2) /
                                      (sin(omega1 * tau / 2) * sin(omega1 * tau1 / 2))),
                   equation(rho2, omega2 * sin(omega2 * tau / 2 + omega2 * tau1 / 2) /
                                      (sin(omega2 * tau / 2) * sin(omega2 * tau1 / 2))),
                   equation(Ptilde, block(2, {rho1, 0, 0, rho2}))},
       .words = "$rho_i$, with $alpha_i = omega_i tau/2$ and $beta_i = omega_i tau_1/2$",
       .prove = by_normal_form()},
      {.id = "70",
       .kind = Kind::step,
       .printed = {equation(P, Lambda * Ptilde * inverse(Lambda))},
       .words = "$P$ in modal coordinates",
       .prove = by_normal_form()},
      {.id = "70.det",
       .kind = Kind::theorem,
       .printed = {equation(determinant(P), rho1 * rho2),
                   equation(rho1 * sin(omega1 * tau / 2) * sin(omega1 * tau1 / 2),
                            omega1 * sin(omega1 * Theta / 2)),
                   equation(rho2 * sin(omega2 * tau / 2) * sin(omega2 * tau1 / 2),
                            omega2 * sin(omega2 * Theta / 2))},
       .words =
           "where $P$ exists, $det P = 0$ exactly if $omega_1$ or $omega_2$ is a whole multiple of $omega$",
       .assumptions = {rest_of_period},
       .prove = by_normal_form()},
  };
}

}  // namespace

std::vector<Claim> appendix5() {
  return joined({motion(), relations(), through_P(), weaker_hypotheses(), symmetry(), theorem(),
                 longer_slip(), resonance(), uniqueness(), attraction()});
}

}  // namespace stickslip::proofs::pascal2012
