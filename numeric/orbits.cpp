#include "numeric/orbits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/domain.hpp"
#include "core/interruption.hpp"
#include "numeric/families/through_phases/isolate.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/orbit_over_box.hpp"

namespace stickslip::numeric {

using namespace families;
using namespace motion;
using namespace scalars;

namespace {

// Enough for the conditions of an orbit that is not next to violating one.
constexpr int fewest_digits = 20;
// How often an undecided condition is looked at with four times the digits.
constexpr int more_attempts = 2;

Rational lower(const Range& range) {
  return range.middle - range.radius;
}
Rational upper(const Range& range) {
  return range.middle + range.radius;
}
Rational middle(const Range& range) {
  return range.middle;
}
Ball ball(const Range& range) {
  return range.radius == 0 ? Ball(range.middle) : Ball::from_interval(lower(range), upper(range));
}

// f of each datum.
template <class S>
Given<S> each(const OrbitQuestion& q, S (*f)(const Range&)) {
  return mapped<S>(Given<Range>{q.parameters, q.phi, q.ur}, f);
}

Concluded<Orbit> at_the_point(const OrbitQuestion& q, const Candidate& candidate, int digits) {
  const Given<Rational> given = each(q, middle);
  const ClosedMotion closed = prove_closed(candidate.equations, given, candidate.guess, digits);
  if (closed.existence.truth != Truth::proved) {
    return Unresolved{candidate.where, closed.existence.reason};
  }
  const WorkingPrecision scope(bits_for(digits) + 64);
  const auto lasts = [](const Phase& phase) { return phase.duration.is_positive(); };
  if (!std::all_of(closed.motion.phases.begin(), closed.motion.phases.end(), lasts)) {
    return Unresolved{candidate.where, no_time_at_all};
  }
  if (!candidate.is_same(closed.motion)) {
    return Unresolved{candidate.where, may_be_another};
  }
  // With a stick r = ur (12) is a result; the datum, if there is one, has been met.
  const bool known = given.ur && !has_stick(*q.family);
  return decided_orbit(*q.family, closed, known ? std::optional(Ball(*given.ur)) : std::nullopt);
}

// The orbit that the middle of the box has, over the whole box.
Concluded<Orbit> over_the_box(const OrbitQuestion& q, const Candidate& candidate) {
  OrbitOverBox over = prove_over_box(*q.family, candidate, each(q, ball));
  if (over.existence.truth != Truth::proved) {
    return Unresolved{candidate.where,
                      "the orbit at the middle of the parameters is not proved for all of them: " +
                          over.existence.reason + ", first " + over.split};
  }
  over.orbit.split = over.orbit.admissible.truth == Truth::undecided ? over.split : "";
  return over.orbit;
}

void require_understood(const OrbitQuestion& q) {
  if (q.family == nullptr) {
    throw UsageError("a family of orbits is missing: " + names_of_families());
  }
  const Family& family = *q.family;
  if (q.phi && !family.why_no_phi.empty()) {
    throw UsageError(family.why_no_phi);
  }
  if (q.ur && !family.why_no_ur.empty()) {
    throw UsageError(family.why_no_ur);
  }
  if (!family.why_datum.empty() && q.phi.has_value() == q.ur.has_value()) {
    throw UsageError(family.why_datum);
  }
  if (q.neighbourhood && asks_for_box(q)) {
    throw UsageError("a neighbourhood is proved at numbers, and a parameter is an interval");
  }
  if (q.neighbourhood && !q.ur && !has_stick(family)) {
    throw UsageError(
        "how far motions come back from depends on ur: a neighbourhood of orbits that never "
        "stick needs it");
  }
}

// Each bound is on one parameter, so the two corners speak for the whole box.
void require_domain(const OrbitQuestion& q) {
  require_model_domain(each(q, lower).data);
  require_model_domain(each(q, upper).data);
  const int belt = q.family->belt;
  const Rational V = belt < 0 ? upper(q.parameters.V) : lower(q.parameters.V), us = upper(q.parameters.us);
  require(belt == 0 || V * belt > 0, "V", V,
          fmt::format("V {} 0 for {} orbits", belt < 0 ? '<' : '>', q.family->name));
  if (q.ur) {
    require(lower(*q.ur) > us, "ur", lower(*q.ur), "ur > us = " + stickslip::to_string(us));
  }
}

// Where a natural frequency may be a multiple k omega for a member of the box: with k = 1 there is no Q (7),
// and a motion that never sticks closes in no way or in many for every k. The first two multiples stand for
// all: next to omega = 0 there are too many to list, or no bound for them.
std::vector<Unresolved> resonances_inside(const OrbitQuestion& q) {
  const WorkingPrecision scope(bits_for(fewest_digits));
  const model::Parameters<Ball> a = each(q, ball).data;
  const model::Modes<Ball> m = model::modes<Ball>(a.chi, a.eta);
  std::vector<Unresolved> result;
  for (const auto& [omega_j, name] : {std::pair(m.omega1, "omega1"), std::pair(m.omega2, "omega2")}) {
    const Ball ratio = omega_j / a.omega;
    Ball first = ratio.lower();
    arb_ceil(first.raw(), first.raw(), WorkingPrecision::bits());
    first = (first - Ball(1)).is_positive() ? first : Ball(1);
    const int listed = has_stick(*q.family) ? 1 : 2;
    for (int i = 0; i < listed; ++i) {
      const Ball k = first + Ball(i);
      const bool concerns = !has_stick(*q.family) || k.overlaps(Ball(1));
      if (concerns && ratio.overlaps(k)) {
        const bool more = i == 1 && ratio.overlaps(k + Ball(1));
        result.push_back({{{"omega", a.omega}},
                          fmt::format("a resonance may lie in the box of parameters: {} omega = {}{}",
                                      k.approximate(), name, more ? ", and further multiples" : "")});
      }
    }
  }
  return result;
}

OrbitList concluded(const OrbitQuestion& q, const Found& found, int digits) {
  OrbitList list{q, {}, found.unresolved, found.remarks, found.cells, 0};
  const bool box = asks_for_box(q);
  conclude_all(
      found.candidates,
      [&](const Candidate& candidate) {
        return box ? over_the_box(q, candidate) : at_the_point(q, candidate, digits);
      },
      list.orbits, list.unresolved);
  list.open_at_middle = box ? list.unresolved.size() - found.unresolved.size() : 0;
  if (box) {
    list.remarks.push_back(Remark::searched_at_middle);
    std::ranges::move(resonances_inside(q), std::back_inserter(list.unresolved));
  }
  return list;
}

}  // namespace

Orbit decided_orbit(const Family& family, const ClosedMotion& closed, const std::optional<Ball>& ur) {
  const Motion& motion = closed.motion;
  Orbit orbit;
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    orbit.values.push_back({family.durations[k], motion.phases[k].duration});
  }
  for (const NamedBall& value : start_values(motion)) {
    orbit.values.push_back(value);
  }
  const Ball friction = ur.value_or(friction_of(family, closed));
  orbit.values.push_back({ur || has_stick(family) ? "ur" : "ur_max", friction});
  orbit.motion = motion;
  orbit.conditions = families::conditions(family, closed, has_stick(family) ? friction : ur);
  orbit.admissible = admissible(orbit.conditions);
  if (is_admissible(orbit)) {
    orbit.stability = decide_stability(motion);
  }
  return orbit;
}

words::WordQuestion machine_of(const OrbitQuestion& question, const Orbit& orbit) {
  constexpr int digits = 17;
  const Rational ur = question.ur ? question.ur->middle : parse_rational(to_text(orbit.ur(), digits).mid);
  return {each(question, middle).data, ur, question.digits};
}

bool all_decided(const OrbitList& list) {
  return list.unresolved.empty() &&
         std::ranges::all_of(list.orbits, [](const Orbit& orbit) { return all_decided(orbit); });
}

void require_answerable(const OrbitQuestion& question) {
  require_understood(question);
  require_domain(question);
}

OrbitList list_orbits(const OrbitQuestion& question) {
  require_answerable(question);
  const Found found = question.family->search(each(question, middle));
  int digits = std::max(question.digits, fewest_digits);
  OrbitList list = concluded(question, found, digits);
  for (int attempt = 0; attempt < more_attempts && list.complete() && !all_decided(list) && !interrupted();
       ++attempt) {
    digits *= 4;
    list = concluded(question, found, digits);
  }
  for (Orbit& orbit : list.orbits) {
    if (question.neighbourhood && is_stable(orbit)) {
      machines::surround(orbit, machine_of(question, orbit));
    }
  }
  if (interrupted() && !list.unresolved.empty()) {
    list.remarks.push_back(Remark::interrupted);
  }
  return list;
}

}  // namespace stickslip::numeric
