// Orbits that never stick and are not symmetric. Where the first natural frequency is twice the load's, x2'
// of the first mode, epsilon cos(omega_1 t), vanishes at 0 and at tau = pi/omega, and the mode has the load's
// period: it may be added to the motion of (33), as long as x2' keeps its sign on both slips.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "model/nonsticking_closed_form.hpp"
#include "numeric/families/nonsticking.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/half_period.hpp"

namespace stickslip::proofs::pascal2012::half_period {

using namespace methods;
using namespace numeric::motion;
using namespace symbols;
namespace families = numeric::families;

namespace {

constexpr long bits = 192;
const Rational largest_epsilon(1, 20);

// omega_1 = 7/10, omega_2 = 13/10 and omega = omega_1/2, exactly.
struct Data {
  ExactParameters a;
  Rational ur;
};
Data data() {
  const Rational omega1(7, 10), omega2(13, 10);
  return {{model::chi_from_frequencies<Rational>(omega1, omega2),
           model::eta_from_frequencies<Rational>(omega1, omega2), Rational(1, 10), Rational(0), omega1 / 2,
           Rational(3)},
          Rational(3, 25)};
}

Outcome at_the_data(const std::string& route) {
  const Data d = data();
  Outcome outcome;
  outcome.route = route;
  outcome.at = {{"chi", d.a.chi}, {"eta", d.a.eta},     {"us", d.a.us}, {"ur", d.ur},
                {"V", d.a.V},     {"omega", d.a.omega}, {"p", d.a.p}};
  return outcome;
}

// The motion of (33) with (35), cos(phi) > 0, plus the mode.
Motion with_mode(const Ball& epsilon) {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(data().a));
  const model::HalfPeriod<Ball> h =
      model::half_period<Ball>(o.data.chi, o.modes, o.d0, o.data.omega, Ball::pi());
  const Ball sin_phi = -h.friction_speed / (o.Q(1) * o.data.omega);
  const Ball cos_phi = sqrt(Ball(1) - sin_phi * sin_phi);
  Ball phi;
  arb_asin(phi.raw(), sin_phi.raw(), WorkingPrecision::bits());
  model::Vector4<Ball> Z0 = model::half_period_start<Ball>(h, o.Q, o.d0, o.data.omega, cos_phi, sin_phi);
  Z0(0) += epsilon;
  Z0(1) += epsilon * o.modes.lambda1;
  const Ball tau = Ball::pi() / o.data.omega;
  return compose(o, phi, Z0, {{PhaseKind::slip, tau}, {PhaseKind::overshoot, tau}});
}

Verdict all_obey() {
  const families::Family& family = families::nonsticking();
  const Ball ur(data().ur);
  constexpr int parts = 10;
  std::vector<Verdict> verdicts;
  for (int k = -parts; k < parts; ++k) {
    const Rational unit = largest_epsilon / parts;
    const Motion here = with_mode(Ball::hull(Ball(Rational(unit * k)), Ball(Rational(unit * (k + 1)))));
    verdicts.push_back(
        admissible(decide_all(family.phases, families::requirements(family), here, all_waves(here), ur)));
  }
  return all_of(verdicts);
}

Claim family_of_orbits() {
  return {.id = "33.even.orbits",
          .kind = Kind::theorem,
          .origin = Origin::new_result,
          .words =
              "with $omega_1 = 7/10$, $omega_2 = 13/10$, $omega = 7/20$, $u_s = 0.1$, $u_r = 0.12$, $p = 3$, "
              "$V = 0$ these motions are orbits of the friction law for all $epsilon$ from $-1/20$ to "
              "$1/20$: a whole family at one and the same machine",
          .prove = [](Prover&, const Claim&) {
            const WorkingPrecision precision(bits);
            Outcome outcome = at_the_data(
                "(25), (26) and the sign of $x2'$ for all times of both slips and all $epsilon$, in balls; "
                "they begin as 33.even.start says, close, and meet the belt at $tau$, by 33.even and "
                "33.even.speed");
            outcome.uses = {"5", "27", "33.even", "33.even.speed", "33.even.start"};
            outcome.verdict = all_obey();
            return outcome;
          }};
}

// What with_mode starts from, (34), is what 33.even starts from: with the phase of (35) the belt is at rest.
Claim start_of_the_motion() {
  return {.id = "33.even.start",
          .kind = Kind::step,
          .origin = Origin::auxiliary,
          .printed = {equation(first_row * speed_continued, -q1 * omega * sin(phi) - a1 * d01 - a2 * d02),
                      equation(second_row * speed_continued, 0)},
          .words =
              "the load's phase of (35) lets these motions leave a belt at rest, $z2'(0) = 0$, and then "
              "$z1'(0)$ is that of (34); that the phase must be so is deduced where $det H_3$ is not "
              "zero, and here it is zero",
          .assumptions = {{"35", equation(q2 * omega * sin(phi), -(b1 * d01 + b2 * d02))}},
          .prove = by_combination({{}, {{assuming("35"), 0, -1}}})};
}

std::vector<Claim> motions_that_close() {
  const Term epsilon = scalar("epsilon");
  const Term mode = epsilon * column({1, lambda1});
  const std::vector<Assumption> started{{"31.even", equation(omega, omega1 / 2)},
                                        half,
                                        {"33.odd", {cos(omega2 * pi() / omega1), 0, Relation::not_equal}},
                                        continued(z10, first_row * (Q * cos(phi) - d0 + mode)),
                                        continued(z20, second_row * (Q * cos(phi) - d0 + mode)),
                                        continued(zdot10, first_row * speed_continued),
                                        continued(zdot20, second_row * speed_continued)};
  const Term slipped = H(tau) * (Z0 - F0) + F(tau);
  return {
      {.id = "33.even",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .printed = {equation(Z0, H(tau) * (slipped - F(tau)) + 2 * L(tau) * d0 + F0)},
       .words = "where $omega_1 = 2 omega$, the motion of (33) plus any multiple $epsilon cos(omega_1 t)$ of "
                "the first mode closes, too",
       .assumptions = started,
       .prove = by_normal_form()},
      {.id = "33.even.speed",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .printed = {equation(second_row * block(1, {zero(2, 2), I2}) * slipped, -zdot20)},
       .words = "it meets a belt at rest at $tau$ if it leaves it at 0",
       .assumptions = started,
       .prove = by_normal_form()},
      {.id = "33.even.places",
       .kind = Kind::theorem,
       .origin = Origin::auxiliary,
       .printed = {equation(slipped + delta0 + Z0 + delta0, 2 * column({mode, zero(2, 1)}))},
       .words = "it is symmetric in space for $epsilon = 0$ only: $x(tau) = -x(0)$ fails by $2 epsilon (1, "
                "lambda_1)$",
       .assumptions = started,
       .prove = by_normal_form()},
  };
}

}  // namespace

std::vector<Claim> even_resonance() {
  std::vector<Claim> claims = motions_that_close();
  claims.push_back(start_of_the_motion());
  claims.push_back(family_of_orbits());
  return claims;
}

Claim always_symmetric() {
  return {.id = "7.always",
          .kind = Kind::theorem,
          .words =
              "abstract and Section 7, said without exception: with the belt at rest every orbit that never "
              "sticks is symmetric in space and time",
          .prove = [](Prover& prover, const Claim&) {
            const WorkingPrecision precision(bits);
            Outcome outcome = at_the_data("$x_1(tau)$ is not $-x_1(0)$ on the orbit with $epsilon = 1/20$");
            outcome.uses = {"33.even.orbits", "33.even.places"};
            const Motion here = with_mode(Ball(largest_epsilon));
            const Ball at_0 = here.phases[0].Z(0) + here.oscillator.d0(0),
                       at_tau = here.phases[1].Z(0) + here.oscillator.d0(0);
            std::vector<Coordinate> point = outcome.at;
            point.push_back({"epsilon", largest_epsilon});
            outcome.verdict = prover.prove("33.even.orbits").outcome.verdict;
            if (outcome.verdict.truth == Truth::proved) {
              outcome.verdict =
                  (at_0 + at_tau).is_nonzero()
                      ? Verdict::refuted(Witness{point, {}, at_tau, -at_0, "$x_1(tau)$", "$-x_1(0)$"})
                      : Verdict::undecided("the states at 0 and tau may be opposite");
            }
            return outcome;
          }};
}

}  // namespace stickslip::proofs::pascal2012::half_period
