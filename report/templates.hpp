// Pages from mustache templates and JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "report/json.hpp"

namespace stickslip::report {

// Where the templates are: installed beside the running program, else in the source tree it was built from.
// Throws InputOutputError naming both places if neither exists.
[[nodiscard]] std::filesystem::path template_directory();

using Escape = std::string (*)(std::string_view);

// The template filled in. In it, keys of the JSON are names, arrays are lists, null and false are false;
// has_KEY says whether KEY is neither empty nor null. Values are escaped unless written {{& KEY}} or
// {{{KEY}}}. Throws InternalError naming the template if it is malformed.
[[nodiscard]] std::string render(const std::string& name, const std::string& source, const Json& data,
                                 Escape escape);

}  // namespace stickslip::report
