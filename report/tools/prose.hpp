// Text made safe for pages, and sentences with formulas in them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stickslip::report::tools {

// Plain text made safe for the two page formats.

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

// Sentences with formulas in them, each between dollars and otherwise as one types it: "slip with $x2' < V$".
// Without the dollars, plain() of core/verdict.hpp, they are for terminals and data.

// The sentence for a page: words escaped, the LaTeX of formulas between <tex> and </tex>, or between dollars.
// What stands between the marks is symbols (symbolic/typeset/names.hpp), numbers, signs and brackets; outside
// them only a number with an exponent or a radius, such as 1.5 ± 2e-7, is set as a formula.
[[nodiscard]] std::string prose_html(std::string_view sentence);
[[nodiscard]] std::string prose_tex(std::string_view sentence);

// A list of data for pages and pictures: "χ=0.3, η=4, u_s=0.1" for "chi=0.3, eta=4, us=0.1".
[[nodiscard]] std::string in_greek(std::string list);

// With a capital.
[[nodiscard]] std::string capitalised(std::string words);

}  // namespace stickslip::report::tools
