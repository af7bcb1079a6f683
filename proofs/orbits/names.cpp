#include "proofs/orbits/names.hpp"

#include <fmt/format.h>

#include "proofs/orbits/definitions.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using tactics::Symbolic;

Term Names::phi() const {
  return q_.phi && !q_.lag ? Term(*q_.phi) : Variable{"phi"};
}
Term Names::ur() const {
  return q_.ur ? Term(*q_.ur) : Variable{"ur"};
}
Variable Names::motion(std::size_t k) {
  return {fmt::format("X{}", k + 1), motion_type};
}
Term Names::state(std::size_t k, const Term& t) {
  return apply(motion(k), t);
}
Term Names::friction_at(std::size_t k, const Term& t) const {
  return friction()({state(k, t), t, chi(), eta(), omega_, q_.data.p, phi()});
}

Term Names::start(std::size_t k) const {
  Symbolic sum;
  for (std::size_t i = 0; i < k; ++i) {
    sum += Symbolic(Variable{q_.durations.at(i)});
  }
  return sum.term;
}
Term Names::end(std::size_t k) const {
  return k + 1 == q_.phases.size() ? Term(2 * q_.period) * pi() / omega_ : start(k + 1);
}

Formula Names::phase(std::size_t k) const {
  const bool stick = q_.phases.at(k) == PhaseKind::stick;
  std::vector<Term> arguments{motion(k), start(k), end(k), chi(), eta()};
  if (!stick) {
    arguments.push_back(us());
  }
  arguments.insert(arguments.end(), {V(), omega_, q_.data.p, phi()});
  if (stick) {
    arguments.push_back(ur());
  }
  return phase_definition(q_.phases[k])(arguments);
}
Definitions Names::definitions(std::size_t k) const {
  Definitions result{phase_definition(q_.phases.at(k))};
  if (q_.phases[k] == PhaseKind::stick) {
    result.insert(friction());
  }
  return result;
}

}  // namespace stickslip::proofs::orbits
