// A periodic motion of a machine at all values of some of its data in a box: with one datum a branch between
// two values, with more what tolerances leave of it.
//
// The box is halved until on each part Newton's test passes for all machines at once (chain_proof.hpp). Where
// it is halved a closed chain is proved in the middle; of two parts that have such a one in common what they
// share is connected, and there the chains of each depend continuously on the data and are single zeros, so
// they are the same. So the motions of all parts that are connected in this way are one family.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/branches/state.hpp"
#include "numeric/machines/orbits/machine_orbit.hpp"
#include "numeric/machines/phases/numbers_in_data.hpp"

namespace stickslip::numeric::machines {

// What the motion is, by what is proved of it, and whether that is all there is to ask.
[[nodiscard]] branches::State state_of(const MachineOrbit& orbit);
[[nodiscard]] bool is_decided(branches::State state);

// A motion of the machine at these.
struct MotionAt {
  Values values;
  MachineGuess guess;
};

struct DataBox {
  // The machine at values of the data, as NumbersInData assumes.
  std::function<Machine(const Values&)> at;
  Values low, high;  // low < high
};

// What motions are, each of them by proof, where it is asked for; with the names of the conditions that all
// of them violate or, where the state is not decided, of those that are open, "stability" included.
struct Judged {
  branches::State state = branches::State::undecided;
  std::string names;
};

struct PartOfBox {
  Values low, high;
  // Of "at all data there is exactly one closed motion in a box that goes with the data, these depend
  // continuously on the data, the given motions in the part are among them, and they are one family with
  // those of all other parts of that number and with the given motion of it".
  Verdict existence;
  Judged motions;
  std::size_t family = 0;
};

struct Effort {
  int most_halvings;  // of one datum
  long most_parts;    // that are looked at, of equal ones those next to the given motions first
  bool with_state = true;
};

// The parts make up the box. `motions`: of one family as far as it is known, at least one, all through the
// same phases. Undecided where the numbers are not known as functions of the data and where parts would be
// smaller than the effort allows. Throws as NumbersInData does, and DomainError for a motion outside.
[[nodiscard]] std::vector<PartOfBox> motions_over(const DataBox& box, const std::vector<MotionAt>& motions,
                                                  const Effort& effort);

struct Joint {
  // Of "at each value between there is exactly one closed motion in a box that goes with the value, and these
  // form a curve from the one motion to the other".
  Verdict existence;
  // Of "and each of them is in that state".
  Verdict state;
};
// Of each of some motions of one state and the next, over one datum that rises or falls: in parts that may
// hold many of them, down to 2^-12 of the shortest way between two. Without a state it is not asked for.
[[nodiscard]] std::vector<Joint> joints_between(const std::function<Machine(const Rational&)>& at,
                                                const std::vector<MotionAt>& motions,
                                                std::optional<branches::State> state);

}  // namespace stickslip::numeric::machines
