// What the derived expressions are written in, shared by the files that list them.
#pragma once

#include <string>
#include <vector>

#include "model/flows.hpp"
#include "symbolic/algebra/symbols.hpp"
#include "symbolic/objects/objects.hpp"
#include "symbolic/typeset/latex.hpp"

namespace stickslip::symbolic::objects {

using Lines = std::vector<Line>;

[[nodiscard]] GiNaC::ex chi();
[[nodiscard]] GiNaC::ex eta();
[[nodiscard]] GiNaC::ex omega();
[[nodiscard]] GiNaC::ex phi();
[[nodiscard]] model::Modes<GiNaC::ex> modes();
[[nodiscard]] model::Parameters<GiNaC::ex> parameters();
// As abbreviations: the objects Q and d0 say what they are.
[[nodiscard]] model::Vector2<GiNaC::ex> Q_symbols();
[[nodiscard]] model::Vector2<GiNaC::ex> d0_symbols();

// left = value, in these unknowns.
[[nodiscard]] GiNaC::ex written_in(const GiNaC::ex& value, Unknowns unknowns);
[[nodiscard]] Line scalar(const std::string& left, const GiNaC::ex& value, Unknowns unknowns = Unknowns::chi);
template <class Derived>
[[nodiscard]] Line matrix(const std::string& left, const Eigen::MatrixBase<Derived>& value,
                          Unknowns unknowns = Unknowns::chi) {
  const auto written =
      value.unaryExpr([unknowns](const GiNaC::ex& entry) { return written_in(entry, unknowns); });
  Line line{left, typeset::latex(written), {}, static_cast<std::size_t>(value.cols())};
  for (const auto& row : value.rowwise()) {
    line.entries.insert(line.entries.end(), row.begin(), row.end());
  }
  return line;
}
// left = the sum, its terms in an order that does not depend on how it was built, broken into lines that
// fit a page.
[[nodiscard]] Line sum(const std::string& left, const GiNaC::ex& value);
// chi, eta, lambda_1, lambda_2 in the frequencies, for lines that have them as abbreviations.
void append_meanings(Lines& lines, Unknowns unknowns);

// The equations of the orbits, Sections 4-6 and Appendices 3 and 5.
[[nodiscard]] std::vector<Object> orbit_objects();

}  // namespace stickslip::symbolic::objects
