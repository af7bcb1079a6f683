// Trees of lines as terms: 0, I and what stands about them take the sizes that fit. For parse.cpp.
#pragma once

#include <string_view>
#include <utility>

#include "proofs/symbols/parse_tree.hpp"

namespace stickslip::proofs::symbols::parsing {

// The two sides of a relation, of one size; a number; any term. Throw ParseError.
[[nodiscard]] std::pair<Term, Term> sides_of(const Node& left, const Node& right, std::string_view line,
                                             const Names& names);
[[nodiscard]] Term number_of(const Node& node, std::string_view line, const Names& names);
[[nodiscard]] Term term_of(const Node& node, std::string_view line, const Names& names,
                           const std::optional<Shape>& shape = {});

}  // namespace stickslip::proofs::symbols::parsing
