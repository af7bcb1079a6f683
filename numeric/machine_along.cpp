#include "numeric/machine_along.hpp"

namespace stickslip::numeric {

DataTaken MachineAlong::taken(const Rational& value) const {
  MachineInSI machine = at_from;
  const Rational share = (value - from) / (to - from);
  const auto move = [&](Rational& at, const Rational& last) { at += share * (last - at); };
  for (Rational MachineInSI::*const member :
       {&MachineInSI::m1, &MachineInSI::m2, &MachineInSI::k1, &MachineInSI::k2,
        &MachineInSI::friction_sliding, &MachineInSI::belt_velocity, &MachineInSI::load_amplitude,
        &MachineInSI::load_frequency}) {
    move(machine.*member, at_to.*member);
  }
  if (machine.friction_at_rest) {
    move(*machine.friction_at_rest, *at_to.friction_at_rest);
  }
  return data_taken(machine, thousands);
}

}  // namespace stickslip::numeric
