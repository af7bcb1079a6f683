// Section 6: the orbits that never stick, (25)-(37). Symmetric orbits: tau = pi/omega = Theta/2 is assumed.
#include "proofs/methods/implications.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace symbols::vocabulary;
using namespace half_period;

const Term I2_above = block(1, {I2, zero(2, 2)}), I2_below = block(1, {zero(2, 2), I2});

const Assumption leaves_down{"4.down", {friction_at_rest(z10, z20, phi), ur, Relation::greater}};
const Assumption leaves_up{"4.up", {friction_at_rest(z1B, z2B, omega * tau + phi), -ur, Relation::less}};
const Assumption step_of_friction{"4.ur", {us, ur, Relation::less}};

std::vector<Claim> conditions() {
  return {
      {.id = "25",
       .kind = Kind::condition,
       .printed = {inequality25},
       .words = "at $t = 0$, where $z2' = V$, the friction at rest exceeds $u_r$: the mass leaves the belt's "
                "velocity downwards; $r > u_r$ of (4) in $z = x - d_0$, and conversely",
       .assumptions = {leaves_down},
       .prove = by_positive_combination({{.positive = {{eta, {{assuming("4.down")}}}}}})},
      {.id = "26",
       .kind = Kind::condition,
       .printed = {inequality26},
       .words = "at $t = tau$, where $z2' = V$, the friction at rest is below $-u_r$: the mass leaves the "
                "belt's velocity upwards; $r < -u_r$ of (4) in $z = x - d_0$, and conversely",
       .assumptions = {leaves_up},
       .prove = by_positive_combination({{.positive = {{eta, {{assuming("4.up")}}}}}})},
      {.id = "25.begins",
       .kind = Kind::condition,
       .printed = {{eta * (us - friction_at_rest(z10, z20, phi)), 0, Relation::less}},
       .words = "with (25) the slip really begins: $x2'' = eta (u_s - r) < 0$ under $u = u_s$",
       .assumptions = {leaves_down, step_of_friction},
       .prove = by_positive_combination(
           {{.positive = {{eta, {{assuming("4.down")}}}, {eta, {{assuming("4.ur")}}}}}})},
      {.id = "26.begins",
       .kind = Kind::condition,
       .printed = {{eta * (-us - friction_at_rest(z1B, z2B, omega * tau + phi)), 0, Relation::greater}},
       .words = "with (26) the overshoot really begins: $x2'' = eta (-u_s - r) > 0$ under $u = -u_s$",
       .assumptions = {leaves_up, step_of_friction},
       .prove = by_positive_combination(
           {{.positive = {{eta, {{assuming("4.up")}}}, {eta, {{assuming("4.ur")}}}}}})},
      {.id = "26.half",
       .kind = Kind::condition,
       .printed = {half.statement},
       .words =
           "each slip lasts half a period of the load; for $V = 0$ and off resonance that follows (A5.half)",
       .assumptions = {half},
       .prove = by_premises({assuming("26.half")})},
      {.id = "26.tau",
       .kind = Kind::condition,
       .printed = {equation(p * cos(omega * tau + phi) - eta * (ur + us), -p * cos(phi) - eta * (ur + us))},
       .words = "the right side of (26) for $tau = pi/omega$",
       .assumptions = {half},
       .prove = by_normal_form()},
  };
}

// (27)-(30): the motion closes.
std::vector<Claim> closing() {
  return {
      {.id = "27",
       .kind = Kind::step,
       .printed = {equation(Z(t), H(t - tau) * (ZB - FB) + 2 * L(t - tau) * d0 + F(t))},
       .words = "the overshooting slip that begins at $tau$ with $Z_B$; $tau$ and $Theta$ may be any times",
       .assumptions = {overshoots, named_B, not_before(t, tau), not_after(t, Theta)},
       .prove = by_differential_equation({"2.overshoot", "28.ZB", H, F(t) - 2 * delta0})},
      {.id = "28.F",
       .kind = Kind::step,
       .printed = {equation(FB, F(tau)), equation(FB, -F0)},
       .words = "the forced response after half a period",
       .assumptions = {half},
       .prove = by_normal_form()},
      {.id = "28.Theta",
       .kind = Kind::identity,
       .printed = {equation(F(Theta), F0)},
       .words = "the forced response after a period",
       .assumptions = {period},
       .prove = by_normal_form()},
      {.id = "28",
       .kind = Kind::step,
       .printed = {equation(Z0, H(tau) * (ZB - FB) + 2 * L(tau) * d0 + F0)},
       .words = "the motion has the period $Theta$",
       .assumptions = {half, period, overshoots, named_B, closes},
       .prove =
           by_rewriting({from("27").at("t", Theta), assuming("28.closes").solved_for(Z0), from("28.Theta")})},
      {.id = "28.B",
       .kind = Kind::step,
       .printed = {equation(ZB, H(tau) * (Z0 - F0) + FB)},
       .words = "the state at the end of the first slip, by (5)",
       .assumptions = {half, begins, slips_below, named_B},
       .prove = by_rewriting(
           {from("5").at("t", tau), assuming("28.ZB").solved_for(ZB), from("28.F").solved_for(F(tau))})},
      {.id = "29.H",
       .kind = Kind::identity,
       .printed = {equation(H(tau) - H(-tau), 2 * block(2, {zero(2, 2), H2(tau), H3(tau), zero(2, 2)}))},
       .words = "the part of $H$ that changes sign with time",
       .prove = by_normal_form()},
      {.id = "29",
       .kind = Kind::step,
       .printed = {equation((H(tau) - H(-tau)) * (ZB - FB) + 2 * L(tau) * d0, zero(4, 1))},
       .words = "(28) with $Z_0$ eliminated",
       .assumptions = motion,
       .prove = by_rewriting({from("28").solved_for(H(tau) * ZB), from("28.B").solved_for(ZB),
                              from("38.inverse").at("t", tau)})},
      {.id = "30",
       .kind = Kind::step,
       .printed = {equation(H2(tau) * (zdotB - Q * omega * sin(phi)) + (H1(tau) - I2) * d0, zero(2, 1)),
                   equation(H3(tau) * (zB + Q * cos(phi) + d0), zero(2, 1))},
       .words = "(29) by blocks",
       .assumptions = motion,
       .prove = by_combination({{{from("29"), 0, I2_above / 2}}, {{from("29"), 0, I2_below / 2}}})},
      {.id = "30.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {equation((H(tau) - H(-tau)) * (ZB - FB) + 2 * L(tau) * d0, zero(4, 1))},
       .words = "conversely (30) gives (29)",
       .assumptions = motion,
       .prove = by_combination(
           {{{from("30"), 0, 2 * column({I2, zero(2, 2)})}, {from("30"), 1, 2 * column({zero(2, 2), I2})}}})},
  };
}

// (31)-(33): the states at both ends of the slip, and V = 0.
std::vector<Claim> states() {
  const Term rest = H2_inverse * (H1(tau) - I2) * d0;
  return {
      {.id = "31",
       .kind = Kind::step,
       .printed = {equation(zB, -Q * cos(phi) - d0), equation(xB, -Q * cos(phi)),
                   equation(zdotB, Q * omega * sin(phi) + H2_inverse * (I2 - H1(tau)) * d0)},
       .words = "the state at $tau$, if $det H_3$ is not zero; that $det H_2$ is not zero follows (31.det)",
       .assumptions = motion_and({regular}),
       .prove = by_combination({{{from("30"), 1, inverse(H3(tau))}},
                                {{from("30"), 1, inverse(H3(tau))}},
                                {{from("30"), 0, H2_inverse}}})},
      {.id = "31.det",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(determinant(H3(tau)), omega1 * omega2 * sin(omega1 * tau) * sin(omega2 * tau)),
                   equation(determinant(H2(tau)), sin(omega1 * tau) * sin(omega2 * tau) / (omega1 * omega2))},
       .words = "where (31) fails: at $tau = pi/omega$ both determinants vanish exactly if $omega_1$ or "
                "$omega_2$ is a whole multiple of $omega$",
       .prove = by_normal_form()},
      {.id = "31.modes",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(sin(omega1 * tau) / omega1 * (first_row * modal_speed) +
                                (cos(omega1 * tau) - 1) * (first_row * modal_rest),
                            0),
                   equation(sin(omega2 * tau) / omega2 * (second_row * modal_speed) +
                                (cos(omega2 * tau) - 1) * (second_row * modal_rest),
                            0)},
       .words = "the first of (30) mode by mode: where $sin(omega_j pi/omega) = 0$, no motion closes if "
                "$cos(omega_j pi/omega) = -1$ ($omega_j$ an odd multiple of $omega$), and the mode's speed "
                "and place are free if it is 1 (an even multiple)",
       .assumptions = motion,
       .prove = by_combination(
           {{{from("30"), 0, first_row * inverse(Lambda)}}, {{from("30"), 0, second_row * inverse(Lambda)}}}),
       .parts =
           {"the first mode: $sin(omega_1 tau)/omega_1$ times its speed at $tau$, less the load's, plus "
            "$cos(omega_1 tau) - 1$ times its place of rest is zero",
            "the second mode: $sin(omega_2 tau)/omega_2$ times its speed at $tau$, less the load's, plus "
            "$cos(omega_2 tau) - 1$ times its place of rest is zero"}},
      {.id = "31.rest",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(modal_rest, us / (1 - chi) / (power(omega2, 2) - power(omega1, 2)) *
                                            column({power(omega2, 2), -power(omega1, 2)}))},
       .words = "the friction moves the place of rest of both modes, $Lambda^{-1} d_0$ has no zero component",
       .prove = by_normal_form()},
      {.id = "32",
       .kind = Kind::identity,
       .printed = {equation(power(H1(tau), 2) - I2, H2(tau) * H3(tau)),
                   equation(H3(tau), H2_inverse * power(H1(tau), 2) - H2_inverse)},
       .words = "(40) at $tau$, solved for $H_3$",
       .assumptions = {half, regular},
       .prove = by_combination({{{from("40").at("t", tau)}}, {{from("40").at("t", tau), 0, -H2_inverse}}})},
      {.id = "33",
       .kind = Kind::theorem,
       .printed = {equation(z0, Q * cos(phi) - d0), equation(x0, Q * cos(phi)),
                   equation(zdot0, -Q * omega * sin(phi) + rest)},
       .words = "the state at $t = 0$",
       .assumptions = motion_and({regular}),
       .prove =
           by_combination({{{from("28"), 0, I2_above}, {from("31"), 0, H1(tau)}, {from("31"), 2, H2(tau)}},
                           {{from("28"), 0, I2_above}, {from("31"), 0, H1(tau)}, {from("31"), 2, H2(tau)}},
                           {{from("28"), 0, I2_below},
                            {from("31"), 0, H3(tau)},
                            {from("31"), 2, H1(tau)},
                            {from("32"), 1, 1, d0}}})},
      {.id = "33.symmetry",
       .kind = Kind::theorem,
       .printed = {equation(x0, -xB), equation(zdot0, -zdotB)},
       .words = "the states at 0 and $tau$ are opposite",
       .assumptions = motion_and({regular}),
       .prove = by_combination({{{from("33"), 0}, {from("31"), 0}}, {{from("33"), 2}, {from("31"), 2}}})},
      {.id = "33.V",
       .kind = Kind::theorem,
       .printed = {equation(V, 0)},
       .words = "a motion that never sticks, with $tau = Theta/2$, exists only if $V = 0$",
       .assumptions = motion_and({regular, starts_with_belt, meets_belt}),
       .prove = by_combination({{{from("33.symmetry"), 1, second_row / 2}}})},
      {.id = "33.back",
       .kind = Kind::theorem,
       .origin = Origin::converse,
       .printed = {equation(Z0, H(tau) * H(tau) * (Z0 - F0) + 2 * L(tau) * d0 + F0)},
       .words = "conversely the states of (33) close by (28), with $H_2^{-1}(H_1 - I)$ continued to where "
                "$det H_2$ is zero; only $cos(omega_j pi/(2 omega)) = 0$ is excluded, $omega_j$ an odd "
                "multiple of $omega$, where no motion closes",
       .assumptions = {half, continued(z10, first_row * (Q * cos(phi) - d0)),
                       continued(z20, second_row * (Q * cos(phi) - d0)),
                       continued(zdot10, first_row * speed_continued),
                       continued(zdot20, second_row * speed_continued)},
       .prove = by_normal_form()},
  };
}

// (34), (35): the closed forms.
std::vector<Claim> closed_forms() {
  return {
      {.id = "35.def",
       .kind = Kind::definition,
       .printed = {equation(phi1, omega1 * tan(omega1 * pi() / (2 * omega))),
                   equation(phi2, omega2 * tan(omega2 * pi() / (2 * omega))),
                   equation(lambda1, (1 - power(omega1, 2)) / chi),
                   equation(lambda2, (1 - power(omega2, 2)) / chi),
                   equation(d, chi / (power(omega1, 2) - power(omega2, 2))),
                   equation(a1, d * (phi1 * lambda2 - phi2 * lambda1)), equation(a2, d * (phi2 - phi1)),
                   equation(b1, d * (phi1 - phi2) * lambda1 * lambda2),
                   equation(b2, d * (lambda2 * phi2 - lambda1 * phi1))},
       .words = "the abbreviations of (34) and (35); $phi_i$ is infinite where $omega_i$ is an odd multiple "
                "of $omega$",
       .prove = by_normal_form()},
      {.id = "34.H",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(H2_inverse * (H1(tau) - I2), -block(2, {a1, a2, b1, b2}))},
       .words =
           "$H_2^{-1}(H_1 - I)$ in closed form: the numbers $a_i$, $b_i$ of (34) and (35) are its entries",
       .assumptions = {half, regular},
       .prove = by_normal_form()},
      {.id = "34",
       .kind = Kind::step,
       .printed = {equation(z10, q1 * cos(phi) - d01), equation(z20, q2 * cos(phi) - d02),
                   equation(zdot10, -q1 * omega * sin(phi) - a1 * d01 - a2 * d02)},
       .words = "the initial state in closed form",
       .assumptions = motion_and({regular}),
       .prove = by_combination({{{from("33"), 0, first_row}},
                                {{from("33"), 0, second_row}},
                                {{from("33"), 2, first_row}, {from("34.H"), 0, first_row, d0}}})},
      {.id = "35",
       .kind = Kind::step,
       .printed = {equation(sin(phi), -(b1 * d01 + b2 * d02) / (q2 * omega))},
       .words = "the load's phase; it is determined only if the load acts on the second mass $(q_2 != 0)$",
       .assumptions = motion_and({regular, starts_with_belt, meets_belt}),
       .prove = by_combination({{{from("33"), 2, second_row / (q2 * omega)},
                                 {from("34.H"), 0, second_row / (q2 * omega), d0},
                                 {from("33.V"), 0, -1 / (q2 * omega)}}})},
  };
}

}  // namespace

std::vector<Claim> section6() {
  return joined({conditions(),
                 closing(),
                 states(),
                 closed_forms(),
                 section6_load(),
                 not_enough_for_slips(),
                 {odd_resonance()},
                 even_resonance(),
                 example_P()});
}

}  // namespace stickslip::proofs::pascal2012
