// What the friction law asks of a phase of a motion, or of all motions of a set.
#pragma once

#include <optional>
#include <vector>

#include "numeric/machines/linear_phases.hpp"
#include "numeric/motion/conditions.hpp"

namespace stickslip::numeric::machines {

struct JudgedPhase {
  // Its neighbours; nothing where only the part of the phase from, or until, some time inside it is meant.
  std::optional<Piece> before;
  Piece piece;
  std::optional<Piece> after;
  Ball start, duration;  // in the time of the motion
  Vector begin, end;     // w at its ends
};

// Appends what keeps the phase from ending early and what lets it begin and end as it does, decided for each
// motion that begins and ends in these balls, under the premise that it reaches the belt, the end of the
// law's piece or r = ur at the end that its neighbour stands for. `exact`: the oscillator of the phases.
void judge_phase(std::vector<motion::Condition>& list, const LinearPhases& phases,
                 const model::FrictionOscillator<Rational>& exact, const JudgedPhase& phase);

}  // namespace stickslip::numeric::machines
