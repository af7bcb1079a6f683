// The C libraries below know no exceptions: where they find no memory, they would abort. So does the
// allocator.
#pragma once

namespace stickslip::cli {

inline constexpr const char * out_of_memory = "stickslip: out of memory.";

// From now on `new`, GMP and FLINT, with Arb and CLN on top of GMP, end the program with a sentence and
// exit_internal when there is no memory left. To be called before any number is made.
void end_in_words_without_memory();

}  // namespace stickslip::cli
