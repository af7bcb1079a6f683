// Motions of one phase, for ever: slip, overshoot or stick.
#pragma once

#include <string>

#include "numeric/words/word_orbit.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

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

// "forced" and "room", of numeric/words/pure.hpp, are in the units; of a stick "room" is ur - p/eta of
// pure_stick there.
[[nodiscard]] tools::Json to_json(const PureWord& word, const Units& units = {});
[[nodiscard]] tools::File pure_schema();

}  // namespace stickslip::report::orbits
