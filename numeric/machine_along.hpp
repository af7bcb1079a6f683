// A machine in SI units of which one value varies: the data of (2) and (4) as functions of it. A mass or a
// stiffness moves several of them, which then go along a path; nothing is rounded on it.
#pragma once

#include <optional>

#include "numeric/machine.hpp"
#include "numeric/motion/closing.hpp"

namespace stickslip::numeric {

// Each number is `of` the member; a full turn is 2 pi.
template <class T, class Of>
[[nodiscard]] model::Machine<T> machine_with(const Of& of, const T& full_turn) {
  return {of(&MachineInSI::m1),
          of(&MachineInSI::m2),
          of(&MachineInSI::k1),
          of(&MachineInSI::k2),
          of(&MachineInSI::friction_sliding),
          of(&MachineInSI::belt_velocity),
          of(&MachineInSI::load_amplitude),
          T(full_turn * of(&MachineInSI::load_frequency))};
}

struct MachineAlong {
  // Between these each of the machine's values is linear in the one that varies. Both have friction at rest,
  // or neither.
  MachineInSI at_from, at_to;
  Rational from, to;                 // of the value that varies, from < to
  int thousands = 0;                 // the unit of length is 1000^thousands m all along
  std::optional<Rational> phi = {};  // where it is given beside the machine

  // By (3), where the one that varies has that value; S: of the constants. With ur if there is friction at
  // rest.
  template <class T, class S>
  [[nodiscard]] motion::Given<T> at(const T& value) const {
    const model::Machine<T> m = machine<T, S>(value);
    const T Omega = sqrt(model::Omega_squared<T>(m));
    const T per_unit = T(scalars::scalar<S>(1 / power_of_1000(thousands)));
    motion::Given<T> given{model::dimensionless<T>(m, Omega)};
    for (T * const length : {&given.data.us, &given.data.V, &given.data.p}) {
      *length = *length * per_unit;
    }
    if (phi) {
      given.phi = T(scalars::scalar<S>(*phi));
    }
    if (at_from.friction_at_rest) {
      const T force = linear<T, S>(*at_from.friction_at_rest, *at_to.friction_at_rest, value);
      given.ur = T(model::length_of<T>(m, force) * per_unit);
    }
    return given;
  }

  // Contains sqrt((k1 + k2)/m1), per second, for each value in the ball.
  [[nodiscard]] Ball Omega(const Ball& value) const {
    return sqrt(model::Omega_squared<Ball>(machine<Ball, Ball>(value)));
  }

  // What is taken for the machine at that value: omega and V are rounded, in the same unit of length. Throws
  // as data_taken does.
  [[nodiscard]] DataTaken taken(const Rational& value) const;

 private:
  template <class T, class S>
  [[nodiscard]] T linear(const Rational& first, const Rational& last, const T& value) const {
    const Rational slope = (last - first) / (to - from);
    const Rational at_zero = first - slope * from;
    return slope == 0     ? T(scalars::scalar<S>(first))
           : at_zero == 0 ? T(T(scalars::scalar<S>(slope)) * value)
                          : T(T(scalars::scalar<S>(at_zero)) + T(scalars::scalar<S>(slope)) * value);
  }
  template <class T, class S>
  [[nodiscard]] model::Machine<T> machine(const T& value) const {
    const auto of = [&](Rational MachineInSI::*member) {
      return linear<T, S>(at_from.*member, at_to.*member, value);
    };
    return machine_with<T>(of, T(S(2) * scalars::pi<S>()));
  }
};

}  // namespace stickslip::numeric
