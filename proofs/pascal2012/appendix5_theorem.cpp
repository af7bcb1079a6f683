// Appendix 5 as one theorem: off resonance and for V = 0, a motion of two slips per period that closes is
// symmetric in space and time. Composed of (66)-(69), without dividing by q_2: omega = 1 needs no exception.
#include "proofs/methods/implications.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/appendix5.hpp"

namespace stickslip::proofs::pascal2012::two_slips {

using namespace methods;
using namespace symbols;

namespace {

const Term quarter = omega * tau / 2;
const Term second_place = block(1, {0, 1, 0, 0});

std::vector<Assumption> moving(std::vector<Assumption> more) {
  more.insert(more.begin(), {off_resonance, starts_with_belt, meets_belt});
  return cycle_and(std::move(more));
}

}  // namespace

std::vector<Assumption> two_slips_at_rest() {
  return moving({at_rest, goes_down});
}

std::vector<Assumption> in_first_half() {
  std::vector<Assumption> all = two_slips_at_rest();
  all.insert(all.end(), {not_before(t, 0), not_after(t, tau)});
  return all;
}

std::vector<Claim> theorem() {
  return {
      {.id = "A5.turn",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(omega * (z2B - z20) * cos(quarter), 2 * V * sin(quarter))},
       .words = "the second rows of (66), with nothing divided by: how far the slip goes and how long it "
                "lasts; for $V > 0$ a slip that ends with $z2B < z20$ lasts longer than half a period",
       .assumptions = moving({}),
       .prove = by_combination({{{from("66"), 0, omega * cos(quarter) * second_row},
                                 {from("66"), 1, -sin(quarter) * second_row},
                                 {assuming("25.V"), 0, sin(quarter)},
                                 {assuming("26.V"), 0, sin(quarter)}}})},
      {.id = "A5.falls",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {{z2B - z20, V * tau, Relation::less}},
       .words = "$x2' < V$ on the slip takes the second mass back against the belt",
       .assumptions = {begins, slips_below, slip_takes_time, named_B, goes_down},
       .prove = by_mean_value({.phase = "2.slip",
                               .slope = "25.slope",
                               .begins = "6.Z0",
                               .ends = "28.ZB",
                               .lasts = "tau.positive",
                               .row = second_place})},
      {.id = "A5.down",
       .kind = Kind::step,
       .printed = {falls.statement},
       .words = "$V = 0$: the slip takes the second mass down",
       .assumptions = {begins, slips_below, slip_takes_time, named_B, at_rest, goes_down},
       .prove = by_positive_combination({{.positive = {{1, {{from("A5.falls")}}}}}})},
      {.id = "A5.cos",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(cos(quarter), 0)},
       .words = "$V = 0$: the case $sin(phi + omega tau/2) = 0$ of (67), all its branches $phi_B = -phi + 2 "
                "k pi$, is excluded by $z2B < z20$, the other remains",
       .assumptions = moving({at_rest, falls}),
       .prove = by_combination({{{from("A5.turn"), 0, 1 / (omega * (z2B - z20))},
                                 {assuming("A5.V"), 0, 2 * sin(quarter) / (omega * (z2B - z20))}}})},
      {.id = "A5.half",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {half.statement},
       .words = "the slip lasts half a period",
       .assumptions = two_slips_at_rest(),
       .prove = by_premises({from("67.second").given("67.case2", "A5.cos").given("25.slip", "A5.down")})},
      {.id = "A5.second",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {second_half.statement},
       .words = "so does the overshoot",
       .assumptions = two_slips_at_rest(),
       .prove = by_combination(
           {{{assuming("56.tau1"), 0, -1}, {assuming("28.period"), 0}, {from("A5.half"), 0, -1}}})},
      {.id = "A5.regular",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {regular_H1.statement},
       .words = "$det(H_1 - I)$ is not zero off resonance",
       .assumptions = {half, period, off_resonance},
       .prove =
           by_nonzero_multiple("70.resonance", power(2 * cos(omega1 * tau / 2) * cos(omega2 * tau / 2), 2))},
      {.id = "A5.theorem",
       .kind = Kind::theorem,
       .printed = {equation(X(t), -X(t + tau)), half.statement},
       .words = "Appendix 5: off resonance, a motion with $V = 0$ and two slips per period, $x2' < 0$ on the "
                "first, is symmetric in space and time; $det P != 0$, $det H_2 != 0$ and $omega != 1$ are "
                "not needed",
       .assumptions = in_first_half(),
       .prove = by_premises({from("69.motion")
                                 .given("26.half", "A5.half")
                                 .given("67.tau1", "A5.second")
                                 .given("69.H1", "A5.regular"),
                             from("A5.half")})},
  };
}

}  // namespace stickslip::proofs::pascal2012::two_slips
