// Section 5: orbits with an overshooting part, (18)-(24).
#include "model/appendix3.hpp"
#include "proofs/half_period.hpp"
#include "proofs/implications.hpp"
#include "proofs/linear.hpp"
#include "proofs/meaning.hpp"
#include "proofs/overshooting.hpp"
#include "proofs/paper.hpp"

namespace stickslip::proofs {
namespace {

using namespace overshooting;
using half_period::friction_at_rest;

const std::string sec = "sec5";

using Assumptions = std::vector<Assumption>;

// The friction at rest of (4) at t = 0, tau and tau + tau1.
const Term load_at_C = omega * (tau + tau1) + phi;
const Term r0 = friction_at_rest(z10, z20, phi), rB = friction_at_rest(z1B, z2B, omega* tau + phi),
           rC = friction_at_rest(z1C, z2C, load_at_C);

// chi eta (z2 - z1) - p cos(load): eta (r - u_s).
Term eta_r(const Term& z1, const Term& z2, const Term& load_phase) {
  return chi * eta * (z2 - z1) - p * cos(load_phase);
}

const Statement at_start = equation(chi * eta * (z20 - z10), p* cos(phi) + eta*(ur - us));
const Statement inequality18{eta_r(z1B, z2B, omega* tau + phi) + eta * (ur + us), 0, Relation::less};
const Term middle19 = eta_r(z1C, z2C, load_at_C);
const Statement above19{-eta * (ur + us), middle19, Relation::less};
const Statement below19{middle19, eta*(ur - us), Relation::less};

const Assumption breaks_away{"12.r", equation(r0, ur)};
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
          .values = {equation(z2C, p* cos(load_phase) / (chi * eta))},
          .true_there = {sticks_above.statement, sticks_below.statement, step_of_friction.statement},
          .false_there = {printed19, eta*(ur - us), Relation::less}};
}

std::vector<Claim> conditions() {
  return {
      {.id = "18",
       .place = sec,
       .kind = Kind::condition,
       .printed = {inequality18},
       .words = "at t = tau, where z2' = V, the friction at rest is below -u_r: the mass leaves the belt's "
                "velocity upwards; r < -u_r of (4) in z = x - d_0",
       .assumptions = {leaves_up},
       .prove = by_positive_combination({{.positive = {{eta, {{assuming("4.up")}}}}}})},
      {.id = "18.back",
       .place = sec,
       .kind = Kind::condition,
       .printed = {leaves_up.statement},
       .words = "conversely (18) says that r < -u_r",
       .assumptions = {{"18", inequality18}},
       .prove = by_positive_combination({{.positive = {{1 / eta, {{assuming("18")}}}}}})},
      {.id = "19",
       .place = sec,
       .kind = Kind::condition,
       .printed = {{-eta * (ur + us), printed19, Relation::less}, {printed19, eta*(ur - us), Relation::less}},
       .words = "at t = tau + tau_1, where z2' = V, the friction at rest is below u_r in size: the mass "
                "sticks; |r| < u_r of (4) in z = x - d_0",
       .assumptions = {sticks_above, sticks_below, step_of_friction},
       .prove = by_counterexample(printed_landing()),
       .corrected = {above19, below19},
       .prove_corrected =
           by_positive_combination({{.positive = {{eta, {{assuming("4.rest")}}}}},
                                    {.positive = {{eta, {{assuming("4.rest2")}}}}}})},
      {.id = "19.back",
       .place = sec,
       .kind = Kind::condition,
       .printed = {sticks_above.statement, sticks_below.statement},
       .words = "conversely (19), with eta and tau_1, says that |r| < u_r",
       .assumptions = {{"19.above", above19}, {"19.below", below19}},
       .prove = by_positive_combination({{.positive = {{1 / eta, {{assuming("19.above")}}}}},
                                         {.positive = {{1 / eta, {{assuming("19.below")}}}}}})},
      {.id = "19.implied",
       .place = sec,
       .kind = Kind::condition,
       .printed = {above19},
       .words = "the left inequality of (19) is no condition: a mass that comes down to the belt's velocity "
                "under u = -u_s, x2'' = -eta (r + u_s) <= 0, has r >= -u_s > -u_r",
       .assumptions = {{"19.down", {-eta * (rC + us), 0, Relation::less_or_equal}}, step_of_friction},
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("19.down")}}}, {eta, {{assuming("4.ur")}}}}}})},
      {.id = "24",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(ur, us + (chi * (z20 - z10) - p / eta * cos(phi)))},
       .words = "u_r from the state at t = 0, by (12); the bracket is f",
       .assumptions = {{"12", at_start}},
       .prove = by_combination({{{assuming("12"), 0, -1 / eta}}})},
      {.id = "24.back",
       .place = sec,
       .kind = Kind::step,
       .printed = {at_start, breaks_away.statement},
       .words = "conversely (24) gives (12), which is r = u_r of (4)",
       .assumptions = {{"24", equation(us + (chi * (z20 - z10) - p / eta * cos(phi)), ur)}},
       .prove = by_combination({{{assuming("24"), 0, eta}}, {{assuming("24")}}})},
  };
}

// The motion through its three phases, and (20).
std::vector<Claim> motion() {
  const Assumptions whole{named_B, named_C, closes, period};
  return {
      {.id = "20.slips",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(ZC, after_both)},
       .words = "the state at the end of the overshoot: (5) on (0, tau), then (8)",
       .assumptions = {named_B, named_C},
       .prove = by_rewriting({assuming("19.ZC").solved_for(ZC), from("27").at("t", tau + tau1),
                              from("56.B").solved_for(ZB), from("56.F").solved_for(FB),
                              from("38.group").at("t", tau1).at("s", tau).solved_for(H(tau1) * H(tau))})},
      {.id = "20.sticking",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(Z(t), Gamma(t - tau - tau1) * ZC)},
       .words = "the stick that begins at tau + tau_1",
       .prove = by_differential_equation(first_order(stick_matrix), zero(4, 1), ZC, tau + tau1)},
      {.id = "20",
       .place = sec,
       .kind = Kind::condition,
       .printed = {equation(Z0, Gamma(T) * ZC)},
       .words = "Z(Theta) = Z_0 with the stick in closed form",
       .assumptions = {closes, period},
       .prove = by_rewriting({assuming("20").solved_for(Z0), from("20.sticking").at("t", Theta)})},
      {.id = "20.C",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(ZC, Gamma(-T) * Z0)},
       .words = "(20) solved for the state at the beginning of the stick: the combination of (20) whose "
                "components (21) are, since the signs of Gamma_ij in (47)-(49) are those of Gamma(-T)",
       .assumptions = {closes, period},
       .prove = by_rewriting({from("20").solved_for(Z0), from("41.inverse").at("t", T)})},
      {.id = "20.back",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(Z(Theta), Z0)},
       .words = "conversely that state closes the motion",
       .assumptions = {{"20.C", equation(ZC, Gamma(-T) * Z0)}, period},
       .prove = by_rewriting({from("20.sticking").at("t", Theta), assuming("20.C").solved_for(ZC),
                              from("41.inverse").at("t", T)})},
      {.id = "21.gap",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(after_both, Gamma(-T) * Z0)},
       .words = "slip, overshoot and stick close",
       .assumptions = whole,
       .prove = by_rewriting({from("20.C").solved_for(ZC),
                              from("20.slips").solved_for(H(tau + tau1) * Z0)})},
      {.id = "18.speed",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(row(4) * after_slip, V)},
       .words = "z2'(tau) = V",
       .assumptions = {named_B, meets_belt},
       .prove = by_combination({{{from("56.B"), 0, -row(4)}}})},
      {.id = "19.speed",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(row(4) * after_both, V)},
       .words = "z2'(tau + tau_1) = V",
       .assumptions = {named_B, named_C, lands_on_belt},
       .prove = by_combination({{{from("20.slips"), 0, -row(4)}}})},
  };
}

std::string id_of(int equation_number, char letter) {
  return std::to_string(46 + equation_number) + "." + letter;
}

// What equation i of (21) adds to the closing gap i, times a factor: (a_i - its value) z10 + …
std::vector<Multiple> coefficients_of(int i, const Term& factor) {
  return {{from(id_of(i, 'a')), 0, factor * z10},
          {from(id_of(i, 'b')), 0, factor * z20},
          {from(id_of(i, 'c')), 0, factor * zdot10},
          {from(id_of(i, 'd')), 0, factor}};
}

std::vector<Multiple> joined(std::vector<Multiple> a, const std::vector<Multiple>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string line(int i) {
  return "21." + std::to_string(i);
}

Assumption assumed_line(int i) {
  return {line(i), equation(closing_form(i), 0)};
}

// The gap i by equation i of (21).
std::vector<Multiple> gap_from_line(int i, const Term& factor) {
  return joined({{assuming(line(i)), 0, factor}}, coefficients_of(i, -factor));
}

std::vector<Claim> linear_equations() {
  std::vector<std::vector<Multiple>> forward;
  std::vector<Multiple> state{{from("20.slips")}};
  std::vector<Statement> lines;
  for (int i = 1; i <= 5; ++i) {
    lines.push_back(equation(closing_form(i), 0));
    const Multiple gap = i <= 3   ? Multiple{from("21.gap"), 0, row(i)}
                         : i == 4 ? Multiple{from("18.speed")}
                                  : Multiple{from("19.speed")};
    forward.push_back(joined({gap}, coefficients_of(i, 1)));
    if (i != 4) {
      state = joined(state, gap_from_line(i, place(i == 5 ? 4 : i)));
    }
  }
  const Term speed_C = scalar("zdot2C");
  return {
      {.id = "21",
       .place = sec,
       .kind = Kind::step,
       .printed = lines,
       .words = "five linear equations for z_1(0), z_2(0), z_1'(0): three components of (20), and z2' = V at "
                "tau (18) and at tau + tau_1 (19); z2' = V at 0 is put in",
       .assumptions = {named_B, named_C, closes, period, starts_with_belt, meets_belt, lands_on_belt},
       .prove = by_combination(forward)},
      {.id = "21.back",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(ZC, Gamma(-T) * Z0), equation(scalar("zdot2B"), V), equation(speed_C, V)},
       .words = "conversely the five equations give the state at tau + tau_1 that closes the motion, all four "
                "components of (20), and z2' = V at tau and tau + tau_1",
       .assumptions = {named_B, named_C, starts_with_belt, assumed_line(1), assumed_line(2), assumed_line(3),
                       assumed_line(4), assumed_line(5)},
       .prove = by_combination(
           {state,
            joined({{from("56.B"), 0, row(4)}}, gap_from_line(4, 1)),
            joined({{from("20.slips"), 0, row(4)}}, gap_from_line(5, 1))})},
  };
}

// The cofactor of the coefficient in equation j, column k of (a, b, c).
Term cofactor(int j, int k) {
  const std::string columns = "abc";
  const auto at = [&](int row_step, int column_step) {
    return coefficient(columns[static_cast<std::size_t>((k - 1 + column_step) % 3)],
                       (j - 1 + row_step) % 3 + 1);
  };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}

// Delta times unknown k, less Delta_k, is this sum of the equations; times a factor.
std::vector<Multiple> by_cramer(int k, const Term& factor) {
  std::vector<Multiple> result;
  for (int j = 1; j <= 3; ++j) {
    result.push_back({assuming(line(j)), 0, factor * cofactor(j, k)});
  }
  return result;
}

Statement compatible(int i) {
  return equation(coefficient('a', i) * Delta1 + coefficient('b', i) * Delta2 + coefficient('c', i) * Delta3 +
                      coefficient('d', i) * Delta,
                  0);
}

// F_k from equation k + 3 and, by Cramer's rule, the first three.
std::vector<Multiple> necessary(int i) {
  std::vector<Multiple> result{{assuming(line(i)), 0, Delta}};
  for (int k = 1; k <= 3; ++k) {
    result = joined(result, by_cramer(k, -coefficient("abc"[k - 1], i)));
  }
  return result;
}

std::vector<GiNaC::ex> determinants() {
  model::ClosingCoefficients<GiNaC::ex> k;
  for (int i = 1; i <= 5; ++i) {
    const auto at = [i](char letter) { return symbolically()(coefficient(letter, i).name()); };
    const auto place = static_cast<std::size_t>(i - 1);
    k.a[place] = at('a');
    k.b[place] = at('b');
    k.c[place] = at('c');
    k.d[place] = at('d');
  }
  const model::CramerDeterminants<GiNaC::ex> c = model::cramer<GiNaC::ex>(k);
  return {c.Delta, c.Delta1, c.Delta2, c.Delta3};
}

std::vector<Claim> solution() {
  const Assumption regular{"22.regular", {Delta, 0, Relation::not_equal}};
  const Assumptions solved{{"22.z10", equation(z10, Delta1 / Delta)},
                           {"22.z20", equation(z20, Delta2 / Delta)},
                           {"22.zdot10", equation(zdot10, Delta3 / Delta)},
                           regular};
  Assumptions compatible_too = solved;
  compatible_too.push_back({"23.1", compatible(4)});
  compatible_too.push_back({"23.2", compatible(5)});
  return {
      {.id = "22.Delta",
       .place = sec,
       .kind = Kind::definition,
       .printed = {equation(Delta, determinant_of_columns({"a", "b", "c"})),
                   equation(Delta1, determinant_of_columns({"-d", "b", "c"})),
                   equation(Delta2, determinant_of_columns({"d", "a", "c"})),
                   equation(Delta3, determinant_of_columns({"d", "b", "a"}))},
       .words = "the determinants of the first three equations",
       .prove = by_formulas(determinants),
       .illegible = "the letter Delta, and which of the d_j in Delta_1 have a minus sign"},
      {.id = "22",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(z10, Delta1 / Delta), equation(z20, Delta2 / Delta),
                   equation(zdot10, Delta3 / Delta)},
       .words = "Cramer's rule for the first three equations",
       .assumptions = {assumed_line(1), assumed_line(2), assumed_line(3), regular},
       .prove = by_combination({by_cramer(1, 1 / Delta), by_cramer(2, 1 / Delta), by_cramer(3, 1 / Delta)}),
       .illegible = "the letter Delta, and the inequality sign in Delta != 0"},
      {.id = "22.back",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(closing_form(1), 0), equation(closing_form(2), 0), equation(closing_form(3), 0)},
       .words = "conversely (22) solves them",
       .assumptions = solved,
       .prove = by_normal_form()},
      {.id = "23",
       .place = sec,
       .kind = Kind::step,
       .printed = {compatible(4), compatible(5)},
       .words = "F_1 = 0 and F_2 = 0 are necessary for all five equations to have a solution, also where Delta "
                "is zero",
       .assumptions = {assumed_line(1), assumed_line(2), assumed_line(3), assumed_line(4), assumed_line(5)},
       .prove = by_combination({necessary(4), necessary(5)})},
      {.id = "23.back",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(closing_form(4), 0), equation(closing_form(5), 0)},
       .words = "conversely (22) and (23) solve the other two equations, if Delta is not zero",
       .assumptions = compatible_too,
       .prove = by_combination({{{assuming("23.1"), 0, 1 / Delta}}, {{assuming("23.2"), 0, 1 / Delta}}})},
  };
}

void append(std::vector<Claim>& claims, std::vector<Claim> more) {
  claims.insert(claims.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Claim> section5() {
  std::vector<Claim> claims = conditions();
  append(claims, motion());
  append(claims, linear_equations());
  append(claims, solution());
  return claims;
}

}  // namespace stickslip::proofs
