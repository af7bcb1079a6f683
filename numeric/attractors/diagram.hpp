// What a machine does while one of its data varies, and which starts in a plane end on what: by brute force,
// many times over what attractors.hpp does once.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "numeric/attractors/many_starts.hpp"
#include "numeric/machine.hpp"

namespace stickslip::numeric::attractors {

struct DiagramQuestion {
  AttractorQuestion machine;  // at each value
  std::string parameter;      // chi, eta, us, V, omega, p or ur; or one of a machine in SI units
  Rational from, to;          // from < to
  long values = 41;           // at least 2, equally far apart, both ends among them
  // Of a machine in SI units: what is taken for it, with ur, when the parameter, one of its own, has a value.
  std::function<DataTaken(const Rational&)> taken = {};
};

// Of each attractor states at load phase 0, one period apart.
struct DiagramPoint : PointAlong<Attractor, model::Vector4<double>> {
  std::optional<DataTaken> taken;  // if the question has it
};

struct Diagram {
  DiagramQuestion question;
  std::vector<DiagramPoint> points;  // by rising value; fewer than asked for after an interruption
  bool interrupted = false;
};

// Throws UsageError for a parameter of another name, and DomainError when no value is in the domain.
[[nodiscard]] Diagram diagram_of(const DiagramQuestion& question);

struct BasinsQuestion {
  AttractorQuestion machine;        // its starts and seed say nothing
  std::array<int, 2> across{0, 1};  // the two of x1, x2, x1', x2' that vary, 0 to 3
  std::optional<model::Vector4<double>>
      through;                           // the plane goes through it; else the middle of random starts
  std::array<long, 2> pixels{100, 100};  // columns and rows
};

struct Basins {
  BasinsQuestion question;
  std::vector<model::Vector4<double>> starts;  // the middle of each pixel, row by row, across[0] rises first
  std::vector<Attractor> attractors;
  std::vector<std::size_t> at;  // which of them each start ends on
  bool interrupted = false;
};

// The window is as wide as the box of random starts, about `through`. Throws as find_attractors_from does.
[[nodiscard]] Basins basins_of(const BasinsQuestion& question);

}  // namespace stickslip::numeric::attractors
