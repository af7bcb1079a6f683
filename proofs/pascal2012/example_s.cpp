// Section 4, example S: the orbit of Fig. 2, and the numbers that are printed for it.
#include <fmt/format.h>

#include "core/error.hpp"
#include "numeric/families/symmetric.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric::families;
using namespace numeric::motion;
using namespace methods;

namespace {

const Example& printed() {
  return example_named("S");
}

// The proved orbit whose slip lasts as long as printed, if there is exactly one.
const SymmetricOrbit& orbit() {
  static const SymmetricOrbit found = [] {
    constexpr int digits = 30;
    const Ball tau = printed_interval(printed().result("tau").value);
    std::vector<SymmetricOrbit> near;
    for (const SymmetricProof& proof : solve_symmetric(printed().data, digits)) {
      if (proof.existence.truth == Truth::proved && proof.orbit.phase == LoadPhase::first &&
          (abs(proof.orbit.state.tau - tau) - Ball(1)).is_negative()) {
        near.push_back(proof.orbit);
      }
    }
    if (near.size() != 1) {
      throw InternalError(fmt::format("{} proved orbits lie near the printed one of Fig. 2", near.size()));
    }
    return near.front();
  }();
  return found;
}

const char * const ball_route = "Krawczyk's test in balls on equations equivalent to (13) and (15)";

PrintedPlace where() {
  return {printed(), "S.orbit", ball_route};
}

Claim orbit_value(const std::string& name, Ball SymmetricState<Ball>::*member) {
  return printed_value(where(), name, [member] { return orbit().state.*member; });
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
            outcome.verdict = all_of({vanishes(components(orbit().residual13), "$Z(tau) - E Z_0$ (13)"),
                                      vanishes(components(orbit().residual15), "$Z_0 - Gamma(T) E Z_0$ (15)"),
                                      vanishes(components(orbit().residual16), "(16)")});
            return outcome;
          }};
}

Claim printed_values_close() {
  return {.id = "S.16",
          .kind = Kind::numbers,
          .words =
              "the printed $tau$, $z_1(0)$, $z_2(0)$, $z_1'(0)$, each within half a unit of its last place, "
              "solve (16)",
          .prove = [](Prover&, const Claim&) {
            const SymmetricState<Ball>& state = orbit().state;
            const PrintedZero zero =
                printed_zero_of_16(printed().data, LoadPhase::first,
                                   {as_printed(printed().result("tau"), state.tau),
                                    as_printed(printed().result("z10"), state.z10),
                                    as_printed(printed().result("z20"), state.z20),
                                    as_printed(printed().result("zdot10"), state.zdot10)});
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
  using State = SymmetricState<Ball>;
  std::vector<Claim> claims{
      closes(),
      orbit_value("tau", &State::tau),
      orbit_value("T", &State::T),
      orbit_value("Theta", &State::Theta),
      orbit_value("z10", &State::z10),
      orbit_value("z20", &State::z20),
      orbit_value("zdot10", &State::zdot10),
      orbit_value("ur", &State::ur),
      printed_values_close(),
  };
  for (std::vector<Claim> more : {origins(), orbit_claims(where())}) {
    std::move(more.begin(), more.end(), std::back_inserter(claims));
  }
  return claims;
}

}  // namespace stickslip::proofs::pascal2012
