// Standard output, checked to the last byte.
#pragma once

#include <string_view>

#include "core/error.hpp"
#include "report/table.hpp"

namespace stickslip::cli {

// The reader of standard output is gone (stickslip check | head): nothing to say, and nobody to say it to.
struct ReaderGone : InputOutputError {
  using InputOutputError::InputOutputError;
};

// Writes the text and waits until the system has taken it. Throws ReaderGone or, if standard output is closed
// or full, InputOutputError.
void print(std::string_view text);

// A line on standard error, for a person; whether it arrives does not matter.
void tell(std::string_view line) noexcept;

// Eighty columns; coloured on a terminal, unless NO_COLOR is set to something or the terminal is dumb.
[[nodiscard]] report::Style terminal_style();

}  // namespace stickslip::cli
