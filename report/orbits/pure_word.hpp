// Motions of one phase, for ever: slip, overshoot or stick.
#pragma once

#include <string>

#include "numeric/words/word_orbit.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

struct PureWord {
  numeric::words::WordQuestion machine;
  numeric::motion::PhaseKind kind;
};

// Of "some motions stay in this phase for ever".
[[nodiscard]] Verdict exists(const PureWord& word);

// Whether there are such motions, which, and that they are neutral. Speeds and forces are in the units.
[[nodiscard]] std::string terminal_report(const PureWord& word, const tools::Style& style,
                                          const Units& units = {});

// As report/schema/pure.schema.json says: what provenance() says, and {"word": "S", "O" or "T", "parameters":
// {"chi", …, "p", "ur"}, "verdict", "reason", "forced": BALL, "room": BALL, "stability": "neutral"}, of
// numeric/words/pure_slip.hpp; of a stick "room" is ur - p/eta of pure_stick.hpp. Absent: a reason of what is
// proved; of a stick "forced"; of what is not proved to exist "room" and "stability". "forced" and "room" are
// in the units.
[[nodiscard]] tools::Json to_json(const PureWord& word, const Units& units = {});

}  // namespace stickslip::report::orbits
