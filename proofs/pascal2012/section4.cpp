// Section 4: the symmetric orbits, (12)-(16): slip on (0, tau), stick on (tau, Theta). (17) is proved in
// Appendix 2.
#include "proofs/methods/implications.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace symmetric;

const Term z1 = scalar("z1"), z2 = scalar("z2");
const Assumption breaks{"4.breaks", equation(friction_at_rest(z10, z20, phi), ur)};
const Assumption repeats{"28.closes", equation(Z(Theta), Z0)};

const Term top = block(1, {I2, zero(2, 2)});

Term diagonal(const Term& a, const Term& b) {
  return block(2, {a, 0, 0, b});
}

// (12)-(14): the friction at both ends of the slip.
std::vector<Claim> ends() {
  const Assumption state_C1{"13.z1", equation(z1C, -z10)}, state_C2{"13.z2", equation(z2C, -z20)};
  const Assumption slides{"4.us", {us, 0, Relation::greater}}, holds{"4.ur", {ur, us, Relation::greater}};
  return {
      {.id = "12",
       .kind = Kind::condition,
       .printed = {starts_with_belt.statement, equation12},
       .words = "the slip begins where $r$ of (4) reaches $u_r$, in $z = x - d_0$",
       .assumptions = {starts_with_belt, breaks},
       .prove = by_combination({{{assuming("25.V")}}, {{assuming("4.breaks"), 0, eta}}})},
      {.id = "12.back",
       .kind = Kind::condition,
       .origin = Origin::converse,
       .printed = {breaks.statement},
       .words = "conversely (12) says $r = u_r$",
       .assumptions = {{"12", equation12}},
       .prove = by_combination({{{assuming("12"), 0, 1 / eta}}})},
      {.id = "12.begins",
       .kind = Kind::condition,
       .origin = Origin::reading,
       .printed = {{eta * (us - friction_at_rest(z10, z20, phi)), 0, Relation::less}},
       .words = "with (12) the slip really begins: $x2'' = eta (u_s - r) < 0$ takes the velocity below the "
                "belt's",
       .assumptions = {breaks, holds},
       .prove = by_positive_combination(
           {{.positive = {{eta, {{assuming("4.ur")}}}}, .equations = {{assuming("4.breaks"), 0, eta}}}})},
      {.id = "13",
       .kind = Kind::definition,
       .printed = {slip_ends.statement},
       .words =
           "the slip ends in the state opposite in place and equal in velocity: a condition that selects the "
           "family, and no consequence of anything",
       .assumptions = {slip_ends},
       .prove = by_premises({assuming("13")})},
      {.id = "13.matrix",
       .kind = Kind::definition,
       .printed = {equation(E, block(2, {-I2, zero(2, 2), zero(2, 2), I2}))},
       .words = "$E$ turns places round and keeps velocities",
       .prove = by_normal_form()},
      {.id = "13.E",
       .kind = Kind::identity,
       .printed = {equation(E * E, I4)},
       .words = "$E$ reverses twice to nothing",
       .prove = by_normal_form()},
      {.id = "4.friction",
       .kind = Kind::condition,
       .printed = {slides.statement, holds.statement},
       .words = "the slipping friction is positive and below the friction at rest",
       .assumptions = {slides, holds},
       .prove = by_premises({assuming("4.us"), assuming("4.ur")})},
      {.id = "14",
       .kind = Kind::step,
       .printed = {equation(at_C, -eta * (ur - us))},
       .words = "the friction at rest at the end of the slip, by (12), (13) and the time lag",
       .assumptions = {time_lag, state_C1, state_C2, {"12", equation12}},
       .prove = by_combination({{{assuming("12"), 0, -1}}})},
      {.id = "14.order",
       .kind = Kind::condition,
       .printed = {{-eta * (ur + us), -eta * (ur - us), Relation::less},
                   {-eta * (ur - us), eta * (ur - us), Relation::less}},
       .words = "(14) lies strictly between the ends of (11): the mass sticks; from $0 < u_s < u_r$",
       .assumptions = {slides, holds},
       .prove = by_positive_combination({{.positive = {{2 * eta, {{assuming("4.us")}}}}},
                                         {.positive = {{2 * eta, {{assuming("4.ur")}}}}}})},
  };
}

// The time lag: sufficient (44.F0), and necessary but for one case.
std::vector<Claim> lag() {
  const Term middle = cos(omega * tau / 2 + phi);
  const auto share = [](const Term& row) { return row * inverse(Lambda) * Q; };
  const auto lines = [](const Term& row, const Term& frequency) {
    const Term mode = row * inverse(Lambda);
    return std::vector<Multiple>{{from("13.slip"), 0,
                                  block(1, {mode * (frequency * sin(frequency * tau / 2) / 2),
                                            mode * (cos(frequency * tau / 2) / 2)})}};
  };
  return {
      {.id = "13.slip",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {slip13},
       .words = "(13) for the motion (5), with any phase $phi$ of the load",
       .assumptions = {slips_below, begins, slip_takes_time, slip_ends},
       .prove = by_rewriting({from("5").at("t", tau).solved_for(H(tau) * Z0), assuming("13")})},
      {.id = "4.lag.needed",
       .kind = Kind::theorem,
       .origin = Origin::converse,
       .printed = {equation(middle * balance(omega1) * share(half_period::first_row), 0),
                   equation(middle * balance(omega2) * share(half_period::second_row), 0)},
       .words = "where (13) holds, $cos(phi + omega tau/2) = 0$: $phi$ is the time lag or differs from it by "
                "$pi$; but for the slips with $omega_j tan(omega_j tau/2) = omega tan(omega tau/2)$ for both "
                "$j$, where the phase is free",
       .assumptions = {slips_below, begins, slip_takes_time, slip_ends},
       .prove =
           by_combination({lines(half_period::first_row, omega1), lines(half_period::second_row, omega2)}),
       .parts = {"where (13) holds, $cos(phi + omega tau/2)$ times $omega_1 sin(omega_1 tau/2) cos(omega "
                 "tau/2) - omega cos(omega_1 tau/2) sin(omega tau/2)$ times the first mode of $Q$ is zero",
                 "where (13) holds, $cos(phi + omega tau/2)$ times $omega_2 sin(omega_2 tau/2) cos(omega "
                 "tau/2) - omega cos(omega_2 tau/2) sin(omega tau/2)$ times the second mode of $Q$ is "
                 "zero"}},
  };
}

// (13) is no more than the time lag where the motion is determined: E Z(tau) leads back to itself, as Z_0
// does, since H(tau) E H(tau) = E = Gamma(T) E Gamma(T) and E F_0 = F(tau).
std::vector<Claim> reversal() {
  const Term whole = Gamma(T) * H(tau);
  const std::vector<Assumption> closed{time_lag,        slips_below,          begins,
                                       slip_takes_time, half_period::named_B, sticks,
                                       stick_lasts,     stick_takes_time,     closes};
  std::vector<Assumption> regular = closed;
  regular.push_back({"13.regular", {symbols::determinant(I4 - whole), 0, Relation::not_equal}});
  return {
      {.id = "4.sticking",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(Z(t), Gamma(t - tau) * ZB)},
       .words = "the stick that begins at $tau$, however the slip ended",
       .assumptions = {sticks, half_period::named_B, not_before(t, tau), not_after(t, Theta)},
       .prove = by_differential_equation({"9.stick", "28.ZB", Gamma, zero(4, 1)})},
      {.id = "13.gap",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation((I4 - whole) * (E * ZB - Z0), zero(4, 1))},
       .words = "the motion backwards in time, and what it may differ by",
       .assumptions = closed,
       .prove = by_combination({{{from("5").at("t", tau), 0, -(whole * E + Gamma(T))},
                                 {assuming("28.ZB"), 0, whole * E + Gamma(T)},
                                 {assuming("28.closes"), 0, Gamma(T) * E + I4},
                                 {from("4.sticking").at("t", Theta), 0, -(Gamma(T) * E + I4)}}})},
      {.id = "13.follows",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {slip_ends.statement},
       .words = "(13) follows from the time lag, where a motion of one slip and one stick is determined by "
                "their lengths",
       .assumptions = regular,
       .prove = by_combination({{{assuming("28.ZB")}, {from("13.gap"), 0, E * inverse(I4 - whole)}}})},
  };
}

// (16) where cos(omega_1 tau/2) = 0: three linear equations for the state are left, which have a solution for
// every such tau, and the motion from there does not end its slip by (13).
Counterexample spurious() {
  const Term turn = tan(T / 2), angle = omega2 * tau / 2;
  const Term second_place = z20 - q2 * s0 - lambda1 * (chi * z20 - chi * V * turn - q1 * s0),
             second_speed = V + q2 * omega * c0 - lambda1 * q1 * omega * c0;
  return {.point = {{"omega1", Rational(1, 2)},
                    {"omega2", Rational(7, 3)},
                    {"omega", Rational(3, 5)},
                    {"us", Rational(1, 10)},
                    {"V", Rational(1)},
                    {"p", Rational(1, 2)}},
          .values = {equation(tau, pi() / omega1), equation(T, 2 * pi() / omega - tau), time_lag.statement,
                     half_sine.statement, half_cosine.statement, equation(zdot20, V),
                     equation(z20, V * T / 2), equation(z10, chi * z20 + turn * (zdot10 - chi * V)),
                     equation(zdot10, (cos(angle) * second_place + sin(angle) / omega2 * second_speed) /
                                          (lambda1 * (cos(angle) * turn + sin(angle) / omega2)))},
          .true_there = {slip16, stick16, {T, 0, Relation::greater}},
          .false_there = {slip13}};
}

// The stick, and what (13) and (15) are worth as (16).
std::vector<Claim> closing() {
  return {
      {.id = "4.stick",
       .kind = Kind::step,
       .printed = {equation(Z(t), Gamma(t - tau) * E * Z0)},
       .words = "the stick that begins at $tau$ where the slip ended by (13)",
       .assumptions = {sticks, slip_ends, not_before(t, tau), not_after(t, Theta)},
       .prove = by_differential_equation({"9.stick", "13", Gamma, zero(4, 1)})},
      {.id = "15",
       .kind = Kind::step,
       .printed = {stick_ends.statement},
       .words = "the motion has the period $Theta = tau + T$",
       .assumptions = {slip_ends, sticks, stick_lasts, stick_takes_time, closes},
       .prove = by_rewriting(
           {from("4.stick").at("t", Theta).solved_for(Gamma(Theta - tau) * E * Z0), assuming("28.closes")})},
      {.id = "16",
       .kind = Kind::step,
       .printed = {slip16, stick16},
       .words = "the upper halves of (13) and (15)",
       .assumptions = {time_lag, half_sine, half_cosine, slips_below, begins, slip_takes_time, slip_ends,
                       stick_ends},
       .prove = by_combination({{{from("13.slip"), 0, top}}, {{assuming("15"), 0, -top}}}),
       .prove_converse = by_counterexample(spurious())},
      {.id = "16.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {slip13, stick_ends.statement},
       .words = "conversely (16) gives (13) and (15), where $cos(omega_j tau/2)$ and $cos(T/2)$ are not zero",
       .assumptions = {time_lag, half_sine, half_cosine, {"16.slip", slip16}, {"16.stick", stick16}},
       .prove = by_combination(
           {{{assuming("16.slip"), 0,
              column({I2, -Lambda * diagonal(omega1 * tan(omega1 * tau / 2), omega2 * tan(omega2 * tau / 2)) *
                              inverse(Lambda)})}},
            {{assuming("16.stick"), 0, column({-I2, Sigma * diagonal(tan(T / 2), 0) * inverse(Sigma)})}}})},
  };
}

// (11) during the stick.
std::vector<Claim> stick_conditions() {
  const Assumption above{"11.above",
                         {friction_at_rest(z1, z2, omega * (tau + t1) + phi), -ur, Relation::greater}},
      below{"11.below", {friction_at_rest(z1, z2, omega * (tau + t1) + phi), ur, Relation::less}};
  const Term pull = chi * eta * (z2 - z1) + p * sin(omega * (t1 + tau / 2));
  const Statement f1{pull - eta * (ur - us), 0, Relation::less_or_equal},
      f2{pull + eta * (ur + us), 0, Relation::greater};
  const Statement f1_strict{f1.left, 0, Relation::less};
  return {
      {.id = "4.f",
       .kind = Kind::condition,
       .printed = {f1, f2},
       .words = "(11) with the time lag, at the time $tau + t_1$ of the stick; $f_1 <= 0$ holds with < "
                "inside the stick",
       .assumptions = {time_lag, above, below},
       .prove = by_positive_combination({{.positive = {{eta, {{assuming("11.below")}}}}},
                                         {.positive = {{eta, {{assuming("11.above")}}}}}}),
       .illegible = "the 0 of the range, printed as $t < t_1 < T$"},
      {.id = "4.f.back",
       .kind = Kind::condition,
       .origin = Origin::converse,
       .printed = {below.statement, above.statement},
       .words =
           "conversely $f_1 < 0 < f_2$ gives (11); $f_1 = 0$, which the paper allows, is where (11) ends",
       .assumptions = {time_lag, {"4.f1", f1_strict}, {"4.f2", f2}},
       .prove = by_positive_combination({{.positive = {{1 / eta, {{assuming("4.f1")}}}}},
                                         {.positive = {{1 / eta, {{assuming("4.f2")}}}}}})},
      {.id = "4.f.end",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(chi * eta * (z20 - z10) + p * sin(omega * (T + tau / 2)) - eta * (ur - us), 0)},
       .words = "at the end of the stick, where $z = z_0$, $f_1 = 0$: the slip begins by (12)",
       .assumptions = {time_lag, {"4.T", equation(T, 2 * pi() / omega - tau)}, {"12", equation12}},
       .prove = by_combination({{{assuming("12")}}})},
  };
}

}  // namespace

std::vector<Claim> section4() {
  return joined({ends(), lag(), closing(), reversal(), determinant_of_16(), stick_conditions(),
                 not_enough_for_slip_and_stick(), example_S()});
}

}  // namespace stickslip::proofs::pascal2012
