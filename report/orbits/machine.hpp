// A machine in SI units and the dimensionless data that are taken for it, for readers and for programs.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "numeric/families/orbit.hpp"
#include "numeric/machine.hpp"
#include "numeric/simulation/record.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// Of frequencies and units, unless others are asked for.
inline constexpr int digits_of_machine = 8;

// The machine, the data taken, how exact they are, and what the units of the answer are in SI.
[[nodiscard]] std::string terminal_report(const numeric::DataTaken& taken, const tools::Style& style,
                                          int digits = digits_of_machine);

// The machine, with friction in N, what the units of (2) are in SI, and what is rounded.
[[nodiscard]] tools::Json to_json(const numeric::DataTaken& taken);

// Of a machine, each under its name in JSON; friction in N.
[[nodiscard]] std::vector<std::pair<std::string, Rational>> values_in_SI(const numeric::MachineInSI& machine);

// " in kg", "" for a coefficient: of a value of a machine in SI units, by its name in the machine's file.
[[nodiscard]] std::string in_unit_of(const std::string& name);
// "m1 = 4 kg", of the same.
[[nodiscard]] std::string with_unit(const std::string& name, const std::string& value);

// Whether the value of an orbit that has this name is a time.
[[nodiscard]] bool is_time(const std::string& name);

// What the terminal's report is made of: a label and a sentence each.
[[nodiscard]] std::vector<tools::Row> machine_rows(const numeric::DataTaken& taken,
                                                   int digits = digits_of_machine);

// In which units a text says its times, lengths, velocities, forces and energies, and reads them.
class Units {
 public:
  static constexpr int all_digits = std::numeric_limits<int>::max();

  Units() = default;  // those of (2)
  // s, m, m/s, N, J; a text has at most so many digits of a value, however many are asked for.
  explicit Units(const numeric::DataTaken& si, int most_digits = all_digits);

  // Those of (2), for a machine in SI units that titles of pictures are to name.
  [[nodiscard]] static Units dimensionless(const numeric::DataTaken& taken, int most_digits = all_digits);

  [[nodiscard]] bool are_SI() const { return si_.has_value(); }
  // How many of the digits asked for a text has.
  [[nodiscard]] int digits(int asked) const { return std::min(asked, most_digits_); }
  // For a title of gnuplot: the machine in two lines, without the value that varies, by its name in the
  // machine's file; or these data, if it is none in SI units.
  [[nodiscard]] std::string machine_or(const std::string& data, const std::string& but_for = "") const;
  // Enough for the factor of a unit to take none of so many digits.
  [[nodiscard]] static long bits_for(int digits);
  // A value of an orbit by its name, and a time, with so many bits.
  [[nodiscard]] Ball value(const numeric::families::NamedBall& value, int digits) const;
  [[nodiscard]] Ball time(const Ball& t, int digits) const;
  // A value of an orbit by its name, z10, tau, ur, ..., to at most so many digits, with its unit:
  // rad, and those of SI.
  [[nodiscard]] std::string text(const numeric::families::NamedBall& value, int digits) const;
  // The same without its radius, each digit right to one unit of the last one.
  [[nodiscard]] std::string short_text(const numeric::families::NamedBall& value, int digits) const;
  // "x1 in m", or "x1": what stands over numbers.
  [[nodiscard]] std::string labelled(const std::string& name, const char * unit) const;
  // The unit behind a number, or nothing.
  [[nodiscard]] const char * unit(const char * in_SI) const { return si_ ? in_SI : ""; }
  // A state (x1, x2, x1', x2'), and back; a time; what a simulation tells, its data left as they are.
  [[nodiscard]] model::Vector4<double> state(const model::Vector4<double>& X) const;
  [[nodiscard]] model::Vector4<double> of_state(const model::Vector4<double>& told) const;
  [[nodiscard]] double time(double t) const { return t * factors_.time; }
  [[nodiscard]] double of_time(double told) const { return told / factors_.time; }
  [[nodiscard]] double velocity(double v) const { return v * factors_.velocity; }
  [[nodiscard]] numeric::simulation::Sample sample(numeric::simulation::Sample s) const;
  [[nodiscard]] numeric::simulation::Record record(numeric::simulation::Record r) const;
  [[nodiscard]] Ball time(const Ball& t) const;
  [[nodiscard]] Ball length(const Ball& x) const;
  [[nodiscard]] Ball velocity(const Ball& v) const;
  [[nodiscard]] Ball force(const Ball& f) const;

 private:
  struct Measured {
    Ball value;
    const char * unit;
  };
  [[nodiscard]] Measured measured(const numeric::families::NamedBall& value) const;

  std::optional<numeric::MachineInSI> machine_;
  int most_digits_ = all_digits;
  std::optional<numeric::DataTaken> si_;
  struct {
    double time = 1, length = 1, velocity = 1, force = 1, energy = 1;
  } factors_;
};

}  // namespace stickslip::report::orbits
