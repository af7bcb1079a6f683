// What a machine does: the motions that many starts end on, each periodic one proved.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/many_starts.hpp"
#include "numeric/words/pure.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::attractors {

struct AttractorQuestion {
  words::WordQuestion machine;
  long starts = 500;
  std::uint64_t seed = 1;
  long most_periods = 20000;   // that a start is followed for
  bool neighbourhood = false;  // of each orbit that is stable, too
};

struct Attractor : Ending {
  // Periodic: what is proved; its existence may be undecided.
  std::optional<words::WordOrbit> orbit;
  std::string family;            // periodic: that of the paper that it belongs to, if any
  model::Vector4<double> state;  // (x1, x2, x1', x2') on it at load phase 0
};

struct AttractorList : Endings<Attractor> {
  AttractorQuestion question;
};

// Where all motions are proved to grow beyond all bounds (words/pure.hpp) that is the answer, without a
// simulation. At a natural frequency no periodic motion is proved. Throws as words::require_simulated_domain
// and simulation::Simulation do.
[[nodiscard]] AttractorList find_attractors(const AttractorQuestion& question);

// What the motions from these starts at load phase 0 settle on; the question's number of starts and seed say
// nothing. Throws likewise.
[[nodiscard]] AttractorList find_attractors_from(const AttractorQuestion& question,
                                                 const std::vector<model::Vector4<double>>& starts);

// What the motion from X at load phase 0 settles on, `count` being 1; the share says nothing. Outside the
// domain of words a periodic motion is not proved. Throws as simulation::Simulation does.
[[nodiscard]] Attractor find_attractor(const words::WordQuestion& machine, const model::Vector4<double>& X,
                                       long most_periods = 20000);

// The paper's family that an orbit is one of; empty when it is none, or not known to be.
[[nodiscard]] std::string family_of(const words::WordOrbit& orbit);

}  // namespace stickslip::numeric::attractors
