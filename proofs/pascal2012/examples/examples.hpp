// What the paper prints about its three examples: the data and the numbers of Figs. 2, 3 and 4.
#pragma once

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

// S, O, P: symmetric, overshooting, non-sticking.
[[nodiscard]] const methods::Examples& printed_examples();

// Throws UsageError naming the known ones when there is no example of that name.
[[nodiscard]] const methods::Example& example_named(const std::string& name);

// Data of ours, "V": a belt that moves, and a motion that never sticks (7.only).
[[nodiscard]] const methods::Example& on_a_moving_belt();

}  // namespace stickslip::proofs::pascal2012
