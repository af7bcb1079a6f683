// What commands say about machines of any number of masses (numeric/machines): for readers, for programs, as
// pages and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/machines/machine_attractors.hpp"
#include "numeric/machines/machine_branch.hpp"
#include "numeric/machines/motions_over_data.hpp"
#include "numeric/machines/planar_basin.hpp"
#include "numeric/machines/set_after.hpp"
#include "numeric/machines/steady_sliding.hpp"
#include "numeric/simulation/record.hpp"
#include "report/orbits/many_starts.hpp"
#include "report/tools/files.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::machines {

// Where a machine comes from, and its units.
struct Origin {
  std::string file;                          // as it was given
  bool in_SI = true;                         // kg, N, m, s; else numbers without units
  std::string options = "--params " + file;  // that give it to a command
};

// A result with the machine that it is about.
struct Attractors {
  numeric::machines::MachineAttractors list;
  Origin origin;
};
// Along one of the file's numbers, by its path; where starts in a plane end.
struct Diagram {
  numeric::machines::MachineDiagram diagram;
  std::string parameter;
  Origin origin;
};
struct Basins {
  numeric::machines::MachineBasins basins;
  Origin origin;
};
struct WordOrbits {
  numeric::machines::MachineWordOrbits list;
  Origin origin;
};
// Of the branches of a word's orbits along one of the file's numbers.
struct Branches {
  numeric::machines::MachineWord question;  // with the machine at `start`
  std::string parameter;                    // its path in the file
  Rational from, to, start;
  std::optional<int> orbit;  // of those at the start, from 1; nothing: all
  bool all = false;          // that are not admissible, too
  bool without_gaps = false;
  std::vector<numeric::machines::MachineBranch> branches;
  std::string seen;  // what was met at the start in place of an orbit
  bool interrupted = false;
  Origin origin;
};
// Of motions through a word's phases where several of the file's numbers, by their paths, vary at once.
struct OverBox {
  numeric::machines::MachineWord question;  // with the machine at `start`
  struct Datum {
    std::string path;
    Rational from, to, start;
  };
  std::vector<Datum> data = {};
  std::optional<int> orbit = {};  // of those at the start, from 1; nothing: all
  bool all = false;               // that are not admissible, too
  long most_parts = 0;            // that are looked at, of each
  struct Family {
    numeric::machines::MachineOrbit at_start;
    std::vector<numeric::machines::PartOfBox> parts;
  };
  std::vector<Family> motions = {};
  std::string seen = {};  // what was met at the start in place of an orbit
  bool interrupted = false;
  Origin origin = {};
};
// Steady sliding, and along one of the file's numbers; `machine` is the file's. With the share of starts that
// end in it, if it was asked for.
struct SteadyBasin {
  numeric::machines::Rectangle starts;
  numeric::machines::PlanarBasin basin;
};
struct SteadyBasins {
  numeric::machines::Rectangle starts;
  numeric::machines::PlanarBasinAlong along;
};
struct Steady {
  numeric::machines::Machine machine;
  numeric::machines::SteadySliding state;
  int digits = 20;
  Origin origin;
  std::optional<SteadyBasin> basin = {};
};
struct SteadyBranch {
  numeric::machines::Machine machine;
  std::string parameter;
  Rational from, to;
  numeric::machines::SteadyAlong along;
  int digits = 20;
  Origin origin;
  std::optional<SteadyBasins> basins = {};
};
struct Motion {
  numeric::machines::Machine machine;
  Eigen::VectorXd start;  // (x, x')
  double theta = 0;       // of the load at the start
  double duration = 0;    // that was asked for
  std::optional<double> every;
  numeric::simulation::RecordOf<numeric::simulation::AnyState> record;
  Origin origin;
};

// Where a box of starts is after some time.
struct SetMotion {
  numeric::machines::SetAfter set;
  Origin origin;
};

[[nodiscard]] std::string terminal_report(const Attractors& result, const tools::Style& style);
// The position of the mass on the belt is drawn: with a load once a period, without where phases begin.
[[nodiscard]] orbits::ToldAlong told(const Diagram& result);
[[nodiscard]] orbits::ToldPlane told(const Basins& result);
[[nodiscard]] std::string terminal_report(const WordOrbits& result, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const Branches& result, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const OverBox& result, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const Steady& result, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const SteadyBranch& result, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const Motion& result, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const SetMotion& result, const tools::Style& style);

[[nodiscard]] tools::Json to_json(const Attractors& result);
[[nodiscard]] tools::Json to_json(const Diagram& result);
[[nodiscard]] tools::Json to_json(const Basins& result);
[[nodiscard]] tools::Json to_json(const WordOrbits& result);
[[nodiscard]] tools::Json to_json(const Branches& result);
[[nodiscard]] tools::Json to_json(const OverBox& result);
[[nodiscard]] tools::Json to_json(const Steady& result);
[[nodiscard]] tools::Json to_json(const SteadyBranch& result);
[[nodiscard]] tools::Json to_json(const Motion& result);
[[nodiscard]] tools::Json to_json(const SetMotion& result);
[[nodiscard]] std::vector<tools::File> schemas();

// A line of names, then a line for each orbit that was proved on its own: the number, the branch, the state,
// the period, how long each phase lasts, x and x' when the first begins; with 17 digits.
[[nodiscard]] std::string to_csv(const Branches& result);
// A line of names, then a line for each part: the motion (1, 2, …), least and greatest value of each number,
// exactly, and what the motions are in it.
[[nodiscard]] std::string to_csv(const OverBox& result);
// Names with units; t, phase, x, x', r, u, E; numbers with 17 digits.
[[nodiscard]] std::string csv_names(const Motion& motion);
[[nodiscard]] std::string csv_line(
    const numeric::simulation::SampleOf<numeric::simulation::AnyState>& sample);

// The position of the mass on the belt where the first phase begins against the parameter; empty when there
// is nothing to draw.
[[nodiscard]] std::string plot_script(const Branches& result, tools::PlotFormat format,
                                      tools::PlotShape shape = tools::PlotShape::wide);
// The parts in the plane of the first two numbers, where the others are as at the start, of one of the
// motions, from 0; empty when there is none.
[[nodiscard]] std::string plot_script(const OverBox& result, tools::PlotFormat format,
                                      tools::PlotShape shape = tools::PlotShape::wide,
                                      std::size_t motion = 0);

// The files of one directory: index.html with its style sheets, the JSON, pictures. Throw InputOutputError if
// a program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> pages(const Attractors& result);
[[nodiscard]] std::vector<tools::File> pages(const Diagram& result);
[[nodiscard]] std::vector<tools::File> pages(const Basins& result);
[[nodiscard]] std::vector<tools::File> pages(const WordOrbits& result);
[[nodiscard]] std::vector<tools::File> pages(const Branches& result);
[[nodiscard]] std::vector<tools::File> pages(const OverBox& result);

}  // namespace stickslip::report::machines
