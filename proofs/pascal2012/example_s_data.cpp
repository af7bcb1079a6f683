// Section 4, example S: the data of Fig. 2. They leave the load's phase no choice; at all of them, the
// printed u_r included, there are orbits of slip and stick that do not obey (13).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "model/waves.hpp"
#include "numeric/words/complete_list.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/printed_example.hpp"
#include "proofs/pascal2012/symmetric_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;
namespace words = numeric::words;

namespace {

const Example& printed() {
  return example_named("S");
}

// Where 13.slip leaves the load's phase free (4.lag.needed) the balance of both modes is zero. Of the mode
// j it is a wave in tau.
kernel::Term balance_of(const kernel::Variable& frequency) {
  const kernel::Term omega = printed().data.omega, half = kernel::Term(kernel::Variable{"tau"}) / 2;
  return frequency * sin(frequency * half) * cos(omega * half) -
         omega * cos(frequency * half) * sin(omega * half);
}
model::Wave<tactics::Symbolic> wave_of(const kernel::Variable& frequency) {
  const tactics::Symbolic omega = kernel::Term(printed().data.omega), omega_j = frequency;
  model::Wave<tactics::Symbolic> wave;
  wave.add((omega_j + omega) / 2, 0, (omega_j - omega) / 2);
  wave.add((omega_j - omega) / 2, 0, (omega_j + omega) / 2);
  return wave;
}

// For all 0 < tau < Theta not both are zero, from the ranges of omega1 and omega2: near 0 the second is
// positive, as it rises from zero; later one of both has a sign in each piece.
kernel::Theorem phase_is_fixed(const orbits::Ranges& ranges) {
  using namespace kernel;
  const Variable tau{"tau"}, omega1{"omega1"}, omega2{"omega2"};
  const Term first = balance_of(omega1), second = balance_of(omega2);
  const Term Theta = Term(2) * pi() / Term(printed().data.omega);
  const Formula goal = negation(all({equal(first, 0), equal(second, 0)}));
  const auto from_sign = [&](const Theorem& inequality) {
    return Theorem::consequence({tactics::different(inequality)}, goal);
  };
  const Rational soon(1, 8), last(11);

  const model::Wave<tactics::Symbolic> falls = model::affine<tactics::Symbolic>(-1, wave_of(omega2), 0);
  const Theorem near_zero = orbits::stays_below(
      {falls, 0, soon, Theorem::combination(equal(orbits::value(falls, 0), 0)), {}}, tau, ranges);
  const Theorem early =
      from_sign(Theorem::order(less(0, second), {Positive{{near_zero}}}));  // 0 < tau, tau <= soon

  orbits::Ranges later = ranges;
  later[tau] = {soon, last};
  const Theorem late = orbits::in_pieces(tau, later, [&](const orbits::Ranges& here) {
    const auto one_has_a_sign = tactics::first_that_works(
        std::array{less(0, first), less(first, 0), less(0, second), less(second, 0)},
        [&](const Formula& relation) {
          return from_sign(Theorem::sign(relation, orbits::ranges_in(relation, here)));
        });
    return one_has_a_sign ? *one_has_a_sign : throw KernelError("both may be zero at one time");
  });

  const Formula during = between(0, tau, Theta);
  const Theorem before_last = Theorem::order(
      at_most(tau, last),
      {Positive{{tactics::part(Theorem::assume(during), 1)}}, Positive{{Theorem::sign(less(Theta, last))}}});
  const Theorem at_all =
      Theorem::consequence({Theorem::discharge(early, at_most(tau, soon)),
                            Theorem::discharge(late, at_most(soon, tau)), Theorem::trichotomy(tau, soon)},
                           goal);
  return tactics::for_every(
      tau, during,
      Theorem::cut(tactics::part(Theorem::assume(during), 0), Theorem::cut(before_last, at_all)));
}

// (pi - omega tau)/2.
Ball lag_of(const Orbit& orbit) {
  return (Ball::pi() - Ball(printed().data.omega) * orbit.tau()) / 2;
}

// Whether phi is the time lag and pi, and not the time lag.
bool has_the_other_phase(const Orbit& orbit) {
  const Ball later = orbit.phi() - lag_of(orbit);
  return (later - Ball::pi()).contains_zero() || (later + Ball::pi()).contains_zero();
}

// "2 of the 4 admissible orbits at the data of Fig. 2 have phi + pi: …".
std::string of_the_other_phase() {
  std::vector<std::string> other;
  std::size_t admissible = 0;
  for (const Orbit& orbit : orbits_of(printed()).list.orbits) {
    if (is_admissible(orbit)) {
      ++admissible;
      if (has_the_other_phase(orbit)) {
        other.push_back(told_apart(orbit, *printed().family));
      }
    }
  }
  return fmt::format("{} of the {} admissible orbits at the data of Fig. 2 have $phi + pi$: {}", other.size(),
                     admissible, fmt::join(other, "; "));
}

Outcome lag(Prover&, const Claim&) {
  Outcome outcome = proved_by(
      at_the_data(printed(),
                  "at each time up to $Theta$, $omega_j tan(omega_j tau/2)$ is not $omega tan(omega tau/2)$ "
                  "for one of the two $j$, by signs in balls; the load acts on both modes, by 7.modal"),
      {"4.lag.needed", "7.modal"},
      [] { return at_frequencies(printed().data.chi, printed().data.eta, phase_is_fixed); });
  outcome.found = of_the_other_phase();
  return outcome;
}

Outcome lag_is_no_consequence(Prover&, const Claim&) {
  Outcome outcome = at_the_data(printed(), "an orbit that has another phase, as a theorem");
  const std::vector<Orbit>& all = orbits_of(printed()).list.orbits;
  const auto other = std::ranges::find_if(
      all, [](const Orbit& orbit) { return is_admissible(orbit) && has_the_other_phase(orbit); });
  if (other == all.end()) {
    outcome.verdict = Verdict::undecided("no orbit with another phase is proved at the data");
    return outcome;
  }
  outcome.route += ": " + told_apart(*other, *printed().family);
  outcome.verdict = differs_at(outcome.at, other->phi(), lag_of(*other), "the phase $phi$ of the load",
                               "$(pi - omega tau)/2$");
  prove(outcome, [&] {
    return orbits::orbit_theorem(orbits::question_of(question_of(printed()), other->motion), other->motion);
  });
  return outcome;
}

// Z(tau) is not E Z_0.
Verdict not_symmetric(const Motion& motion) {
  const bool slip_first = motion.phases[0].kind == PhaseKind::slip;
  const Phase &slip = motion.phases[slip_first ? 0 : 1], &stick = motion.phases[slip_first ? 1 : 0];
  return (slip.Z(0) + stick.Z(0)).is_nonzero() || (slip.Z(1) + stick.Z(1)).is_nonzero()
             ? Verdict::proved()
             : Verdict::undecided("the places at both ends of the slip may be opposite");
}

words::WordList slip_and_stick(const Rational& ur, int digits) {
  return words::all_orbits({.data = printed().data, .ur = ur, .digits = digits}, words::Word::parse("ST"), 1);
}

Outcome asymmetric(Prover&, const Claim&) {
  const Rational ur = printed().result("ur").value.value;
  const words::WordList list = slip_and_stick(ur, 20);
  Outcome outcome = at_the_data(printed(), "exhaustive search in balls; the slips last");
  outcome.at.push_back({"ur", ur});
  std::vector<Verdict> each;
  std::vector<std::string> slips;
  for (const words::WordOrbit& found : list.orbits) {
    const Motion& motion = found.orbit.motion;
    const auto slip = std::ranges::find(motion.phases, PhaseKind::slip, &Phase::kind);
    outcome.route += (each.empty() ? " " : " and ") + shown(slip->duration);
    slips.push_back(fmt::format("$tau = {}$", digits_of(slip->duration)));
    each.insert(each.end(), {found.existence, found.orbit.admissible, not_symmetric(motion)});
  }
  outcome.verdict = !list.unresolved.empty() ? Verdict::undecided("the list is not complete")
                    : list.orbits.size() != 2
                        ? Verdict::refuted(fmt::format("there are {}", list.orbits.size()))
                        : all_of(each);
  outcome.found = fmt::format("their slips last {}", fmt::join(slips, " and "));
  return outcome;
}

// Between these the two orbits of S.asymmetric meet.
Outcome fold(Prover&, const Claim&) {
  Outcome outcome = at_the_data(printed(), "exhaustive searches in balls");
  outcome.verdict = Verdict::proved();
  for (const auto& [ur, count] : {std::pair(Rational(31, 200), 0), {Rational(4, 25), 2}}) {
    const words::WordList list = slip_and_stick(ur, 10);
    if (!list.unresolved.empty()) {
      outcome.verdict = Verdict::undecided("a list is not complete");
    } else if (std::ssize(list.orbits) != count) {
      outcome.verdict = Verdict::refuted(fmt::format("there are {}", list.orbits.size()));
    }
  }
  return outcome;
}

}  // namespace

Proofs data_of_S() {
  return {
      {"S.lag", lag}, {"4.lag.only", lag_is_no_consequence}, {"S.asymmetric", asymmetric}, {"S.fold", fold}};
}

}  // namespace stickslip::proofs::pascal2012
