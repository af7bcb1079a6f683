// Pages from mustache templates and JSON.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "report/tools/json.hpp"

namespace stickslip::report::tools {

// The text of each file in report/templates/, by its name; the library has them inside.
[[nodiscard]] const std::map<std::string, std::string>& templates();

using Escape = std::string (*)(std::string_view);

// How text gets onto a page: as it stands, and a sentence with formulas in it (prose.hpp).
struct PageFormat {
  Escape text;
  Escape prose;
};

extern const PageFormat html_format;
extern const PageFormat tex_format;
extern const PageFormat plain_format;  // nothing is escaped

// The template filled in. In it, keys of the JSON are names, arrays are lists, null and false are false;
// has_KEY says whether KEY is neither empty nor null. Values are escaped unless written {{& KEY}} or
// {{{KEY}}}; {{#prose}}{{&KEY}}{{/prose}} is a sentence; {{>NAME}} is the file _NAME.mustache. Throws
// InternalError naming the template if it is malformed.
[[nodiscard]] std::string render(const std::string& name, const std::string& source, const tools::Json& data,
                                 const PageFormat& format);

// The same for one of the templates: NAME.mustache.
[[nodiscard]] std::string render_file(const std::string& name, const tools::Json& data,
                                      const PageFormat& format);

}  // namespace stickslip::report::tools
