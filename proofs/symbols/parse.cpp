#include "proofs/symbols/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace stickslip::proofs::symbols {
namespace {

// Characters before that place.
std::size_t characters(std::string_view line, std::size_t at) {
  return static_cast<std::size_t>(std::ranges::count_if(
      line.substr(0, at), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The line about that place, with a caret below it.
std::string pointing(std::string_view line, std::size_t at) {
  constexpr std::size_t before = 60, after = 20;
  const auto is_inside = [&](std::size_t k) {
    return k < line.size() && (static_cast<unsigned char>(line[k]) & 0xC0U) == 0x80U;
  };
  std::size_t begin = at > before ? at - before : 0, end = std::min(line.size(), at + after);
  while (is_inside(begin)) {
    ++begin;
  }
  while (is_inside(end)) {
    ++end;
  }
  const std::string cut = begin > 0 ? "…" : "";
  return fmt::format("  {}{}{}\n  {:>{}}", cut, line.substr(begin, end - begin), end < line.size() ? "…" : "",
                     "^", characters(line.substr(begin), at - begin) + 1 + (begin > 0 ? 1 : 0));
}

}  // namespace

ParseError::ParseError(std::string_view line, std::size_t at, const std::string& what)
    : UsageError(fmt::format("column {}: {}", characters(line, at) + 1, what)),
      excerpt_(pointing(line, at)) {}

ParseError ParseError::in(const std::string& place) const {
  return {fmt::format("{}: {}", place, what()), excerpt_};
}

bool Names::has(const std::string& name) const {
  return quantities.contains(name) || functions.contains(name) || abbreviations.contains(name);
}

Names names_of(const Symbols& table) {
  Names names;
  for (const Symbol& symbol : table) {
    if (symbol.name == "I" || symbol.name == "abs") {
      continue;
    }
    auto& map = symbol.of_time ? names.functions : names.quantities;
    if (!map.emplace(symbol.name, symbol.shape).second) {
      throw InternalError("two symbols are written " + symbol.name);
    }
  }
  return names;
}

bool is_name(const std::string& word) {
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
         std::ranges::all_of(
             word, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

}  // namespace stickslip::proofs::symbols
