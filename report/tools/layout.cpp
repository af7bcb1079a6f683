#include "report/tools/layout.hpp"

#include <algorithm>

#include "core/verdict.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::tools {
namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t narrowest = 20;

// The longest beginning of the text that fits, whole code points, at least one.
std::size_t bytes_that_fit(std::string_view text, std::size_t width) {
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t next = end + code_point(text, end).length;
    if (end > 0 && columns(text.substr(0, next)) > width) {
      break;
    }
    end = next;
  }
  return end;
}

std::vector<std::size_t> column_widths(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns(row[i].text));
    }
  }
  return widths;
}

std::string painted(const Cell& cell) {
  return cell.colour.empty() ? cell.text : cell.colour + cell.text + "\x1b[0m";
}

void append_row(std::string& result, const Row& row, const std::vector<std::size_t>& widths,
                std::size_t width) {
  std::size_t start = 0;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    result += painted(row[i]);
    result.append(widths[i] - columns(row[i].text) + gap, ' ');
    start += widths[i] + gap;
  }
  const std::size_t left = width > start + narrowest ? width - start : narrowest;
  const std::vector<std::string> lines = wrapped(row.back().text, left);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    result.append(i == 0 ? 0 : start, ' ');
    result += painted({lines[i], row.back().colour});
    result.erase(result.find_last_not_of(' ') + 1);
    result += '\n';
  }
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::string_view rest = text;
  while (columns(rest) > width) {
    const std::size_t fits = bytes_that_fit(rest, width);
    const std::size_t space = rest.substr(0, fits + 1).rfind(' ');
    const bool between_words = space != std::string_view::npos && space > 0;
    lines.emplace_back(rest.substr(0, between_words ? space : fits));
    rest.remove_prefix(between_words ? space + 1 : fits);
  }
  lines.emplace_back(rest);
  return lines;
}

std::string columns_of(std::vector<Row> rows, std::size_t width) {
  for (Row& row : rows) {
    for (Cell& cell : row) {
      cell.text = plain(std::move(cell.text));
    }
  }
  const std::vector<std::size_t> widths = column_widths(rows);
  std::string result;
  for (const Row& row : rows) {
    if (!row.empty()) {
      append_row(result, row, widths, width);
    }
  }
  return result;
}

std::string labelled(std::size_t indent, const std::string& label, const std::string& text,
                     std::size_t width) {
  return columns_of({{{std::string(indent, ' ') + label}, {text}}}, width);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many.empty() ? one + "s" : many);
}

std::string spaced(std::string word) {
  std::ranges::replace(word, '_', ' ');
  return word;
}

}  // namespace stickslip::report::tools
