#include "proofs/example_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "numeric/printed.hpp"

namespace stickslip::proofs {
namespace {

constexpr int digits = 30;

OrbitQuestion question_of(const Example& example) {
  const ExactParameters& a = example.data;
  OrbitQuestion question;
  question.family = example.family;
  question.parameters = {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}};
  if (example.phi) {
    question.phi = Range{*example.phi};
  }
  if (example.ur) {
    question.ur = Range{*example.ur};
  }
  question.digits = digits;
  return question;
}

Claim list_claim(const PrintedPlace& where) {
  return {
      .id = where.example.name + ".list",
      .place = where.place,
      .kind = Kind::numbers,
      .words =
          fmt::format("all orbits of the family at the data of {}, admissible or not", where.example.figure),
      .prove = [where](Prover&, const Claim&) {
        const OrbitList& list = orbits_of(where.example);
        const auto good =
            std::count_if(list.orbits.begin(), list.orbits.end(),
                          [](const DecidedOrbit& orbit) { return orbit.admissible.truth == Truth::proved; });
        Outcome outcome = at_the_data(
            where.example,
            fmt::format("exhaustive search in balls: {} orbits, {} of them admissible, {} boxes unresolved",
                        list.orbits.size(), good, list.unresolved.size()));
        outcome.verdict =
            list.complete()
                ? Verdict::proved()
                : Verdict::undecided(fmt::format("{} boxes are unresolved", list.unresolved.size()));
        return outcome;
      }};
}

Claim condition_claim(const PrintedPlace& where, const Requirement& requirement) {
  return {.id = fmt::format("{}.if.{}", where.example.name, requirement.id),
          .place = where.place,
          .kind = Kind::condition,
          .words = fmt::format("{}, at the data of {}", requirement.statement, where.example.figure),
          .prove = [where, id = requirement.id](Prover&, const Claim&) {
            const std::vector<Condition>& conditions = printed_orbit(where.example).conditions;
            const auto found = std::find_if(conditions.begin(), conditions.end(),
                                            [&](const Condition& condition) { return condition.id == id; });
            if (found == conditions.end()) {
              throw InternalError("the orbit has no condition " + id);
            }
            std::string route = "decided in balls for all times of the phase, ends included";
            if (found->margin) {
              route += "; smallest margin " + shown(*found->margin);
            }
            if (found->at) {
              route += " at t = " + shown(*found->at);
            }
            Outcome outcome = at_the_data(where.example, route);
            outcome.uses = {where.orbit};
            outcome.verdict = found->verdict;
            return outcome;
          }};
}

}  // namespace

std::string shown(const Ball& ball) {
  const BallText text = to_text(ball, 6);
  return fmt::format("{} ± {}", text.mid, text.rad);
}

const OrbitList& orbits_of(const Example& example) {
  static std::map<std::string, OrbitList> lists;
  const auto known = lists.find(example.name);
  return known != lists.end() ? known->second
                              : lists.emplace(example.name, list_orbits(question_of(example))).first->second;
}

const Ball& value_of(const DecidedOrbit& orbit, const std::string& name) {
  const auto found = std::find_if(orbit.values.begin(), orbit.values.end(),
                                  [&](const NamedBall& value) { return value.name == name; });
  if (found == orbit.values.end()) {
    throw InternalError("the orbit has no value " + name);
  }
  return found->value;
}

const DecidedOrbit& printed_orbit(const Example& example) {
  std::vector<const DecidedOrbit*> near;
  for (const DecidedOrbit& orbit : orbits_of(example).orbits) {
    if (std::all_of(example.results.begin(), example.results.end(), [&](const PrintedResult& result) {
          const Ball& value = value_of(orbit, result.name);
          const PrintedComparison comparison = compare_printed(result.name, as_printed(result, value), value);
          return (abs(comparison.units) - Ball(100)).is_negative();
        })) {
      near.push_back(&orbit);
    }
  }
  if (near.size() != 1) {
    throw InternalError(
        fmt::format("{} proved orbits lie near the printed one of {}", near.size(), example.figure));
  }
  return *near.front();
}

std::vector<Claim> orbit_claims(const PrintedPlace& where) {
  std::vector<Claim> claims{list_claim(where)};
  const bool ur_known = where.example.family != Family::nonsticking || where.example.ur.has_value();
  for (const Requirement& requirement : requirements(where.example.family, ur_known)) {
    claims.push_back(condition_claim(where, requirement));
  }
  return claims;
}

Ball printed_decimal(const Example& example, const std::string& name) {
  return Ball(as_printed(example.result(name), value_of(printed_orbit(example), name)).value);
}

Claim computed_from(const PrintedPlace& where, const std::string& name, const std::string& formula,
                    std::function<Ball()> value) {
  return {
      .id = fmt::format("{}.from.{}", where.example.name, name),
      .place = where.place,
      .kind = Kind::numbers,
      .words = fmt::format("the printed {} is {} of the other printed values, rounded", name, formula),
      .prove = [=, value = std::move(value)](Prover&, const Claim&) {
        const Ball computed = value();
        Outcome outcome = at_the_data(where.example, formula + " at the printed decimals, in balls");
        outcome.comparisons = {compared(name, as_printed(where.example.result(name), computed), computed)};
        outcome.verdict = outcome.comparisons.front().verdict;
        return outcome;
      }};
}

}  // namespace stickslip::proofs
