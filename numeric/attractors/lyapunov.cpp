#include "numeric/attractors/lyapunov.hpp"

#include <algorithm>
#include <cmath>

#include "core/interruption.hpp"

namespace stickslip::numeric::attractors {

namespace {

constexpr int blocks = 20;
constexpr double small = 1e-8;

}  // namespace

template <int N, int L>
Exponent largest_exponent(simulation::SimulationOf<N, L> simulation, long periods) {
  using State = typename simulation::SimulationOf<N, L>::State;
  const long in_block = std::max(1L, periods / blocks);
  const long lead = blocks * in_block / 5;  // in which the neighbour turns into the fastest direction
  State X = simulation.state();
  const double size = small * std::max(X.norm(), 1e-100);
  // In all components, with one sign turned.
  const auto aside = [&](Eigen::Index turned) {
    State direction = State::Constant(X.size(), size / std::sqrt(static_cast<double>(X.size())));
    direction(std::min(turned, X.size() - 1)) *= -1;
    return direction;
  };
  State deviation = aside(1);
  simulation::SimulationOf<N, L> neighbour = simulation;
  // How much the deviation grows in a period, as a logarithm; it is `size` long again after that. A neighbour
  // that falls together with the motion starts anew.
  const auto growth = [&] {
    neighbour.restart(0, X + deviation);
    simulation.advance(simulation.period());
    neighbour.advance(simulation.period());
    X = simulation.state();
    deviation = neighbour.state() - X;
    const double length = deviation.norm();
    if (!(length > 1e-6 * size)) {
      deviation = aside(2);
      return std::log(1e-6);
    }
    deviation *= size / length;
    return std::log(length / size);
  };
  for (long k = 0; k < lead && !interrupted(); ++k) {
    (void)growth();
  }
  double sum = 0;
  double squares = 0;
  for (int b = 0; b < blocks; ++b) {
    double mean = 0;
    for (long k = 0; k < in_block; ++k) {
      if (interrupted()) {
        return {};
      }
      mean += growth() / static_cast<double>(in_block);
    }
    sum += mean;
    squares += mean * mean;
  }
  const double value = sum / blocks;
  // From a fifth of the time to six fifths of it a deviation in proportion to time grows by six.
  const double least = 3 * std::log(6) / static_cast<double>(blocks * in_block);
  return {value, std::sqrt(std::max(0.0, squares / blocks - value * value) / (blocks - 1)), least};
}

template Exponent largest_exponent(simulation::SimulationOf<2, 1>, long);
template Exponent largest_exponent(simulation::SimulationOf<Eigen::Dynamic, Eigen::Dynamic>, long);

Kind kind_by(const Exponent& exponent) {
  return exponent.is_positive() ? Kind::irregular
         : exponent.is_zero()   ? Kind::quasi_periodic
                                : Kind::unsettled;
}

}  // namespace stickslip::numeric::attractors
