// Section 4, example S: the orbit of Fig. 2, and the numbers that are printed for it.
#include <algorithm>

#include "core/sinc.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/printed_closing.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;

namespace {

const Example& printed() {
  return example_named("S");
}

const char * const ball_route = "Krawczyk's test in balls on equations equivalent to (13) and (15)";

PrintedPlace where() {
  return {printed(), "S.orbit", ball_route};
}

Claim orbit_value(const std::string& name) {
  return printed_value(where(), name, [name] { return value_of(printed_orbit(printed()), name); });
}

std::vector<Ball> components(const model::Vector4<Ball>& v) {
  return {v(0), v(1), v(2), v(3)};
}

Claim closes() {
  return {.id = "S.orbit",
          .kind = Kind::numbers,
          .words = "an orbit with the data of Fig. 2 exists: it closes in all components of (13) and (15)",
          .prove = [](Prover&, const Claim&) {
            Outcome outcome = at_the_data(printed(), ball_route);
            outcome.uses = {"5", "10", "17.slip", "17.stick"};
            const WorkingPrecision precision(192);
            const Motion& motion = printed_orbit(printed()).motion;  // its stick begins at E Z_0
            const std::vector<model::Vector4<Ball>> gap = gaps(motion);
            const Phase& slip = motion.phases.front();
            const model::Vector4<Ball> x(slip.duration, slip.Z(0), slip.Z(1), slip.Z(2));
            outcome.verdict = all_of(
                {vanishes(components(gap.front()), "$Z(tau) - E Z_0$ (13)"),
                 vanishes(components(gap.back()), "$Z_0 - Gamma(T) E Z_0$ (15)"),
                 vanishes(components(equations_16(printed().data, families::LoadPhase::first)(x)), "(16)")});
            return outcome;
          }};
}

Claim printed_values_close() {
  return {.id = "S.16",
          .kind = Kind::numbers,
          .origin = Origin::reading,
          .words =
              "the printed $tau$, $z_1(0)$, $z_2(0)$, $z_1'(0)$, each within half a unit of its last place, "
              "solve (16)",
          .prove = [](Prover&, const Claim&) {
            const auto value = [](const char * name) {
              return as_printed(printed().result(name), value_of(printed_orbit(printed()), name));
            };
            const PrintedClosing<4> zero = printed_zero_of_16(
                printed().data, {value("tau"), value("z10"), value("z20"), value("zdot10")});
            Outcome outcome;
            outcome.route =
                "(16) evaluated in balls at the printed values and over the intervals that they stand for";
            outcome.verdict = zero.verdict;
            if (outcome.verdict.truth != Truth::proved) {
              outcome.verdict.reason +=
                  "; at the printed decimals themselves (16) leaves " + residuals(components(zero.at_points));
            }
            return outcome;
          }};
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
                            "not $omega tan(omega tau/2)$ for one of the two $j$, in balls");
            outcome.uses = {"4.lag.needed"};
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
  return {
      .id = "S.data",
      .kind = Kind::theorem,
      .words = "Fig. 2: $u_r = 0.1607$ belongs to the data of a symmetric orbit",
      .prove = [](Prover&, const Claim&) {
        const OrbitList& list = orbits_of(printed()).list;
        const Decimal given = printed().result("ur").value;
        Outcome outcome = at_the_data(printed(), "the $u_r$ of each orbit in the complete list, in balls");
        outcome.uses = {"S.list", "S.lag"};
        outcome.verdict = Verdict::undecided("the list is not complete");
        if (!list.complete() || list.orbits.empty()) {
          return outcome;
        }
        const Ball stated = Ball::hull(Ball(given.lower()), Ball(given.upper()));
        if (std::ranges::any_of(list.orbits,
                                [&](const Orbit& orbit) { return value_of(orbit, "ur").overlaps(stated); })) {
          outcome.verdict = Verdict::undecided("some orbit may have this u_r");
          return outcome;
        }
        outcome.verdict = Verdict::refuted(
            Witness{outcome.at, {}, value_of(printed_orbit(printed()), "ur"), Ball(given.value)});
        return outcome;
      }};
}

// Which printed numbers were computed from which.
std::vector<Claim> origins() {
  const Example& example = printed();
  const PrintedPlace place = where();
  return {
      computed_from(
          place, "T", "$Theta - tau$",
          [&example] { return printed_decimal(example, "Theta") - printed_decimal(example, "tau"); }),
      computed_from(place, "z20", "$V T/2$, by (16),",
                    [&example] { return Ball(example.data.V) * printed_decimal(example, "T") / Ball(2); }),
      computed_from(place, "ur", "(12) solved for $u_r$", [&example] {
        const ExactParameters& a = example.data;
        const Ball cos_phi = sin(Ball(a.omega) * printed_decimal(example, "tau") / Ball(2));
        return Ball(a.us) +
               Ball(a.chi) * (printed_decimal(example, "z20") - printed_decimal(example, "z10")) -
               Ball(a.p) / Ball(a.eta) * cos_phi;
      })};
}

}  // namespace

std::vector<Claim> example_S() {
  std::vector<Claim> claims{
      closes(),
      orbit_value("tau"),
      orbit_value("T"),
      orbit_value("Theta"),
      orbit_value("z10"),
      orbit_value("z20"),
      orbit_value("zdot10"),
      orbit_value("ur"),
      printed_values_close(),
      lag_claim(),
      friction_claim(),
  };
  for (std::vector<Claim> more : {origins(), orbit_claims(where())}) {
    std::move(more.begin(), more.end(), std::back_inserter(claims));
  }
  return claims;
}

}  // namespace stickslip::proofs::pascal2012
