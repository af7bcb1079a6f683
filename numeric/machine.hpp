// A machine in SI units as data of (2) and (4), in rationals.
#pragma once

#include <optional>

#include "model/machine.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::numeric {

// In kg, N/m, N, m/s and, in place of an angular frequency, Hz.
struct MachineInSI {
  Rational m1, m2, k1, k2, friction_sliding;
  std::optional<Rational> friction_at_rest;
  Rational belt_velocity, load_amplitude, load_frequency;
  Rational load_phase = 0;  // rad
};

// The data that are taken for a machine. (2) and (4) hold with x, us, ur, V and p multiplied by any number,
// so the unit of these lengths is one in which the numbers are of a readable size.
struct DataTaken {
  static constexpr int digits = 20;

  MachineInSI machine;
  motion::ExactParameters data;  // exact, except for what is said to be rounded
  std::optional<Rational> ur;    // exact
  int thousands = 0;             // the unit of length is 1000^thousands m
  bool rounded_V = false;        // to so many significant digits; omega always is

  // At the working precision.
  [[nodiscard]] Ball Omega() const;      // sqrt((k1 + k2)/m1), per second
  [[nodiscard]] Ball length() const;     // the unit, in m
  [[nodiscard]] Ball velocity() const;   // what x' = 1 is, in m/s
  [[nodiscard]] Ball force() const;      // what u = 1 is, in N
  [[nodiscard]] Ball frequency() const;  // what omega = 1 is, in Hz
};

[[nodiscard]] Rational power_of_1000(int exponent);

// By (3). chi, eta, us, ur and p are rational; Omega is a square root and omega has a factor 2 pi, so omega
// is irrational and V mostly is: they are replaced by decimals next to them, which is to say that
// load_frequency and belt_velocity are changed by less than one part in 10^19. (No resonance is lost by that:
// with rational data and 2 pi there is none.) Throws DomainError unless masses, stiffnesses, friction and
// frequency are > 0, velocity and amplitude >= 0, friction at rest > sliding. The unit of length is the one
// that `thousands` says, if it is given.
[[nodiscard]] DataTaken data_taken(const MachineInSI& machine, std::optional<int> thousands = {});

}  // namespace stickslip::numeric
