// A machine in tables: a TOML file of masses, springs with dashpots, belt, friction and loads.
//
//   units = "SI"                  # or "none", for numbers without units
//   [[mass]]
//   m = 2.5                       # in kg; the first is mass 1
//   [[spring]]
//   between = [0, 1]              # masses; 0 is the wall
//   k = 1200                      # in N/m; and of the dashpot beside it in N s/m: one of the two may be
//   missing c = 0.6 [belt] mass = 1                      # the one on the belt velocity = 0.05 # in m/s
//   [friction]
//   at_rest = 13.5                # in N
//   sliding = [[0, 9], [0.05, 7.5], [0.3, 6]]   # relative velocity and force, linear between, then constant;
//                                 # or one force, or a + (b - a) s(v/c) + d v, s(y) = exp(-y) or 1/(1 + y):
//   # sliding = {falls = "exponentially", from = b, to = a, over = c, viscous = d}   # or "hyperbolically"
//   [friction.overshoot]          # where the mass is faster than the belt, if it is another one
//   [[load]]
//   mass = 1
//   amplitude = 12                # in N, of cos
//   sine = 3                      # in N, of sin, if there is one
//   frequency = 3.2               # in Hz, or angular_frequency in rad/s; several: whole multiples of one
//   [[load]]
//   mass = 1
//   constant = 4                  # in N
//
// Each number is taken exactly as it is written; in quotes it may be a fraction, "1/3".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/machines/machine.hpp"

namespace stickslip::cli {

struct MachineInTables {
  numeric::machines::Machine machine;
  bool in_SI = true;
};

// Whether the text has a table [[mass]].
[[nodiscard]] bool has_tables(const std::string& text);

// One of the file's numbers by its path, such as "belt.velocity", "mass.2.m", "spring.1.k",
// "load.1.amplitude", "friction.at_rest", "friction.sliding.2.1" (the relative velocity of the second point):
// members of lists are counted from 1; or "frequency", of all loads together, whose multiples stay.
struct Datum {
  std::string path;
  Rational value;  // that takes the place of the file's
};

// Nothing where it has none. Throws UsageError, with the file and the line, for what is no TOML, missing,
// unknown, of the wrong kind or no number, for a path that no number that can vary has, and for two that lead
// to one or vary together; DomainError as numeric::machines::require_machine.
[[nodiscard]] std::optional<MachineInTables> machine_in_tables(const std::string& text,
                                                               const std::string& file,
                                                               const std::vector<Datum>& data = {});
// What the file says there. Throws likewise.
[[nodiscard]] Rational value_in_tables(const std::string& text, const std::string& file,
                                       const std::string& path);

}  // namespace stickslip::cli
