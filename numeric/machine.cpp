#include "numeric/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/domain.hpp"
#include "numeric/machine_along.hpp"

namespace stickslip::numeric {
namespace {

constexpr long bits = 256;

// Of a number of thousands of digits the first ones.
std::string brief(const Rational& value) {
  constexpr std::size_t most = 40;
  const std::string text = to_string(value);
  return text.size() <= most ? text : fmt::format("{}...", std::string_view(text).substr(0, most));
}

// Powers of ten that no machine needs, within which everything is representable.
void require_positive(const char * name, const Rational& value) {
  static const Rational least = parse_rational("1e-50"), most = parse_rational("1e50");
  require(value >= least && value <= most, name, brief(value),
          fmt::format("{0} > 0, from 1e-50 to 1e50", name));
}

void require_not_negative(const char * name, const Rational& value) {
  require(value >= 0, name, brief(value), fmt::format("{} >= 0", name));
  if (value > 0) {
    require_positive(name, value);
  }
}

void require_machine(const MachineInSI& m) {
  require_positive("m1", m.m1);
  require_positive("m2", m.m2);
  require_positive("k1", m.k1);
  require_positive("k2", m.k2);
  require_positive("friction_sliding", m.friction_sliding);
  require_not_negative("belt_velocity", m.belt_velocity);
  require_not_negative("load_amplitude", m.load_amplitude);
  require_positive("load_frequency", m.load_frequency);
  if (m.friction_at_rest && *m.friction_at_rest <= m.friction_sliding) {
    throw DomainError("friction_at_rest", to_string(*m.friction_at_rest) + " N",
                      "greater than the sliding friction, " + to_string(m.friction_sliding) + " N");
  }
}

// The square root where it is rational.
std::optional<Rational> rational_root(const Rational& q) {
  if (mpz_perfect_square_p(q.get_num_mpz_t()) == 0 || mpz_perfect_square_p(q.get_den_mpz_t()) == 0) {
    return std::nullopt;
  }
  return Rational(mpz_class(sqrt(q.get_num())), mpz_class(sqrt(q.get_den())));
}

Rational decimal_near(const Ball& value) {
  return parse_rational(to_text(value, DataTaken::digits).mid);
}

// With it the largest of the lengths is between 0.1 and 100.
int readable_thousands(double largest) {
  return static_cast<int>(std::floor((std::log10(largest) + 1) / 3));
}

template <class S>
model::Machine<S> machine_over(const MachineInSI& m, const S& full_turn) {
  return machine_with<S>([&](Rational MachineInSI::*member) { return S(m.*member); }, full_turn);
}

}  // namespace

Rational power_of_1000(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 1000, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(mpz_class(1), power) : Rational(power);
}

Ball DataTaken::Omega() const {
  return sqrt(Ball(Rational((machine.k1 + machine.k2) / machine.m1)));
}
Ball DataTaken::length() const {
  return Ball(power_of_1000(thousands));
}
Ball DataTaken::velocity() const {
  return length() * Omega();
}
Ball DataTaken::force() const {
  return length() * Ball(Rational(machine.k1 + machine.k2));
}
Ball DataTaken::frequency() const {
  return Omega() / (Ball(2) * Ball::pi());
}

DataTaken data_taken(const MachineInSI& machine, std::optional<int> given_thousands) {
  require_machine(machine);
  const WorkingPrecision precision(bits);
  const model::Machine<Ball> balls = machine_over<Ball>(machine, Ball(2) * Ball::pi());
  const Ball Omega = sqrt(model::Omega_squared<Ball>(balls));
  const model::Parameters<Ball> enclosed = model::dimensionless<Ball>(balls, Omega);
  // What a root or pi enters is taken from the balls, everything else from the rationals.
  const model::Machine<Rational> exact = machine_over<Rational>(machine, Rational(0));
  const std::optional<Rational> root = rational_root(model::Omega_squared<Rational>(exact));
  model::Parameters<Rational> data = model::dimensionless<Rational>(exact, root.value_or(Rational(1)));
  std::optional<Rational> ur;
  if (machine.friction_at_rest) {
    ur = model::length_of<Rational>(exact, *machine.friction_at_rest);
  }
  const int thousands = given_thousands.value_or(readable_thousands(
      std::max({enclosed.V.approximate(), enclosed.us.approximate(), ur.value_or(Rational(0)).get_d()})));
  const Rational unit = power_of_1000(thousands);
  const bool rounded_V = !root && machine.belt_velocity != 0;
  data.V = rounded_V ? decimal_near(enclosed.V / Ball(unit)) : Rational(data.V / unit);
  data.us /= unit;
  data.p /= unit;
  data.omega = decimal_near(enclosed.omega);
  if (ur) {
    *ur /= unit;
  }
  return {machine, data, ur, thousands, rounded_V};
}

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
