// What commands say about machines of any number of masses (numeric/machines): for readers, for programs, as
// pages and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/machines/attractors/machine_attractors.hpp"
#include "numeric/machines/attractors/steady_sliding.hpp"
#include "numeric/machines/basins/planar_basin.hpp"
#include "numeric/machines/basins/set_after.hpp"
#include "numeric/machines/orbits/machine_branch.hpp"
#include "numeric/machines/orbits/motions_over_data.hpp"
#include "numeric/simulation/record.hpp"
#include "report/orbits/attractors/many_starts.hpp"
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

// One of the file's numbers, by its path, that varies, and at which value motions are looked for, if any are.
struct Varied {
  std::string path;
  Rational from, to, start;
};

// Results: each has a question with the machine that it is about, and an origin.
struct Attractors : numeric::machines::MachineAttractors {
  Origin origin;
};
// Along one of the file's numbers, by its path; where starts in a plane end.
struct Diagram : numeric::machines::MachineDiagram {
  std::string parameter;
  Origin origin;
};
struct Basins : numeric::machines::MachineBasins {
  Origin origin;
};
struct WordOrbits : numeric::machines::MachineWordOrbits {
  Origin origin;
};
// What follows the orbits of a word from where they were found, at the start.
struct FromOrbits {
  numeric::machines::MachineWord question;  // with the machine there
  Origin origin;
  std::optional<int> orbit = {};  // of those there, from 1; nothing: all
  bool all = false;               // that are not admissible, too
  std::string seen = {};          // what was met there in place of an orbit
  bool interrupted = false;
};
// Their branches along a number.
struct Branches : FromOrbits {
  Varied varied;
  bool without_gaps = false;
  std::vector<numeric::machines::MachineBranch> branches = {};
};
// Their motions where several numbers vary at once.
struct OverBox : FromOrbits {
  std::vector<Varied> data = {};
  long most_parts = 0;  // that are looked at, of each
  struct Family {
    numeric::machines::MachineOrbit at_start;
    std::vector<numeric::machines::PartOfBox> parts;
  };
  std::vector<Family> motions = {};
};
// Steady sliding, and along one of the file's numbers; the machine is the file's. With the share of starts
// that end in it, if it was asked for.
struct SteadyQuestion {
  numeric::machines::Machine machine;
  int digits = 20;
};
struct SteadyBasin {
  numeric::machines::Rectangle starts;
  numeric::machines::PlanarBasin basin;
};
struct SteadyBasins {
  numeric::machines::Rectangle starts;
  numeric::machines::PlanarBasinAlong along;
};
struct Steady {
  SteadyQuestion question;
  numeric::machines::SteadySliding state;
  Origin origin;
  std::optional<SteadyBasin> basin = {};
};
struct SteadyBranch {
  SteadyQuestion question;
  Varied varied;
  numeric::machines::SteadyAlong along;
  Origin origin;
  std::optional<SteadyBasins> basins = {};
};
struct MotionQuestion {
  numeric::machines::Machine machine;
  Eigen::VectorXd start = {};  // (x, x')
  double theta = 0;            // of the load at the start
  double duration = 0;
  std::optional<double> every = {};
};
struct Motion {
  MotionQuestion question;
  Origin origin;
  numeric::simulation::RecordOf<numeric::simulation::AnyState> record = {};
};

// Where a box of starts is after some time.
struct SetMotion : numeric::machines::SetAfter {
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

// Of each of these.
template <class Result>
[[nodiscard]] tools::Json to_json(const Result& result);
[[nodiscard]] std::vector<tools::File> schemas();

// A line of names, then a line for each orbit that was proved on its own: the number, the branch, the state,
// the period, how long each phase lasts, x and x' when the first begins; with 17 digits.
[[nodiscard]] std::string to_csv(const Branches& result);
// A line of names, then a line for each part: the motion (1, 2, …), least and greatest value of each number,
// exactly, and what the motions are in it.
[[nodiscard]] std::string to_csv(const OverBox& result);

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
