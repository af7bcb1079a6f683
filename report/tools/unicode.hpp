// UTF-8 as code points: all that tables and escapes need.
#pragma once

#include <cstddef>
#include <string_view>

namespace stickslip::report::tools {

struct CodePoint {
  char32_t value;      // U+FFFD for a broken byte
  std::size_t length;  // in bytes, at least 1
};

// The code point that begins at text[position]. Assumes position < text.size().
[[nodiscard]] CodePoint code_point(std::string_view text, std::size_t position);

// Columns that the text takes on a terminal: one per code point, none for a combining mark.
[[nodiscard]] std::size_t columns(std::string_view text);

}  // namespace stickslip::report::tools
