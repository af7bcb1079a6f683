// Machines with neighbourhoods of their stable orbits, and starts in these.
#pragma once

#include <random>

#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "tests/numeric/examples.hpp"

namespace stickslip::numeric::machines {

using namespace stickslip::examples;

using Simulation = simulation::SimulationOf<Eigen::Dynamic, Eigen::Dynamic>;

// The paper's oscillator with C = share K.
[[nodiscard]] inline Machine with_damping(const ExactParameters& data, const Rational& ur,
                                          const Rational& share = 0) {
  Machine machine{model::friction_oscillator<Rational>(data, ur)};
  for (Eigen::Index i = 0; i < 4; ++i) {
    machine.oscillator.damping.data()[i] = Rational(share * machine.oscillator.stiffness.data()[i]);
  }
  return machine;
}

[[nodiscard]] inline Machine damped_O(const Rational& share = Rational(1, 500)) {
  return with_damping(O(), Rational("45899365993320057/100000000000000000"), share);
}
[[nodiscard]] inline Machine P_with_period_3() {
  return with_damping(motion::parse_parameters("3/10", "4", "1/10", "0", "3/5", "1"), Rational("2996/10000"));
}

// Where lengths are counted l times as large, and times 1/t.
[[nodiscard]] inline Machine in_other_units(Machine machine, const Rational& l, const Rational& t) {
  auto& o = machine.oscillator;
  o.stiffness *= Rational(t * t);
  o.damping *= t;
  o.V *= Rational(l * t);
  o.omega *= t;
  const Rational force(l * t * t);
  for (model::FrictionLaw<Rational> * law : {&o.forward, &o.backward}) {
    law->at_rest *= force;
    for (model::SlidingPiece<Rational>& piece : law->sliding) {
      piece = {piece.from * l * t, piece.force * force, piece.slope * t};
    }
  }
  for (model::HarmonicForce<Rational>& load : o.loads) {
    load.cosine *= force;
    load.sine *= force;
  }
  return machine;
}

// c + S z with |z| = size.
[[nodiscard]] inline Eigen::VectorXd member(const Neighbourhood& n, double size, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd z(n.S.cols());
  for (double& x : z) {
    x = normal(engine);
  }
  return zeros::in_double(n.centre) + zeros::in_double(n.S) * Eigen::VectorXd(z * (size / z.norm()));
}

// How far a state is from c, in parts of the set.
[[nodiscard]] inline double place(const Neighbourhood& n, const Eigen::VectorXd& X) {
  return (zeros::in_double(n.inverse) * (X - zeros::in_double(n.centre))).norm() / n.radius;
}

}  // namespace stickslip::numeric::machines
