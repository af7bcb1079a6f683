// What the verdicts on boxes of all families have in common: for the sources of this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "model/machine.hpp"
#include "numeric/atlas/along.hpp"
#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

[[nodiscard]] inline Finding open(Reason reason) {
  return {-1, -1, -1, static_cast<std::uint8_t>(reason)};
}

// Doubles around the number; GMP's lies next to it, on the side of zero.
[[nodiscard]] inline std::pair<double, double> around(const Rational& x) {
  const double near = x.get_d();
  return sgn(x) == 0 ? std::pair{0.0, 0.0}
                     : std::pair{std::nextafter(near, -INFINITY), std::nextafter(near, INFINITY)};
}

template <class T, class S>
struct Data {
  model::Parameters<T> parameters;
  std::optional<T> datum;  // the seventh, where it is given
  double least = 0;        // how short pieces of a phase, as shares of it, are worth looking at
  std::vector<T> axes;     // those that vary
};

// Of machines in SI units, whose values these are, the data by (3), with us as the unit of length.
template <class T, class S>
void take_machines(const Question& q, const std::vector<T>& values, Data<T, S>& data) {
  const auto value = [&](const char * name) -> const T& { return values[place_of(q, name)]; };
  const bool by_force = q.values == Values::forces;
  const T sliding =
      by_force ? value("friction_force_sliding") : T(value("normal_force") * value("friction_sliding"));
  const T turn = T(S(2) * scalars::pi<S>());
  const model::Machine<T> machine{value("m1"),
                                  value("m2"),
                                  value("k1"),
                                  value("k2"),
                                  sliding,
                                  value("belt_velocity"),
                                  value("load_amplitude"),
                                  T(turn * value("load_frequency"))};
  model::Parameters<T>& a = data.parameters;
  a = model::dimensionless<T>(machine, T(sqrt(model::Omega_squared<T>(machine))));
  a.V = a.V / a.us;
  a.p = a.eta * machine.load_amplitude / sliding;
  a.us = T(1);
  if (values.size() == names_of(q).size()) {
    data.datum = takes_phi(*q.family)
                     ? values.back()
                     : T(values.back() / value(by_force ? "friction_force_sliding" : "friction_sliding"));
  }
}

// The axes are the variables 1, 2, …, of which the k-th, if k > 0, is `instead`; the others are left free.
template <class T, class S>
[[nodiscard]] Data<T, S> forms_of(const Question& q, const Box& box, int k = 0, const T& instead = T()) {
  Data<T, S> data;
  std::vector<T> all;
  double width = 0;  // the largest share of a parameter that a radius is
  int next = 1;
  for (const Interval& x : box) {
    if (x.is_point()) {
      all.push_back(T(scalars::scalar<S>(x.lower)));
      continue;
    }
    const double low = around(x.lower).first;
    const double high = around(x.upper).second;
    const double middle = low + (high - low) / 2;
    const double radius = scalars::reach(low, middle, high);
    all.push_back(next == k ? instead : T::variable(middle, radius, next));
    data.axes.push_back(all.back());
    ++next;
    width = std::max(width, middle == 0 ? 1 : radius / std::abs(middle));
  }
  data.least = std::clamp(width / 16, 0x1p-30, 0x1p-5);
  if (q.is_in_SI()) {
    take_machines<T, S>(q, all, data);
    return data;
  }
  data.parameters = {all[0], all[1], all[2], all[3], all[4], all[5]};
  if (all.size() > place_of_datum) {
    data.datum = all[place_of_datum];
  }
  return data;
}

// Looks at what is not known of an orbit.
template <class Orbit>
void judge_orbit(const families::Family& family, const Orbit& orbit, double least, bool without_load,
                 Knowledge::Orbit& known) {
  if (known.admissible == Truth::undecided) {
    known.conditions.resize(family.requirements.size());
    bool all = true;
    for (const bool along : {false, true}) {  // what costs little first
      for (std::size_t k = 0; k < known.conditions.size(); ++k) {
        const motion::Requirement& requirement = family.requirements[k];
        Knowledge::Condition& condition = known.conditions[k];
        if (requirement.along != along || condition.truth == Truth::proved) {
          continue;
        }
        const Decision decision = orbit.holds(requirement, least, condition.open);
        condition.truth = decision.truth;
        condition.hope = decision.hope;
        if (condition.truth == Truth::refuted) {
          known.admissible = Truth::refuted;
          known.conditions.clear();
          return;
        }
        all = all && condition.truth == Truth::proved;
      }
    }
    if (!all) {
      return;
    }
    known.admissible = Truth::proved;
    known.conditions.clear();
  }
  // Without load each shift in time of the orbit is an orbit: none attracts all of its neighbours.
  const Decision stable = without_load ? Decision{Truth::refuted} : orbit.stability();
  known.stable = stable.truth;
  known.of_stability = stable.hope;
}

// What is said of a box whose orbits are these.
[[nodiscard]] Finding finding_of(const std::vector<Knowledge::Sheet>& sheets);

}  // namespace stickslip::numeric::atlas
