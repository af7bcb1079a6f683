#include "numeric/orbits.hpp"

#include <algorithm>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/nonsticking.hpp"
#include "numeric/symmetric_list.hpp"

namespace stickslip {
namespace {

// Enough for the conditions of an orbit that is not next to violating one.
constexpr int fewest_digits = 20;
// How often an undecided condition is looked at with four times the digits.
constexpr int more_attempts = 2;

void fill_in_verdict(OrbitList& list, DecidedOrbit orbit) {
  orbit.admissible = admissible(orbit.conditions);
  list.orbits.push_back(std::move(orbit));
}

// phi of the symmetric family over a range of tau.
Ball symmetric_phi(const ExactParameters& a, LoadPhase phase, const Ball& tau) {
  return model::symmetric_phase<Ball>(symmetric_data<Ball>(a, phase), Ball::pi(), tau);
}

DecidedOrbit decided(const ExactParameters& a, const SymmetricOrbit& found) {
  const WorkingPrecision scope(found.bits);
  const SymmetricState<Ball>& s = found.state;
  const model::Parameters<Ball> data{Ball(a.chi), Ball(a.eta),   Ball(a.us),
                                     Ball(a.V),   Ball(a.omega), Ball(a.p)};
  // The stick begins at E Z0 (13).
  const model::Vector4<Ball> Z0(s.z10, s.z20, s.zdot10, data.V);
  const model::Vector4<Ball> ZC(-s.z10, -s.z20, s.zdot10, data.V);
  DecidedOrbit orbit;
  orbit.values = {{"tau", s.tau}, {"T", s.T},           {"Theta", s.Theta},   {"phi", s.phi},
                  {"z10", s.z10}, {"z20", s.z20},       {"zdot10", s.zdot10}, {"x10", s.x10},
                  {"x20", s.x20}, {"xdot10", s.zdot10}, {"ur", s.ur}};
  orbit.motion = {model::oscillator<Ball>(data),
                  {{PhaseKind::slip, Ball(0), s.tau, s.phi, Z0},
                   {PhaseKind::stick, s.tau, s.T, Ball(s.phi + data.omega * s.tau), ZC}}};
  orbit.conditions = decide_conditions(Family::symmetric, orbit.motion, s.ur);
  return orbit;
}

void list_symmetric_orbits(OrbitList& list, int digits) {
  const ExactParameters& a = list.question.parameters;
  const SymmetricList found = list_symmetric(a, digits);
  for (const SymmetricOrbit& orbit : found.orbits) {
    fill_in_verdict(list, decided(a, orbit));
  }
  for (const UnresolvedTau& open : found.unresolved) {
    list.unresolved.push_back(
        {{{"tau", open.tau}, {"phi", symmetric_phi(a, open.phase, open.tau)}}, open.reason});
  }
  if (found.load_absent) {
    list.remarks.push_back(Remark::load_absent);
  }
  if (found.closes_without_stick) {
    list.remarks.push_back(Remark::closes_without_stick);
  }
}

DecidedOrbit decided(const NonstickingOrbit& found, const std::optional<Rational>& ur) {
  const Phase& slip = found.motion.phases.front();
  const std::optional<Ball> given = ur ? std::optional(Ball(*ur)) : std::nullopt;
  DecidedOrbit orbit;
  orbit.values = {{"tau", found.tau}, {"tau1", found.tau1},    {"Theta", found.Theta}, {"phi", found.phi},
                  {"z10", slip.Z(0)}, {"z20", slip.Z(1)},      {"zdot10", slip.Z(2)},  {"x10", found.x10},
                  {"x20", found.x20}, {"xdot10", found.xdot10}};
  orbit.values.push_back(given ? NamedBall{"ur", *given} : NamedBall{"ur_max", found.ur_max});
  orbit.motion = found.motion;
  orbit.conditions = nonsticking_conditions(found, given);
  return orbit;
}

void list_nonsticking_orbits(OrbitList& list, int digits) {
  const OrbitQuestion& q = list.question;
  const NonstickingList found = list_nonsticking(q.parameters, digits);
  const WorkingPrecision scope(4L * digits + 96);
  for (const NonstickingOrbit& orbit : found.orbits) {
    fill_in_verdict(list, decided(orbit, q.ur));
  }
  for (const UnresolvedNonsticking& open : found.unresolved) {
    const Ball phi = open.mu - Ball(q.parameters.omega) * open.tau / Ball(2);
    list.unresolved.push_back({{{"tau", open.tau}, {"phi", phi}}, open.reason});
  }
}

void require_meaningful(const OrbitQuestion& q) {
  const bool meaningful = q.family == Family::symmetric      ? !q.phi && !q.ur
                          : q.family == Family::overshooting ? q.phi.has_value() != q.ur.has_value()
                                                             : !q.phi;
  if (!meaningful) {
    throw InternalError("phi or ur given to a family of orbits that does not take it");
  }
  if (q.ur && *q.ur <= q.parameters.us) {
    throw DomainError("ur", to_string(*q.ur), "ur > us = " + to_string(q.parameters.us));
  }
}

OrbitList listed(const OrbitQuestion& question, int digits) {
  OrbitList list{question, {}, {}, {}};
  switch (question.family) {
    case Family::symmetric:
      list_symmetric_orbits(list, digits);
      return list;
    case Family::overshooting:
      throw InternalError("the search for overshooting orbits is not there yet");
    case Family::nonsticking:
      list_nonsticking_orbits(list, digits);
      return list;
  }
  throw InternalError("a family of no known kind");
}

}  // namespace

bool all_decided(const OrbitList& list) {
  return std::all_of(list.orbits.begin(), list.orbits.end(), [](const DecidedOrbit& orbit) {
    return std::all_of(orbit.conditions.begin(), orbit.conditions.end(), [](const Condition& condition) {
      return condition.verdict.truth == Truth::proved || condition.verdict.truth == Truth::refuted;
    });
  });
}

OrbitList list_orbits(const OrbitQuestion& question) {
  require_model_domain(question.parameters);
  require_meaningful(question);
  int digits = std::max(question.digits, fewest_digits);
  OrbitList list = listed(question, digits);
  for (int attempt = 0; attempt < more_attempts && list.complete() && !all_decided(list); ++attempt) {
    digits *= 4;
    list = listed(question, digits);
  }
  return list;
}

}  // namespace stickslip
