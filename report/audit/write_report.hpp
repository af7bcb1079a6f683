// The report on the audit of a paper, any paper: for programs outside.
#pragma once

#include <filesystem>
#include <string>

#include "proofs/methods/paper.hpp"

namespace stickslip::report::audit {

// Writes what `stickslip audit --out` writes into the directory, which is created if only its last component
// is missing: index.html, paper.html, statements.html and what these need; audit.json; audit.tex and, where
// there is TeX, audit.pdf; of a paper with examples the orbits at their data, listed anew, in orbits.html.
// `command` is what the report says that it was made by. Returns a sentence about what could not be made;
// empty if everything was. Throws InputOutputError if the directory cannot be written to, or if KaTeX,
// gnuplot is missing or fails; then nothing is half-written.
std::string write_report(const proofs::methods::Paper& paper, const proofs::methods::Audit& audit,
                         const std::filesystem::path& directory, const std::string& command);

}  // namespace stickslip::report::audit
