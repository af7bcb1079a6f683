// Beyond Appendix 5: its conclusion with weaker hypotheses, and a stronger theorem by another route.
#include "proofs/methods/calculus.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/appendix5.hpp"

namespace stickslip::proofs::pascal2012::two_slips {

using namespace methods;
using namespace symbols;

namespace {

// Mode j of a vector of places or speeds.
Term mode(const Term& row, const Term& vector) {
  return row * inverse(Lambda) * vector;
}

// What one mode contributes: frequency, eigenvector, row.
struct Mode {
  Term frequency, eigenvector, row;
  std::size_t number;

  [[nodiscard]] Term alpha() const { return frequency * tau / 2; }
  [[nodiscard]] Term beta() const { return frequency * tau1 / 2; }
};

const Mode first{omega1, psi1, first_row, 0}, second{omega2, psi2, second_row, 1};

// sin(alpha) y = omega_j cos(alpha) x for xi_1 = (x, y) in mode j, and the like for xi_2.
Statement relation1(const Mode& m) {
  return equation(sin(m.alpha()) * mode(m.row, Y1), m.frequency * cos(m.alpha()) * mode(m.row, X1));
}
Statement relation2(const Mode& m) {
  return equation(sin(m.beta()) * mode(m.row, Y2), -m.frequency * cos(m.beta()) * mode(m.row, X2));
}

// The combination a * relation1 + b * (relation2 at xi_1 = xi_2) in mode j.
std::vector<Multiple> both_relations(const Mode& m, const Term& a, const Term& b) {
  const Term row = m.row * inverse(Lambda);
  return {{from("65.modes"), m.number, m.eigenvector * a},
          {from("65.modes"), m.number + 2, m.eigenvector * b},
          {from("61"), 1, m.eigenvector * (b * sin(m.beta())) * (row * bottom)},
          {from("61"), 1, m.eigenvector * (b * m.frequency * cos(m.beta())) * (row * top)}};
}

// Solved for X_1 or Y_1: the determinant of the two relations is omega_j sin(alpha + beta).
std::vector<Multiple> solved(bool for_place) {
  std::vector<Multiple> all;
  for (const Mode& m : {first, second}) {
    const Term S = sin(m.frequency * Theta / 2);
    const std::vector<Multiple> part =
        for_place ? both_relations(m, -sin(m.beta()) / (m.frequency * S), sin(m.alpha()) / (m.frequency * S))
                  : both_relations(m, cos(m.beta()) / S, cos(m.alpha()) / S);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::vector<Multiple> and_also(std::vector<Multiple> all, const Multiple& one) {
  all.push_back(one);
  return all;
}

// (2) for two motions x and y under frictions u and w and the same load.
const Term x1 = scalar("x1"), x2 = scalar("x2"), xdot1 = scalar("xdot1"), xdot2 = scalar("xdot2"),
           y1 = scalar("y1"), y2 = scalar("y2"), ydot1 = scalar("ydot1"), ydot2 = scalar("ydot2"),
           u = scalar("u"), w = scalar("w");

std::vector<Statement> two_motions() {
  const Term load = p * cos(omega * t + phi);
  return {equation(x1, xdot1),
          equation(x2, xdot2),
          equation(xdot1, -x1 + chi * x2),
          equation(xdot2, -chi * eta * (x2 - x1) + eta * u + load),
          equation(y1, ydot1),
          equation(y2, ydot2),
          equation(ydot1, -y1 + chi * y2),
          equation(ydot2, -chi * eta * (y2 - y1) + eta * w + load)};
}

const Term energy = power(xdot1 - ydot1, 2) / 2 + power(xdot2 - ydot2, 2) / (2 * eta) +
                    power(x1 - y1, 2) / 2 - chi * (x1 - y1) * (x2 - y2) + chi * power(x2 - y2, 2) / 2;

// The sides on which x and y slip, +1 below the belt and -1 above, and how much slower than it they are.
const Term side_x = scalar("side_x"), side_y = scalar("side_y"), gap_x = scalar("gap_x"),
           gap_y = scalar("gap_y");
const Term delta = vector("delta", 4);
const Function difference{"delta", {4, 1}};

const Assumption friction_x{"4.x", equation(u, us *side_x)}, friction_y{"4.y", equation(w, us *side_y)},
    slips_x{"4.gap.x", equation(xdot2, V - side_x * gap_x)},
    slips_y{"4.gap.y", equation(ydot2, V - side_y * gap_y)},
    one_side_x{"4.side.x", equation(power(side_x, 2), 1)},
    one_side_y{"4.side.y", equation(power(side_y, 2), 1)},
    moves_x{"4.moves.x", {gap_x, 0, Relation::greater}}, moves_y{"4.moves.y", {gap_y, 0, Relation::greater}},
    returns{"A5.returns", equation(difference(Theta), delta)},
    free_difference{"A5.same", equation(delta, H(Theta) * delta)},
    same_friction{"A5.frictions", equation(u, w)}, begins{"A5.begins", equation(difference(0), delta)};

// (4) for two motions that never stick: u = u_s sign(V - x2'), w = u_s sign(V - y2').
const std::vector<Assumption> both_slip{friction_x, friction_y, slips_x, slips_y,
                                        one_side_x, one_side_y, moves_x, moves_y};

std::vector<Assumption> both_slip_and(std::vector<Assumption> more) {
  more.insert(more.begin(), both_slip.begin(), both_slip.end());
  return more;
}

// The energy of the difference never grows.
std::vector<Claim> decrease() {
  const Term sides = side_x - side_y, weight = us / 2 * (gap_x + gap_y);
  const Term power_of_friction = (xdot2 - ydot2) * (u - w);
  return {
      {.id = "A5.energy",
       .kind = Kind::identity,
       .printed = {equation(derivative(energy), power_of_friction)},
       .words = "two motions $x$ and $y$ by (2) under the same load, with frictions $u$ and $w$: the energy "
                "of their difference changes at the rate $(x2' - y2')(u - w)$",
       .prove = by_rate_of_change(energy, two_motions())},
      {.id = "A5.sign",
       .kind = Kind::step,
       .printed = {equation(power_of_friction, -(weight * power(sides, 2)))},
       .words =
           "while neither sticks the rate is never positive, and zero only if both slip on the same side",
       .assumptions = both_slip,
       .prove = by_combination({{{assuming("4.side.x"), 0, us / 2 * (gap_y - gap_x)},
                                 {assuming("4.side.y"), 0, us / 2 * (gap_x - gap_y)}}})},
      {.id = "A5.weight",
       .kind = Kind::step,
       .printed = {{weight, 0, Relation::greater}},
       .words = "the weight is positive",
       .assumptions = {moves_x, moves_y},
       .prove = by_positive_combination(
           {{.positive = {{us / 2, {{assuming("4.moves.x")}}}, {us / 2, {{assuming("4.moves.y")}}}}}})},
      {.id = "A5.sides",
       .kind = Kind::theorem,
       .printed = {equation(sides, 0)},
       .words = "if both have the period $Theta$, they slip on the same side at almost all times",
       .assumptions = both_slip_and({returns}),
       .prove = by_periodic_decrease({.rate = from("A5.energy"),
                                      .form = from("A5.sign"),
                                      .positive = from("A5.weight"),
                                      .periodic = "A5.returns",
                                      .weight = weight,
                                      .difference = sides,
                                      .motions = {{x1, y1}, {x2, y2}, {xdot1, ydot1}, {xdot2, ydot2}}})},
      {.id = "A5.frictions",
       .kind = Kind::step,
       .printed = {same_friction.statement},
       .words = "so their frictions are equal",
       .assumptions = both_slip_and({returns}),
       .prove = by_combination({{{from("A5.sides"), 0, us}}})},
  };
}

// The difference then moves freely, and is zero.
std::vector<Claim> one_motion() {
  const Term back =
      block(2, {inverse(2 * (I2 - H1(Theta))), zero(2, 2), zero(2, 2), inverse(2 * (I2 - H1(Theta)))});
  return {
      {.id = "A5.difference",
       .kind = Kind::step,
       .printed = {equation(difference(t), H(t) * delta)},
       .words = "the difference of two motions by (2) with equal frictions moves freely",
       .assumptions = {same_friction},
       .prove = by_differential_equation(first_order(K), column({0, 0, 0, eta * (u - w)}), delta)},
      {.id = "A5.same",
       .kind = Kind::step,
       .printed = {free_difference.statement},
       .words = "it returns after $Theta$",
       .assumptions = both_slip_and({returns}),
       .prove = by_rewriting({from("A5.difference")
                                  .at("t", Theta)
                                  .given("A5.frictions", "A5.frictions")
                                  .solved_for(H(Theta) * delta),
                              assuming("A5.returns")})},
      {.id = "A5.free",
       .kind = Kind::step,
       .printed = {equation(delta, zero(4, 1))},
       .words = "a difference that moves freely with period $Theta$ is zero off resonance",
       .assumptions = {off_resonance, free_difference},
       .prove = by_combination({{{assuming("A5.same"), 0, back * (I4 - H(-Theta))}}})},
      {.id = "A5.unique",
       .kind = Kind::theorem,
       .printed = {equation(delta, zero(4, 1))},
       .words = "off resonance there is at most one motion of period $Theta$ that never sticks: for every "
                "$V$, any number of transitions, any $omega$",
       .assumptions = both_slip_and({returns, off_resonance}),
       .prove = by_premises({from("A5.free").given("A5.same", "A5.same")})},
  };
}

// The motion half a period later, and what makes y(t) = -x(t + Theta/2).
const Term later_side = scalar("side_later"), later_gap = scalar("gap_later"), later_u = scalar("u_later"),
           later1 = scalar("x1_later"), later2 = scalar("x2_later"), later_speed = scalar("xdot2_later");
const std::vector<Assumption> opposite{{"A5.y1", equation(y1, -later1)},
                                       {"A5.y2", equation(y2, -later2)},
                                       {"A5.ydot2", equation(ydot2, -later_speed)},
                                       {"A5.w", equation(w, -later_u)},
                                       {"A5.side", equation(side_y, -later_side)},
                                       {"A5.gap", equation(gap_y, later_gap)}};
const Assumption later_friction{"4.later", equation(later_u, us *later_side)},
    later_slips{"4.gap.later", equation(later_speed, V - later_side * later_gap)},
    later_one_side{"4.side.later", equation(power(later_side, 2), 1)},
    later_moves{"4.moves.later", {later_gap, 0, Relation::greater}};

std::vector<Assumption> opposite_and(std::vector<Assumption> more) {
  more.insert(more.begin(), opposite.begin(), opposite.end());
  return more;
}

// At V = 0 the opposite motion half a period later is one as well.
std::vector<Claim> mirror() {
  const Term later = t + Theta / 2;
  const Assumption mirrored{"A5.mirrored", equation(X(t) - (-X(later)), delta)};
  const auto acceleration = [](const Term& place1, const Term& place2, const Term& force, const Term& time) {
    return -chi * eta * (place2 - place1) + eta * force + p * cos(omega * time + phi);
  };
  return {
      {.id = "A5.mirror",
       .kind = Kind::identity,
       .printed = {equation(acceleration(y1, y2, w, t), -acceleration(later1, later2, later_u, later)),
                   equation(-y1 + chi * y2, -(-later1 + chi * later2))},
       .words = "$y(t) = -x(t + Theta/2)$ obeys (2) with the opposite friction: half a period later the load "
                "is the opposite one",
       .assumptions = opposite_and({period}),
       .prove = by_normal_form()},
      {.id = "A5.mirror.friction",
       .kind = Kind::step,
       .printed = {friction_y.statement, slips_y.statement},
       .words = "for $V = 0$ it slips on the other side, just as far from the belt's velocity: that is the "
                "friction which (4) gives it",
       .assumptions = opposite_and({later_friction, later_slips, at_rest}),
       .prove = by_normal_form()},
      {.id = "A5.mirror.side",
       .kind = Kind::step,
       .printed = {one_side_y.statement},
       .words = "it slips on one side at a time",
       .assumptions = opposite_and({later_one_side}),
       .prove = by_combination({{{assuming("4.side.later")}}})},
      {.id = "A5.mirror.moves",
       .kind = Kind::step,
       .printed = {moves_y.statement},
       .words = "and never sticks",
       .assumptions = opposite_and({later_moves}),
       .prove = by_positive_combination({{.positive = {{1, {{assuming("4.moves.later")}}}}}})},
      {.id = "A5.symmetry",
       .kind = Kind::theorem,
       .printed = {equation(X(t), -X(later))},
       .words = "$V = 0$, off resonance: every motion of period $Theta$ that never sticks is symmetric in "
                "space and time, as $X(t)$ and $-X(t + Theta/2)$ are both such motions (A5.mirror) and there "
                "is one only; no count of transitions, no $det P$, no $det H_2$, no $omega != 1$",
       .assumptions = opposite_and({friction_x, slips_x, one_side_x, moves_x, later_friction, later_slips,
                                    later_one_side, later_moves, at_rest, returns, off_resonance, mirrored}),
       .prove = by_rewriting(
           {assuming("A5.mirrored").solved_for(X(t)), from("A5.unique")
                                                          .given("4.y", "A5.mirror.friction")
                                                          .given("4.gap.y", "A5.mirror.friction")
                                                          .given("4.side.y", "A5.mirror.side")
                                                          .given("4.moves.y", "A5.mirror.moves")})},
  };
}

}  // namespace

std::vector<Claim> weaker_hypotheses() {
  const std::vector<Multiple> X = solved(true), Y = solved(false);
  return {
      {.id = "65.modes",
       .kind = Kind::identity,
       .printed = {relation1(first), relation1(second), relation2(first), relation2(second)},
       .words = "(60) mode by mode, with half the angles: nothing is divided by",
       .assumptions = cycle,
       .prove = by_normal_form()},
      {.id = "65.sharp",
       .kind = Kind::theorem,
       .printed = {equation(X1, zero(2, 1)), equation(Y1, zero(2, 1)), equation(X2, zero(2, 1)),
                   equation(Y2, zero(2, 1))},
       .words = "$xi_1 = xi_2 = 0$ off resonance, whatever $tau$: neither $det H_2$ nor $det P$ is needed",
       .assumptions = cycle_and({off_resonance}),
       .prove =
           by_combination({X, Y, and_also(X, {from("61"), 1, -top}), and_also(Y, {from("61"), 1, -bottom})})},
  };
}

std::vector<Claim> uniqueness() {
  std::vector<Claim> claims = decrease();
  for (std::vector<Claim> more : {one_motion(), mirror()}) {
    std::move(more.begin(), more.end(), std::back_inserter(claims));
  }
  return claims;
}

}  // namespace stickslip::proofs::pascal2012::two_slips
