// The branch of a periodic motion of a machine over an interval of one of its data.
//
// It is followed in floating point from one value to the next, and at each of them the motion is proved on
// its own, with its conditions and its stability; where two neighbours differ in what is proved, the values
// are halved until they are close. At a fold, where the branch turns back, it is followed on. What is said of
// these values is proved; what is said between them only where it is asked for (curve.hpp).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/machines/orbits/motions_over_data.hpp"

namespace stickslip::numeric::machines {

struct MachineBranchQuestion {
  std::function<Machine(const Rational&)> at;  // the machine at a value of the datum
  Rational from, to;                           // from < to
  Rational start;                              // in between: the guess is of the machine there
  MachineGuess guess;
  int digits = 20;
  bool without_gaps = false;  // whether the values between those of samples are to be proved, too
};

// The motion at one value, proved.
struct MachineSample {
  Rational value;
  branches::State state = branches::State::undecided;
  MachineOrbit orbit;
  bool before_fold = false, after_fold = false;  // neighbours of which one is each have a fold between them
};

// Between these values, those of neighbours in the list of samples, the state changes. A fold lies a little
// beyond a value, which is both.
struct MachineChange {
  branches::ChangeKind kind = branches::ChangeKind::condition;
  Rational first, last;
  std::string words;
};

struct MachineBranchEnd {
  Rational at;
  branches::End kind =
      branches::End::stopped;  // absent also where it is a shorter motion taken several times
  std::string words;
};

struct MachineBranch {
  Verdict existence;                   // of the motion at the start; what follows needs it proved
  std::vector<MachineSample> samples;  // along the branch, in which the start's values rise
  std::vector<MachineChange> changes;  // likewise
  MachineBranchEnd first, last;
  // Of each sample and the next, where they were asked for: the state is that of both. Across a change of
  // state and at a fold, where a motion lasts no time, or a state is not decided, its verdict is undecided.
  std::vector<Joint> joints;
  bool interrupted = false;

  // Whether every sample is decided, the branch ends for a reason, and, where joints were asked for, all but
  // those at folds prove what there is to prove.
  [[nodiscard]] bool resolved() const;
};

// Changes are enclosed to this share of the interval.
inline constexpr double branch_resolution = 0x1p-20;

// Throws as prove_machine_orbit does, for the machines at both ends, too; UsageError unless from < to with
// the start in between.
[[nodiscard]] MachineBranch follow_machine_branch(const MachineBranchQuestion& question);

}  // namespace stickslip::numeric::machines
