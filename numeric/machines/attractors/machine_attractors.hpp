// What a machine does: the motions that many starts end on, each periodic one proved.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/many_starts.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/attractors/steady_sliding.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::machines {

struct MachineStarts {
  Machine machine;
  long starts = 500;
  std::uint64_t seed = 1;
  long most_periods = 20000;  // that a start is followed for; without a load, events
  int digits = 20;            // significant ones, of every value of an orbit
};

struct MachineAttractor : attractors::Ending {
  std::optional<MachineOrbit> orbit;  // periodic: what is proved; its existence may be undecided
  Eigen::VectorXd state;              // (x, x') on it; with a load at theta = 0
};

// Without a load that varies events are counted where else periods are.
struct MachineAttractors : attractors::Endings<MachineAttractor> {
  MachineStarts question;
  std::optional<SteadySliding> steady;  // without a load that varies
};

// At random within start_box. The same seed gives the same starts everywhere. Throws as require_machine does.
[[nodiscard]] MachineAttractors find_attractors(const MachineStarts& question);

// What the motions from these starts at load phase 0 settle on; the question's number of starts and seed say
// nothing, steady sliding is not looked at. Throws likewise.
[[nodiscard]] MachineAttractors find_attractors_from(const MachineStarts& question,
                                                     const std::vector<Eigen::VectorXd>& starts);

// What a machine does while one of its numbers varies. Drawn are of each attractor, with a load, states at
// load phase 0, one period apart; without a load states where a phase begins, a slip, an overshoot or a
// stick.
struct MachineDiagram {
  MachineStarts question;  // at each value; its machine is at none of them
  std::function<Machine(const Rational&)> at;
  Rational from, to;  // from < to
  long values = 41;   // at least 2, equally far apart, both ends among them
  std::vector<attractors::PointAlong<MachineAttractor, Eigen::VectorXd>> points;
  bool interrupted = false;  // there are fewer points than were asked for
};
// Fills in the points. Throws as find_attractors does when no value is in the domain.
[[nodiscard]] MachineDiagram along(MachineDiagram diagram);

// Which starts in a plane end on what.
struct MachineBasins {
  MachineStarts question;                     // its starts and seed say nothing
  std::array<int, 2> across{0, 1};            // the two of (x, x') that vary
  std::optional<Eigen::VectorXd> through;     // the plane goes through it; else the middle of random starts
  std::optional<std::array<double, 2>> half;  // of the window; else as wide as the box of random starts
  bool prove = false;  // of each pixel, as far as that succeeds, that all of its starts end where one does
  std::array<long, 2> pixels{60, 60};   // columns and rows
  std::vector<Eigen::VectorXd> starts;  // the middle of each pixel, row by row, across[0] rises first
  std::vector<MachineAttractor> attractors;
  std::vector<std::size_t> ends;  // on which of them each start ends
  std::vector<char> proved;       // whether that is proved, of the whole pixel; empty unless asked for
  bool interrupted = false;
};
// Of the pixels, in parts of all; 0 unless asked for.
[[nodiscard]] double proved_share(const MachineBasins& basins);
// Fills in what comes after the question. Throws likewise.
[[nodiscard]] MachineBasins in_plane(MachineBasins basins);

// Orbits through given phases.
struct MachineWord {
  Machine machine;
  words::Word word;
  std::optional<long> periods;          // of the load; nothing: any number
  std::optional<Eigen::VectorXd> near;  // (x, x') at theta = 0; else random starts
  int digits = 20;
};
struct MachineWordOrbits {
  MachineWord question;
  std::vector<MachineOrbit> orbits;  // proved to exist
  std::string seen;                  // what was met instead, in half a sentence; empty with an orbit
  bool interrupted = false;
};

// With a start: the motion from there through so many periods if it goes through the word, else what it
// settles on; without, what random starts settle on within 2,000 periods, or where that is nothing of the
// kind, as many as MachineStarts has. Throws as settle does.
[[nodiscard]] MachineWordOrbits find_word_orbits(const MachineWord& question);

}  // namespace stickslip::numeric::machines
