// Section 4, example S: u_r = 0.1607 is printed among the data of Fig. 2. For a symmetric orbit it is a
// result and another number; at all the printed data there are orbits of slip and stick that do not obey
// (13).
#include <fmt/format.h>

#include <algorithm>

#include "core/sinc.hpp"
#include "numeric/words/complete_list.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;
namespace words = numeric::words;

namespace {

const Example& printed() {
  return example_named("S");
}

// Where 13.slip leaves the load's phase free (4.lag.needed): omega_j tan(omega_j tau/2) = omega tan(omega
// tau/2) for both j. Times the cosines these are omega_j^2 - omega^2 times tau/4 times s_j, where s_j =
// sinc((omega_j + omega) tau/2) + sinc((omega_j - omega) tau/2). Whether in each part of [from, to] some s_j
// has no zero.
bool phase_is_fixed(const model::Oscillator<Ball>& o, const Rational& from, const Rational& to, int depth) {
  const Ball half = Ball::hull(Ball(from), Ball(to)) / Ball(2);
  const auto balance = [&](const Ball& omega_j) {
    return sinc((omega_j + o.data.omega) * half) + sinc((omega_j - o.data.omega) * half);
  };
  if (balance(o.modes.omega1).is_nonzero() || balance(o.modes.omega2).is_nonzero()) {
    return true;
  }
  const Rational middle = (from + to) / 2;
  return depth > 0 && phase_is_fixed(o, from, middle, depth - 1) && phase_is_fixed(o, middle, to, depth - 1);
}

Claim lag_claim() {
  return {.id = "S.lag",
          .kind = Kind::numbers,
          .origin = Origin::auxiliary,
          .words =
              "at the data of Fig. 2 there is no slip, however long in the period, that leaves the load's "
              "phase free (4.lag.needed): the list of orbits, which has both phases of the time lag, is "
              "that of all orbits that obey (13)",
          .prove = [](Prover&, const Claim&) {
            Outcome outcome =
                at_the_data(printed(),
                            "at each time up to 11, which is beyond $Theta$, $omega_j tan(omega_j tau/2)$ is "
                            "not $omega tan(omega tau/2)$ for one of the two $j$, in balls; the load acts on "
                            "both modes, by 7.modal");
            outcome.uses = {"4.lag.needed", "7.modal"};
            const WorkingPrecision precision(128);
            const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(printed().data));
            const Rational last(11);
            const bool beyond = (Ball(last) - Ball(2) * Ball::pi() / o.data.omega).is_positive();
            outcome.verdict = beyond && phase_is_fixed(o, Rational(0), last, 20)
                                  ? Verdict::proved()
                                  : Verdict::undecided("both may hold at some time");
            return outcome;
          }};
}

// Fig. 2 gives u_r as a datum, beside the others.
Claim friction_claim() {
  return {.id = "S.data",
          .kind = Kind::theorem,
          .words = "Fig. 2: $u_r = 0.1607$ belongs to the data of a symmetric orbit",
          .prove = [](Prover&, const Claim&) {
            const OrbitList& list = orbits_of(printed()).list;
            const Decimal given = printed().result("ur").value;
            Outcome outcome =
                at_the_data(printed(), "the $u_r$ of each orbit in the complete list, in balls");
            outcome.uses = {"S.list", "S.lag"};
            outcome.verdict = Verdict::undecided("the list is not complete");
            if (!list.complete() || list.orbits.empty()) {
              return outcome;
            }
            const Ball stated = Ball::hull(Ball(given.lower()), Ball(given.upper()));
            if (std::ranges::any_of(list.orbits,
                                    [&](const Orbit& orbit) { return orbit.ur().overlaps(stated); })) {
              outcome.verdict = Verdict::undecided("some orbit may have this u_r");
              return outcome;
            }
            outcome.verdict = Verdict::refuted(Witness{outcome.at,
                                                       {},
                                                       value_of(printed_orbit(printed()), "ur"),
                                                       Ball(given.value),
                                                       "$u_r$ of the orbit",
                                                       "the printed one"});
            return outcome;
          }};
}

// Z(tau) is not E Z_0.
Verdict not_symmetric(const Motion& motion) {
  const bool slip_first = motion.phases[0].kind == PhaseKind::slip;
  const Phase &slip = motion.phases[slip_first ? 0 : 1], &stick = motion.phases[slip_first ? 1 : 0];
  return (slip.Z(0) + stick.Z(0)).is_nonzero() || (slip.Z(1) + stick.Z(1)).is_nonzero()
             ? Verdict::proved()
             : Verdict::undecided("the places at both ends of the slip may be opposite");
}

Claim asymmetric_claim() {
  return {
      .id = "S.asymmetric",
      .kind = Kind::theorem,
      .origin = Origin::new_result,
      .words =
          "at the data of Fig. 2, $u_r = 0.1607$ included, exactly two orbits of one slip and one stick in "
          "a period of the load exist; they obey every condition, and are not symmetric",
      .prove = [](Prover&, const Claim&) {
        const Rational ur = printed().result("ur").value.value;
        const words::WordList list =
            words::all_orbits({.data = printed().data, .ur = ur, .digits = 20}, words::Word::parse("ST"), 1);
        Outcome outcome = at_the_data(printed(), "exhaustive search in balls; the slips last");
        outcome.at.push_back({"ur", ur});
        std::vector<Verdict> each;
        for (const words::WordOrbit& found : list.orbits) {
          const Motion& motion = found.orbit.motion;
          const auto slip = std::ranges::find(motion.phases, PhaseKind::slip,
                                              [](const Phase& phase) { return phase.kind; });
          outcome.route += (each.empty() ? " " : " and ") + shown(slip->duration);
          each.insert(each.end(), {found.existence, found.orbit.admissible, not_symmetric(motion)});
        }
        outcome.verdict = !list.unresolved.empty() ? Verdict::undecided("the list is not complete")
                          : list.orbits.size() != 2
                              ? Verdict::refuted(fmt::format("there are {}", list.orbits.size()))
                              : all_of(each);
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> data_of_S() {
  return {lag_claim(), friction_claim(), asymmetric_claim()};
}

}  // namespace stickslip::proofs::pascal2012
