#include "proofs/pascal2012/printed_example.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/printed.hpp"
#include "proofs/methods/example_orbits.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric::motion;
using namespace methods;

Decimal as_printed(const PrintedResult& result, const Ball& value) {
  Decimal decimal = result.value;
  if (result.sign_lost && value.is_negative()) {
    decimal.value = -decimal.value;
    decimal.text = "-" + decimal.text;
  }
  return decimal;
}

Comparison compared(const std::string& name, const Decimal& printed, const Ball& value) {
  const PrintedComparison comparison = compare_printed(name, printed, value);
  return {name,
          symbolic::typeset::latex_name(name),
          printed.text,
          comparison.value,
          comparison.units,
          comparison.verdict};
}

Outcome at_the_data(const Example& example, const std::string& route) {
  Outcome outcome;
  outcome.route = route;
  outcome.at = data_of(example);
  return outcome;
}

void prove(Outcome& outcome, const std::function<kernel::Theorem()>& theorem) {
  try {
    outcome.theorems = {theorem()};
    outcome.by_kernel = true;
  } catch (const kernel::KernelError& error) {
    outcome.verdict = Verdict::undecided(error.what());
  }
}

std::vector<Coordinate> coordinates(const ExactParameters& a, const Rational& ur) {
  return {{"chi", a.chi}, {"eta", a.eta},     {"us", a.us}, {"ur", ur},
          {"V", a.V},     {"omega", a.omega}, {"p", a.p}};
}

Outcome proved_by(Outcome outcome, const std::set<std::string>& uses,
                  const std::function<kernel::Theorem()>& theorem) {
  outcome.uses = uses;
  outcome.verdict = Verdict::proved();
  prove(outcome, theorem);
  return outcome;
}

void prove_of_orbit(
    Outcome& outcome, Prover& prover, const PrintedPlace& where,
    const std::function<kernel::Theorem(const kernel::Theorem&, const orbits::Question&)>& theorem) {
  const std::vector<kernel::Theorem>& orbit = prover.prove(where.orbit).outcome.theorems;
  if (!orbit.empty()) {
    prove(outcome, [&] {
      return theorem(orbit.front(),
                     orbits::question_of(question_of(where.example), printed_orbit(where.example).motion));
    });
  }
}

namespace {

Claim printed_value(const PrintedPlace& where, const std::string& name) {
  const PrintedResult& result = where.example.result(name);
  return {.id = where.example.name + "." + name,
          .kind = Kind::numbers,
          .words = fmt::format("${} = {}${}", name, result.value.text,
                               result.sign_lost ? " up to its sign, which is not legible in the source" : ""),
          .prove = [=](Prover& prover, const Claim&) {
            const Ball proved = printed_orbit(where.example).value(name);
            const Decimal printed = as_printed(result, proved);
            Outcome outcome = at_the_data(where.example, where.route);
            outcome.uses = {where.orbit};
            outcome.comparisons = {compared(name, printed, proved)};
            outcome.verdict = outcome.comparisons.front().verdict;
            if (outcome.verdict.truth != Truth::undecided) {
              prove_of_orbit(outcome, prover, where,
                             [&](const kernel::Theorem& orbit, const orbits::Question& q) {
                               return orbits::value_theorem(orbit, q, name, printed.lower(), printed.upper(),
                                                            outcome.verdict.truth == Truth::refuted);
                             });
            }
            return outcome;
          }};
}

}  // namespace

std::vector<Claim> printed_values(const PrintedPlace& where, const std::vector<std::string>& names) {
  std::vector<Claim> claims;
  for (const std::string& name : names) {
    claims.push_back(printed_value(where, name));
  }
  return claims;
}

Verdict vanishes(const std::vector<Ball>& residual, const std::string& what) {
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const std::string component =
        residual.size() == 1 ? what : fmt::format("component {} of {}", i + 1, what);
    if (!residual[i].contains_zero()) {
      return Verdict::refuted(fmt::format("{} is {}", component, to_string(residual[i])));
    }
    if (!(residual[i].radius() - Ball(parse_rational("1e-20"))).is_negative()) {
      return Verdict::undecided(fmt::format("{} is only known as {}", component, to_string(residual[i])));
    }
  }
  return Verdict::proved();
}

std::string residuals(const std::vector<Ball>& values) {
  std::vector<std::string> shown;
  for (const Ball& value : values) {
    shown.push_back(to_text(value, 3).mid);
  }
  return fmt::format("{}", fmt::join(shown, ", "));
}

}  // namespace stickslip::proofs::pascal2012
