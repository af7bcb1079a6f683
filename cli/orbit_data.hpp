// From what the user types to the question that numeric/orbits.hpp answers.
#pragma once

#include <string>

#include "cli/typed_parameters.hpp"
#include "numeric/orbits.hpp"
#include "numeric/words/word_orbit.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

// Those in a file. Throws InputOutputError when it cannot be read, and as parse_parameters does.
[[nodiscard]] TypedParameters read_parameters(const std::string& file);

// The question about the family. `typed` replaces what the file says, which replaces the data of the example;
// file and example may be empty. The example's phi or ur counts only for its own family and when neither is
// given otherwise. Throws UsageError for a missing or malformed parameter.
[[nodiscard]] numeric::OrbitQuestion question(const proofs::methods::Paper& paper,
                                              const numeric::Family& family, const TypedParameters& typed,
                                              const std::string& file, const std::string& example,
                                              int digits);

// The machine whose motions are asked for: the same, with ur in any case, that of the example's own orbit to
// 17 digits when none is given, and without phi, for the load is cos(omega t). Throws likewise, also for
// intervals.
[[nodiscard]] numeric::words::WordQuestion machine(const proofs::methods::Paper& paper,
                                                   const TypedParameters& typed, const std::string& file,
                                                   const std::string& example, int digits);

}  // namespace stickslip::cli
