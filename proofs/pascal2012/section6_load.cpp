// Section 6, (36) and (37): which loads keep the mass from sticking.
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/half_period.hpp"

namespace stickslip::proofs::pascal2012::half_period {

using namespace methods;
using namespace symbols;

namespace {

const Assumption at_start{"25", inequality25}, at_end{"26", inequality26}, both{"36", inequality36};

const Statement sharp{power(p, 2), power(bound, 2) * (power(B, 2) + power(eta * ur / omega, 2)),
                      Relation::greater};
const Statement pushes{q2 * cos(phi), 0, Relation::greater};

std::vector<Assumption> closed_motion(std::vector<Assumption> more) {
  more.insert(more.begin(), regular);
  return motion_and(std::move(more));
}

std::vector<Assumption> moving_motion(std::vector<Assumption> more) {
  more.insert(more.begin(), {starts_with_belt, meets_belt});
  return closed_motion(more);
}

const Term push = power(omega, 2) * q2 * cos(phi);

// What x2' would be on the first slip without the load's push, by 37.speed.
Term share(const Term& frequency, const Term& phi_i) {
  return frequency * sin(frequency * t) - phi_i * (cos(frequency * t) - cos(omega * t));
}
const Term unpushed =
    us / ((1 - chi) * (power(omega2, 2) - power(omega1, 2))) *
    (lambda1 * power(omega2, 2) * share(omega1, phi1) - lambda2 * power(omega1, 2) * share(omega2, phi2));
const Term pushed = q2 * omega * cos(phi) * sin(omega * t);

// (q_2 omega sin(phi))^2 - B^2, times a coefficient, is a multiple of (35).
Multiple from_35(const Term& coefficient) {
  return {from("35"), 0, coefficient * power(q2 * omega, 2) * (sin(phi) - B / (q2 * omega))};
}

// p^2 - (bound q_2 omega)^2, times a coefficient, is a multiple of the difference of p and bound q_2 omega.
Multiple from_load(const Term& coefficient) {
  return {from("37.p"), 0, coefficient * (p + bound * q2 * omega)};
}

// A point where (37) holds and (36) fails: the load is given by (35), u_r is large.
Counterexample weak_load() {
  const Term load = -bound * B / sin(phi);
  const Term second = load * (1 - power(omega, 2)) / D;
  return {.point = {{"omega1", Rational(1, 2)},
                    {"omega2", Rational(2)},
                    {"omega", Rational(3, 5)},
                    {"phi", Rational(29, 10)},
                    {"us", Rational(1, 10)},
                    {"ur", Rational(5)}},
          .values = {equation(p, load), equation(q1, chi * load / D), equation(q2, second)},
          .true_there = {load_acts.statement,
                         inequality37,
                         equation(sin(phi), -B / (q2 * omega)),
                         pushes,
                         {ur, us, Relation::greater}},
          .false_there = {inequality36}};
}

std::vector<Claim> condition36() {
  const Term lever = chi * eta * block(1, {-1, 1});
  return {
      {.id = "36",
       .kind = Kind::condition,
       .printed = {inequality36},
       .words = "(25) in closed form",
       .assumptions = closed_motion({at_start}),
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("25")}}}},
             .equations = {{from("34"), 0, chi * eta}, {from("34"), 1, -chi * eta}}}})},
      {.id = "36.26",
       .kind = Kind::condition,
       .printed = {inequality36},
       .words = "(26) in closed form is the same condition",
       .assumptions = closed_motion({at_end}),
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("26")}}}}, .equations = {{from("31"), 0, lever}}}})},
      {.id = "36.back",
       .kind = Kind::condition,
       .printed = {inequality25, inequality26},
       .words = "conversely (36) gives (25) and (26): the three are equivalent for a motion that closes",
       .assumptions = closed_motion({both}),
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("36")}}}},
             .equations = {{from("34"), 0, -chi * eta}, {from("34"), 1, chi * eta}}},
            {.positive = {{1, {{assuming("36")}}}}, .equations = {{from("31"), 0, -lever}}}})},
      {.id = "36.q2",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(chi * eta * (q2 - q1) - p, power(omega, 2) * q2)},
       .words = "the second row of $(K - omega^2 I) Q = (0, p)$: (36) is $omega^2 q_2 cos(phi) > eta u_r$",
       .prove = by_normal_form()},
      {.id = "36.load",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {pushes},
       .words = "(36) holds only if $q_2$ is not zero: neither $p = 0$ nor $omega = 1$, where (35) would not "
                "determine $phi$, allows a motion that never sticks",
       .assumptions = {both},
       .prove = by_positive_combination(
           {{.positive = {{1 / power(omega, 2), {{assuming("36")}}}, {eta * ur / power(omega, 2)}},
             .equations = {{from("36.q2"), 0, -cos(phi) / power(omega, 2)}}}})},
      {.id = "36.square",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {{power(push, 2), power(eta * ur, 2), Relation::greater}},
       .words = "the square of (36)",
       .assumptions = {both},
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("36")}, {assuming("36")}}}, {2 * eta * ur, {{assuming("36")}}}},
             .equations = {{from("36.q2"), 0,
                            -cos(phi) * (push + chi * eta * (q2 - q1) * cos(phi) - p * cos(phi))}}}})},
      {.id = "35.bound",
       .kind = Kind::condition,
       .printed = {{abs(B / (q2 * omega)), 1, Relation::less}},
       .words = "a phase $phi$ exists; the case of equality is excluded by (36)",
       .assumptions = moving_motion({both}),
       .prove = by_positive_combination(
           {{.positive = {{1 / power(omega, 2), {{from("36.square")}}}, {power(eta * ur / omega, 2)}},
             .equations = {from_35(1)},
             .divisors = {{power(q2 * omega, 2)}}}})},
  };
}

std::vector<Claim> condition37() {
  const Term square = power(bound, 2);
  const Term rest = power(eta * ur / omega, 2);
  return {
      {.id = "37.p",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(p, bound * q2 * omega)},
       .words = "(7) solved for the load amplitude",
       .prove = by_normal_form()},
      {.id = "37",
       .kind = Kind::condition,
       .printed = {inequality37},
       .words = "the load amplitude that (36) needs",
       .assumptions = moving_motion({load_acts, both}),
       .prove = by_positive_combination({{.positive = {{1, {{from("37.sharp")}}}, {square * rest}}}},
                                        assuming("1.p"))},
      {.id = "37.enough",
       .kind = Kind::condition,
       .origin = Origin::reading,
       .printed = {inequality36},
       .words = "a load above the bound (37) is enough for (36), with the phase of (35)",
       .assumptions = {load_acts,
                       {"37", inequality37},
                       {"35", equation(sin(phi), -B / (q2 * omega))},
                       {"36.load", pushes},
                       {"4.ur", {ur, us, Relation::greater}}},
       .prove = by_counterexample(weak_load())},
      {.id = "37.sharp",
       .kind = Kind::condition,
       .origin = Origin::new_result,
       .printed = {sharp},
       .words = "what (36) and (35) say about the load amplitude",
       .assumptions = moving_motion({both}),
       .prove = by_positive_combination({{.positive = {{square / power(omega, 2), {{from("36.square")}}}},
                                          .equations = {from_35(square), from_load(1)}}})},
      {.id = "37.sharp.back",
       .kind = Kind::condition,
       .origin = Origin::new_result,
       .printed = {inequality36},
       .words = "conversely that amplitude gives (36), for the one of the two phases $phi$ allowed by (35) "
                "for which $q_2 cos(phi)$ is positive",
       .assumptions = moving_motion({{"37.sharp", sharp}, {"36.load", pushes}}),
       .prove =
           by_positive_combination({{.positive = {{power(omega, 2) / square, {{assuming("37.sharp")}}}},
                                     .equations = {from_35(-power(omega, 2)),
                                                   from_load(-power(omega, 2) / square),
                                                   {from("36.q2"), 0, cos(phi) * (push + eta * ur)}},
                                     .divisors = {{power(omega, 2), {{assuming("36.load")}}}, {eta * ur}}}})},
      {.id = "37.speed",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(block(1, {0, 0, 0, 1}) * (H(t) * (Z0 - F0) + F(t)), unpushed - pushed)},
       .words =
           "the speed of the second mass on the first slip: $x2' < 0$ there exactly if $q_2 omega cos(phi)$ "
           "exceeds, for all $0 < t < pi/omega$, what the other terms give divided by $sin(omega t)$",
       .assumptions = moving_motion({}),
       .prove = by_combination({{{from("33"), 0, second_row * H3(t)},
                                 {from("33"), 2, second_row * H1(t)},
                                 {from("35"), 0, -q2 * omega * cos(omega * t)}}})},
  };
}

// What x2' < 0 at a time of the slip, by 37.speed, says about the load amplitude: as (36) does by 37.sharp.
std::vector<Claim> load_of_the_slip() {
  const Term square = power(bound, 2), sine = sin(omega * t), g = scalar("g");
  const Statement enough{power(p * sine, 2), square * (power(B * sine, 2) + power(g, 2)), Relation::greater};
  const Statement below{g, pushed, Relation::less};
  const Assumption without_push{"37.g", equation(g, unpushed)}, slips{"37.speed", below},
      pushes_down{"36.load", pushes}, within{"37.within", {sine, 0, Relation::greater}},
      rises{"37.rises", {g, 0, Relation::greater}}, falls{"37.falls", {g, 0, Relation::less_or_equal}};
  const Positive push_down{omega, {{assuming("36.load")}, {assuming("37.within")}}};
  return {
      {.id = "37.slip",
       .kind = Kind::condition,
       .origin = Origin::new_result,
       .printed = {enough},
       .words = "what $x2' < 0$ and (35) say about the load amplitude at a time of the slip at which without "
                "the load's push $x2'$ would be $g > 0$: 37.sharp with $g/sin(omega t)$ in place of $eta "
                "u_r/omega$",
       .assumptions = moving_motion({without_push, slips, rises}),
       .prove = by_positive_combination(
           {{.positive = {{square, {{assuming("37.speed")}, {assuming("37.speed")}}},
                          {2 * square, {{assuming("37.rises")}, {assuming("37.speed")}}}},
             .equations = {from_35(square * power(sine, 2)), from_load(power(sine, 2))}}})},
      {.id = "37.slip.back",
       .kind = Kind::condition,
       .origin = Origin::new_result,
       .printed = {below},
       .words = "conversely that amplitude gives $x2' < 0$ at that time, for the phase $phi$ for which $q_2 "
                "cos(phi)$ is positive",
       .assumptions = moving_motion({without_push, pushes_down, within, rises, {"37.slip", enough}}),
       .prove = by_positive_combination(
           {{.positive = {{1 / square, {{assuming("37.slip")}}}},
             .equations = {from_35(-power(sine, 2)), from_load(-power(sine, 2) / square)},
             .divisors = {push_down, {1, {{assuming("37.rises")}}}}}})},
      {.id = "37.slip.free",
       .kind = Kind::condition,
       .origin = Origin::new_result,
       .printed = {below},
       .words = "at all other times of the slip $x2' < 0$ follows from $q_2 cos(phi) > 0$: the least load is "
                "the largest that 37.sharp, and 37.slip at some time, ask for",
       .assumptions = {without_push, pushes_down, within, falls},
       .prove = by_positive_combination({{.positive = {push_down, {1, {{assuming("37.falls")}}}}}})},
  };
}

}  // namespace

std::vector<Claim> section6_load() {
  return joined({condition36(), condition37(), load_of_the_slip()});
}

}  // namespace stickslip::proofs::pascal2012::half_period
