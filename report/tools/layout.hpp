// Text in columns and paragraphs of a given width.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stickslip::report::tools {

// How a terminal wants its text.
struct Style {
  bool colour = false;
  std::size_t width = 80;
};

// A cell of a table: its text and, for a terminal that has them, the escape sequence of its colour.
struct Cell {
  std::string text;
  std::string colour = {};
};

using Row = std::vector<Cell>;

// The text broken into lines of at most `width` columns (at least 1), between words where possible. Never
// empty.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

// Rows in columns as wide as their widest cell, two spaces between them; the last column takes what is left
// of the width, at least 20, and is wrapped. Sentences lose the marks of their formulas. Every line ends with
// a line feed.
[[nodiscard]] std::string columns_of(std::vector<Row> rows, std::size_t width);

// "label text" wrapped to the width, all lines indented, those after the first as far as the text.
[[nodiscard]] std::string labelled(std::size_t indent, const std::string& label, const std::string& text,
                                   std::size_t width);

// "1 orbit", "2 orbits", "2 branches": by default the plural has an s.
[[nodiscard]] std::string counted(std::size_t count, const std::string& one, const std::string& many = "");

// What the function makes of each member, one behind the other with the separator between them.
template <class Range, class Function = std::identity>
[[nodiscard]] std::string enumerated(const Range& range, const Function& function = {},
                                     const char * separator = ", ") {
  std::string text;
  bool first = true;
  for (const auto& member : range) {
    text += first ? "" : separator;
    text += std::invoke(function, member);
    first = false;
  }
  return text;
}

// The members of a map, those first of which `size` makes the most.
template <class Key, class Value, class Size = std::identity>
[[nodiscard]] std::vector<std::pair<Key, Value>> largest_first(const std::map<Key, Value>& all,
                                                               const Size& size = {}) {
  std::vector<std::pair<Key, Value>> rows(all.begin(), all.end());
  std::ranges::stable_sort(rows, std::greater(),
                           [&](const auto& row) { return std::invoke(size, row.second); });
  return rows;
}

// A word of the program without its underscores: "as printed" for to_string(Status::as_printed).
[[nodiscard]] std::string spaced(std::string word);

}  // namespace stickslip::report::tools
