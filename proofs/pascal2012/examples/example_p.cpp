// Section 6, example P: the orbit of Fig. 4, and the numbers that are printed for it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "model/nonsticking.hpp"
#include "numeric/branches/branches.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/nonsticking.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/pascal2012/examples/symmetric_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace methods;

namespace {

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
Outcome friction(Prover& prover, const Claim&) {
  const Example& example = example_named("P");
  const Ball slack = largest_friction(example) - Ball(*example.ur);
  Outcome outcome =
      of_its_orbit(example, "$0 <= ur_max - u_r < 1e-4$, in balls, with (25) and (26) at their ends");
  const Ball rest = Ball(parse_rational("1e-4")) - slack;
  outcome.verdict = slack.is_positive() && rest.is_positive() ? Verdict::proved()
                    : slack.is_negative() || rest.is_negative()
                        ? Verdict::refuted("$ur_max - u_r$ is " + to_string(slack))
                        : Verdict::undecided("$ur_max - u_r$ is " + to_string(slack));
  if (outcome.verdict.truth == Truth::proved) {
    prove_of_orbit(outcome, prover, example_named("P"),
                   [&](const kernel::Theorem& orbit, const orbits::Question& question) {
                     return orbits::value_theorem(orbit, question, "ur_max", *example.ur,
                                                  *example.ur + parse_rational("1e-4"), false);
                   });
  }
  return outcome;
}

// (37) made sharp, with x2' < 0 on the whole slip.
const std::set<std::string> made_sharp{"37.sharp", "37.sharp.back", "37.slip", "37.slip.back",
                                       "37.slip.free"};

Outcome least_load_of_figure(Prover&, const Claim&) {
  const Example& example = example_named("P");
  const LeastLoad least = least_load(printed_orbit(example).motion, Ball(*example.ur), 20);
  Outcome outcome = at_the_data(
      example, fmt::format("the supremum bracketed in balls: $S = {}$, $eta u_r/omega = {}$, least $p = {}$",
                           shown(least.speed_push), shown(least.friction_push), shown(least.p)));
  outcome.uses = made_sharp;
  outcome.uses.insert("P.orbit");
  const Ball slack = Ball(example.data.p) - least.p;
  outcome.verdict = slack.is_positive()   ? Verdict::proved()
                    : slack.is_negative() ? Verdict::refuted("the least $p$ is " + shown(least.p))
                                          : Verdict::undecided("the least $p$ is " + shown(least.p));
  return outcome;
}

// Where x2' < 0 within the slip asks for more than (36).
Outcome more_than_36(Prover&, const Claim&) {
  const Example example{"",
                        "",
                        &families::nonsticking(),
                        parse_parameters("0.64", "7.9", "0.1", "0", "0.492", "7"),
                        std::nullopt,
                        parse_rational("0.15"),
                        {}};
  Outcome outcome{.route = "an orbit with $p = 7$, and the supremum of 37.slip, bracketed in balls",
                  .uses = made_sharp,
                  .at = coordinates(example.data, *example.ur)};
  const OrbitList list = list_orbits(question_of(example, 30));
  const auto orbit = std::ranges::find_if(list.orbits, is_admissible);
  if (orbit == list.orbits.end()) {
    outcome.verdict = Verdict::undecided("no orbit with p = 7 is proved");
    return outcome;
  }
  const Ball ur(*example.ur);
  const model::Oscillator<Ball>& o = orbit->motion.oscillator;
  const Ball by36 = sqrt(model::least_load_squared<Ball>(
      o.data, o.modes, model::half_period<Ball>(o.data.chi, o.modes, o.d0, o.data.omega, Ball::pi()), ur));
  const Ball least = least_load(orbit->motion, ur, 20).p;
  outcome.found = fmt::format("$p > {}$, where (36) asks for $p > {}$", digits_of(least), digits_of(by36));
  outcome.verdict =
      (least - by36).is_positive() ? Verdict::proved() : Verdict::undecided("(36) may ask for as much");
  return outcome;
}

// "stable for $V$ from 0 to 0.229523…".
std::string followed(const numeric::branches::Branch& branch) {
  using numeric::branches::State;
  std::vector<std::string> pieces;
  for (const numeric::branches::Piece& piece : branch.pieces) {
    const bool holds = numeric::branches::is_admissible(piece.state);
    pieces.push_back(
        fmt::format("{} for $V$ from {} to {}",
                    holds ? to_string(piece.state) : "no orbit, as " + piece.condition + " fails,",
                    to_text(piece.first, 10).mid, to_text(piece.last, 10).mid));
  }
  return fmt::format("{}", fmt::join(pieces, "; "));
}

Outcome over_the_belts_speed(Prover&, const Claim&) {
  Outcome outcome = at_the_data(example_named("P"), "all branches, of which every piece is proved in balls");
  numeric::branches::BranchQuestion question{.orbits = question_of(example_named("P")),
                                             .parameter = "V",
                                             .from = 0,
                                             .to = Rational(3, 10),
                                             .at = {}};
  question.orbits.ur = Range{Rational(1, 4)};
  const numeric::branches::BranchList list = numeric::branches::list_branches(question);
  const auto good = std::ranges::find_if(list.branches, [](const numeric::branches::Branch& one) {
    return numeric::branches::is_admissible(one.pieces.front().state);
  });
  if (!list.complete || !list.resolved() || good == list.branches.end()) {
    outcome.verdict = Verdict::undecided("not all orbits are known");
    return outcome;
  }
  outcome.found = followed(*good);
  outcome.verdict = Verdict::proved();
  return outcome;
}

}  // namespace

Proofs data_of_P() {
  return {{"P.from.ur", friction},
          {"P.least", least_load_of_figure},
          {"37.least", more_than_36},
          {"P.belt", over_the_belts_speed}};
}

std::vector<Claim> values_of_P() {
  return printed_values(
      example_named("P"),
      "an orbit with the data of Fig. 4 exists: a slip and an overshoot that close, (28), and "
      "obey the friction law at all times",
      "Krawczyk's test in balls on equations equivalent to (28)", {"Theta", "x10", "x20", "xdot10", "phi"});
}

std::vector<Claim> orbit_of_P() {
  return orbit_claims(example_named("P"), list_of_P());
}

}  // namespace stickslip::proofs::pascal2012
