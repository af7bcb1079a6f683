// All closed motions through two, three or four phases that stick, by the search of isolate.hpp for their
// durations: ST, OT; OTS, OST; OSTS, OSOT; STST, OTST, OTOT. The equations are those of one_stick_closing.hpp
// and two_sticks.hpp.
#pragma once

#include "numeric/families/family.hpp"

namespace stickslip::numeric::families {

struct ThroughPhases {
  motion::Given<Rational> given;          // exactly one of phi and ur; phi for slip, overshoot, stick only
  std::vector<motion::PhaseKind> phases;  // a stick last
  long periods = 1;                       // n, of the load
  // Motions that are known to break the friction law may be left out.
  bool lawful = false;
};

// Every motion that closes with positive durations is a candidate or in an unresolved part. Only if `lawful`,
// of those with one stick and up to three phases, where n/omega is a whole number, those of which no phase
// lasts longer than pi but the stick are left out. None of these obeys the law: x1'' + x1 = chi x2 returns
// after n Theta, a multiple of 2 pi, only if the integral of (x2' - V) exp(i t) over the motion is zero. But
// where x2' - V has one sign on less than half a turn, or first one and then the other on such a stretch
// each, some cos(t - t0) has the same signs. Of a word that repeats another one over fewer periods, such as
// STST over two, half of the motions say all, and repetitions are candidates, too, if at all. Lists of four
// phases mostly stay open where n/omega is a whole number: there the rows lose rank as all phases but the
// sticks become short. Parts say tau, tau1, tau2, how long the phases last but the last stick. Assumes the
// domain of words.
[[nodiscard]] FoundOf<Isolated> closed_through(const ThroughPhases& question);

}  // namespace stickslip::numeric::families
