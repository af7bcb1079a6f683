#include "report/tools/unicode.hpp"

namespace stickslip::report::tools {
namespace {

constexpr CodePoint broken{0xFFFD, 1};

unsigned byte(std::string_view text, std::size_t position) {
  return static_cast<unsigned char>(text[position]);
}

std::size_t length_by_first_byte(unsigned first) {
  if (first < 0x80) {
    return 1;
  }
  if (first >= 0xC2 && first < 0xE0) {
    return 2;
  }
  if (first >= 0xE0 && first < 0xF0) {
    return 3;
  }
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

}  // namespace

CodePoint code_point(std::string_view text, std::size_t position) {
  const unsigned first = byte(text, position);
  const std::size_t length = length_by_first_byte(first);
  if (length == 1) {
    return {first, 1};
  }
  if (length == 0 || position + length > text.size()) {
    return broken;
  }
  char32_t value = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned next = byte(text, position + i);
    if ((next & 0xC0U) != 0x80U) {
      return broken;
    }
    value = (value << 6U) | (next & 0x3FU);
  }
  return {value, length};
}

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point(text, i);
    const bool combining = c.value >= 0x300 && c.value < 0x370;
    count += combining ? 0 : 1;
    i += c.length;
  }
  return count;
}

}  // namespace stickslip::report::tools
