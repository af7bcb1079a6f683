#include "numeric/attractors/diagram.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "model/named_data.hpp"
#include "numeric/attractors/settle.hpp"

namespace stickslip::numeric::attractors {

using model::Vector4;

namespace {

// The machine with one of its data replaced.
words::WordQuestion with(words::WordQuestion machine, const std::string& name, const Rational& value) {
  for (const auto& [datum, member] : model::named_data<Rational>) {
    if (datum == name) {
      machine.data.*member = value;
      return machine;
    }
  }
  if (name != "ur") {
    throw UsageError("along: '" + name + "' is none of chi, eta, us, V, omega, p and ur");
  }
  machine.ur = value;
  return machine;
}

// The machine when the question's parameter has the value.
words::WordQuestion machine_at(const DiagramQuestion& question, DiagramPoint& point) {
  words::WordQuestion machine = question.machine.machine;
  if (!question.taken) {
    return with(machine, question.parameter, point.value);
  }
  point.taken = question.taken(point.value);
  machine.data = point.taken->data;
  machine.ur = point.taken->ur.value();
  return machine;
}

}  // namespace

Diagram diagram_of(const DiagramQuestion& question) {
  Diagram result{question, {}, false};
  result.points =
      points_along<DiagramPoint>(question.from, question.to, question.values, [&](DiagramPoint& point) {
        AttractorQuestion here = question.machine;
        here.machine = machine_at(question, point);
        const AttractorList list = find_attractors(here);
        point.attractors = list.attractors;
        for (const Attractor& a : list.attractors) {
          point.once.push_back(states_once_a_period<Vector4<double>>(
              simulation::Simulation(motion::parameters_as<double>(here.machine.data),
                                     scalars::scalar<double>(here.machine.ur), 0, a.state),
              count_once(a)));
        }
        result.interrupted = list.interrupted;
        return !list.interrupted;
      });
  return result;
}

Basins basins_of(const BasinsQuestion& question) {
  const StartBox box = start_box(motion::parameters_as<double>(question.machine.machine.data));
  Basins result{question, {}, {}, {}, false};
  result.starts = starts_in_plane<Vector4<double>>(question.through.value_or(box.middle), box.half,
                                                   question.across, question.pixels);
  const AttractorList list = find_attractors_from(question.machine, result.starts);
  result.attractors = list.attractors;
  result.interrupted = list.interrupted;
  result.at = ends_of(list.attractors, result.starts.size());
  return result;
}

}  // namespace stickslip::numeric::attractors
