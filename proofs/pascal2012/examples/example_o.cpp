// Section 5, example O: the orbit of Fig. 3, and the numbers that are printed for it.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/waves.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_o_closing.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace methods;
using namespace symbols;

namespace {

const Example& printed() {
  return example_named("O");
}

// --- (21)-(24) at the printed values ---

const kernel::Variable tau_{"tau"}, tau1_{"tau1"};

// Theorems on (21)-(23), with tau, tau1 and whatever else is printed in the intervals that the decimals stand
// for.
struct Interval {
  kernel::Variable name;
  Decimal printed;
};
kernel::Theorem over_intervals(const std::vector<Interval>& intervals,
                               const std::function<kernel::Theorem(const orbits::Ranges&)>& theorem) {
  return at_frequencies(printed().data.chi, printed().data.eta, [&](orbits::Ranges ranges) {
    std::vector<kernel::Variable> names;
    for (const Interval& one : intervals) {
      names.push_back(one.name);
      ranges.emplace(one.name, kernel::Interval{one.printed.lower(), one.printed.upper()});
    }
    return orbits::for_all_in(theorem(ranges), names, ranges);
  });
}

Decimal decimal(const std::string& name) {
  return printed().result(name).value;
}
Ball exactly(const std::string& name) {
  return Ball(printed_decimal(printed(), name));
}

// F_1 and F_2 are not both zero.
kernel::Theorem not_compatible() {
  return over_intervals({{tau_, decimal("tau")}, {tau1_, decimal("tau1")}}, incompatible);
}

Outcome printed_times(Prover&, const Claim&) {
  Outcome outcome = at_the_data(
      printed(), "a sum of $F_1$ and $F_2$ is not zero over the printed intervals, in balls, by slopes");
  const auto F =
      model::compatibility<Ball>(closing_of_O(exactly("tau"), exactly("tau1"), model::Reading::derived));
  outcome.verdict = Verdict::refuted(
      "$F_1$ and $F_2$ are not both zero in the printed intervals; at the printed decimals they are " +
      residuals({F[0], F[1]}));
  prove(outcome, not_compatible);
  return outcome;
}

Decimal signed_decimal(const std::string& name) {
  return as_printed(printed().result(name), printed_orbit(printed()).value(name));
}

// z2' is not V at tau, by its equation (21) with the coefficients (50).
kernel::Theorem belt_not_met() {
  using kernel::Variable;
  const Variable z10{"z10"}, z20{"z20"}, zdot10{"zdot10"};
  const auto k = closing_of_O(tau_, tau1_, model::Reading::derived);
  const tactics::Symbolic speed = k.a[3] * z10 + k.b[3] * z20 + k.c[3] * zdot10 + k.d[3];
  return over_intervals({{tau_, decimal("tau")},
                         {z10, signed_decimal("z10")},
                         {z20, signed_decimal("z20")},
                         {zdot10, decimal("zdot10")}},
                        [&](const orbits::Ranges& ranges) {
                          return orbits::in_pieces(tau_, ranges, [&](const orbits::Ranges& here) {
                            return orbits::sign_by_parts(kernel::differ(speed.term, 0), here);
                          });
                        });
}

Outcome printed_state_closes(Prover&, const Claim&) {
  Outcome outcome = at_the_data(printed(), "(18)-(20) in balls over the printed intervals");
  const PrintedClosing closing = printed_closing_overshooting(
      printed().data, *printed().phi,
      {decimal("tau"), decimal("tau1"), signed_decimal("z10"), signed_decimal("z20"), decimal("zdot10")});
  outcome.verdict = closing.verdict;  // refuted or undecided
  prove(outcome, belt_not_met);
  outcome.verdict.reason += "; at the printed decimals $z2'(tau) - V$ and $Z(Theta) - Z_0$ are " +
                            residuals({closing.at_points.begin(), closing.at_points.end()});
  return outcome;
}

// (22) at the printed tau and tau_1: one of Delta1, Delta2, Delta3 over Delta.
template <class Ratio>
Claim by_22(const std::string& name, const Ratio& ratio) {
  return computed_from(
      printed(), name, "(22) with $T = Theta - tau - tau_1$",
      [ratio] {
        return Ball(ratio(
            model::cramer<Ball>(closing_of_O(exactly("tau"), exactly("tau1"), model::Reading::derived))));
      },
      [ratio](const Decimal& decimal, bool it_is) {
        const auto at = [](const char * time) { return kernel::Term(printed_decimal(printed(), time)); };
        const auto c =
            model::cramer<tactics::Symbolic>(closing_of_O(at("tau"), at("tau1"), model::Reading::derived));
        return over_intervals({}, [&](const orbits::Ranges& ranges) {
          return rounds_to(decimal, ratio(c).term, it_is, ranges);
        });
      });
}

// The printed c_1 takes F_1 farther from zero than the derived one.
kernel::Theorem farther_from_zero() {
  const auto square = [](model::Reading reading) {
    return power(model::compatibility<tactics::Symbolic>(closing_of_O(tau_, tau1_, reading))[0].term, 2);
  };
  return over_intervals(
      {{tau_, decimal("tau")}, {tau1_, decimal("tau1")}}, [&](const orbits::Ranges& ranges) {
        return orbits::sign_by_parts(
            kernel::less(square(model::Reading::derived), square(model::Reading::printed)), ranges);
      });
}

Outcome not_by_the_printed_c1(Prover&, const Claim&) {
  const Ball tau = printed_interval(decimal("tau")), tau1 = printed_interval(decimal("tau1"));
  const auto F_1 = [&](model::Reading reading) {
    return abs(model::compatibility<Ball>(closing_of_O(tau, tau1, reading))[0]);
  };
  Outcome outcome = at_the_data(printed(), "(23) in balls over the printed intervals");
  const Ball more = F_1(model::Reading::printed) - F_1(model::Reading::derived);
  outcome.verdict = more.is_positive()   ? Verdict::proved()
                    : more.is_negative() ? Verdict::refuted("it is nearer")
                                         : Verdict::undecided("the balls overlap");
  if (outcome.verdict.truth == Truth::proved) {
    prove(outcome, farther_from_zero);
  }
  return outcome;
}

// What the rounding of omega = 0.6289, the datum on which most depends, can explain: parts of the interval
// that the decimal stands for, in each of which some printed result is none of the orbit's.
Outcome rounding_of_the_data(Prover&, const Claim&) {
  constexpr int parts = 10;
  const Decimal omega = parse_decimal(stickslip::to_string(printed().data.omega));
  const Rational step = (omega.upper() - omega.lower()) / parts;
  Outcome outcome{.verdict = Verdict::proved(),
                  .route = "the orbit for all $omega$ of each tenth of the interval, in balls"};
  std::map<std::string, std::vector<Rational>> explained;
  std::optional<Ball> z20;
  for (int i = 0; i < parts; ++i) {
    OrbitQuestion question = question_of(printed());
    const Rational middle = omega.lower() + (i + Rational(1, 2)) * step;
    question.parameters.omega = {middle, step / 2};
    const OrbitList list = list_orbits(question);
    const auto orbit = std::ranges::find_if(list.orbits, is_admissible);
    bool all = true;
    for (const PrintedResult& result : printed().results) {
      const bool may =
          orbit == list.orbits.end() ||
          orbit->value(result.name).overlaps(printed_interval(as_printed(result, orbit->value(result.name))));
      all = all && may;
      if (may) {
        explained[result.name].insert(explained[result.name].end(), {middle - step / 2, middle + step / 2});
      }
    }
    if (all) {
      outcome.verdict = Verdict::undecided("some $omega$ may give all of them");
      return outcome;
    }
    z20 = z20 ? Ball::hull(*z20, orbit->value("z20")) : orbit->value("z20");
  }
  const auto between = [&](const std::string& name) {
    const auto& ends = explained[name];
    return ends.empty() ? "no $omega$ at all"
                        : fmt::format("an $omega$ from {} to {}", stickslip::to_string(ends.front()),
                                      stickslip::to_string(ends.back()));
  };
  outcome.found = fmt::format("$z_20$ is {} over the interval; the printed $tau_1$ needs {}, $z_20$ {}",
                              shown(*z20), between("tau1"), between("z20"));
  return outcome;
}

}  // namespace

Proofs numbers_of_O() {
  return {{"O.23", printed_times},
          {"O.21", printed_state_closes},
          {"O.c1", not_by_the_printed_c1},
          {"O.rounding", rounding_of_the_data}};
}

std::vector<Claim> orbit_of_O() {
  return joined(
      {printed_values(printed(),
                      "an orbit with the data of Fig. 3 exists: a slip, an overshoot and a stick that close, "
                      "(18)-(20), and obey the friction law at all times",
                      "Krawczyk's test in balls on equations equivalent to (18)-(20)",
                      {"tau", "tau1", "T", "Theta", "ur", "z10", "z20", "zdot10"}),
       orbit_claims(printed())});
}

std::vector<Claim> origins_of_O() {
  return {by_22("z10", [](const auto& c) { return c.Delta1 / c.Delta; }),
          by_22("z20", [](const auto& c) { return c.Delta2 / c.Delta; }),
          by_22("zdot10", [](const auto& c) { return c.Delta3 / c.Delta; }),
          computed_by(printed(), "ur", "(24)",
                      [](const auto& known) {
                        const std::array z{known("z10"), known("z20")};
                        return model::friction_at(
                            known.data(), [&](int i) { return z.at(static_cast<std::size_t>(i)); },
                            known.number(*printed().phi));
                      }),
          computed_by(printed(), "T", "$Theta - tau - tau_1$",
                      [](const auto& known) { return known("Theta") - known("tau") - known("tau1"); })};
}

}  // namespace stickslip::proofs::pascal2012
