// What the abstract, Section 6 and the conclusion assert about the three families: those of it that orbits
// and attractors decide.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/transformed.hpp"
#include "numeric/attractors/attractors.hpp"
#include "numeric/orbits.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/pascal2012/met_by_orbits.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;
using namespace symbols;
using numeric::attractors::Attractor;
using numeric::attractors::AttractorList;
using numeric::attractors::AttractorQuestion;

namespace {

// "Such orbits exist": the example of the paper is one.
Proof exists(const std::string& example) {
  return [=](Prover& prover, const Claim&) {
    Outcome outcome = of_its_orbit(
        example_named(example), "the orbit of the example, with every condition along the motion, in balls");
    outcome.verdict = printed_orbit(example_named(example)).admissible;
    if (outcome.verdict.truth == Truth::proved) {
      outcome.theorems = prover.prove(orbit_claim(example_named(example))).outcome.theorems;
      outcome.by_kernel = !outcome.theorems.empty();
    }
    return outcome;
  };
}

// The first on a moving belt of which every condition is proved.
const Orbit& orbit_on_moving_belt() {
  const std::vector<Orbit>& all = orbits_of(on_a_moving_belt()).list.orbits;
  const auto found = std::ranges::find_if(all, is_admissible);
  if (found == all.end()) {
    throw kernel::KernelError("no orbit on a moving belt is proved at the data");
  }
  return *found;
}
// What `theorem` makes of it.
kernel::Theorem of_moving_belt(
    const std::function<kernel::Theorem(const kernel::Theorem&, const orbits::Question&)>& theorem) {
  const Motion& motion = orbit_on_moving_belt().motion;
  const orbits::Question known = orbits::question_of(question_of(on_a_moving_belt()), motion);
  return theorem(orbits::orbit_theorem(known, motion), known);
}

Outcome only_at_rest(Prover&, const Claim&) {
  Outcome outcome{.uses = {"28.reduced"}};
  outcome.verdict = differs_at(data_of(on_a_moving_belt()), Ball(on_a_moving_belt().data.V), Ball(0),
                               "the velocity of the belt, $V$,", "what the paper asks for");
  prove(outcome, [] { return of_moving_belt(orbits::stability_theorem); });
  if (outcome.by_kernel) {
    const Orbit& orbit = orbit_on_moving_belt();
    outcome.route = fmt::format(
        "a counterexample proved in balls, with every condition along the motion: $tau = {}$, $Theta = {}$, "
        "$phi = {}$",
        shown(orbit.tau()), shown(orbit.Theta()), shown(orbit.phi()));
  }
  return outcome;
}

// The title: limit cycles.
Outcome isolated(Prover& prover, const Claim&) {
  Outcome outcome{.verdict = Verdict::proved(),
                  .route = "each orbit is the only one in a box, by Krawczyk's test"};
  for (const char * name : {"S", "O", "P"}) {
    const std::string orbit = name + std::string(".orbit");
    outcome.uses.insert(orbit);
    const std::vector<kernel::Theorem>& theorems = prover.prove(orbit).outcome.theorems;
    if (theorems.size() < 2) {
      return {.verdict = Verdict::undecided(orbit + " is not proved to be locally unique")};
    }
    outcome.theorems.push_back(theorems.back());
  }
  outcome.by_kernel = true;
  return outcome;
}

// Among all motions of the load's period: a family of them through the orbit would have a multiplier 1.
Outcome isolated_among_all(Prover&, const Claim&) {
  Outcome outcome{.route =
                      "the multipliers in balls; the phases of motions nearby are the same, as the "
                      "conditions of (4) hold strictly"};
  std::vector<Verdict> each;
  for (const char * name : {"S", "O", "P"}) {
    outcome.uses.insert(name + std::string(".stability"));
    const Orbit& orbit = printed_orbit(example_named(name));
    each.push_back(orbit.admissible);
    const bool none_is_1 =
        orbit.stability && std::ranges::all_of(orbit.stability->multipliers, [](const ComplexBall& mu) {
          return (mu.re - Ball(1)).is_nonzero() || mu.im.is_nonzero();
        });
    each.push_back(none_is_1 ? Verdict::proved()
                             : Verdict::undecided(fmt::format("a multiplier of {} may be 1", name)));
  }
  outcome.verdict = all_of(each);
  return outcome;
}

// What the response settles on attracts.
Outcome steady(Prover& prover, const Claim&) {
  const Example& example = example_named("S");
  Outcome outcome = at_the_data(example,
                                "a Floquet multiplier of the orbit is larger than 1, in balls: motions that "
                                "begin near it leave it");
  outcome.uses = {"S.stability", "O.stability", "P.stability"};
  const auto kind_of = [](const char * name) {
    const std::optional<Stability>& found = printed_orbit(example_named(name)).stability;
    return found ? found->kind : StabilityKind::undecided;
  };
  const bool others_attract = kind_of("O") == StabilityKind::stable && kind_of("P") == StabilityKind::stable;
  if (kind_of("S") != StabilityKind::unstable || !others_attract) {
    outcome.verdict = Verdict::undecided("the stability of the orbits is not that");
    return outcome;
  }
  const ComplexBall& largest = printed_orbit(example).stability->multipliers.front();
  outcome.verdict = differs_at(outcome.at, sqrt(largest.squared_modulus()), Ball(1),
                               "the modulus of the multiplier", "what it exceeds");
  outcome.theorems = prover.prove("S.stability").outcome.theorems;
  outcome.by_kernel = !outcome.theorems.empty();
  return outcome;
}

Outcome as_one_motion(Prover&, const Claim&) {
  return proved_by(
      at_the_data(on_a_moving_belt(), "the motions of its phases, joined at their ends and continued"), {},
      [] { return of_moving_belt(orbits::one_motion); });
}

// What random starts end on at the data of the figures: a check in floating point, with shares.

// u_r, where it is a result, to the digits of a double.
Rational friction_of(const Example& example) {
  return example.ur ? *example.ur : parse_rational(to_text(printed_orbit(example).ur(), 17).mid);
}

std::string shown(const Attractor& one) {
  const std::string share =
      fmt::format("{:.0f} % ({:.0f} to {:.0f})", 100 * one.share, 100 * one.least, 100 * one.most);
  if (one.kind != numeric::attractors::Kind::periodic) {
    return share + " " + to_string(one.kind);
  }
  const std::string proved = one.orbit && one.orbit->existence.truth == Truth::proved ? ", proved" : "";
  return fmt::format("{} period {}{}{}", share, one.periods, proved,
                     one.family.empty() ? "" : ", of the paper's families");
}

Claim attractors_of(const Example& example, long starts, bool attracts) {
  return {
      .id = example.name + ".attractors",
      .kind = methods::Kind::check,
      .origin = Origin::new_result,
      .words = fmt::format(
          "of {} random starts at the data of {} {}; shares, with 95 % of confidence", starts, example.figure,
          attracts ? "more end on its orbit than on any other motion" : "none ends on its orbit"),
      .prove = [&example, starts, attracts](Prover&, const Claim&) {
        Outcome outcome = of_its_orbit(example,
                                       "simulation of the law (4) in floating point, of which "
                                       "periodic motions are proved");
        AttractorQuestion question;
        question.machine = {.data = example.data, .ur = friction_of(example), .digits = 10};
        question.starts = starts;
        const AttractorList list = numeric::attractors::find_attractors(question);
        const auto found = transformed(list.attractors, [](const Attractor& one) { return shown(one); });
        outcome.found = fmt::format("{}", fmt::join(found, "; "));
        const auto is_of_family = [](const Attractor& one) { return !one.family.empty(); };
        const bool so = attracts ? is_of_family(list.attractors.front())
                                 : std::ranges::none_of(list.attractors, is_of_family);
        outcome.verdict = list.interrupted ? Verdict::undecided("interrupted")
                          : so             ? Verdict::checked("they end on these motions")
                                           : Verdict::undecided("they end on other motions");
        return outcome;
      }};
}

}  // namespace

Proofs cycles() {
  return {{"7.cycles", isolated},     {"7.isolated", isolated_among_all},
          {"7.steady", steady},       {"7.overshoot", exists("O")},
          {"7.rest", exists("P")},    {"7.only", only_at_rest},
          {"V.motion", as_one_motion}};
}

std::vector<Claim> attractors() {
  return {attractors_of(example_named("S"), 40, false), attractors_of(example_named("O"), 10, true),
          attractors_of(example_named("P"), 500, false)};
}

}  // namespace stickslip::proofs::pascal2012
