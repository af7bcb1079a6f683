// An orbit that never sticks on a belt that moves, with slips of half a period each. Where the first natural
// frequency is twice the load's, x2' of the first mode, V cos(omega_1 t), is V at 0, at tau = pi/omega and at
// Theta, and the mode has the load's period: added to an orbit for a belt at rest it makes one for this belt.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "numeric/branches/branches.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/example_orbit.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace numeric::motion;

namespace {

// omega_1 = 1/2 and omega_2 = 3/2 are even multiples of omega = 1/4: then (33) and (35) have tan(omega_j
// pi/(2 omega)) = 0 and phi = 0, and all is rational.
const ExactParameters data{Rational(5, 8),  Rational(12, 5), Rational(1, 10),
                           Rational(1, 10), Rational(1, 4),  Rational(3)};
const Rational friction(3, 25), omega1_there(1, 2), omega2_there(3, 2);
const Rational lambda1_there(6, 5);

// The amplitudes of both modes in x1: the place of rest is left, and the belt's velocity met.
struct Amplitudes {
  Rational rest1, rest2, mode;
};
Amplitudes amplitudes() {
  return {Rational(3 * data.us), Rational(-data.us / 3), Rational(data.V / (omega1_there * lambda1_there))};
}

kernel::Theorem orbit() {
  const auto [rest1, rest2, mode] = amplitudes();
  const orbits::Question question{.data = data,
                                  .phases = {PhaseKind::slip, PhaseKind::overshoot},
                                  .durations = {"tau", "tau1"},
                                  .ur = friction};
  const kernel::Substitution exactly{{{"omega1"}, omega1_there},
                                     {{"omega2"}, omega2_there},
                                     {{"tau"}, kernel::Term(4) * kernel::pi()},
                                     {{"phi"}, 0},
                                     {{"A1_1"}, Rational(-rest1)},
                                     {{"B1_1"}, mode},
                                     {{"A2_1"}, Rational(-rest2)},
                                     {{"B2_1"}, 0},
                                     {{"A1_2"}, rest1},
                                     {{"B1_2"}, mode},
                                     {{"A2_2"}, rest2},
                                     {{"B2_2"}, 0}};
  const kernel::Theorem nothing_between = kernel::Theorem::reflexive(0);
  const kernel::Theorem orbit =
      orbits::orbit_theorem(question, {exactly, {{{"omega"}, data.omega}}, {}, nothing_between.conclusion()},
                            {equal(kernel::Variable{"tau"}, kernel::Term(4) * kernel::pi())});
  return orbits::one_motion(kernel::Theorem::cut(nothing_between, orbit), question);
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

Outcome only_at_rest_by_halves(Prover&, const Claim&) {
  Outcome outcome;
  outcome.route =
      "a counterexample in closed form, where $omega_1 = 2 omega$: the orbit for a belt at rest, and a free "
      "motion of the first mode with $x2' = V cos(omega_1 t)$, which has the load's period; its speed "
      "against "
      "the belt's by signs in balls, and by mean values at the ends";
  outcome.verdict = differs_at(coordinates(data, friction), Ball(data.V), Ball(0),
                               "the velocity of the belt, $V$,", "what the paper asks for");
  prove(outcome, orbit);
  return outcome;
}

}  // namespace

Proofs moving_belt() {
  return {{"7.only.half", only_at_rest_by_halves}, {"P.belt", over_the_belts_speed}};
}

}  // namespace stickslip::proofs::pascal2012
