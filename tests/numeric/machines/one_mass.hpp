// One mass on a belt: on a spring 1 with a dashpot 1/10, without a load.
#pragma once

#include "numeric/machines/machine.hpp"

namespace stickslip::numeric::machines {

[[nodiscard]] inline Machine one_mass(const Rational& V, const model::FrictionLaw<Rational>& law) {
  Machine machine;
  auto& o = machine.oscillator;
  o.masses = {Rational(1)};
  o.stiffness = model::MatrixX<Rational>::Constant(1, 1, Rational(1));
  o.damping = model::MatrixX<Rational>::Constant(1, 1, Rational(1, 10));
  o.rubbing = 0;
  o.V = V;
  o.omega = Rational(1);
  o.forward = o.backward = law;
  return machine;
}

}  // namespace stickslip::numeric::machines
