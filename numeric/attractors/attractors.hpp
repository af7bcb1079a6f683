// What a machine does: the motions that many starts end on, each periodic one proved.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/settle.hpp"

namespace stickslip::numeric::attractors {

struct AttractorQuestion {
  words::WordQuestion machine;
  long starts = 500;
  std::uint64_t seed = 1;
  long most_periods = 20000;  // that a start is followed for
};

struct Attractor {
  Kind kind = Kind::unsettled;
  long count = 0;                         // of the starts that end on it
  double share = 0, least = 0, most = 0;  // with Wilson's interval of 95 %
  std::string word;                       // periodic: its letters, in the first rotation
  long periods = 0;                       // periodic: n
  // Periodic: what is proved; its existence may be undecided.
  std::optional<words::WordOrbit> orbit;
  std::string family;              // periodic: that of the paper that it belongs to, if any
  model::Vector4<double> state;    // (x1, x2, x1', x2') on it at load phase 0
  std::optional<double> lyapunov;  // irregular, quasi-periodic: a check, the mean over its starts
};

struct AttractorList {
  AttractorQuestion question;
  // By falling count. Irregular motions are one entry, and so are those of each other kind that is not
  // periodic: a simulation cannot tell how many attractors they are.
  std::vector<Attractor> attractors;
  long simulated = 0;  // periods in all
  bool interrupted = false;
};

// Throws as words::require_word_domain and simulation::Simulation do.
[[nodiscard]] AttractorList find_attractors(const AttractorQuestion& question);

// "periodic", "quasi-periodic", "irregular", "slides", "stuck", "unsettled".
[[nodiscard]] std::string to_string(Kind kind);

// Wilson's interval of 95 % for a share of which `count` of `total` are a sample.
struct Interval {
  double least, most;
};
[[nodiscard]] Interval wilson(long count, long total);

// The paper's family that an orbit is one of; empty when it is none, or not known to be.
[[nodiscard]] std::string family_of(const words::WordOrbit& orbit);

}  // namespace stickslip::numeric::attractors
