// Printed statements read back from a line of text, in the notation in which text() prints them.
//
//   statement  = expression relation expression { relation expression } [ times ]
//   relation   = "=" | "!=" | "<" | "<=" | ">" | ">="   (or ≠, ≤, ≥)
//   times      = ( "," | "for" [ "almost all" ] ) expression "<" "t" "<" expression
//                [ "but for finitely many t" ]
//                [ ", continuous on [" expression "," expression "]" ]
//   expression = [ "-" ] product { ( "+" | "-" ) product }   (-a b is (-a) b)
//   product    = factor { "*" factor | "/" factor | factor }   (no bare factor after "/" factor)
//   factor     = primary [ "^" [ "-" ] digits ]   (or ², ³; A^-1 is the inverse)
//   primary    = number | symbol | function { "'" } [ power ] "(" expression ")"
//              | "(" expression ")" | "|" expression "|" | "[" rows of blocks "]"
//              | "det(" expression ")" | "d/dt[" expression "]"
//
// 0 and I take the sizes of what they stand with. What is a quantity and a function, as x1 and x1(t), is the
// function where "(" follows at once. Greek letters and subscripts may be typed: ω₁, omega_1 and omega1 are
// the same.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::symbols {

// What is put in for a name where it is read, with the arguments for the parameters, which are numbers.
struct Abbreviation {
  std::vector<std::string> parameters;
  Term means;
};

// The names that a line may use, with the shapes of what they stand for.
struct Names {
  std::map<std::string, Shape, std::less<>> quantities;
  std::map<std::string, Shape, std::less<>> functions;  // their values', of one scalar
  std::map<std::string, Abbreviation, std::less<>> abbreviations;
  std::string own_by = {};  // what a further one is named by, if anything, for messages: "--symbols "

  [[nodiscard]] bool has(const std::string& name) const;
};

[[nodiscard]] Names names_of(const Symbols& table);
// Whether it can be the name of a symbol: a letter, then letters, digits and '_'.
[[nodiscard]] bool is_name(const std::string& word);

// A line that cannot be read. The message is a sentence that begins with the column, from 1.
class ParseError : public UsageError {
 public:
  // `at`: where in the line, in bytes from 0.
  ParseError(std::string_view line, std::size_t at, const std::string& what);
  // The same, of a line that stands in a file.
  [[nodiscard]] ParseError in(const std::string& place) const;
  // The line, and below it a caret at that place.
  [[nodiscard]] const std::string& excerpt() const { return excerpt_; }

 private:
  ParseError(const std::string& message, std::string excerpt)
      : UsageError(message), excerpt_(std::move(excerpt)) {}
  std::string excerpt_;
};

// What the line says; more than one statement for a chain of relations. Throws ParseError.
[[nodiscard]] std::vector<Statement> parse_statements(std::string_view line, const Names& names);

// A single term, of that shape where the line leaves it open. Throws ParseError.
[[nodiscard]] Term parse_term(std::string_view line, const Names& names,
                              const std::optional<Shape>& shape = {});

}  // namespace stickslip::proofs::symbols
