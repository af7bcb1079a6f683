// Section 2: the model, (1)-(4).
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/pascal2012/printed_example.hpp"
#include "proofs/pascal2012/units.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace symbols::vocabulary;

// Quantities with units: masses, stiffnesses, time, load and friction, velocities.
const Term m1 = scalar("m1"), m2 = scalar("m2"), k1 = scalar("k1"), k2 = scalar("k2"),
           time = scalar("ttilde"), Omega = scalar("Omega"), load = scalar("ptilde"),
           frequency = scalar("omegatilde"), friction = scalar("Ftilde"), belt = scalar("v0"),
           velocity = scalar("v2");
const Function Rtilde{"Rtilde", {1, 1}};

// Dimensionless ones; accelerations are second derivatives by t.
const Term x1 = scalar("x1"), x2 = scalar("x2"), xdot2 = scalar("xdot2"), xddot1 = scalar("xddot1"),
           xddot2 = scalar("xddot2"), u = scalar("u");

const Assumption newton1{"2.newton.1", equation(m1 *power(Omega, 2) * xddot1, -k1 *x1 + k2 * (x2 - x1))},
    newton2{"2.newton.2", equation(m2 *power(Omega, 2) * xddot2,
                                   -k2 *(x2 - x1) + friction + load * cos(frequency * time + phi))};
const Assumption scale{"3.Omega", equation(power(Omega, 2), (k1 + k2) / m1)};
const std::vector<Assumption> ratios{{"3.eta", equation(eta, m1 / m2)},
                                     {"3.chi", equation(chi, k2 / (k1 + k2))}};
const std::vector<Assumption> rescaled{{"3.u", equation(u, friction / (k1 + k2))},
                                       {"3.p", equation(p, eta * load / (k1 + k2))},
                                       {"3.t", equation(t, Omega * time)},
                                       {"3.omega", equation(omega, frequency / Omega)}};
const Assumption stiff1{"3.k1", {k1, 0, Relation::greater}}, stiff2{"3.k2", {k2, 0, Relation::greater}},
    heavy1{"3.m1", {m1, 0, Relation::greater}}, heavy2{"3.m2", {m2, 0, Relation::greater}},
    stiff{"3.k", {k1 + k2, 0, Relation::greater}}, quick{"3.Omega.sign", {Omega, 0, Relation::greater}};

const Statement first2 = equation(xddot1 + x1 - chi * x2, 0),
                second2 = equation(xddot2 + chi * eta * (x2 - x1), eta *u + p * cos(omega * t + phi));

std::vector<Assumption> all_of_3(std::vector<Assumption> more) {
  std::vector<Assumption> all = ratios;
  all.insert(all.end(), rescaled.begin(), rescaled.end());
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// What (3) names exists: the frequencies that give these chi and eta, by 39.frequencies, and Omega.
kernel::Theorem quantities_exist(const kernel::Theorem& frequencies) {
  using kernel::Positive;
  using kernel::Theorem;
  using kernel::Variable;
  const Variable m1{"m1"}, m2{"m2"}, k1{"k1"}, k2{"k2"};
  const kernel::Term k = kernel::Term(k1) + k2;
  const auto positive = [](const kernel::Term& a, const std::vector<Positive>& because) {
    return Theorem::order(kernel::less(0, a), because);
  };
  const Theorem stiff1 = tactics::above(0, k1), stiff2 = tactics::above(0, k2),
                heavy1 = tactics::above(0, m1), heavy2 = tactics::above(0, m2),
                stiff = positive(k, {{{stiff1}}, {{stiff2}}}), by_k = tactics::inverse_is_positive(stiff),
                by_m1 = tactics::inverse_is_positive(heavy1), by_m2 = tactics::inverse_is_positive(heavy2);
  const kernel::Term ratio = k2 / k, masses = kernel::Term(m1) / m2, rate = k / m1;
  Theorem exist = Theorem::instantiate(frequencies, {{{"chi"}, ratio}, {{"eta"}, masses}});
  for (const Theorem& known : {positive(ratio, {{{stiff2, by_k}}}),
                               Theorem::order(kernel::less(ratio, 1), {Positive{{stiff1, by_k}}}),
                               positive(masses, {{{heavy1, by_m2}}})}) {
    exist = Theorem::cut(known, exist);
  }
  const Theorem scale = tactics::detach(Theorem::square_root(rate),
                                        Theorem::order(kernel::at_most(0, rate), {Positive{{stiff, by_m1}}}));
  return Theorem::cut(tactics::different(stiff),
                      tactics::nonzero(tactics::both({exist, scale}), {heavy1, heavy2}));
}

// (1)-(3): from Newton's equations to the dimensionless ones.
std::vector<Claim> equations() {
  return {
      {.id = "1",
       .kind = Kind::definition,
       .printed = {equation(Rtilde(time), load * cos(frequency * time + phi))},
       .words = "the load, for any amplitude, frequency and phase"},
      {.id = "2.newton",
       .kind = Kind::model,
       .words = "Newton's equations of Fig. 1: spring $k_1$ between wall and $m_1$, spring $k_2$ between "
                "$m_1$ and $m_2$, friction and load on $m_2$"},
      {.id = "2",
       .kind = Kind::step,
       .printed = {first2, second2},
       .words = "the dimensionless equations of motion, from Newton's by (3), d/dt of time and $t = Omega$ "
                "times time",
       .assumptions = all_of_3({newton1, newton2, scale, stiff, heavy1, heavy2, quick}),
       .prove = by_combination(
           {{{assuming("2.newton.1"), 0, 1 / (k1 + k2)}, {assuming("3.Omega"), 0, -m1 / (k1 + k2) * xddot1}},
            {{assuming("2.newton.2"), 0, m1 / (m2 * (k1 + k2))},
             {assuming("3.Omega"), 0, -m1 / (k1 + k2) * xddot2}}})},
      {.id = "3",
       .kind = Kind::definition,
       .printed = {equation(eta, m1 / m2), equation(chi, k2 / (k1 + k2)), equation(u, friction / (k1 + k2)),
                   equation(p, eta * load / (k1 + k2)), equation(t, Omega * time),
                   equation(omega, frequency / Omega), equation(V, belt / Omega)},
       .words = "the dimensionless quantities, $Omega = sqrt((k_1 + k_2)/m_1)$: $t$, $chi$, $eta$, $omega$ "
                "are numbers, $x$, $u$, $p$ and $V$ lengths"},
      {.id = "3.exist",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .words =
           "for all positive masses and stiffnesses there are frequencies $0 < omega_1 < 1 < omega_2$ that "
           "give $chi = k_2/(k_1 + k_2)$ and $eta = m_1/m_2$, and there is $Omega$ with $Omega^2 = (k_1 + "
           "k_2)/m_1$: (3) names what exists",
       .prove =
           [](Prover& prover, const Claim&) {
             Outcome outcome;
             outcome.route = "39.frequencies at these ratios, and a square root";
             outcome.uses = {"39.frequencies"};
             outcome.verdict = Verdict::proved();
             prove(outcome, [&] { return quantities_exist(prover.theorem("39.frequencies")); });
             return outcome;
           }},
      {.id = "3.load",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(omega * t, frequency * time),
                   equation(p * cos(omega * t + phi),
                            eta / (k1 + k2) * (load * cos(frequency * time + phi)))},
       .words = "the load of (2) is that of (1): the same angle, and $eta/(k_1 + k_2)$ times the force",
       .assumptions = {rescaled[1], rescaled[2], rescaled[3], stiff, quick},
       .prove = by_normal_form()},
      {.id = "3.domain",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {{chi, 0, Relation::greater}, {chi, 1, Relation::less}, {eta, 0, Relation::greater}},
       .words = "the domain of the model, $0 < chi < 1$ and $eta > 0$, from positive masses and stiffnesses",
       .assumptions = {ratios[0], ratios[1], stiff1, stiff2, stiff, heavy1, heavy2},
       .prove = by_positive_combination(
           {{.positive = {{1, {{assuming("3.k2")}}}},
             .divisors = {{1, {{assuming("3.k1")}}}, {1, {{assuming("3.k2")}}}}},
            {.positive = {{1, {{assuming("3.k1")}}}},
             .divisors = {{1, {{assuming("3.k1")}}}, {1, {{assuming("3.k2")}}}}},
            {.positive = {{1, {{assuming("3.m1")}}}}, .divisors = {{1, {{assuming("3.m2")}}}}}})},
  };
}

const Term pull = chi * (x2 - x1) - p / eta * cos(omega * t + phi);

// A state at rest on the belt without load: r = chi (x2 - x1), with chi = 9/13.
std::vector<Coordinate> at_rest(const Rational& gap) {
  return {{"omega1", Rational(1, 2)}, {"omega2", Rational(2)}, {"us", Rational(1, 4)}, {"ur", Rational(1, 2)},
          {"V", Rational(1)},         {"xdot2", Rational(1)},  {"x1", Rational(0)},    {"x2", gap},
          {"p", Rational(0)},         {"omega", Rational(1)},  {"phi", Rational(0)},   {"t", Rational(0)}};
}

// (4) as a definition.
std::vector<Claim> friction_law() {
  const Assumption no_acceleration{"9.rest", equation(xddot2, 0)}, motion{"2", second2};
  return {
      {.id = "4",
       .kind = Kind::model,
       .words = "Coulomb's law: $u = u_s sign(V - x2')$ while slipping; at $x2' = V$, with the friction $r$ "
                "that would keep it so, $u = r$ if $|r| < u_r$, $u_s$ if $r > u_r$, $-u_s$ if $r < -u_r$"},
      {.id = "4.V",
       .kind = Kind::step,
       .printed = {equation(V - xdot2, (belt - velocity) / Omega)},
       .words = "$V = v_0/Omega$: $V - x2'$ has the sign of the belt's velocity relative to the mass",
       .assumptions = {{"4.belt", equation(V, belt / Omega)},
                       {"4.mass", equation(xdot2, velocity / Omega)},
                       quick},
       .prove = by_normal_form()},
      {.id = "4.r",
       .kind = Kind::step,
       .printed = {equation(u, pull)},
       .words = "the friction that keeps $x2'' = 0$, by (2)",
       .assumptions = {motion, no_acceleration},
       .prove = by_combination({{{assuming("2"), 0, -1 / eta}}})},
      {.id = "4.defined",
       .kind = Kind::definition,
       .origin = Origin::reading,
       .words = "the law gives a friction in every state",
       .prove = by_counterexample({.point = at_rest(Rational(13, 18)),
                                   .false_there = {{xdot2, V, Relation::not_equal},
                                                   {pull, -ur, Relation::less},
                                                   {abs(pull), ur, Relation::less},
                                                   {pull, ur, Relation::greater}}})},
      {.id = "4.unique",
       .kind = Kind::definition,
       .origin = Origin::reading,
       .words = "the law continues every motion in one way",
       .prove = by_counterexample({.point = at_rest(Rational(1, 2)),
                                   .true_there = {{abs(pull), ur, Relation::less}},
                                   .false_there = {{eta * (us - pull), 0, Relation::greater_or_equal}}})},
      {.id = "4.slips",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(xddot2, eta * (u - pull))},
       .words = "(2) with $r$: a mass at the belt's velocity is accelerated by $eta (u - r)$",
       .assumptions = {motion},
       .prove = by_combination({{{assuming("2")}}})},
  };
}

}  // namespace

std::vector<Claim> section2() {
  return joined({equations(), unit_of_time(), friction_law()});
}

}  // namespace stickslip::proofs::pascal2012
