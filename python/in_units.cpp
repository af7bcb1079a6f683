#include "python/in_units.hpp"

#include "report/orbits/neighbourhood.hpp"

namespace stickslip::python {

using namespace numeric::attractors;
using numeric::words::WordOrbit;

namespace {

void tell_in(const Units& units, WordOrbit& o) {
  for (numeric::families::NamedBall& value : o.orbit.values) {
    value.value = units.value(value);
  }
  for (numeric::motion::Phase& phase : o.orbit.motion.phases) {
    phase.duration = units.time(phase.duration);
  }
  if (o.orbit.neighbourhood) {
    o.orbit.neighbourhood = std::make_shared<numeric::machines::Neighbourhood>(
        report::orbits::in_units(*o.orbit.neighbourhood, units));
  }
}

void tell_in(const Units& units, Attractor& a) {
  a.state = units.state(a.state);
  if (a.orbit) {
    tell_in(units, *a.orbit);
  }
}

void tell_in(const Units& units, std::vector<Attractor>& attractors) {
  for (Attractor& a : attractors) {
    tell_in(units, a);
  }
}

void tell_in(const Units& units, std::vector<model::Vector4<double>>& states) {
  for (model::Vector4<double>& X : states) {
    X = units.state(X);
  }
}

}  // namespace

long bits_for(int digits) {
  constexpr long more = 256;
  return static_cast<long>(3.33 * digits) + more;
}

WordOrbits in_units(WordOrbits list, const Units& units) {
  const WorkingPrecision precision(bits_for(list.question.machine.digits));
  for (WordOrbit& o : list.orbits) {
    tell_in(units, o);
  }
  return list;
}

AttractorList in_units(AttractorList list, const Units& units) {
  const WorkingPrecision precision(bits_for(list.question.machine.digits));
  tell_in(units, list.attractors);
  return list;
}

Diagram in_units(Diagram diagram, const Units& units) {
  const WorkingPrecision precision(bits_for(diagram.question.machine.machine.digits));
  for (DiagramPoint& point : diagram.points) {
    const Units here = point.taken ? Units(*point.taken) : units;
    tell_in(here, point.attractors);
    for (auto& states : point.once) {
      tell_in(here, states);
    }
  }
  return diagram;
}

Basins in_units(Basins basins, const Units& units) {
  const WorkingPrecision precision(bits_for(basins.question.machine.machine.digits));
  tell_in(units, basins.attractors);
  tell_in(units, basins.starts);
  return basins;
}

report::orbits::Simulated in_units(report::orbits::Simulated simulated, const Units& units) {
  simulated.record = units.record(simulated.record);
  if (simulated.settles) {
    const WorkingPrecision precision(bits_for(20));
    tell_in(units, *simulated.settles);
  }
  return simulated;
}

}  // namespace stickslip::python
