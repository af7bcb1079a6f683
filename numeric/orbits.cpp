#include "numeric/orbits.hpp"

#include <algorithm>
#include <array>
#include <variant>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/parameter_box.hpp"
#include "numeric/families/symmetric_list.hpp"

namespace stickslip::numeric {

using namespace families;
using namespace motion;
using namespace scalars;

namespace {

// Enough for the conditions of an orbit that is not next to violating one.
constexpr int fewest_digits = 20;
// How often an undecided condition is looked at with four times the digits.
constexpr int more_attempts = 2;

using Guess = std::vector<double>;

template <class Function>
auto each_parameter(const model::Parameters<Range>& a, const Function& f) {
  return model::Parameters<decltype(f(a.chi))>{f(a.chi), f(a.eta), f(a.us), f(a.V), f(a.omega), f(a.p)};
}

Rational lower(const Range& range) {
  return range.middle - range.radius;
}
Rational upper(const Range& range) {
  return range.middle + range.radius;
}
Ball ball(const Range& range) {
  return range.radius == 0 ? Ball(range.middle) : Ball::from_interval(lower(range), upper(range));
}
std::optional<Ball> ball(const std::optional<Range>& range) {
  return range ? std::optional(ball(*range)) : std::nullopt;
}
ExactParameters middle(const model::Parameters<Range>& a) {
  return each_parameter(a, [](const Range& range) { return range.middle; });
}
model::Parameters<Ball> balls(const model::Parameters<Range>& a) {
  return each_parameter(a, [](const Range& range) { return ball(range); });
}

// An orbit as its motion tells it; ur is u_r, or the largest admissible one.
DecidedOrbit decided_orbit(const OrbitQuestion& q, const Motion& motion, const Ball& ur,
                           const std::vector<Condition>& conditions) {
  const Phase& slip = motion.phases.front();
  const Ball Theta = Ball(2) * Ball::pi() / motion.oscillator.data.omega;
  const bool overshoots = q.family != Family::symmetric;
  const bool never_sticks = q.family == Family::nonsticking;
  const Ball phi = (slip.load + Ball::pi()).is_negative() ? slip.load + Ball(2) * Ball::pi() : slip.load;
  DecidedOrbit orbit;
  orbit.values.push_back({"tau", slip.duration});
  if (overshoots) {
    orbit.values.push_back({"tau1", motion.phases[1].duration});
  }
  if (!never_sticks) {
    orbit.values.push_back({"T", motion.phases.back().duration});
  }
  const model::Vector2<Ball>& d0 = motion.oscillator.d0;
  for (const NamedBall& value : {NamedBall{"Theta", Theta},
                                 {"phi", phi},
                                 {"z10", slip.Z(0)},
                                 {"z20", slip.Z(1)},
                                 {"zdot10", slip.Z(2)},
                                 {"x10", slip.Z(0) + d0(0)},
                                 {"x20", slip.Z(1) + d0(1)},
                                 {"xdot10", slip.Z(2)},
                                 {never_sticks && !q.ur ? "ur_max" : "ur", ur}}) {
    orbit.values.push_back(value);
  }
  orbit.motion = motion;
  orbit.conditions = conditions;
  orbit.admissible = admissible(conditions);
  if (orbit.admissible.truth == Truth::proved) {
    orbit.stability = decide_stability(motion);
  }
  return orbit;
}

// What became of an orbit that the search found.
using Entry = std::variant<DecidedOrbit, UnresolvedPart>;

// The orbit that the middle of the box has, over the whole box.
Entry over_box(const OrbitQuestion& q, const BoxOrbit& box, const std::vector<NamedBall>& at_middle) {
  if (box.existence.truth != Truth::proved) {
    return UnresolvedPart{at_middle,
                          "the orbit at the middle of the parameters is not proved for all of them: " +
                              box.existence.reason + ", first " + box.split};
  }
  DecidedOrbit orbit = decided_orbit(q, box.motion, ball(q.ur).value_or(box.ur), box.conditions);
  orbit.split = orbit.admissible.truth == Truth::undecided ? box.split : "";
  return orbit;
}

// Adds entry(orbit) of each.
template <class Orbit, class MakeEntry>
void add(OrbitList& list, const std::vector<Orbit>& orbits, const MakeEntry& entry) {
  for (const Entry& made : parallel_map(orbits.size(), [&](std::size_t i) { return entry(orbits[i]); })) {
    if (const auto * orbit = std::get_if<DecidedOrbit>(&made)) {
      list.orbits.push_back(*orbit);
    } else {
      list.unresolved.push_back(std::get<UnresolvedPart>(made));
    }
  }
}

void list_symmetric_orbits(OrbitList& list, int digits) {
  const OrbitQuestion& q = list.question;
  const ExactParameters a = middle(q.parameters);
  const SymmetricList found = list_symmetric(a, digits);
  add(list, found.orbits, [&](const SymmetricOrbit& orbit) -> Entry {
    const SymmetricState<Ball>& s = orbit.state;
    if (asks_for_box(q)) {
      const Guess guess{s.tau.approximate(), s.C.approximate()};
      const int sigma = orbit.phase == LoadPhase::first ? 1 : -1;
      return over_box(q, prove_symmetric_over(balls(q.parameters), sigma, guess),
                      {{"tau", s.tau}, {"phi", s.phi}});
    }
    const WorkingPrecision scope(orbit.bits);
    const Motion motion = motion_of(a, orbit);
    return decided_orbit(q, motion, s.ur, decide_conditions(Family::symmetric, motion, s.ur));
  });
  for (const UnresolvedTau& open : found.unresolved) {
    const model::SymmetricData<Ball> data = symmetric_data<Ball>(a, open.phase);
    const Ball phi = model::symmetric_phase<Ball>(data, Ball::pi(), open.tau);
    list.unresolved.push_back({{{"tau", open.tau}, {"phi", phi}}, open.reason});
  }
  if (found.load_absent) {
    list.remarks.push_back(Remark::load_absent);
  }
  if (found.closes_without_stick) {
    list.remarks.push_back(Remark::closes_without_stick);
  }
}

BoxOrbit overshooting_over_box(const OrbitQuestion& q, const OvershootingState<Ball>& s) {
  Guess guess{s.tau.approximate(), s.tau1.approximate(), s.z10.approximate(), s.z20.approximate(),
              s.zdot10.approximate()};
  if (q.phi) {
    return prove_overshooting_over(balls(q.parameters), ball(*q.phi), guess);
  }
  guess.push_back(s.phi.approximate());
  return prove_overshooting_at_friction_over(balls(q.parameters), ball(*q.ur), guess);
}

void list_overshooting_orbits(OrbitList& list, int digits) {
  const OrbitQuestion& q = list.question;
  const ExactParameters a = middle(q.parameters);
  const OvershootingList found = q.phi ? list_overshooting_at_phase(a, q.phi->middle, digits)
                                       : list_overshooting_at_friction(a, q.ur->middle, digits);
  add(list, found.orbits, [&](const OvershootingOrbit& orbit) -> Entry {
    const OvershootingState<Ball>& s = orbit.state;
    if (asks_for_box(q)) {
      return over_box(q, overshooting_over_box(q, s), {{"tau", s.tau}, {"tau1", s.tau1}});
    }
    const WorkingPrecision scope(orbit.bits);
    const Motion motion = motion_of(a, orbit);
    return decided_orbit(q, motion, s.ur, decide_conditions(Family::overshooting, motion, s.ur));
  });
  for (const UnresolvedTimes& open : found.unresolved) {
    list.unresolved.push_back({{{"tau", open.tau}, {"tau1", open.tau1}}, open.reason});
  }
}

void list_nonsticking_orbits(OrbitList& list, int digits) {
  const OrbitQuestion& q = list.question;
  const NonstickingList found = list_nonsticking(middle(q.parameters), digits);
  const WorkingPrecision scope(asks_for_box(q) ? WorkingPrecision::bits() : bits_for(digits) + 64);
  const std::optional<Ball> ur = ball(q.ur);
  add(list, found.orbits, [&](const NonstickingOrbit& orbit) -> Entry {
    if (asks_for_box(q)) {
      const Guess guess{orbit.box(0).approximate(), orbit.box(1).approximate()};
      return over_box(q, prove_nonsticking_over(balls(q.parameters), ur, guess),
                      {{"tau", orbit.tau}, {"phi", orbit.phi}});
    }
    return decided_orbit(q, orbit.motion, ur.value_or(orbit.ur_max), nonsticking_conditions(orbit, ur));
  });
  for (const UnresolvedNonsticking& open : found.unresolved) {
    const Ball phi = open.mu - Ball(q.parameters.omega.middle) * open.tau / Ball(2);
    list.unresolved.push_back({{{"tau", open.tau}, {"phi", phi}}, open.reason});
  }
}

void require_understood(const OrbitQuestion& q) {
  if (q.family != Family::overshooting && q.phi) {
    throw UsageError(q.family == Family::symmetric
                         ? "phi is not given for symmetric orbits: the symmetry fixes it, (pi - omega tau)/2"
                         : "phi is not given for non-sticking orbits: it is a result");
  }
  if (q.family == Family::symmetric && q.ur) {
    throw UsageError("ur is not given for symmetric orbits: it is a result, by (12)");
  }
  if (q.family == Family::overshooting && q.phi.has_value() == q.ur.has_value()) {
    throw UsageError(
        "overshooting orbits need exactly one of phi and ur: with phi, ur is a result; with ur, phi is");
  }
}

// Each bound is on one parameter, so the two corners speak for the whole box.
void require_domain(const OrbitQuestion& q) {
  require_model_domain(each_parameter(q.parameters, lower));
  require_model_domain(each_parameter(q.parameters, upper));
  if (q.ur && lower(*q.ur) <= upper(q.parameters.us)) {
    throw DomainError("ur", stickslip::to_string(lower(*q.ur)),
                      "ur > us = " + stickslip::to_string(upper(q.parameters.us)));
  }
}

OrbitList listed(const OrbitQuestion& question, int digits) {
  OrbitList list{question, {}, {}, {}};
  switch (question.family) {
    case Family::symmetric:
      list_symmetric_orbits(list, digits);
      break;
    case Family::overshooting:
      list_overshooting_orbits(list, digits);
      break;
    case Family::nonsticking:
      list_nonsticking_orbits(list, digits);
      break;
  }
  if (asks_for_box(question)) {
    list.remarks.push_back(Remark::searched_at_middle);
  }
  return list;
}

}  // namespace

bool asks_for_box(const OrbitQuestion& q) {
  const model::Parameters<Range>& a = q.parameters;
  const std::array<const Range *, 6> all{&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p};
  return std::any_of(all.begin(), all.end(), [](const Range * range) { return range->radius != 0; }) ||
         (q.phi && q.phi->radius != 0) || (q.ur && q.ur->radius != 0);
}

bool all_decided(const OrbitList& list) {
  const auto decided = [](const Condition& c) {
    return c.verdict.truth == Truth::proved || c.verdict.truth == Truth::refuted;
  };
  return list.unresolved.empty() &&
         std::all_of(list.orbits.begin(), list.orbits.end(), [&](const DecidedOrbit& orbit) {
           return std::all_of(orbit.conditions.begin(), orbit.conditions.end(), decided);
         });
}

OrbitList list_orbits(const OrbitQuestion& question) {
  require_understood(question);
  require_domain(question);
  int digits = std::max(question.digits, fewest_digits);
  OrbitList list = listed(question, digits);
  for (int attempt = 0; attempt < more_attempts && list.complete() && !all_decided(list) && !interrupted();
       ++attempt) {
    digits *= 4;
    list = listed(question, digits);
  }
  if (interrupted() && !list.unresolved.empty()) {
    list.remarks.push_back(Remark::interrupted);
  }
  return list;
}

}  // namespace stickslip::numeric
