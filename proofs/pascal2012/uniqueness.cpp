// Beyond Appendix 5: its conclusion with weaker hypotheses, and a stronger theorem by another route.
#include "proofs/methods/implications.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/appendix5.hpp"

namespace stickslip::proofs::pascal2012::two_slips {

using namespace methods;
using namespace symbols;

Assumption slips_with_friction(const std::string& id, const Term& motion, const Term& speed,
                               const Term& end) {
  const Term force = eta * us * sign(V - speed) + p * cos(omega * t + phi);
  return {id, almost_always(
                  0, end, equation(derivative(motion), first_order(K) * motion + column({0, 0, 0, force})))};
}

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

// The row of relation1, or of relation2 for sign -1.
Term both_rows(const Mode& m, int sign) {
  const Term angle = sign > 0 ? m.alpha() : m.beta(), row = m.row * inverse(Lambda);
  return sin(angle) * (row * bottom) - sign * m.frequency * cos(angle) * (row * top);
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

// A component of X or Y.
Term of_time(const char * name) {
  return Function{name, {}}(t);
}
const Term x1 = of_time("x1"), x2 = of_time("x2"), xdot1 = of_time("xdot1"), xdot2 = of_time("xdot2"),
           y1 = of_time("y1"), y2 = of_time("y2"), ydot1 = of_time("ydot1"), ydot2 = of_time("ydot2");

const Assumption law_x = slips_with_friction("4.x", X(t), xdot2, Theta),
                 law_y = slips_with_friction("4.y", Y(t), ydot2, Theta),
                 returns_x{"A5.returns.x", equation(X(Theta), X(0))},
                 returns_y{"A5.returns.y", equation(Y(Theta), Y(0))};
const std::vector<Assumption> two_periodic_motions{law_x, law_y, returns_x, returns_y};

std::vector<Assumption> two_motions_and(std::vector<Assumption> more) {
  more.insert(more.begin(), two_periodic_motions.begin(), two_periodic_motions.end());
  return more;
}

const Term energy = power(xdot1 - ydot1, 2) / 2 + power(xdot2 - ydot2, 2) / (2 * eta) +
                    power(x1 - y1, 2) / 2 - chi * (x1 - y1) * (x2 - y2) + chi * power(x2 - y2, 2) / 2;
const Term side_x = sign(V - xdot2), side_y = sign(V - ydot2);

// The energy of the difference never grows, so the frictions are equal.
std::vector<Claim> decrease() {
  return {
      {.id = "A5.energy",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .printed = {almost_always(0, Theta,
                                 equation(derivative(energy), us * (xdot2 - ydot2) * (side_x - side_y)))},
       .words = "the energy of the difference of two motions by (2) and (4) that never stick, under the same "
                "load, changes at the rate $(x2' - y2')$ times the difference of the frictions",
       .assumptions = {law_x, law_y},
       .prove = by_chain_rule({assuming("4.x"), assuming("4.y")})},
      {.id = "A5.stable",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {{substitute(energy, {{"t", Theta}}), substitute(energy, {{"t", 0}}),
                    Relation::less_or_equal}},
       .words = "two motions that do not stick do not move apart, in the norm of this energy, over any time "
                "$Theta$: an orbit that never sticks may be neutral, but is not linearly unstable",
       .assumptions = {law_x, law_y, {"Theta.positive", {Theta, 0, Relation::greater}}},
       .prove = by_decrease(from("A5.energy"), 2 * us)},
      {.id = "A5.sides",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .printed = {almost_always(0, Theta, equation(side_x, side_y))},
       .words = "if both have the period $Theta$, they slip on the same side at almost all times: else their "
                "energy would decrease and not come back",
       .assumptions = two_periodic_motions,
       .prove = by_periodic_decrease(
           {.rate = from("A5.energy"), .returns = {"A5.returns.x", "A5.returns.y"}, .weight = 2 * us})},
  };
}

// A difference that moves freely, of period Theta, is zero.
std::vector<Claim> free_motion() {
  const Function delta{"delta", {4, 1}};
  const Assumption moves_freely{
      "A5.moves", almost_always(0, Theta, equation(derivative(delta(t)), first_order(K) * delta(t)))},
      returns{"A5.returns", equation(delta(Theta), delta(0))};
  // (2 (I - H_1(Theta)))^-1 by modes, which divides by the sines alone.
  const auto halves = [](const Term& frequency) { return 1 / (4 * power(sin(frequency * Theta / 2), 2)); };
  const Term inverted = Lambda * block(2, {halves(omega1), 0, 0, halves(omega2)}) * inverse(Lambda);
  const Term back = block(2, {inverted, zero(2, 2), zero(2, 2), inverted});
  const Term start = H(t) * back * (I4 - H(-Theta));
  return {
      {.id = "A5.difference",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(delta(t), H(t) * delta(0))},
       .words = "what moves freely at almost all times, and continuously, moves by $H$",
       .assumptions = {moves_freely, not_before(t, 0), not_after(t, Theta)},
       .prove = by_differential_equation({"A5.moves", "", H, zero(4, 1)})},
      {.id = "A5.free",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(delta(t), zero(4, 1))},
       .words = "a difference that moves freely with period $Theta$ is zero off resonance",
       .assumptions = {moves_freely, returns, off_resonance, not_before(t, 0), not_after(t, Theta)},
       .prove = by_instances({{.premise = from("A5.difference")},
                              {.premise = from("A5.difference").at("t", Theta), .left = start},
                              {.premise = assuming("A5.returns"), .left = -start}})},
  };
}

std::vector<Claim> one_motion() {
  return {
      {.id = "A5.moves",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {almost_always(0, Theta,
                                 equation(derivative(X(t) - Y(t)), first_order(K) * (X(t) - Y(t))))},
       .words = "with equal frictions the difference of two motions moves freely",
       .assumptions = two_periodic_motions,
       .prove = by_chain_rule({assuming("4.x"), assuming("4.y"), from("A5.sides")})},
      {.id = "A5.unique",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(X(t), Y(t))},
       .words = "off resonance there is at most one motion of period $Theta$ that never sticks: for every "
                "$V$, any finite number of transitions, any $omega$",
       .assumptions = two_motions_and({off_resonance, not_before(t, 0), not_after(t, Theta)}),
       .prove = by_instances({{.premise = from("A5.free"),
                               .functions = {{"delta", X(t) - Y(t)}},
                               .supplied = {from("A5.moves")}}})},
  };
}

// At V = 0 the opposite motion half a period later is one as well.
std::vector<Claim> mirror() {
  const Term later = t + Theta / 2, longer = 3 * Theta / 2;
  const Assumption law = slips_with_friction("4.x", X(t), xdot2, longer),
                   still_returns{"A5.returns.later", equation(X(longer), X(Theta / 2))};
  return {
      {.id = "A5.mirror",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {slips_with_friction("", -X(later), component(3, -X(later)), Theta).statement},
       .words = "for $V = 0$ the motion $-X(t + Theta/2)$ obeys (2) and (4), too: half a period later the "
                "load is the opposite one",
       .assumptions = {law, at_rest, period},
       .prove = by_chain_rule({assuming("4.x")}, Theta / 2)},
      {.id = "A5.symmetry",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(X(t), -X(later))},
       .words = "$V = 0$, off resonance: every motion of period $Theta$ that never sticks is symmetric in "
                "space and time, as $X(t)$ and $-X(t + Theta/2)$ are both such motions and there is one "
                "only; no count of transitions, no $det P$, no $det H_2$, no $omega != 1$",
       .assumptions = {law, returns_x, still_returns, at_rest, period, off_resonance, not_before(t, 0),
                       not_after(t, Theta)},
       .prove = by_instances({{.premise = from("A5.unique"),
                               .functions = {{"Y", -X(later)}},
                               .supplied = {from("A5.mirror")}}})},
  };
}

}  // namespace

std::vector<Claim> weaker_hypotheses() {
  const std::vector<Multiple> X = solved(true), Y = solved(false);
  return {
      {.id = "65.modes",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {relation1(first), relation1(second), relation2(first), relation2(second)},
       .words = "(60) mode by mode, with half the angles: nothing is divided by",
       .assumptions = cycle,
       .prove = by_combination({{{from("57"), 0, both_rows(first, 1)}},
                                {{from("57"), 0, both_rows(second, 1)}},
                                {{from("57"), 1, both_rows(first, -1)}},
                                {{from("57"), 1, both_rows(second, -1)}}})},
      {.id = "65.sharp",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(X1, zero(2, 1)), equation(Y1, zero(2, 1)), equation(X2, zero(2, 1)),
                   equation(Y2, zero(2, 1))},
       .words = "$xi_1 = xi_2 = 0$ off resonance, whatever $tau$: neither $det H_2$ nor $det P$ is needed",
       .assumptions = cycle_and({off_resonance}),
       .prove =
           by_combination({X, Y, and_also(X, {from("61"), 1, -top}), and_also(Y, {from("61"), 1, -bottom})})},
  };
}

std::vector<Claim> uniqueness() {
  return joined({decrease(), free_motion(), one_motion(), mirror()});
}

}  // namespace stickslip::proofs::pascal2012::two_slips
