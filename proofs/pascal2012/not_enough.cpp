// The conditions at the ends of phases are not enough for what the motion does between: motions that obey all
// of them, close, and pass the belt's velocity during a slip, or need more friction than there is in a stick.
#include "proofs/methods/implications.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/pascal2012/overshooting.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using Assumptions = std::vector<Assumption>;

Assumptions joined(Assumptions all, const Assumptions& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// What is printed is false at values with which all that is assumed holds, and so is its closed form.
Claim refuted(const std::string& id, const std::string& words, const Assumptions& assumptions,
              const Statement& printed, const Statement& closed_form, const Scene& at) {
  std::vector<Statement> hold;
  for (const Assumption& one : assumptions) {
    hold.push_back(one.statement);
  }
  return {.id = id,
          .kind = Kind::step,
          .printed = {printed},
          .words = words,
          .assumptions = assumptions,
          .prove = by_counterexample({at.point, at.values, hold, {printed, closed_form}})};
}

const Assumption friction_acts{"4.us", {vocabulary::us, 0, Relation::greater}},
    step_of_friction{"4.ur", {vocabulary::ur, vocabulary::us, Relation::greater}};

}  // namespace

namespace half_period {

namespace {

// All that the paper asks of two slips of half a period each but what they do between their ends.
Assumptions all_conditions(const Assumptions& more) {
  return joined({half,
                 period,
                 starts_with_belt,
                 meets_belt,
                 {"25", inequality25},
                 {"26", inequality26},
                 {"36", inequality36},
                 {"37", inequality37},
                 load_acts,
                 friction_acts,
                 step_of_friction},
                more);
}

// A motion of (34) and (35), the load given by its phase, at a time since one of the slips began.
Scene passes_the_belt(const Term& begin) {
  const Term load = -bound * B / sin(phi), first = chi * load / D, second = load * (1 - power(omega, 2)) / D;
  const Term speed = -q1 * omega * sin(phi) - a1 * d01 - a2 * d02;
  return {.point = {{"omega1", Rational(14, 25)},
                    {"omega2", Rational(12, 5)},
                    {"omega", Rational(49, 100)},
                    {"phi", Rational(-1, 5)},
                    {"us", Rational(1, 10)},
                    {"ur", Rational(3, 20)},
                    {"V", Rational(0)},
                    {"zdot20", Rational(0)},
                    {"zdot2B", Rational(0)}},
          .values = {half.statement, period.statement, equation(p, load), equation(q1, first),
                     equation(q2, second), equation(z10, q1 * cos(phi) - d01),
                     equation(z20, q2 * cos(phi) - d02), equation(zdot10, speed),
                     equation(z1B, -q1 * cos(phi) - d01), equation(z2B, -q2 * cos(phi) - d02),
                     equation(zdot1B, -speed), equation(t, begin + Term(49) / 50)}};
}

}  // namespace

std::vector<Claim> not_enough_for_slips() {
  const Term speed = component(3, X(t));
  const Assumptions below = all_conditions({begins,
                                            slips_below,
                                            named_B,
                                            {"28", equation(Z0, H(tau) * (ZB - FB) + 2 * L(tau) * d0 + F0)},
                                            {"t.after", {t, 0, Relation::greater}},
                                            {"t.before", {t, tau, Relation::less}}});
  const Assumptions above = all_conditions({named_B,
                                            overshoots,
                                            closes,
                                            {"28.B", equation(ZB, H(tau) * (Z0 - F0) + FB)},
                                            {"t.after", {t, tau, Relation::greater}},
                                            {"t.before", {t, Theta, Relation::less}}});
  const Term by5 = component(3, H(t) * (Z0 - F0) + F(t)),
             by27 = component(3, H(t - tau) * (ZB - FB) + 2 * L(t - tau) * d0 + F(t));
  return {
      refuted("25.enough",
              "the motion (5) that begins by (25) slips below the belt's velocity on all of $(0, tau)$; "
              "here (26), (36) and (37) hold, too, and the motion closes",
              below, {speed, V, Relation::less}, {by5, V, Relation::less_or_equal}, passes_the_belt(0)),
      refuted("26.enough",
              "the motion (27) that begins by (26) overshoots on all of $(tau, Theta)$; here (25), (36) "
              "and (37) hold, too, and the motion closes",
              above, {speed, V, Relation::greater}, {by27, V, Relation::greater_or_equal},
              passes_the_belt(tau)),
  };
}

}  // namespace half_period

namespace symmetric {

namespace {

// All that the paper asks of a slip and a stick but what they do between their ends.
Assumptions all_conditions(const Assumptions& more) {
  return joined({time_lag,
                 period,
                 slip_takes_time,
                 stick_takes_time,
                 stick_lasts,
                 starts_with_belt,
                 {"12", equation12},
                 {"13.z1", equation(z1C, -z10)},
                 {"13.z2", equation(z2C, -z20)},
                 {"14.lower", {-eta * (ur + us), at_C, Relation::less}},
                 {"14.upper", {at_C, eta * (ur - us), Relation::less}},
                 stick_ends,
                 half_sine,
                 half_cosine,
                 {"16.slip", slip16},
                 {"16.stick", stick16},
                 friction_acts,
                 step_of_friction},
                more);
}

// (16) is linear in the state and the load: where tau and the frequencies are given these are found. It is a
// zdot10 + b p + c = 0 in each mode.
Scene given_slip(const std::vector<Coordinate>& at, const Term& time) {
  const Term turn = tan(T / 2), rest = z20 * chi - turn * chi * V;
  const Term D = half_period::D, first = chi / D, second = (1 - power(omega, 2)) / D;  // Q is p times these
  struct Line {
    Term a, b, c;
  };
  const auto line = [&](const Term& frequency, const Term& r1, const Term& r2) {
    const Term C = cos(frequency * tau / 2), S = sin(frequency * tau / 2) / frequency;
    return Line{r1 * (C * turn + S), (r1 * first + r2 * second) * (S * omega * c0 - C * s0),
                C * (r1 * rest + r2 * z20) + S * r2 * V};
  };
  const Line l = line(omega1, lambda2, -1), m = line(omega2, -lambda1, 1);
  const Term determinant = l.a * m.b - m.a * l.b;
  return {.point = at,
          .values = {period.statement, stick_lasts.statement, time_lag.statement, half_sine.statement,
                     half_cosine.statement, equation(zdot20, V), equation(z20, V * T / 2),
                     equation(zdot10, (m.c * l.b - l.c * m.b) / determinant),
                     equation(p, (m.a * l.c - l.a * m.c) / determinant), equation(q1, first * p),
                     equation(q2, second * p), equation(z10, rest + turn * zdot10), equation(z1C, -z10),
                     equation(z2C, -z20), equation(ur, us + chi * (z20 - z10) - p / eta * cos(phi)),
                     equation(t, time)}};
}

std::vector<Claim> slip_and_stick() {
  const Assumptions slipping = all_conditions({begins,
                                               slips_below,
                                               slip_ends,
                                               {"t.after", {t, 0, Relation::greater}},
                                               {"t.before", {t, tau, Relation::less}}});
  const Assumptions sticking = all_conditions({{"13.slip", slip13},
                                               slip_ends,
                                               sticks,
                                               closes,
                                               {"t.after", {t, tau, Relation::greater}},
                                               {"t.before", {t, Theta, Relation::less}}});
  const Term speed = component(3, X(t)), by5 = component(3, H(t) * (Z0 - F0) + F(t)),
             by10 = Gamma(t - tau) * E * Z0;
  const auto friction = [](const Term& Z) {
    return friction_at_rest(component(0, Z), component(1, Z), omega * t + phi);
  };
  return {
      refuted("12.enough",
              "the motion (5) that begins by (12) slips below the belt's velocity on all of $(0, tau)$; "
              "here (13)-(16) hold, too, (14) strictly",
              slipping, {speed, V, Relation::less}, {by5, V, Relation::less_or_equal},
              given_slip({{"omega1", Rational(2, 3)},
                          {"omega2", Rational(8, 3)},
                          {"omega", Rational(1, 2)},
                          {"tau", Rational(6)},
                          {"us", Rational(1, 50)},
                          {"V", Rational(1)}},
                         Term(21) / 5)),
      refuted("14.enough",
              "the mass sticks from $tau$ to $tau + T$, $|r| < u_r$ on all of it, if (14) holds strictly; "
              "here (12), (13), (15) and (16) hold, too",
              sticking, {abs(friction(Z(t))), ur, Relation::less},
              {friction(by10), ur, Relation::less_or_equal},
              given_slip({{"omega1", Rational(1, 3)},
                          {"omega2", Rational(2)},
                          {"omega", Rational(2, 3)},
                          {"tau", Rational(3)},
                          {"us", Rational(1, 50)},
                          {"V", Rational(1)}},
                         tau + Term(8) / 5)),
  };
}

}  // namespace

}  // namespace symmetric

std::vector<Claim> not_enough_for_slip_and_stick() {
  return symmetric::slip_and_stick();
}

namespace overshooting {

namespace {

// All that the paper asks of a slip, an overshoot and a stick but what they do between their ends.
Assumptions all_conditions(const Assumptions& more) {
  return joined({half_period::period,
                 period,
                 slip_takes_time,
                 overshoot_takes_time,
                 stick_takes_time,
                 starts_with_belt,
                 {"12", at_start},
                 meets_belt,
                 {"18", inequality18},
                 lands_on_belt,
                 {"19.above", above19},
                 {"19.below", below19},
                 {"56.B", equation(ZB, after_slip)},
                 {"20.C", equation(ZC, Gamma(-T) * Z0)},
                 friction_acts,
                 step_of_friction,
                 named_C},
                more);
}

// tau, tau_1 and T are such multiples of pi that all is rational in pi and the load's phase: the closing
// conditions, which are linear in the state at 0, the load and u_s, solved.
Scene given_times(const Term& time) {
  const auto number = [](int numerator, int denominator) { return Term(numerator) / denominator; };
  const Term push = p * sin(phi);
  const Term D = half_period::D;
  std::vector<Statement> values{
      equation(tau, 6 * pi()),
      equation(tau1, 3 * pi()),
      equation(T, 3 * pi()),
      equation(Theta, 12 * pi()),
      equation(p, number(169, 36) / (cos(phi) - sin(phi))),
      equation(q1, chi * p / D),
      equation(q2, (1 - power(omega, 2)) * p / D),
      equation(us, number(13585, 168921) + number(3080, 18769) * push),
      equation(d01, us / (1 - chi)),
      equation(d02, d01 / chi),
      equation(z10, number(21071, 5343) + number(399, 274) * pi() + number(16422, 23153) * push - d01),
      equation(z20, number(3873, 728) + number(3, 2) * pi() + number(3753, 3211) * push - d02),
      equation(zdot10, number(133, 137) - number(64, 137) * push),
      equation(ur, us + chi * (z20 - z10) - p / eta * cos(phi)),
      equation(t, time)};
  const std::vector<std::pair<Term, Term>> states{
      {column({z1B, z2B, scalar("zdot1B"), scalar("zdot2B")}), after_slip},
      {column({z1C, z2C, scalar("zdot1C"), scalar("zdot2C")}), Gamma(-T) * Z0}};
  for (const auto& [names, state] : states) {
    for (std::size_t i = 0; i < 4; ++i) {
      values.push_back(equation(names.arguments()[i], i == 3 ? V : component(i, state)));
    }
  }
  return {.point = {{"omega1", Rational(1, 3)},
                    {"omega2", Rational(13, 6)},
                    {"omega", Rational(1, 6)},
                    {"phi", Rational(-1, 20)},
                    {"V", Rational(1)},
                    {"zdot20", Rational(1)}},
          .values = std::move(values)};
}

std::vector<Claim> three_phases() {
  const Assumptions overshooting = all_conditions({named_B,
                                                   overshoots,
                                                   {"t.after", {t, tau, Relation::greater}},
                                                   {"t.before", {t, tau + tau1, Relation::less}}});
  const Assumptions sticking = all_conditions({{"20.slips", equation(ZC, after_both)},
                                               sticks,
                                               closes,
                                               {"t.after", {t, tau + tau1, Relation::greater}},
                                               {"t.before", {t, Theta, Relation::less}}});
  const Term speed = component(3, X(t)),
             by8 = component(3, H(t - tau) * (ZB - F(tau)) + 2 * L(t - tau) * d0 + F(t)),
             by10 = Gamma(t - tau - tau1) * ZC;
  const auto friction = [](const Term& Z) {
    return half_period::friction_at_rest(component(0, Z), component(1, Z), omega * t + phi);
  };
  return {
      refuted("18.enough",
              "the motion (8) that begins by (18) overshoots on all of $(tau, tau + tau_1)$; here (12), "
              "(19) and (20) hold, too",
              overshooting, {speed, V, Relation::greater}, {by8, V, Relation::greater_or_equal},
              given_times(tau + Term(79) / 10)),
      refuted("19.enough",
              "the mass that begins to stick by (19) sticks until $tau + tau_1 + T$, $|r| < u_r$ on all of "
              "it; here (12), (18) and (20) hold, too",
              sticking, {abs(friction(Z(t))), ur, Relation::less}, {abs(friction(by10)), ur, Relation::less},
              given_times(tau + tau1 + 5)),
  };
}

}  // namespace

}  // namespace overshooting

std::vector<Claim> not_enough_for_three_phases() {
  return overshooting::three_phases();
}

}  // namespace stickslip::proofs::pascal2012
