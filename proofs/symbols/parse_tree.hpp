// Lines as trees whose sizes are not known yet.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs/symbols/parse.hpp"

namespace stickslip::proofs::symbols::parsing {

// The words and signs of a line.

enum class Kind { number, name, sign, end };

struct Token {
  Kind kind = Kind::end;
  std::string text = {};
  std::size_t at = 0;  // in the line
  bool apart = true;   // a blank or nothing stands before it
};

// Of the line in plain characters: omega1 for ω₁, ^2 for ². The last one is the end. Throws ParseError.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view line);

struct Node {
  Op op = Op::number;
  std::size_t at = 0;  // in the line
  std::string name = {};
  Rational number = 0;  // as that of a Term
  std::vector<Node> parts = {};
  const Abbreviation * abbreviation = nullptr;  // of a symbol or function
};

// left < middle = right, …, at the times and with the interval of continuity that are written.
struct Relations {
  std::vector<Node> sides;
  std::vector<Relation> between;
  std::optional<std::pair<Node, Node>> times, continuous;
  bool almost = false;
};

// Throw ParseError. What they return points into the names.
[[nodiscard]] Relations relations_in(std::string_view line, const Names& names);
[[nodiscard]] Node expression_in(std::string_view line, const Names& names);

}  // namespace stickslip::proofs::symbols::parsing
