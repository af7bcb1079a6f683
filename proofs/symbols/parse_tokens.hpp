// The words and signs of a line. For parse.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stickslip::proofs::symbols::parsing {

enum class Kind { number, name, sign, end };

struct Token {
  Kind kind = Kind::end;
  std::string text = {};
  std::size_t at = 0;  // in the line
  bool apart = true;   // a blank or nothing stands before it
};

// Of the line in plain characters: omega1 for ω₁, ^2 for ². The last one is the end. Throws ParseError.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view line);

}  // namespace stickslip::proofs::symbols::parsing
