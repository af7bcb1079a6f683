// What pages on motions share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/orbits/machine.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// What the page says beside the result.
struct PageFrame {
  std::string file;                           // of the machine, if it was read from one
  std::optional<numeric::DataTaken> machine;  // in SI units, if it was given so
  Units units = {};                           // of states and pictures
};

// A section of facts, for the template _tables.html: of rows of a label and a sentence.
[[nodiscard]] tools::Json table(const char * anchor, const char * heading,
                                const std::vector<tools::Row>& rows);
[[nodiscard]] tools::Json rows_data(const std::vector<tools::Row>& rows);

// What all templates of pages ask for: title, origin, the machine as the first of the "tables".
[[nodiscard]] tools::Json page_data(const PageFrame& frame, const std::string& title,
                                    const std::string& command, const std::string& precision);

// The result as a file beside the page, with the machine: what --json prints.
[[nodiscard]] tools::File json_file(const std::string& name, tools::Json json, const PageFrame& frame);

// index.html from the template, with its style sheets, before the files. Throws InputOutputError when a
// program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> with_page(const std::string& page, const tools::Json& data,
                                                 std::vector<tools::File> files);

}  // namespace stickslip::report::orbits
