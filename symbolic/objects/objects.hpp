// The derived expressions by name, as displayed equations for papers.
#pragma once

#include <string>
#include <vector>

namespace stickslip::symbolic::objects {

// In what an object is written: chi, eta and the abbreviations omega_j, lambda_j (39); or omega_1, omega_2
// alone.
enum class Unknowns { chi, omega };

// One line of a displayed equation, left = right, as LaTeX.
struct Line {
  std::string left;
  std::string right;
};

// A named expression of the paper, built from the templates of model/.
struct Object {
  std::string name;    // "H1"
  std::string number;  // of the paper's equation, "(38)"
  std::string title;   // "first block of H"
  // What it is equal to, and what the abbreviations introduced by that line stand for.
  std::vector<Line> (*lines)(Unknowns unknowns);
};

// In the paper's order.
[[nodiscard]] const std::vector<Object>& objects();

// The object of that name, or nullptr.
[[nodiscard]] const Object * find_object(const std::string& name);

// Its displayed equation, \[ ... \] or, if it has several lines, one gather* or more, for a document with
// amsmath: the same characters on every run, ending with a line feed.
[[nodiscard]] std::string displayed(const Object& object, Unknowns unknowns);

// What chi, eta and lambda_j are in the frequencies, displayed; nothing where they are what is written in.
[[nodiscard]] std::string meanings(Unknowns unknowns);

// Name, equation and title of all objects, one line each.
[[nodiscard]] std::string list_of_objects();

}  // namespace stickslip::symbolic::objects
