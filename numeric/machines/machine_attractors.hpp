// What a machine does: the motions that many starts end on, each periodic one proved.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numeric/machines/settle.hpp"
#include "numeric/machines/steady_sliding.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::machines {

struct MachineStarts {
  Machine machine;
  long starts = 500;
  std::uint64_t seed = 1;
  long most_periods = 20000;  // that a start is followed for; without a load, events
  int digits = 20;            // significant ones, of every value of an orbit
};

struct MachineAttractor {
  attractors::Kind kind = attractors::Kind::unsettled;
  long count = 0;                         // of the starts
  double share = 0, least = 0, most = 0;  // with Wilson's interval of 95 %
  std::string word;                       // periodic: its letters, in the first rotation
  std::optional<MachineOrbit> orbit;      // periodic: what is proved; its existence may be undecided
  Eigen::VectorXd state;                  // (x, x') on it; with a load at theta = 0
};

struct MachineAttractors {
  MachineStarts question;
  std::vector<MachineAttractor> attractors;  // by falling count; those of another kind are one entry each
  std::optional<SteadySliding> steady;       // without a load that varies
  bool interrupted = false;
};

// Where they lie: within `half` of `middle` in each coordinate (x, x'). The middle is the rest position under
// the constant loads and the friction at the belt's velocity, at rest but for the mass that rubs; with
// Omega² = K_jj/m_j and s the largest of |V|, 3 u/(m_j Omega) and the loads' amplitudes over their masses
// and Omega: 2 s/Omega for x, 1.5 s for x', x_j' about V - s.
struct MachineStartBox {
  Eigen::VectorXd middle, half;
};
[[nodiscard]] MachineStartBox start_box(const model::FrictionOscillator<double>& oscillator);

// The same seed gives the same starts everywhere. Throws as require_machine does.
[[nodiscard]] MachineAttractors find_attractors(const MachineStarts& question);

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
// settles on; without, what random starts settle on. Throws as settle does.
[[nodiscard]] MachineWordOrbits find_word_orbits(const MachineWord& question);

}  // namespace stickslip::numeric::machines
