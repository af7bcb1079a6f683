// A machine in SI units and the dimensionless data that are taken for it, for readers and for programs.
#pragma once

#include <optional>
#include <string>

#include "numeric/families/orbit.hpp"
#include "numeric/machine.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// The machine, the data taken, how exact they are, and what the units of the answer are in SI.
[[nodiscard]] std::string terminal_report(const numeric::DataTaken& taken, const tools::Style& style);

// {"si": {"m1", "m2", "k1", "k2", "friction_sliding", "friction_at_rest", "belt_velocity", "load_amplitude",
// "load_frequency", "load_phase"}, "units": {"length", "time", "velocity", "force", "frequency"}: BALL each,
// "rounded": ["omega", "V"]}. Friction is in N; friction_at_rest is absent where it is a result.
[[nodiscard]] tools::Json to_json(const numeric::DataTaken& taken);

// In which units a text says its times, lengths, velocities and forces.
class Units {
 public:
  Units() = default;                                         // those of (2)
  explicit Units(const numeric::DataTaken& si) : si_(si) {}  // s, m, m/s, N

  [[nodiscard]] bool are_SI() const { return si_.has_value(); }
  // A value of an orbit by its name, z10, tau, ur, ..., to at most so many digits, with its unit:
  // rad, and those of SI.
  [[nodiscard]] std::string text(const numeric::families::NamedBall& value, int digits) const;
  // The same without its radius, each digit right to one unit of the last one.
  [[nodiscard]] std::string short_text(const numeric::families::NamedBall& value, int digits) const;
  // A state (x1, x2, x1', x2').
  [[nodiscard]] model::Vector4<double> state(const model::Vector4<double>& X) const;
  [[nodiscard]] Ball time(const Ball& t) const;
  [[nodiscard]] Ball length(const Ball& x) const;
  [[nodiscard]] Ball velocity(const Ball& v) const;

 private:
  struct Measured {
    Ball value;
    const char * unit;
  };
  [[nodiscard]] Measured measured(const numeric::families::NamedBall& value) const;

  std::optional<numeric::DataTaken> si_;
};

}  // namespace stickslip::report::orbits
