// Appendix 2: the symmetry (17) of the orbits of Section 4, by (43)-(46). Where the paper writes Z(t_1) with
// t_1 = t - tau, the argument here is the time t = tau + t_1 itself.
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace symmetric;

// (15) solved for z0: the states at the end of every stick that closes.
Assumption closing_state(const Term& z, const Term& row) {
  return {"15", equation(z, row * inverse(Gamma1(T) + I2) * Gamma2(T) * column({zdot10, zdot20}))};
}

const Assumption from_0 = not_before(t, 0), to_tau = not_after(t, tau);
const Assumption from_start = not_before(t1, 0), to_end = not_after(t1, T);
// What (17) says t_1 is.
const Assumption counted_from_tau{"17.t1", equation(t, tau + t1)};

const Assumption no_load{"17.p", equation(p, 0)};

// chi eta (z_2 - z_1) + p sin(omega (t_1 + tau/2)) at the time after the stick began.
const Term gap = block(1, {-1, 1, 0, 0});
Term pull(const Term& after) {
  return chi * eta * gap * Z(tau + after) + p * sin(omega * (after + tau / 2));
}
// A stick that closes the motion, and one of its times.
std::vector<Assumption> stick_and(std::vector<Assumption> more) {
  more.insert(more.begin(), {period, stick_lasts, sticks, slip_ends, stick_ends, from_start, to_end});
  return more;
}

std::vector<Claim> slip_part() {
  return {
      {.id = "43",
       .kind = Kind::step,
       .printed = {equation(Z(tau - t), H(tau - t) * (Z0 - F0) + F(tau - t))},
       .words = "(5) at the time $tau - t$",
       .assumptions = {slips_below, begins, from_0, to_tau},
       .prove = by_rewriting({from("5").at("t", tau - t)})},
      {.id = "44.F",
       .kind = Kind::identity,
       .printed = {equation(F(tau - t), E * F(t))},
       .words = "time reversal of the forced response, with the time lag of Section 4",
       .assumptions = {time_lag},
       .prove = by_normal_form()},
      {.id = "44.F0",
       .kind = Kind::identity,
       .printed = {equation(F(tau), E * F0)},
       .words = "the same at $t = 0$",
       .assumptions = {time_lag},
       .prove = by_normal_form()},
      {.id = "44.H",
       .kind = Kind::identity,
       .printed = {equation(H(tau - t), H(tau) * H(-t))},
       .words = "group law of the slip flow",
       .prove = by_rewriting({from("38.group").at("t", tau).at("s", -t)})},
      {.id = "44.E",
       .kind = Kind::identity,
       .printed = {equation(H(-t) * E, E * H(t))},
       .words = "time reversal of the slip flow",
       .prove = by_rewriting({from("38.reversal")})},
      {.id = "17.slip",
       .kind = Kind::theorem,
       .printed = {equation(Z(t), E * Z(tau - t))},
       .words = "the slip is symmetric in time",
       .assumptions = {time_lag, slips_below, begins, slip_ends, from_0, to_tau},
       .prove = by_rewriting({from("5"), from("43"), from("44.F"), from("44.F0"), from("44.H"),
                              from("38.commute").at("t", tau).at("s", -t).solved_for(H(tau) * H(-t)),
                              from("5").at("t", tau), assuming("13").solved_for(H(tau) * Z0), from("44.E"),
                              from("13.E")})},
  };
}

std::vector<Claim> stick_part() {
  return {
      {.id = "45",
       .kind = Kind::step,
       .printed = {equation(Z(t), Gamma(T - t1) * E * Z0)},
       .words = "the stick solution at the time $T - t_1$",
       .assumptions = {counted_from_tau, slip_ends, closing_state(z10, block(1, {1, 0})),
                       closing_state(z20, block(1, {0, 1})), sticks, stick_lasts, from_start, to_end},
       .prove = by_normal_form({equation(Gamma(t1) * E * Z0, Gamma(T - t1) * E * Z0)}),
       .corrected = {equation(Z(tau + T - t1), Gamma(T - t1) * E * Z0)},
       .prove_corrected = by_rewriting({from("4.stick").at("t", tau + T - t1)})},
      {.id = "46.group",
       .kind = Kind::identity,
       .printed = {equation(Gamma(T - t1), Gamma(T) * Gamma(-t1))},
       .words = "group law of the stick flow",
       .prove = by_rewriting({from("41.group").at("t", T).at("s", -t1)})},
      {.id = "46.E",
       .kind = Kind::identity,
       .printed = {equation(E * Gamma(t1), Gamma(-t1) * E)},
       .words = "time reversal of the stick flow",
       .prove = by_rewriting({from("41.reversal").at("t", t1)})},
      {.id = "46.period",
       .kind = Kind::step,
       .printed = {equation(Z(Theta), Gamma(T) * E * Z0)},
       .words = "the state at the end of the stick",
       .assumptions = {sticks, stick_lasts, stick_takes_time, slip_ends},
       .prove = by_rewriting({from("4.stick").at("t", Theta)})},
      {.id = "46.closes",
       .kind = Kind::condition,
       .printed = {stick_ends.statement},
       .words = "it is the state in which the slip began: (15) again",
       .assumptions = {stick_ends},
       .prove = by_premises({assuming("15")})},
      {.id = "17.stick",
       .kind = Kind::theorem,
       .printed = {equation(Z(tau + t1), E * Z(tau + T - t1))},
       .words = "the stick is symmetric in time; the paper writes $Z(t_1)$ for what is $Z(tau + t_1)$ here",
       .assumptions = {sticks, stick_lasts, slip_ends, stick_ends, from_start, to_end},
       .prove = by_rewriting({from("4.stick").at("t", tau + t1), from("45"), from("46.group"),
                              from("41.commute").at("t", T).at("s", -t1).solved_for(Gamma(T) * Gamma(-t1)),
                              assuming("15"), from("46.E").at("t1", -t1).solved_for(Gamma(t1) * E)})},
      {.id = "17.F",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(F(t), zero(4, 1)), equation(F0, zero(4, 1))},
       .words = "without a load there is no forced response",
       .assumptions = {no_load},
       .prove = by_normal_form()},
      {.id = "17.free",
       .kind = Kind::theorem,
       .printed = {equation(Z(t), E * Z(tau - t)), equation(Z(tau + t1), E * Z(tau + T - t1))},
       .words = "both symmetries without a load, $p = 0$: those of the self-excited oscillator",
       .assumptions = {no_load, slips_below, begins, sticks, stick_lasts, slip_ends, stick_ends, from_0,
                       to_tau, from_start, to_end},
       .prove = by_rewriting({from("17.stick"), from("5"), from("43"), from("17.F"),
                              from("17.F").at("t", tau), from("17.F").at("t", tau - t), from("44.H"),
                              from("38.commute").at("t", tau).at("s", -t).solved_for(H(tau) * H(-t)),
                              from("5").at("t", tau), assuming("13").solved_for(H(tau) * Z0), from("44.E"),
                              from("13.E")})},
      {.id = "17.odd",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(pull(T - t1), -pull(t1))},
       .words =
           "on the stick $chi eta (z_2 - z_1) + p sin(omega (t_1 + tau/2))$ of Section 4 is odd about its "
           "middle",
       .assumptions = stick_and({}),
       .prove = by_combination({{{from("17.stick"), 0, chi * eta * gap}}})},
      {.id = "17.odd.f",
       .kind = Kind::condition,
       .origin = Origin::auxiliary,
       .printed = {{pull(T - t1) + eta * (ur + us), 0, Relation::greater}},
       .words =
           "so $f_1 < 0$ at all times of the stick gives $f_2 > 0$ at all of them: $f_2(T - t_1) = 2 eta "
           "u_s - f_1(t_1)$",
       .assumptions = stick_and(
           {{"4.f1", {pull(t1) - eta * (ur - us), 0, Relation::less}}, {"4.us", {us, 0, Relation::greater}}}),
       .prove =
           by_positive_combination({{.positive = {{1, {{assuming("4.f1")}}}, {2 * eta, {{assuming("4.us")}}}},
                                     .equations = {{from("17.odd")}}}})},
  };
}

}  // namespace

std::vector<Claim> appendix2() {
  return joined({slip_part(), stick_part()});
}

}  // namespace stickslip::proofs::pascal2012
