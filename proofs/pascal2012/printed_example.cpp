#include "proofs/pascal2012/printed_example.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/printed.hpp"
#include "numeric/families/overshooting.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric::motion;
using namespace methods;
using namespace numeric::families;
using namespace numeric::zeros;

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

Verdict differs_at(const std::vector<Coordinate>& data, const Ball& left, const Ball& right,
                   const std::string& left_name, const std::string& right_name) {
  return Verdict::refuted(Witness{data, {}, left, right, left_name, right_name});
}

std::string orbit_claim(const Example& example) {
  return example.name + ".orbit";
}

Outcome of_its_orbit(const Example& example, const std::string& route) {
  Outcome outcome = at_the_data(example, route);
  outcome.uses = {orbit_claim(example)};
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
    Outcome& outcome, Prover& prover, const Example& example,
    const std::function<kernel::Theorem(const kernel::Theorem&, const orbits::Question&)>& theorem) {
  const std::vector<kernel::Theorem>& orbit = prover.prove(orbit_claim(example)).outcome.theorems;
  if (!orbit.empty()) {
    prove(outcome, [&] {
      return theorem(orbit.front(), orbits::question_of(question_of(example), printed_orbit(example).motion));
    });
  }
}

namespace {

Claim printed_value(const Example& example, const std::string& route, const std::string& name) {
  const PrintedResult& result = example.result(name);
  return {.id = example.name + "." + name,
          .kind = Kind::numbers,
          .words = fmt::format("${} = {}${}", name, result.value.text,
                               result.sign_lost ? " up to its sign, which is not legible in the source" : ""),
          .prove = [&example, &result, route, name](Prover& prover, const Claim&) {
            const Ball proved = printed_orbit(example).value(name);
            const Decimal printed = as_printed(result, proved);
            Outcome outcome = of_its_orbit(example, route);
            outcome.comparisons = {compared(name, printed, proved)};
            outcome.verdict = outcome.comparisons.front().verdict;
            if (outcome.verdict.truth != Truth::undecided) {
              prove_of_orbit(outcome, prover, example,
                             [&](const kernel::Theorem& orbit, const orbits::Question& q) {
                               return orbits::value_theorem(orbit, q, name, printed.lower(), printed.upper(),
                                                            outcome.verdict.truth == Truth::refuted);
                             });
            }
            return outcome;
          }};
}

}  // namespace

std::vector<Claim> printed_values(const Example& example, const std::string& route,
                                  const std::vector<std::string>& names) {
  std::vector<Claim> claims;
  for (const std::string& name : names) {
    claims.push_back(printed_value(example, route, name));
  }
  return claims;
}

std::string residuals(const std::vector<Ball>& values) {
  std::vector<std::string> shown;
  for (const Ball& value : values) {
    shown.push_back(to_text(value, 3).mid);
  }
  return fmt::format("{}", fmt::join(shown, ", "));
}

PrintedClosing printed_closing_overshooting(const ExactParameters& a, const Rational& phi,
                                            const std::array<Decimal, 5>& printed) {
  require_stick_slip_domain(a);
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
  const auto residuals = [&](const auto& number) -> Box<5> {
    Box<5> x;
    std::transform(printed.begin(), printed.end(), x.begin(), number);
    const Ball rest = Ball(2) * Ball::pi() / o.data.omega - x(0) - x(1);
    const Motion m =
        compose(o, Ball(phi), {x(2), x(3), x(4), o.data.V},
                {{PhaseKind::slip, x(0)}, {PhaseKind::overshoot, x(1)}, {PhaseKind::stick, rest}});
    const Phase& stick = m.phases[2];
    const model::Vector4<Ball> Z = flow<Ball>(o, stick.kind, stick.load, stick.Z, stick.duration);
    const Ball& V = o.data.V;  // a stick keeps z2' as it is
    return (Box<5>() << m.phases[1].Z(3) - V, Z(0) - x(2), Z(1) - x(3), Z(2) - x(4), stick.Z(3) - V)
        .finished();
  };
  PrintedClosing result{residuals([](const Decimal& decimal) { return Ball(decimal.value); }),
                        residuals(printed_interval),
                        Verdict::undecided("every closing condition may hold somewhere in the intervals")};
  if (std::ranges::any_of(result.at_intervals, [](const Ball& residual) { return residual.is_nonzero(); })) {
    result.verdict = Verdict::refuted("a closing condition holds nowhere in the printed intervals");
  }
  return result;
}

}  // namespace stickslip::proofs::pascal2012
