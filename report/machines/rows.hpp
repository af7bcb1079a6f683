// Sentences and rows on machines that texts and pages share.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/machines/results.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/branches/branches.hpp"

namespace stickslip::report::machines {

// A machine as its reader sees it.
struct Seen {
  const numeric::machines::Machine& machine;
  bool in_SI;

  [[nodiscard]] const model::FrictionOscillator<Rational>& oscillator() const { return machine.oscillator; }
  // " in s", or nothing without units.
  [[nodiscard]] std::string unit(const char * name) const;
  // A number with its unit.
  [[nodiscard]] std::string with(const Rational& value, const char * name) const;
  // "S", or where the friction law has several pieces "S2".
  [[nodiscard]] std::string name(const numeric::machines::Piece& piece) const;
  // The mass on the belt and, if there is one, another: of which tables and pictures tell.
  [[nodiscard]] std::vector<std::size_t> shown_masses() const;
};

// What a result is about.
[[nodiscard]] Seen seen_of(const auto& result) {
  return {result.question.machine, result.origin.in_SI};
}

// Masses, belt, friction, loads: a label and a sentence each.
[[nodiscard]] std::vector<tools::Row> machine_rows(const Seen& seen);
// Of a periodic motion: period, stability, multipliers; its phases, names first.
[[nodiscard]] std::vector<tools::Row> orbit_rows(const numeric::machines::MachineOrbit& orbit,
                                                 const Seen& seen, int digits);
[[nodiscard]] std::vector<tools::Row> phase_rows(const numeric::machines::MachineOrbit& orbit,
                                                 const Seen& seen);
// "x1", …, "x1'", …: of (x, x').
[[nodiscard]] std::vector<orbits::Coordinate> coordinates_of(const Seen& seen);
// Of a plane those that vary: "x1", "x2".
[[nodiscard]] std::array<std::string, 2> plane_of(const Basins& result);
// What is known: "proved, stable, |mu| = 0.78".
[[nodiscard]] std::string remark(const numeric::machines::MachineOrbit& orbit);
[[nodiscard]] std::vector<orbits::ToldEnding> told(
    const std::vector<numeric::machines::MachineAttractor>& all, const Seen& seen);
// "OTS, period 1", or what kind of motion it is.
[[nodiscard]] std::string name_of(const numeric::machines::MachineOrbit& orbit, bool autonomous);

[[nodiscard]] std::string command_of(const Attractors& result);
[[nodiscard]] std::string command_of(const Diagram& result);
[[nodiscard]] std::string command_of(const Basins& result);
[[nodiscard]] std::string command_of(const WordOrbits& result);
[[nodiscard]] std::string command_of(const Branches& result);
[[nodiscard]] std::string command_of(const OverBox& result);
[[nodiscard]] std::string command_of(const Motion& result);
[[nodiscard]] std::string command_of(const SetMotion& result);
[[nodiscard]] std::string command_of(const Steady& result);
[[nodiscard]] std::string command_of(const SteadyBranch& result);

// Of a branch: how it begins and ends; from, to, how many motions and their state where it is one; place,
// kind and name of each change.
[[nodiscard]] orbits::BranchRows rows_of(const numeric::machines::MachineBranch& branch);
// Of motions over a box of data: what is proved of all parts; then, the largest share of the box first, of
// each kind of part its share, how many parts, what the motions are in them and where in the box they lie.
struct BoxRows {
  std::string heading;
  bool proved = false;  // the motions exist in all of them and it is decided what they are
  std::vector<tools::Row> kinds;
};
[[nodiscard]] BoxRows rows_of(const OverBox& result, const OverBox::Family& family);
// "belt.velocity in m/s from 0.09 to 0.11"; "belt.velocity = 1/10".
[[nodiscard]] std::string range_of(const Varied& varied, const Origin& origin);
[[nodiscard]] std::string start_of(const Varied& varied);
// The same of each number.
[[nodiscard]] std::string box_of(const OverBox& result);
[[nodiscard]] std::string start_of(const OverBox& result);
// The path, with its unit where it is known.
[[nodiscard]] std::string parameter_of(const std::string& path, const Origin& origin);
// Of steady sliding: positions, friction, stability, eigenvalues.
[[nodiscard]] std::vector<tools::Row> rows_of(const numeric::machines::SteadySliding& state, const Seen& seen,
                                              int digits);
// Where its stability changes: place, and what.
[[nodiscard]] std::vector<tools::Row> rows_of(const numeric::machines::SteadyAlong& along, const Seen& seen);
// Of what ends in it: the share of the starts, the closed motion around it. Along a number: value, share and
// what is known of the others, names first; and where the range with such a basin ends.
[[nodiscard]] std::vector<tools::Row> rows_of(const SteadyBasin& basin, const Seen& seen, int digits);
[[nodiscard]] std::vector<tools::Row> rows_of(const SteadyBasins& basins, const std::string& parameter);
[[nodiscard]] std::vector<tools::Row> end_rows(const SteadyBasins& basins);

}  // namespace stickslip::report::machines
