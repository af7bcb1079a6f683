#include "numeric/attractors/lyapunov.hpp"

#include <cmath>

namespace stickslip::numeric::attractors {

using model::Vector4;
using simulation::Simulation;

namespace {

constexpr int blocks = 20;
constexpr int periods_in_block = 250;
// Periods in which the neighbour turns into the fastest direction. On a torus it goes away in proportion to
// time, so what is left of that afterwards is log(6)/5000.
constexpr int lead = 1000;
constexpr double small = 1e-8;

}  // namespace

Exponent largest_exponent(Simulation simulation) {
  Vector4<double> X = simulation.state();
  const double size = small * std::max(X.norm(), 1e-100);
  Vector4<double> deviation = Vector4<double>(0.5, -0.5, 0.5, 0.5) * size;
  // How much the deviation grows in a period, as a logarithm; it is `size` long again after that. A neighbour
  // that falls together with the motion starts anew.
  const auto growth = [&] {
    Simulation neighbour(simulation.data(), simulation.ur(), 0, X + deviation);
    simulation.advance(simulation.period());
    neighbour.advance(simulation.period());
    X = simulation.state();
    deviation = neighbour.state() - X;
    const double length = deviation.norm();
    if (!(length > 1e-6 * size)) {
      deviation = Vector4<double>(0.5, 0.5, -0.5, 0.5) * size;
      return std::log(1e-6);
    }
    deviation *= size / length;
    return std::log(length / size);
  };
  for (int k = 0; k < lead; ++k) {
    (void)growth();
  }
  double sum = 0;
  double squares = 0;
  for (int b = 0; b < blocks; ++b) {
    double mean = 0;
    for (int k = 0; k < periods_in_block; ++k) {
      mean += growth() / periods_in_block;
    }
    sum += mean;
    squares += mean * mean;
  }
  const double value = sum / blocks;
  return {value, std::sqrt(std::max(0.0, squares / blocks - value * value) / (blocks - 1))};
}

}  // namespace stickslip::numeric::attractors
