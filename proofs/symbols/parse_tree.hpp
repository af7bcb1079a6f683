// Lines as trees whose sizes are not known yet. For parse.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs/symbols/parse.hpp"

namespace stickslip::proofs::symbols::parsing {

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
