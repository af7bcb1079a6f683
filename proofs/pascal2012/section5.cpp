// Section 5: orbits with an overshooting part, (18)-(20) and (24).
#include "proofs/methods/implications.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/pascal2012/overshooting.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace overshooting;
using half_period::friction_at_rest;

using Assumptions = std::vector<Assumption>;

// The friction at rest of (4) at tau and at tau + tau1.
const Term rB = friction_at_rest(z1B, z2B, omega *tau + phi), rC = friction_at_rest(z1C, z2C, load_at_C);

const Assumption leaves_up{"4.up", {rB, -ur, Relation::less}};
const Assumption sticks_above{"4.rest", {-ur, rC, Relation::less}};
const Assumption sticks_below{"4.rest2", {rC, ur, Relation::less}};
const Assumption step_of_friction{"4.ur", {us, ur, Relation::less}};

// (19) as the source has it: without eta in front of the bracket, and with tau_2.
const Term printed19 = chi * (z2C - z1C) - p * cos(omega * (tau + tau2) + phi);

// A landing that (4) lets stick and the printed (19) does not allow. tau_2 may be anything; here it is tau_1.
Counterexample printed_landing() {
  const Term load_phase = omega * (tau + tau2) + phi;
  return {.point = {{"omega1", Rational(1, 2)},
                    {"omega2", Rational(2)},
                    {"omega", Rational(3, 5)},
                    {"us", Rational(1, 10)},
                    {"ur", Rational(1, 5)},
                    {"p", 1},
                    {"phi", 0},
                    {"tau", 4},
                    {"tau1", 1},
                    {"tau2", 1},
                    {"z1C", 0}},
          .values = {equation(z2C, p * cos(load_phase) / (chi * eta))},
          .true_there = {sticks_above.statement, sticks_below.statement, step_of_friction.statement},
          .false_there = {{printed19, eta * (ur - us), Relation::less}}};
}

std::vector<Claim> conditions() {
  return {
      {.id = "18",
       .kind = Kind::condition,
       .printed = {inequality18},
       .words = "at $t = tau$, where $z2' = V$, the friction at rest is below $-u_r$: the mass leaves the "
                "belt's velocity upwards; $r < -u_r$ of (4) in $z = x - d_0$",
       .assumptions = {leaves_up},
       .prove = by_positive_combination({{.positive = {{eta, {{assuming("4.up")}}}}}})},
      {.id = "18.back",
       .kind = Kind::condition,
       .printed = {leaves_up.statement},
       .words = "conversely (18) says that $r < -u_r$",
       .assumptions = {{"18", inequality18}},
       .prove = by_positive_combination({{.positive = {{1 / eta, {{assuming("18")}}}}}})},
      {.id = "18.begins",
       .kind = Kind::condition,
       .printed = {{eta * (-us - rB), 0, Relation::greater}},
       .words = "with (18) the overshoot really begins: $x2'' = eta (-u_s - r) > 0$ under $u = -u_s$ takes "
                "the velocity above the belt's",
       .assumptions = {leaves_up, step_of_friction},
       .prove = by_positive_combination(
           {{.positive = {{eta, {{assuming("4.up")}}}, {eta, {{assuming("4.ur")}}}}}})},
      {.id = "19",
       .kind = Kind::condition,
       .printed = {{-eta * (ur + us), printed19, Relation::less},
                   {printed19, eta * (ur - us), Relation::less}},
       .words = "at $t = tau + tau_1$, where $z2' = V$, the friction at rest is below $u_r$ in size: the "
                "mass sticks; $|r| < u_r$ of (4) in $z = x - d_0$",
       .assumptions = {sticks_above, sticks_below, step_of_friction},
       .prove = by_counterexample(printed_landing()),
       .corrected = {above19, below19},
       .prove_corrected = by_positive_combination(
           {{.positive = {{eta, {{assuming("4.rest")}}}}}, {.positive = {{eta, {{assuming("4.rest2")}}}}}})},
      {.id = "19.back",
       .kind = Kind::condition,
       .printed = {sticks_above.statement, sticks_below.statement},
       .words = "conversely (19), with $eta$ and $tau_1$, says that $|r| < u_r$",
       .assumptions = {{"19.above", above19}, {"19.below", below19}},
       .prove = by_positive_combination({{.positive = {{1 / eta, {{assuming("19.above")}}}}},
                                         {.positive = {{1 / eta, {{assuming("19.below")}}}}}})},
      {.id = "19.implied",
       .kind = Kind::condition,
       .origin = Origin::new_result,
       .printed = {above19},
       .words = "the left inequality of (19) is no condition: a mass that comes down to the belt's velocity "
                "under $u = -u_s$, $x2'' = -eta (r + u_s) <= 0$, has $r >= -u_s > -u_r$",
       .assumptions = {{"19.down", {-eta * (rC + us), 0, Relation::less_or_equal}}, step_of_friction},
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("19.down")}}}, {eta, {{assuming("4.ur")}}}}}})},
      {.id = "24",
       .kind = Kind::step,
       .printed = {equation(ur, us + (chi * (z20 - z10) - p / eta * cos(phi)))},
       .words = "$u_r$ from the state at $t = 0$, by (12); the bracket is $f$",
       .assumptions = {{"12", at_start}},
       .prove = by_combination({{{assuming("12"), 0, -1 / eta}}})},
      {.id = "24.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {at_start},
       .words = "conversely (24) gives (12)",
       .assumptions = {{"24", equation(us + (chi * (z20 - z10) - p / eta * cos(phi)), ur)}},
       .prove = by_combination({{{assuming("24"), 0, eta}}})},
  };
}

// The motion through its three phases, and (20).
std::vector<Claim> motion() {
  Assumptions slips_and_lands = both_slips, ends_stick = stick;
  slips_and_lands.push_back(lands_on_belt);
  ends_stick.erase(ends_stick.begin() + 3);  // it need not close
  ends_stick.insert(ends_stick.begin(), {"20.C", equation(ZC, Gamma(-T) * Z0)});
  return {
      {.id = "20.slips",
       .kind = Kind::step,
       .printed = {equation(ZC, after_both)},
       .words = "the state at the end of the overshoot: (5) on $(0, tau)$, then (8)",
       .assumptions = both_slips,
       .prove = by_rewriting({assuming("19.ZC").solved_for(ZC),
                              from("27").at("Theta", tau + tau1).at("t", tau + tau1),
                              from("56.B").solved_for(ZB), from("56.F").solved_for(FB),
                              from("38.group").at("t", tau1).at("s", tau).solved_for(H(tau1) * H(tau))})},
      {.id = "20.sticking",
       .kind = Kind::step,
       .printed = {equation(Z(t), Gamma(t - tau - tau1) * ZC)},
       .words = "the stick that begins at $tau + tau_1$",
       .assumptions = {sticks, named_C, not_before(t, tau + tau1), not_after(t, Theta)},
       .prove = by_differential_equation({"9.stick", "19.ZC", Gamma, zero(4, 1)})},
      {.id = "20",
       .kind = Kind::condition,
       .printed = {equation(Z0, Gamma(T) * ZC)},
       .words = "$Z(Theta) = Z_0$ with the stick in closed form",
       .assumptions = stick,
       .prove = by_rewriting({assuming("20").solved_for(Z0), from("20.sticking").at("t", Theta)})},
      {.id = "20.C",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(ZC, Gamma(-T) * Z0)},
       .words = "(20) solved for the state at the beginning of the stick: the combination of (20) whose "
                "components (21) are, since the signs of $Gamma_ij$ in (47)-(49) are those of $Gamma(-T)$",
       .assumptions = stick,
       .prove = by_rewriting({from("20").solved_for(Z0), from("41.inverse").at("t", T)})},
      {.id = "20.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {equation(Z(Theta), Z0)},
       .words = "conversely that state closes the motion",
       .assumptions = ends_stick,
       .prove = by_rewriting({from("20.sticking").at("t", Theta), assuming("20.C").solved_for(ZC),
                              from("41.inverse").at("t", T)})},
      {.id = "21.gap",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(after_both, Gamma(-T) * Z0)},
       .words = "slip, overshoot and stick close",
       .assumptions = whole_and({}),
       .prove = by_rewriting({from("20.C").solved_for(ZC), from("20.slips").solved_for(H(tau + tau1) * Z0)})},
      {.id = "18.speed",
       .kind = Kind::step,
       .printed = {equation(row(4) * after_slip, V)},
       .words = "$z2'(tau) = V$",
       .assumptions = {begins, slips_below, slip_takes_time, named_B, meets_belt},
       .prove = by_combination({{{from("56.B"), 0, -row(4)}}})},
      {.id = "19.speed",
       .kind = Kind::step,
       .printed = {equation(row(4) * after_both, V)},
       .words = "$z2'(tau + tau_1) = V$",
       .assumptions = slips_and_lands,
       .prove = by_combination({{{from("20.slips"), 0, -row(4)}}})},
  };
}

}  // namespace

std::vector<Claim> section5() {
  return joined({conditions(), motion(), section5_linear(), not_enough_for_three_phases(), example_O()});
}

}  // namespace stickslip::proofs::pascal2012
