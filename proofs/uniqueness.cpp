// Beyond Appendix 5: its conclusion with weaker hypotheses, and a stronger theorem by another route.
#include "proofs/appendix5.hpp"
#include "proofs/implications.hpp"

namespace stickslip::proofs::two_slips {
namespace {

const std::string A5 = "A5";

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

}  // namespace

std::vector<Claim> weaker_hypotheses() {
  const std::vector<Multiple> X = solved(true), Y = solved(false);
  return {
      {.id = "65.modes",
       .place = A5,
       .kind = Kind::identity,
       .printed = {relation1(first), relation1(second), relation2(first), relation2(second)},
       .words = "(60) mode by mode, with half the angles: nothing is divided by",
       .assumptions = cycle,
       .prove = by_normal_form()},
      {.id = "65.sharp",
       .place = A5,
       .kind = Kind::theorem,
       .printed = {equation(X1, zero(2, 1)), equation(Y1, zero(2, 1)), equation(X2, zero(2, 1)),
                   equation(Y2, zero(2, 1))},
       .words = "xi_1 = xi_2 = 0 off resonance, whatever tau: neither det H_2 nor det P is needed",
       .assumptions = cycle_and({off_resonance}),
       .prove =
           by_combination({X, Y, and_also(X, {from("61"), 1, -top}), and_also(Y, {from("61"), 1, -bottom})})},
  };
}

std::vector<Claim> uniqueness() {
  const Assumption free_difference{"A5.same", equation(vector("delta", 4), H(Theta) * vector("delta", 4))};
  const Term back =
      block(2, {inverse(2 * (I2 - H1(Theta))), zero(2, 2), zero(2, 2), inverse(2 * (I2 - H1(Theta)))});
  return {
      {.id = "A5.energy",
       .place = A5,
       .kind = Kind::identity,
       .printed = {equation(derivative(energy), (xdot2 - ydot2) * (u - w))},
       .words = "two motions x and y by (2) under the same load, with frictions u and w: the energy of their "
                "difference changes at the rate (x2' - y2')(u - w)",
       .prove = by_rate_of_change(energy, two_motions())},
      {.id = "A5.opposite",
       .place = A5,
       .kind = Kind::step,
       .printed = {{(xdot2 - ydot2) * (us - (-us)), 0, Relation::less}},
       .words = "while x2' < V < y2', u = u_s and w = -u_s: the energy falls; likewise the other way round, "
                "and it "
                "stays while both frictions are equal",
       .assumptions = {{"4.below", {V, xdot2, Relation::greater}},
                       {"4.above", {ydot2, V, Relation::greater}}},
       .prove = by_positive_combination(
           {{.positive = {{2 * us, {{assuming("4.below")}}}, {2 * us, {{assuming("4.above")}}}}}})},
      {.id = "A5.free",
       .place = A5,
       .kind = Kind::step,
       .printed = {equation(vector("delta", 4), zero(4, 1))},
       .words = "a difference that moves freely with period Theta is zero off resonance",
       .assumptions = {off_resonance, free_difference},
       .prove = by_combination({{{assuming("A5.same"), 0, back * (I4 - H(-Theta))}}})},
      {.id = "A5.mirror",
       .place = A5,
       .kind = Kind::identity,
       .printed = {equation(p * cos(omega * (t + pi() / omega) + phi), -p * cos(omega * t + phi))},
       .words =
           "half a period later the load is the opposite one; for V = 0 so is the friction of the opposite "
           "motion: -X(t + Theta/2) is a motion too, and never sticks if X never does",
       .prove = by_normal_form()},
  };
}

}  // namespace stickslip::proofs::two_slips
