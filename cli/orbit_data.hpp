// From what the user types to the question that numeric/orbits.hpp answers.
#pragma once

#include <cstddef>
#include <string>

#include "cli/machine_file.hpp"
#include "numeric/branches/branches.hpp"
#include "numeric/orbits.hpp"
#include "numeric/words/word_orbit.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

// Throws UsageError naming all of the names that are not among the parameters.
void require_given(const TypedParameters& parameters, const std::vector<std::string>& names);

// What is typed, in the file and of the example, none of which need be all that a question needs. Throws
// UsageError for an unknown example.
[[nodiscard]] TypedParameters given_parameters(const proofs::methods::Paper& paper,
                                               const ParameterFile& file);

// The question about the family. The example's phi or ur counts only for its own family and when neither is
// given otherwise. Throws UsageError for a missing or malformed parameter.
[[nodiscard]] numeric::OrbitQuestion question(const proofs::methods::Paper& paper,
                                              const numeric::Family& family, const ParameterFile& file,
                                              int digits);

// The parameter that a branch is along.
struct Along {
  std::string parameter;
  Rational from, to;
};

// The one parameter that is typed as an interval "A..B"; its lower end stands for it from then on. Throws
// UsageError when none or several are intervals, and as exact_number.
[[nodiscard]] Along along_interval(TypedParameters& typed);

// What is typed with what --along NAME A..B says, if it says anything. Throws UsageError for a name that is
// neither a parameter's nor a machine's in SI units.
[[nodiscard]] TypedParameters with_along(TypedParameters typed, const std::vector<std::string>& along);

// The value `at`, or the middle of the interval.
[[nodiscard]] Rational value_at(const Along& along, const std::optional<Rational>& at);

// The question about the family's orbits over the one parameter that is typed as an interval "A..B": all of
// them, or the branches of the orbits at the value `at` if there is one. Throws likewise, and when none
// or several of the parameters are intervals.
[[nodiscard]] numeric::branches::BranchQuestion branch_question(const proofs::methods::Paper& paper,
                                                                const numeric::Family& family,
                                                                ParameterFile file,
                                                                const std::optional<Rational>& at);

// Which orbits of a word are followed: the admissible ones that are found, of words of four phases and more
// by simulation alone; or all that `stickslip orbits WORD` lists, the K-th of these, or the one near a state.
struct Followed {
  bool all = false;
  std::optional<int> orbit;                    // K
  std::optional<model::Vector4<double>> near;  // (x1, x2, x1', x2') at load phase 0
};

// The same about the orbits through a word, over so many periods of the load, that are found at the value
// `at`, or in the middle of the interval.
[[nodiscard]] numeric::branches::BranchQuestion word_branch_question(const proofs::methods::Paper& paper,
                                                                     const numeric::words::Word& word,
                                                                     int periods, ParameterFile file,
                                                                     const std::optional<Rational>& at,
                                                                     const Followed& followed = {});

// The machine whose motions are asked for: the same, with ur in any case, that of the example's own orbit to
// 17 digits when none is given, and without phi, for the load is cos(omega t). Throws likewise, also for
// intervals.
[[nodiscard]] numeric::words::WordQuestion machine(const proofs::methods::Paper& paper,
                                                   const ParameterFile& file, int digits);

// An orbit as the user names it: FAMILY:K.

struct NamedOrbit {
  numeric::OrbitList list;  // that it is in
  std::size_t index = 0;    // from 0

  [[nodiscard]] const numeric::Orbit& orbit() const { return list.orbits[index]; }
};

// Orbit K, from 1, of those that `stickslip orbits FAMILY` lists at the parameters, of which the family's
// results are left out. Searches for the orbits. Throws UsageError for what is no such name, for a missing
// parameter, for an interval and for an orbit that there is not, DomainError as list_orbits does.
[[nodiscard]] NamedOrbit named_orbit(const std::string& name, const proofs::methods::Paper& paper,
                                     ParameterFile& file, int digits);

}  // namespace stickslip::cli
