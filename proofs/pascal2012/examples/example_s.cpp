// Section 4, example S: the orbit of Fig. 2, the numbers that are printed for it, and its data. These leave
// the load's phase no choice; at all of them, the printed u_r included, there are orbits of slip and stick
// that do not obey (13).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "model/symmetric.hpp"
#include "model/waves.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/words/complete_list.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/pascal2012/examples/symmetric_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;
namespace words = numeric::words;

namespace {

const Example& printed() {
  return example_named("S");
}

// What (16) leaves at the printed decimals, with the paper's load phase.
std::vector<Ball> left_by_16() {
  const Printed<Ball> number{printed()};
  const auto a = families::symmetric_data(printed().data, families::LoadPhase::first);
  const model::Vector2<Ball> Q = model::Q<Ball>(number.data(), a.m) * a.sigma;
  const model::Vector4<Ball> left =
      model::symmetric_residual<Ball>(a.chi, a.m, Q, a.omega, a.Theta, number("tau"),
                                      {number("z10"), number("z20")}, {number("zdot10"), a.V});
  return {left.begin(), left.end()};
}

// By 16.zeros and 16.det, as the determinant does not vanish over the printed interval: for all tau there and
// all z(0), z1'(0) not both of (16).
kernel::Theorem does_not_close(const kernel::Theorem& zeros, const kernel::Theorem& factors) {
  using kernel::Formula;
  using kernel::Term;
  using kernel::Theorem;
  using kernel::Variable;
  const ExactParameters& a = printed().data;
  const Variable tau{"tau"};
  const std::vector<Variable> unknowns{{"z10"}, {"z20"}, {"zdot10"}};
  const Decimal decimal = printed().result("tau").value;
  return at_frequencies(a.chi, a.eta, [&](orbits::Ranges ranges) {
    Theorem result = Theorem::instantiate(tactics::by_rewriting(zeros, factors),
                                          {{{"T"}, Term(2) * kernel::pi() / Term(a.omega) - tau},
                                           {{"omega"}, a.omega},
                                           {{"p"}, a.p},
                                           {{"V"}, a.V},
                                           {{"zdot20"}, a.V}});
    std::vector<Formula> solved;
    result = tactics::settled_by(result, [&](const Formula& one) -> std::optional<Theorem> {
      if (one.variables().contains(unknowns[0])) {
        solved.push_back(one);
        return std::nullopt;
      }
      return one.kind() == kernel::Kind::equal ? Theorem::reflexive(one.parts()[0])
                                               : orbits::sign(one, ranges);
    });
    ranges.emplace(tau, kernel::Interval{decimal.lower(), decimal.upper()});
    const Formula both = kernel::all(solved);
    result = tactics::cut_all(tactics::parts_of(Theorem::assume(both)), result);
    const Theorem apart = orbits::in_pieces(tau, ranges, [&](const orbits::Ranges& here) {
      return orbits::sign_by_parts(differ(result.conclusion().parts()[0], 0), here);
    });
    result = Theorem::consequence({Theorem::discharge(result, both), apart}, negation(both));
    for (const Variable& one : unknowns) {
      result = Theorem::generalize(result, one);
    }
    return orbits::for_all_in(result, {tau}, ranges);
  });
}

Outcome printed_values_close(Prover& prover, const Claim&) {
  Outcome outcome =
      at_the_data(printed(), "the determinant of (16) over the printed interval of $tau$, by signs in balls");
  outcome.uses = {"16.zeros", "16.det"};
  outcome.verdict =
      Verdict::refuted("no solution of (16) has the printed $tau$; at the printed decimals it leaves " +
                       residuals(left_by_16()));
  prove(outcome, [&] { return does_not_close(prover.theorem("16.zeros"), prover.theorem("16.det")); });
  return outcome;
}

// z10 and zdot10 as the first two of (16), which are linear in them, give them.
template <class S>
std::array<S, 2> from_the_slip(const model::Modes<S>& modes) {
  const Printed<S> number{printed()};
  const model::Parameters<S> a = number.data();
  const S tau = number("tau");
  const auto rows = [&](const S& z10, const S& zdot10) {
    return model::Vector4<S>(model::symmetric_residual<S>(a.chi, modes, model::Q<S>(a, modes), a.omega, tau,
                                                          tau, {z10, number("z20")}, {zdot10, a.V}));
  };
  const model::Vector4<S> rest = rows(0, 0), place = rows(1, 0) - rest, speed = rows(0, 1) - rest;
  const S determinant = place(0) * speed(1) - place(1) * speed(0);
  return {S((rest(1) * speed(0) - rest(0) * speed(1)) / determinant),
          S((rest(0) * place(1) - rest(1) * place(0)) / determinant)};
}

Claim by_the_slip(const std::string& name, std::size_t which) {
  using tactics::Symbolic;
  return computed_from(
      printed(), name, "a solution of the slip's half of (16), a function",
      [which] { return from_the_slip(printed_orbit(printed()).motion.oscillator.modes).at(which); },
      [which](const Decimal& decimal, bool it_is) {
        const Rational chi = printed().data.chi;
        return at_frequencies(chi, printed().data.eta, [&](const orbits::Ranges& ranges) {
          const auto modes = model::modes_of<Symbolic>(
              Symbolic(kernel::Term(chi)), kernel::Variable{"omega1"}, kernel::Variable{"omega2"});
          return rounds_to(decimal, from_the_slip(modes).at(which).term, it_is, ranges);
        });
      });
}

// Which printed numbers were computed from which.
std::vector<Claim> origins() {
  const Example& example = printed();
  return {computed_by(example, "T", "$Theta - tau$",
                      [](const auto& printed) { return printed("Theta") - printed("tau"); }),
          computed_by(example, "z20", "$V T/2$, by (16),",
                      [](const auto& printed) {
                        return printed.data().V * printed("T") * printed.number(Rational(1, 2));
                      }),
          by_the_slip("z10", 0), by_the_slip("zdot10", 1),
          computed_by(example, "ur", "(12) solved for $u_r$", [](const auto& printed) {
            const auto a = printed.data();
            const auto cos_phi = sin(a.omega * printed("tau") * printed.number(Rational(1, 2)));
            return a.us + a.chi * (printed("z20") - printed("z10")) - a.p / a.eta * cos_phi;
          })};
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
        [&](const Formula& relation) { return from_sign(orbits::sign(relation, here)); });
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
  return {{"S.16", printed_values_close},
          {"S.lag", lag},
          {"4.lag.only", lag_is_no_consequence},
          {"S.asymmetric", asymmetric},
          {"S.fold", fold}};
}

std::vector<Claim> values_of_S() {
  return printed_values(printed(),
                        "an orbit with the data of Fig. 2 exists: a slip and a stick that close, with the "
                        "paper's time lag, and obey the friction law at all times",
                        "Krawczyk's test in balls on equations equivalent to (13) and (15)",
                        {"tau", "T", "Theta", "z10", "z20", "zdot10", "ur"});
}

std::vector<Claim> orbit_of_S() {
  return joined({origins(), orbit_claims(printed(), list_of_S())});
}

}  // namespace stickslip::proofs::pascal2012
