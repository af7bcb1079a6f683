// The conditions at the ends of phases are not enough for what the motion does between: motions that obey all
// of them, close, and pass the belt's velocity during a slip.
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/half_period.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace half_period {

namespace {

using Statements = std::vector<Statement>;

Statements of(const std::vector<Assumption>& assumptions) {
  Statements result;
  for (const Assumption& one : assumptions) {
    result.push_back(one.statement);
  }
  return result;
}

// All that the paper asks of two slips of half a period each but what they do between their ends.
std::vector<Assumption> all_conditions(const std::vector<Assumption>& more) {
  std::vector<Assumption> all{half,
                              period,
                              starts_with_belt,
                              meets_belt,
                              {"25", inequality25},
                              {"26", inequality26},
                              {"36", inequality36},
                              {"37", inequality37},
                              load_acts,
                              {"4.us", {us, 0, Relation::greater}},
                              {"4.ur", {ur, us, Relation::greater}}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// A motion of (34) and (35), the load given by its phase, at a time since one of the slips began.
Counterexample passes_the_belt(const Term& begin, std::vector<Statement> assumed, Statements fails) {
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
                     equation(zdot1B, -speed), equation(t, begin + Term(49) / 50)},
          .true_there = std::move(assumed),
          .false_there = std::move(fails)};
}

}  // namespace

std::vector<Claim> not_enough_for_slips() {
  const Term speed = component(3, X(t));
  const std::vector<Assumption> below =
      all_conditions({begins,
                      slips_below,
                      named_B,
                      {"28", equation(Z0, H(tau) * (ZB - FB) + 2 * L(tau) * d0 + F0)},
                      {"t.after", {t, 0, Relation::greater}},
                      {"t.before", {t, tau, Relation::less}}});
  const std::vector<Assumption> above = all_conditions({named_B,
                                                        overshoots,
                                                        closes,
                                                        {"28.B", equation(ZB, H(tau) * (Z0 - F0) + FB)},
                                                        {"t.after", {t, tau, Relation::greater}},
                                                        {"t.before", {t, Theta, Relation::less}}});
  const Term by5 = component(3, H(t) * (Z0 - F0) + F(t)),
             by27 = component(3, H(t - tau) * (ZB - FB) + 2 * L(t - tau) * d0 + F(t));
  return {
      {.id = "25.enough",
       .kind = Kind::step,
       .printed = {{speed, V, Relation::less}},
       .words = "the motion (5) that begins by (25) slips below the belt's velocity on all of $(0, tau)$; "
                "here (26), (36) and (37) hold, too, and the motion closes",
       .assumptions = below,
       .prove = by_counterexample(
           passes_the_belt(0, of(below), {{speed, V, Relation::less}, {by5, V, Relation::less_or_equal}}))},
      {.id = "26.enough",
       .kind = Kind::step,
       .printed = {{speed, V, Relation::greater}},
       .words = "the motion (27) that begins by (26) overshoots on all of $(tau, Theta)$; here (25), (36) "
                "and (37) hold, too, and the motion closes",
       .assumptions = above,
       .prove = by_counterexample(passes_the_belt(
           tau, of(above), {{speed, V, Relation::greater}, {by27, V, Relation::greater_or_equal}}))},
  };
}

}  // namespace half_period

}  // namespace stickslip::proofs::pascal2012
