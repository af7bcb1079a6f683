#include "proofs/pascal2012/examples/example_orbit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/transformed.hpp"
#include "numeric/families/family.hpp"
#include "numeric/simulation/agreement.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/tactics/tactics.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric;
using namespace numeric::motion;
using namespace numeric::simulation;
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
  const PrintedComparison comparison = compare_printed(printed, value);
  return {
      name, symbolic::typeset::latex_name(name), printed.text, value, comparison.units, comparison.verdict};
}

Outcome at_the_data(const Example& example, const std::string& route) {
  return {.route = route, .at = data_of(example)};
}

Verdict differs_at(const std::vector<Coordinate>& data, const Ball& left, const Ball& right,
                   const std::string& left_name, const std::string& right_name) {
  return Verdict::refuted(Witness{data, {}, left, right, left_name, right_name});
}

std::string orbit_claim(const Example& example) {
  return example.name + ".orbit";
}

Outcome of_its_orbit(const Example& example, const std::string& route) {
  return {.route = route, .uses = {orbit_claim(example)}, .at = data_of(example)};
}

void prove(Outcome& outcome, const std::function<kernel::Theorem()>& theorem) {
  if (!outcome.verdict.is_decided()) {
    return;
  }
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
            prove_of_orbit(outcome, prover, example,
                           [&](const kernel::Theorem& orbit, const orbits::Question& q) {
                             return orbits::value_theorem(orbit, q, name, printed.lower(), printed.upper(),
                                                          outcome.verdict.truth == Truth::refuted);
                           });
            return outcome;
          }};
}

// That the printed orbit exists, as a theorem.
Claim existence_claim(const Example& example, const std::string& words) {
  return {
      .id = orbit_claim(example),
      .kind = Kind::numbers,
      .words = words,
      .prove =
          [&example](Prover&, const Claim&) {
            Outcome outcome = at_the_data(
                example,
                "the phases in closed form, their equations at the ends by Krawczyk's test, the inequalities "
                "between the ends by signs in balls, and by mean values where the two sides meet");
            try {
              const Motion& motion = printed_orbit(example).motion;
              const orbits::Question question = orbits::question_of(question_of(example), motion);
              outcome.theorems = {orbits::orbit_theorem(question, motion),
                                  orbits::locally_unique(question, motion)};
              outcome.by_kernel = true;
              outcome.verdict = Verdict::proved();
            } catch (const kernel::KernelError& error) {
              outcome.verdict = Verdict::undecided(error.what());
            }
            return outcome;
          },
      .parts = {words,
                "the equations by which phases in closed form fit together, a characteristic polynomial "
                "for both frequencies among them, have exactly one solution in a box about that of the "
                "orbit"}};
}

}  // namespace

std::vector<Claim> printed_values(const Example& example, const std::string& words, const std::string& route,
                                  const std::vector<std::string>& names) {
  std::vector<Claim> claims{existence_claim(example, words)};
  for (const std::string& name : names) {
    claims.push_back(printed_value(example, route, name));
  }
  return claims;
}

std::string residuals(const std::vector<Ball>& values) {
  const auto texts = transformed(values, [](const Ball& value) { return to_text(value, 3).mid; });
  return fmt::format("{}", fmt::join(texts, ", "));
}

namespace {

// "4 orbits, all of them admissible: …".
std::string what_is_listed(const OrbitList& list) {
  std::vector<std::string> good, formal;
  for (const Orbit& orbit : list.orbits) {
    (is_admissible(orbit) ? good : formal).push_back(told_apart(orbit, *list.question.family));
  }
  const std::size_t all = list.orbits.size();
  std::string result = fmt::format("{} orbit{}, {} of them admissible", all, all == 1 ? "" : "s",
                                   formal.empty() ? "all" : std::to_string(good.size()));
  if (!good.empty()) {
    result += fmt::format(": {}", fmt::join(good, "; "));
  }
  return formal.empty() ? result : fmt::format("{}; not admissible: {}", result, fmt::join(formal, "; "));
}

Claim list_claim(const Example& example, const ListTheorem& theorem) {
  return {
      .id = example.name + ".list",
      .kind = Kind::numbers,
      .origin = Origin::new_result,
      .words = fmt::format("all orbits of the family at the data of {}, admissible or not", example.figure),
      .prove =
          [&example, theorem](Prover&, const Claim&) {
            const OrbitList& list = orbits_of(example).list;
            const auto good = std::ranges::count_if(list.orbits, is_admissible);
            Outcome outcome = at_the_data(
                example,
                fmt::format(
                    "exhaustive search in balls: {} orbits, {} of them admissible, {} boxes unresolved",
                    list.orbits.size(), good, list.unresolved.size()));
            if (!list.complete()) {
              outcome.verdict =
                  Verdict::undecided(fmt::format("{} boxes are unresolved", list.unresolved.size()));
              return outcome;
            }
            outcome.verdict = Verdict::proved();
            outcome.found = what_is_listed(list);
            if (theorem.prove) {
              outcome.uses = theorem.uses;
              prove(outcome, [&] { return theorem.prove(list); });
            }
            return outcome;
          },
      .parts = theorem.prove ? std::vector{theorem.says} : std::vector<std::string>{}};
}

Claim condition_claim(const Example& example, const Requirement& requirement) {
  return {.id = fmt::format("{}.if.{}", example.name, requirement.id),
          .kind = Kind::condition,
          .origin = Origin::auxiliary,  // of the paper if one of its statements names it
          .words = fmt::format("{}, at the data of {}", requirement.statement, example.figure),
          .prove = [&example, requirement](Prover& prover, const Claim&) {
            const std::vector<Condition>& conditions = printed_orbit(example).conditions;
            const auto found = std::ranges::find_if(
                conditions, [&](const Condition& condition) { return condition.id == requirement.id; });
            if (found == conditions.end()) {
              throw InternalError("the orbit has no condition " + requirement.id);
            }
            std::string route = "decided in balls for all times of the phase, ends included";
            if (found->margin) {
              route += "; smallest margin " + shown(*found->margin);
            }
            const bool divided = requirement.along && (requirement.touches.start || requirement.touches.end);
            if (found->margin && divided) {
              route += " of the distance, divided by min(1, time to the end of the phase where it is zero)";
            }
            if (found->at) {
              route += " at $t = " + shown(*found->at) + "$";
            }
            Outcome outcome = of_its_orbit(example, route);
            outcome.verdict = found->verdict;
            if (outcome.verdict.truth == Truth::proved) {
              prove_of_orbit(outcome, prover, example,
                             [&](const kernel::Theorem& orbit, const orbits::Question& q) {
                               return orbits::condition_theorem(orbit, q, requirement);
                             });
            }
            return outcome;
          }};
}

std::string shown_complex(const ComplexBall& number) {
  const bool real = number.im.is_exact() && number.im.contains_zero();
  return real ? shown(number.re) : fmt::format("$({}) + ({}) i$", shown(number.re), shown(number.im));
}

Ball largest_modulus(const Stability& stability) {
  Ball largest(0);
  for (const ComplexBall& mu : stability.multipliers) {
    const Ball modulus = sqrt(mu.squared_modulus());
    arb_max(largest.raw(), largest.raw(), modulus.raw(), WorkingPrecision::bits());
  }
  return largest;
}

Claim stability_claim(const Example& example) {
  return {
      .id = example.name + ".stability",
      .kind = Kind::numbers,
      .origin = Origin::new_result,
      .words = fmt::format("the stability of the orbit of {}, which the paper leaves open", example.figure),
      .prove = [&example](Prover& prover, const Claim&) {
        const std::optional<Stability>& stability = printed_orbit(example).stability;
        Outcome outcome = of_its_orbit(example, "Floquet multipliers, enclosed in balls");
        if (!stability || stability->kind == StabilityKind::undecided) {
          outcome.verdict = Verdict::undecided(stability ? stability->reason : "the orbit is not admissible");
          return outcome;
        }
        outcome.route += fmt::format(": {}, with {}", to_string(stability->kind),
                                     fmt::join(transformed(stability->multipliers, shown_complex), ", "));
        outcome.found = fmt::format("{}, the largest $|mu|$ of a Floquet multiplier $mu$ is ${}$ ({})",
                                    to_string(stability->kind), digits_of(largest_modulus(*stability)),
                                    told_apart(printed_orbit(example), *example.family));
        outcome.verdict = Verdict::proved();
        prove_of_orbit(outcome, prover, example, orbits::stability_theorem);
        return outcome;
      }};
}

// The bound is far above the integrator's tolerance of 1e-12 and far below any printed digit.
constexpr double raw_bound = 1e-8;

Claim raw_law_claim(const Example& example) {
  return {.id = example.name + ".raw",
          .kind = Kind::check,
          .origin = Origin::auxiliary,
          .words = fmt::format(
              "the equations of motion (2) with the friction law (4), integrated over one period without any "
              "closed form from the orbit of {}, give its phases, their times and the same state to 1e-8",
              example.figure),
          .prove = [&example](Prover&, const Claim&) {
            const Agreement found = agreement(
                printed_orbit(example),
                [](const Start& start, double duration) { return follow_raw_law(start, duration); });
            Outcome outcome =
                of_its_orbit(example,
                             "integration in floating point by Boost.Odeint at the tolerance 1e-12: a "
                             "check of the closed forms by another route, not a proof in balls");
            outcome.verdict =
                !found.difference.empty() ? Verdict::undecided("the motions differ: " + found.difference)
                : found.time_error <= raw_bound && found.closure <= raw_bound
                    ? Verdict::checked(fmt::format("times agree to {:.1e}, states to {:.1e}",
                                                   found.time_error, found.closure))
                    : Verdict::undecided(fmt::format("times differ by {:.1e}, the state by {:.1e}",
                                                     found.time_error, found.closure));
            return outcome;
          }};
}

}  // namespace

std::string shown(const Ball& ball) {
  const BallText text = to_text(ball, 6);
  return fmt::format("{} ± {}", text.mid, text.rad);
}

std::string told_apart(const Orbit& orbit, const Family& family) {
  std::string result;
  for (const std::string name : {"tau", "tau1", "phi", "ur"}) {
    const bool tells = name != "ur" || families::has_stick(family);
    const bool has = std::ranges::any_of(
        orbit.values, [&](const NamedBall& value) { return value.name == name && !value.value.is_exact(); });
    if (tells && has) {
      result += fmt::format("{}${} = {}$", result.empty() ? "" : ", ", name == "ur" ? "u_r" : name,
                            digits_of(orbit.value(name)));
    }
  }
  return result;
}

std::string digits_of(const Ball& ball) {
  const std::string more = to_text(ball, 16).mid;
  std::size_t end = 0;
  int significant = 0;
  for (; end < more.size() && significant < 6; ++end) {
    significant += (more[end] >= '1' && more[end] <= '9') || (more[end] == '0' && significant > 0) ? 1 : 0;
  }
  if (more.find('e') != std::string::npos || more.find('.') >= end) {
    return shown(ball);
  }
  // A number whose digits go on lies beyond what is cut off, and by less than one unit.
  const Decimal cut = parse_decimal(more.substr(0, end));
  const Ball beyond = abs(ball) - Ball(Rational(abs(cut.value)));
  const bool known = beyond.is_positive() && (Ball(cut.unit) - beyond).is_positive();
  return known ? cut.text + "..." : shown(ball);
}

namespace {

// Far below what the printed decimals leave open, and no single machine any more.
const Rational box_radius(1, 1000000);

Claim box_claim(const Example& example) {
  return {.id = example.name + ".box",
          .kind = Kind::theorem,
          .origin = Origin::new_result,
          .words =
              fmt::format("orbits of the family exist, and obey every condition, for all data within 1e-6 of "
                          "those of {} ($V = 0$, $phi$ and $u_r$, where they are data, as they are)",
                          example.figure),
          .prove = [&example](Prover&, const Claim&) {
            Outcome outcome = of_its_orbit(example, "the orbit for all members of the box, in balls");
            OrbitQuestion question = question_of(example, 10);
            model::Parameters<Range>& a = question.parameters;
            for (Range * one : {&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p}) {
              one->radius = one->middle == 0 ? Rational(0) : box_radius;
            }
            const OrbitList list = list_orbits(question);
            outcome.verdict = std::ranges::any_of(list.orbits, is_admissible)
                                  ? Verdict::proved()
                                  : Verdict::undecided("no orbit is proved for the whole box");
            return outcome;
          }};
}

Claim motion_claim(const Example& example) {
  return {
      .id = example.name + ".motion",
      .kind = Kind::numbers,
      .origin = Origin::auxiliary,
      .words = fmt::format("the orbit of {} as one motion $X$, $X(t + Theta) = X(t)$ for all $t$, that obeys "
                           "(2) or (9) and (4) during each phase, ends included",
                           example.figure),
      .prove = [&example](Prover& prover, const Claim&) {
        Outcome outcome =
            of_its_orbit(example, "the motions of its phases, joined at their ends and continued");
        outcome.verdict = prover.prove(orbit_claim(example)).outcome.verdict;
        prove_of_orbit(outcome, prover, example, orbits::one_motion);
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> orbit_claims(const Example& example, const ListTheorem& list) {
  std::vector<Claim> claims{motion_claim(example), box_claim(example), list_claim(example, list)};
  const Family& family = *example.family;
  const bool ur_known = families::has_stick(family) || example.ur.has_value();
  for (const Requirement& requirement : families::requirements(family, ur_known)) {
    claims.push_back(condition_claim(example, requirement));
  }
  claims.push_back(stability_claim(example));
  claims.push_back(raw_law_claim(example));
  return claims;
}

Rational printed_decimal(const Example& example, const std::string& name) {
  return as_printed(example.result(name), printed_orbit(example).value(name)).value;
}

kernel::Theorem rounds_to(const Decimal& decimal, const kernel::Term& value, bool it_does,
                          const orbits::Ranges& ranges) {
  const auto is = [&](const kernel::Formula& relation) { return orbits::sign_by_parts(relation, ranges); };
  if (it_does) {
    return tactics::both(
        {is(kernel::at_most(decimal.lower(), value)), is(kernel::at_most(value, decimal.upper()))});
  }
  const auto above = tactics::attempt([&] { return is(kernel::less(decimal.upper(), value)); });
  return above ? *above : is(kernel::less(value, decimal.lower()));
}

Claim computed_from(const Example& example, const std::string& name, const std::string& formula,
                    std::function<Ball()> value,
                    std::function<kernel::Theorem(const Decimal&, bool)> theorem) {
  return {.id = fmt::format("{}.from.{}", example.name, name),
          .kind = Kind::numbers,
          .origin = Origin::auxiliary,
          .words = fmt::format("the printed ${}$ is {} of the other printed values, rounded", name, formula),
          .prove = [&example, name, formula, value = std::move(value), theorem = std::move(theorem)](
                       Prover&, const Claim&) {
            const Ball computed = value();
            const Decimal printed = as_printed(example.result(name), computed);
            Outcome outcome = at_the_data(example, formula + " at the printed decimals, in balls");
            outcome.comparisons = {compared(name, printed, computed)};
            outcome.verdict = outcome.comparisons.front().verdict;
            prove(outcome, [&] { return theorem(printed, outcome.verdict.truth == Truth::proved); });
            return outcome;
          }};
}

}  // namespace stickslip::proofs::pascal2012
