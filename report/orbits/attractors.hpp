// Attractors, and orbits of words, for readers and for programs.
#pragma once

#include <string>

#include "numeric/attractors/word_search.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// What provenance() says, and {"parameters": {"chi", …, "p", "ur"}, "starts", "seed", "most_periods",
// "simulated": periods, "interrupted", "followed": starts, "pure_slip": {"forced": BALL, "verdict"} of
// numeric/words/pure_slip.hpp, "attractors": [{"kind": "periodic", "quasi-periodic", "irregular", "slides",
// "stuck", "grows without bound" or "unsettled", "share", "share_interval": [least, most], "count", "state":
// [x1, x2, x1', x2'], "lyapunov", and of a periodic one "period", "word", "verdict", "reason", "durations":
// [BALL], "admissible", "family", "multipliers", "stability", "stability_reason"}]}. Keys that do not apply
// are absent. `verdict` is on "there is exactly one orbit there"; the state is the motion's at a time when
// the load's phase is 0, in double.
[[nodiscard]] tools::Json to_json(const numeric::attractors::AttractorList& list);

// What provenance() says, and {"word", "period", "parameters", "complete", "unresolved":
// [{"tau": BALL, "tau1", "phi", "reason"}], "orbits": [{"word",
// "period", "durations": [BALL], "Theta": BALL, "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10", "ur",
// "admissible", "multipliers", "stability", "stability_reason", "conditions": [{"phase", "id", "statement",
// "verdict", "reason", "margin", "at"}]}], "seen"}, as of the families; "phase" counts from 1, "seen" says
// what was met instead of an orbit.
[[nodiscard]] tools::Json to_json(const numeric::attractors::WordOrbits& list);

// A line for each attractor, then where they are. The parameters are those of (2) in any units, and so are
// margins.
[[nodiscard]] std::string terminal_report(const numeric::attractors::AttractorList& list,
                                          const tools::Style& style, const Units& units = {});
// Each orbit with its values, phases, stability and, of all phases, the least margin of each condition;
// formal solutions in a line each, as of the families.
[[nodiscard]] std::string terminal_report(const numeric::attractors::WordOrbits& list,
                                          const tools::Style& style, const Units& units = {},
                                          InFull in_full = InFull::admissible);

// "settles on OTS with the period 1: stable, |mu| <= 0.916".
[[nodiscard]] std::string in_words(const numeric::attractors::Attractor& attractor);

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::attractors::AttractorQuestion& question);
[[nodiscard]] std::string command_of(const numeric::attractors::WordSearch& question);

}  // namespace stickslip::report::orbits
