// From what the user types to the question that numeric/orbits.hpp answers.
#pragma once

#include <cstddef>
#include <string>

#include "cli/answers/machine_file.hpp"
#include "numeric/orbits.hpp"
#include "numeric/words/word_orbit.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

// Throws UsageError naming all of the names that are not among the parameters.
void require_given(const TypedParameters& parameters, const std::vector<std::string>& names);

// What is typed, in the file and of the example, none of which need be all that a question needs; phi or ur
// of the example for its own family alone, which is the one that is asked about unless another is named.
// Throws UsageError for an unknown example.
[[nodiscard]] TypedParameters given_parameters(const proofs::methods::Examples& examples,
                                               const ParameterFile& file,
                                               const numeric::Family * family = nullptr);

// The question about the family. The example's phi or ur counts only for its own family and when neither is
// given otherwise. Throws UsageError for a missing or malformed parameter.
[[nodiscard]] numeric::OrbitQuestion question(const proofs::methods::Examples& examples,
                                              const numeric::Family& family, const ParameterFile& file,
                                              int digits);

// The machine whose motions are asked for: its data, with ur in any case, that of the example's own orbit to
// 17 digits when none is given, and without phi, for the load is cos(omega t). Throws likewise, also for
// intervals.
[[nodiscard]] numeric::words::WordQuestion machine(const proofs::methods::Examples& examples,
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
[[nodiscard]] NamedOrbit named_orbit(const std::string& name, const proofs::methods::Examples& examples,
                                     ParameterFile& file, int digits);

}  // namespace stickslip::cli
