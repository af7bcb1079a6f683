// Plain text made safe for the two page formats.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stickslip::report::tools {

// UTF-8 as code points: all that tables and escapes need.

struct CodePoint {
  char32_t value;      // U+FFFD for a broken byte
  std::size_t length;  // in bytes, at least 1
};

// The code point that begins at text[position]. Assumes position < text.size().
[[nodiscard]] CodePoint code_point(std::string_view text, std::size_t position);

// Columns that the text takes on a terminal: one per code point, none for a combining mark.
[[nodiscard]] std::size_t columns(std::string_view text);

// For text and quoted attributes of HTML: & < > " ' become references, everything else stays.
[[nodiscard]] std::string escape_html(std::string_view text);

// For running text of a LaTeX document with the default input and font encodings: special characters are
// escaped; the paper's Greek letters, super- and subscripts and relations become mathematics; hyphens in a
// row stay hyphens; a control character becomes a space; any other character beyond ASCII and Latin-1
// letters, and a broken byte, becomes [U+XXXX].
[[nodiscard]] std::string escape_tex(std::string_view text);

}  // namespace stickslip::report::tools
