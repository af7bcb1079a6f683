// Section 6, example P: the orbit of Fig. 4, and the numbers that are printed for it.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "model/nonsticking_closed_form.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/least_load.hpp"
#include "numeric/families/nonsticking.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/nonsticking_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace methods;

namespace {

PrintedPlace where() {
  return {example_named("P"), "P.orbit", "Krawczyk's test in balls on equations equivalent to (28)"};
}

// ur_max of the orbit, which the data do not depend on.
Ball largest_friction(const Example& example) {
  const Ball& phi = printed_orbit(example).phi();
  OrbitQuestion without = question_of(example, 30);
  without.ur.reset();
  for (const Orbit& orbit : list_orbits(without).orbits) {
    if (orbit.phi().overlaps(phi)) {
      return orbit.ur_max();
    }
  }
  throw InternalError("the orbit of Fig. 4 is not in the list without u_r");
}

// The printed u_r is a datum; the paper does not say how it was chosen.
Claim friction_claim() {
  return {
      .id = "P.from.ur",
      .kind = Kind::numbers,
      .origin = Origin::auxiliary,
      .words = "$u_r = 0.2996$ is the largest $u_r$ for which the orbit exists, cut off after four digits",
      .prove = [](Prover& prover, const Claim&) {
        const Example& example = example_named("P");
        const Ball slack = largest_friction(example) - Ball(*example.ur);
        Outcome outcome =
            at_the_data(example, "$0 <= ur_max - u_r < 1e-4$, in balls, with (25) and (26) at their ends");
        outcome.uses = {"P.orbit"};
        const Ball rest = Ball(parse_rational("1e-4")) - slack;
        outcome.verdict = slack.is_positive() && rest.is_positive() ? Verdict::proved()
                          : slack.is_negative() || rest.is_negative()
                              ? Verdict::refuted("$ur_max - u_r$ is " + to_string(slack))
                              : Verdict::undecided("$ur_max - u_r$ is " + to_string(slack));
        if (outcome.verdict.truth == Truth::proved) {
          prove_of_orbit(outcome, prover, where(),
                         [&](const kernel::Theorem& orbit, const orbits::Question& question) {
                           return orbits::value_theorem(orbit, question, "ur_max", *example.ur,
                                                        *example.ur + parse_rational("1e-4"), false);
                         });
        }
        return outcome;
      }};
}

// (37) made sharp, with x2' < 0 on the whole slip.
Claim least_load_claim() {
  return {
      .id = "P.least",
      .kind = Kind::condition,
      .origin = Origin::new_result,
      .words =
          "the load of Fig. 4 exceeds the least one: $p > |bound| sqrt(B^2 + max(S, eta u_r/omega)^2)$, "
          "$B = b_1 d_01 + b_2 d_02$, which is necessary and sufficient; $S$ is the supremum over $0 < t "
          "< pi/omega$ of $g/sin(omega t)$ in 37.slip, and 37.sharp is the case $eta u_r/omega > S$",
      .prove = [](Prover&, const Claim&) {
        const Example& example = example_named("P");
        const LeastLoad least = least_load(printed_orbit(example).motion, Ball(*example.ur), 20);
        Outcome outcome = at_the_data(
            example,
            fmt::format("the supremum bracketed in balls: $S = {}$, $eta u_r/omega = {}$, least $p = {}$",
                        shown(least.speed_push), shown(least.friction_push), shown(least.p)));
        outcome.uses = {"P.orbit", "37.sharp", "37.sharp.back", "37.slip", "37.slip.back", "37.slip.free"};
        const Ball slack = Ball(example.data.p) - least.p;
        outcome.verdict = slack.is_positive()   ? Verdict::proved()
                          : slack.is_negative() ? Verdict::refuted("the least $p$ is " + shown(least.p))
                                                : Verdict::undecided("the least $p$ is " + shown(least.p));
        return outcome;
      }};
}

// Where x2' < 0 within the slip asks for more than (36).
Claim more_than_36() {
  return {
      .id = "37.least",
      .kind = Kind::numbers,
      .origin = Origin::new_result,
      .words =
          "the least load at $chi = 0.64$, $eta = 7.9$, $u_s = 0.1$, $u_r = 0.15$, $V = 0$, $omega = "
          "0.492$, beside the one that (36) alone asks for",
      .prove = [](Prover&, const Claim&) {
        OrbitQuestion question;
        question.family = &families::nonsticking();
        question.parameters = {{Rational(16, 25)}, {Rational(79, 10)},   {Rational(1, 10)},
                               {Rational(0)},      {Rational(123, 250)}, {Rational(7)}};
        question.ur = Range{Rational(3, 20)};
        question.digits = 30;
        Outcome outcome;
        outcome.route = "an orbit with $p = 7$, and the supremum of 37.slip, bracketed in balls";
        outcome.at = {{"chi", question.parameters.chi.middle}, {"eta", question.parameters.eta.middle},
                      {"us", question.parameters.us.middle},   {"ur", question.ur->middle},
                      {"V", question.parameters.V.middle},     {"omega", question.parameters.omega.middle},
                      {"p", question.parameters.p.middle}};
        outcome.uses = {"37.sharp", "37.sharp.back", "37.slip", "37.slip.back", "37.slip.free"};
        const OrbitList list = list_orbits(question);
        const auto orbit = std::ranges::find_if(
            list.orbits, [](const Orbit& one) { return one.admissible.truth == Truth::proved; });
        if (orbit == list.orbits.end()) {
          outcome.verdict = Verdict::undecided("no orbit with p = 7 is proved");
          return outcome;
        }
        const Ball ur(question.ur->middle);
        const model::Oscillator<Ball>& o = orbit->motion.oscillator;
        const Ball by36 = sqrt(model::least_load_squared<Ball>(
            o.data, o.modes, model::half_period<Ball>(o.data.chi, o.modes, o.d0, o.data.omega, Ball::pi()),
            ur));
        const Ball least = least_load(orbit->motion, ur, 20).p;
        outcome.found =
            fmt::format("$p > {}$, where (36) asks for $p > {}$", digits_of(least), digits_of(by36));
        outcome.verdict =
            (least - by36).is_positive() ? Verdict::proved() : Verdict::undecided("(36) may ask for as much");
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> example_P() {
  const Claim existence = existence_claim(
      where(),
      "an orbit with the data of Fig. 4 exists: a slip and an overshoot that close, (28), and "
      "obey the friction law at all times");
  return joined({{existence},
                 printed_values(where(), {"Theta", "x10", "x20", "xdot10", "phi"}),
                 {friction_claim(), least_load_claim(), more_than_36()},
                 orbit_claims(where(), list_of_P())});
}

}  // namespace stickslip::proofs::pascal2012
