// Section 4, example S: the orbit of Fig. 2, and the numbers that are printed for it.
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/pascal2012/printed_closing.hpp"
#include "proofs/pascal2012/symmetric.hpp"
#include "proofs/pascal2012/symmetric_list.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace methods;

namespace {

const Example& printed() {
  return example_named("S");
}

PrintedPlace where() {
  return {printed(), "S.orbit", "Krawczyk's test in balls on equations equivalent to (13) and (15)"};
}

std::vector<Ball> components(const model::Vector4<Ball>& v) {
  return {v(0), v(1), v(2), v(3)};
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
              return as_printed(printed().result(name), printed_orbit(printed()).value(name));
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

// Which printed numbers were computed from which.
std::vector<Claim> origins() {
  const PrintedPlace place = where();
  return {computed_by(place, "T", "$Theta - tau$",
                      [](const auto& printed) { return printed("Theta") - printed("tau"); }),
          computed_by(place, "z20", "$V T/2$, by (16),",
                      [](const auto& printed) {
                        return printed.data().V * printed("T") * printed.number(Rational(1, 2));
                      }),
          computed_by(place, "ur", "(12) solved for $u_r$", [](const auto& printed) {
            const auto a = printed.data();
            const auto cos_phi = sin(a.omega * printed("tau") * printed.number(Rational(1, 2)));
            return a.us + a.chi * (printed("z20") - printed("z10")) - a.p / a.eta * cos_phi;
          })};
}

}  // namespace

std::vector<Claim> example_S() {
  const Claim existence =
      existence_claim(where(),
                      "an orbit with the data of Fig. 2 exists: a slip and a stick that close, with the "
                      "paper's time lag, and obey the friction law at all times");
  return joined({{existence},
                 printed_values(where(), {"tau", "T", "Theta", "z10", "z20", "zdot10", "ur"}),
                 {printed_values_close()},
                 data_of_S(),
                 printed_orbits_of_S(),
                 origins(),
                 orbit_claims(where(), list_of_S())});
}

}  // namespace stickslip::proofs::pascal2012
