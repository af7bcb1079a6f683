// Plain text made safe for the two page formats.
#pragma once

#include <string>
#include <string_view>

namespace stickslip::report::tools {

// For text and quoted attributes of HTML: & < > " ' become references, everything else stays.
[[nodiscard]] std::string escape_html(std::string_view text);

// For running text of a LaTeX document with the default input and font encodings: special characters are
// escaped; the paper's Greek letters, super- and subscripts and relations become mathematics; hyphens in a
// row stay hyphens; a control character becomes a space; any other character beyond ASCII and Latin-1
// letters, and a broken byte, becomes [U+XXXX].
[[nodiscard]] std::string escape_tex(std::string_view text);

}  // namespace stickslip::report::tools
