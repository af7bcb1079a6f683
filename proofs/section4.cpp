// Section 4: the symmetric orbits; what Appendix 2 takes from there, and example S (Fig. 2).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "numeric/examples.hpp"
#include "numeric/symmetric.hpp"
#include "proofs/methods.hpp"
#include "proofs/paper.hpp"
#include "proofs/vocabulary.hpp"
#include "symbolic/names.hpp"

namespace stickslip::proofs {
namespace {

using namespace vocabulary;

const std::string sec = "sec4";

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

// The printed value; where its sign is lost, with the one that the orbit has.
Decimal as_printed(const PrintedResult& result, const Ball& value) {
  Decimal decimal = result.value;
  if (result.sign_lost && value.is_negative()) {
    decimal.value = -decimal.value;
    decimal.text = "-" + decimal.text;
  }
  return decimal;
}

Comparison compared(const std::string& name, const Decimal& decimal, const Ball& value) {
  const PrintedComparison comparison = compare_printed(name, decimal, value);
  return {name,
          symbolic::latex_name(name),
          decimal.text,
          to_text(comparison.value, 20),
          to_text(comparison.units, 4),
          comparison.verdict};
}

// An outcome for the data of Fig. 2.
Outcome at_the_data(const std::string& route) {
  const ExactParameters& a = printed().data;
  Outcome outcome;
  outcome.route = route;
  outcome.at = {{"chi", a.chi}, {"eta", a.eta}, {"us", a.us}, {"V", a.V}, {"omega", a.omega}, {"p", a.p}};
  return outcome;
}

const char* const ball_route = "Krawczyk's test in balls on equations equivalent to (13) and (15)";

// A printed value against the orbit.
Claim printed_value(const std::string& name, Ball SymmetricState<Ball>::*member) {
  const PrintedResult& result = printed().result(name);
  return {.id = "S." + name,
          .place = sec,
          .kind = Kind::numbers,
          .words = fmt::format("{} = {}{}", name, result.value.text,
                               result.sign_lost ? " up to its sign, which is not legible in the source" : ""),
          .prove = [=](Prover&, const Claim&) {
            const Ball& value = orbit().state.*member;
            Outcome outcome = at_the_data(ball_route);
            outcome.uses = {"S.orbit"};
            outcome.comparisons = {compared(name, as_printed(result, value), value)};
            outcome.verdict = outcome.comparisons.front().verdict;
            return outcome;
          }};
}

// Every component contains zero, and is small enough for that to mean something.
Verdict vanishes(const model::Vector4<Ball>& residual, const std::string& what) {
  for (int i = 0; i < 4; ++i) {
    if (!residual(i).contains_zero()) {
      return Verdict::refuted(fmt::format("component {} of {} is {}", i + 1, what, to_string(residual(i))));
    }
    if (!(residual(i).radius() - Ball(parse_rational("1e-20"))).is_negative()) {
      return Verdict::undecided(
          fmt::format("component {} of {} is only known as {}", i + 1, what, to_string(residual(i))));
    }
  }
  return Verdict::proved();
}

Claim closes() {
  return {.id = "S.orbit",
          .place = sec,
          .kind = Kind::numbers,
          .words = "an orbit with the data of Fig. 2 exists: it closes in all components of (13) and (15)",
          .prove = [](Prover&, const Claim&) {
            Outcome outcome = at_the_data(ball_route);
            outcome.uses = {"5", "10", "17.slip", "17.stick"};
            outcome.verdict = all_of({vanishes(orbit().residual13, "Z(tau) - E Z_0 (13)"),
                                      vanishes(orbit().residual15, "Z_0 - Gamma(T) E Z_0 (15)"),
                                      vanishes(orbit().residual16, "(16)")});
            return outcome;
          }};
}

// "-0.0016, 0.0021, …": midpoints of balls far smaller than their last digit.
std::string residuals(const model::Vector4<Ball>& values) {
  std::vector<std::string> shown;
  for (const Ball& value : values) {
    shown.push_back(to_text(value, 3).mid);
  }
  return fmt::format("{}", fmt::join(shown, ", "));
}

Claim printed_values_close() {
  return {
      .id = "S.16",
      .place = sec,
      .kind = Kind::numbers,
      .words =
          "the printed tau, z_1(0), z_2(0), z_1'(0), each within half a unit of its last place, solve (16)",
      .prove = [](Prover&, const Claim&) {
        const SymmetricState<Ball>& state = orbit().state;
        const PrintedZero zero = printed_zero_of_16(
            printed().data, LoadPhase::first,
            {as_printed(printed().result("tau"), state.tau), as_printed(printed().result("z10"), state.z10),
             as_printed(printed().result("z20"), state.z20),
             as_printed(printed().result("zdot10"), state.zdot10)});
        Outcome outcome;
        outcome.route =
            "(16) evaluated in balls at the printed values and over the intervals that they stand for";
        outcome.verdict = zero.verdict;
        if (outcome.verdict.truth != Truth::proved) {
          outcome.verdict.reason +=
              "; at the printed decimals themselves (16) leaves " + residuals(zero.at_points);
        }
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> section4() {
  using State = SymmetricState<Ball>;
  return {
      {.id = "13.E",
       .place = sec,
       .kind = Kind::identity,
       .printed = {equation(E * E, I4)},
       .words = "E reverses twice to nothing",
       .prove = by_normal_form()},
      {.id = "4.stick",
       .place = sec,
       .kind = Kind::step,
       .printed = {equation(Z(t), Gamma(t - tau) * E * Z0)},
       .words = "the stick that begins at tau where the slip ended by (13)",
       .assumptions = {{"13", equation(Z(tau), E * Z0)}},
       .prove = by_differential_equation(first_order(stick_matrix), zero(4, 1), E * Z0, tau)},
      closes(),
      printed_value("tau", &State::tau),
      printed_value("T", &State::T),
      printed_value("Theta", &State::Theta),
      printed_value("z10", &State::z10),
      printed_value("z20", &State::z20),
      printed_value("zdot10", &State::zdot10),
      printed_value("ur", &State::ur),
      printed_values_close(),
  };
}

}  // namespace stickslip::proofs
