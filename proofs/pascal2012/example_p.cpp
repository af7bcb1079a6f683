// Section 6, example P: the orbit of Fig. 4, and the numbers that are printed for it.
#include <fmt/format.h>

#include "core/error.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/least_load.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/half_period.hpp"
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

}  // namespace

std::vector<Claim> half_period::example_P() {
  const Claim existence = existence_claim(
      where(),
      "an orbit with the data of Fig. 4 exists: a slip and an overshoot that close, (28), and "
      "obey the friction law at all times");
  return joined({{existence},
                 printed_values(where(), {"Theta", "x10", "x20", "xdot10", "phi"}),
                 {friction_claim(), least_load_claim()},
                 orbit_claims(where(), list_of_P())});
}

}  // namespace stickslip::proofs::pascal2012
