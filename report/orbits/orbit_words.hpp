// The words that every form of a list of orbits shares.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "numeric/attractors/word_search.hpp"
#include "numeric/orbits.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// The exact notation of a parameter: "0.5", or "0.5+-0.0001" for an interval; a text is one already.
[[nodiscard]] std::string notation(const Range& range);
[[nodiscard]] std::string notation(const Rational& value);
[[nodiscard]] inline const std::string& notation(const std::string& text) {
  return text;
}

// Values with their names.
template <class Value>
using Named = std::vector<std::pair<std::string, Value>>;

// The six parameters in the paper's order, then phi and ur as far as they are given.
[[nodiscard]] Named<Range> named_parameters(const numeric::OrbitQuestion& question);
[[nodiscard]] Named<Rational> named_parameters(const numeric::words::WordQuestion& question);

// Of values with their names, or of the parameters of a question: "chi=0.3, eta=4"; what the program's
// options say of them, " --chi=0.3 --eta=4".
template <class Value>
[[nodiscard]] std::string parameter_list(const Named<Value>& values) {
  return tools::enumerated(values, [](const auto& one) { return one.first + "=" + notation(one.second); });
}
template <class Value>
[[nodiscard]] std::string options_of(const Named<Value>& values) {
  return tools::enumerated(
      values, [](const auto& one) { return " --" + one.first + "=" + notation(one.second); }, "");
}
[[nodiscard]] std::string parameter_list(const auto& question) {
  return parameter_list(named_parameters(question));
}
[[nodiscard]] std::string options_of(const auto& question) {
  return options_of(named_parameters(question));
}

// "tau = 0.1, phi = 0.2, ": where in the domain something is.
[[nodiscard]] std::string place_text(const std::vector<numeric::NamedBall>& where);

// The colour of a kind of phase in pictures: "#1f4e9c".
[[nodiscard]] std::string colour_of(numeric::motion::PhaseKind kind);

// One sentence.
[[nodiscard]] std::string describe(numeric::Remark remark);

// What is to be said of u_r where it is a result, one sentence; none where it is given, or there are not two
// orbits. That each orbit has another u_r is said only if the balls are pairwise disjoint.
[[nodiscard]] std::string remark_on_ur(const numeric::OrbitList& list);

// The domain that was searched.
[[nodiscard]] std::string searched(const numeric::OrbitQuestion& question);

// "complete: 2 orbits, 1 admissible, no unresolved boxes"; for a box of parameters "1 orbit, 1 admissible,
// 2 orbits not proved for the whole box, no unresolved boxes".
[[nodiscard]] std::string result_of_search(const numeric::OrbitList& list);

// The ids of the conditions that decide that the orbit is not admissible, or leave it open.
[[nodiscard]] std::vector<std::string> decisive_conditions(const numeric::Orbit& orbit);

// "admissible", or why it is not known to be: "not admissible: ur, 12".
[[nodiscard]] std::string verdict_on(const numeric::Orbit& orbit);

// "(0.1 ± 1e-5) + i (0.2 ± 1e-5)", or the real part alone when the imaginary part is exactly 0.
[[nodiscard]] std::string complex_text(const numeric::motion::ComplexBall& mu, int digits);

// What the margin of a condition is, in half a sentence.
[[nodiscard]] std::string meaning_of_margin();
// The units of values and conditions, one sentence: those of (3), or which of them are in those of the data
// taken where values are in SI.
[[nodiscard]] std::string meaning_of_units(bool in_SI = false);

// The unit of a value by its name, "rad" or none, where values are not in SI.
[[nodiscard]] std::string unit_of(const std::string& name);

// The LaTeX of the name of an orbit's value: those of symbolic/typeset/names.hpp and ur_max.
[[nodiscard]] std::string latex_of_value(const std::string& name);

// "$\varphi = 0.5$ rad", the value in LaTeX.
[[nodiscard]] std::string latex_of_value(const std::string& name, const std::string& value);

// The command that lists the same orbits.
[[nodiscard]] std::string command_of(const numeric::OrbitQuestion& question);
[[nodiscard]] std::string command_of(const numeric::attractors::WordSearch& question);

}  // namespace stickslip::report::orbits
