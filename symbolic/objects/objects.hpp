// The derived expressions by name, as displayed equations for papers.
#pragma once

#include <string>
#include <vector>

#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::objects {

// In what an object is written: chi, eta and the abbreviations omega_j, lambda_j (39); or omega_1, omega_2
// alone.
enum class Unknowns { chi, omega };

// One line of a displayed equation, left = right, as LaTeX.
struct Line {
  std::string left;
  std::string right;
  // What the right side is, a number or a matrix row by row; nothing where it is only words for the lines
  // that follow.
  std::vector<GiNaC::ex> entries = {};
  std::size_t columns = 1;
};

// A named expression of the paper, built from the templates of model/.
struct Object {
  std::string name;    // "H1"
  std::string number;  // of the paper's equation, "(38)"
  std::string title;   // "first block of $H$", formulas between dollars
  // What it is equal to, and what the abbreviations introduced by that line stand for.
  std::vector<Line> (*lines)(Unknowns unknowns);
};

// In the paper's order.
[[nodiscard]] const std::vector<Object>& objects();

// The object of that name, or nullptr.
[[nodiscard]] const Object * find_object(const std::string& name);

// A displayed equation, \[ ... \] or, if it has several lines, one gather* or more, for a document with
// amsmath: the same characters on every run, ending with a line feed.
[[nodiscard]] std::string displayed(const std::vector<Line>& lines);
[[nodiscard]] std::string displayed(const Object& object, Unknowns unknowns);

// Its lines as they stand in the display, for an environment of the reader's own, such as gather*.
[[nodiscard]] std::string bare(const Object& object, Unknowns unknowns);

// left = the terms, each with its sign except the first, broken into lines that fit a page.
[[nodiscard]] Line broken(const std::string& left, const std::vector<std::string>& terms);

// What chi, eta and lambda_j are in the frequencies, displayed; nothing where they are what is written in.
[[nodiscard]] std::string meanings(Unknowns unknowns);

// Name, equation and title of all objects, one line each.
[[nodiscard]] std::string list_of_objects();

}  // namespace stickslip::symbolic::objects
