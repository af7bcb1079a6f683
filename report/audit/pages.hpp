// The reports: pages for the browser, a paper for print, data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/checks/mutants.hpp"
#include "proofs/methods/motions.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/files.hpp"

namespace stickslip::report::audit {

// The files of one directory, and a sentence about what could not be made; empty if everything was.
struct Report {
  std::vector<tools::File> files;
  std::string note;
};

// The orbits of the examples, and their figures.
struct Figures {
  std::vector<proofs::methods::ExampleOrbits> examples;
  std::vector<tools::File> pictures;
};

// Nothing of an audit is needed for them, and nothing of GiNaC: they may be made on a thread beside one.
// Throws InputOutputError if pictures are to be drawn and gnuplot is missing or fails.
[[nodiscard]] Figures figures_of(const proofs::methods::Paper& paper, bool with_pictures);

// index.html, paper.html, statements.html and, of examples, orbits.html with style.css, katex.css and
// filter.js; audit.json; audit.tex and, where there is TeX, audit.pdf; the
// figures. `command` made it: without one, `stickslip audit`. Throws InputOutputError if a program that draws
// is missing or fails.
[[nodiscard]] Report pages(const Audited& all, const Figures& figures,
                           const std::optional<proofs::checks::Gate>& gate = {},
                           const Certification& certificates = {}, const std::string& command = {});

// The errata of the paper and the hypotheses to be added to it, as a LaTeX document. Throws InputOutputError
// if the template cannot be read.
[[nodiscard]] std::string errata(const Audited& all);

// One result of the audit as a LaTeX theorem with the idea of its proof. Throws InternalError if there is
// none of that id, or if the audit does not have its claims decided.
[[nodiscard]] std::string theorem(const Audited& all, const std::string& id);

// The same kind of report on one list of orbits: index.html with its style sheets, orbits.json, orbits.tex
// and, where there is TeX, orbits.pdf; the figure.
[[nodiscard]] Report pages(const orbits::Listed& listed);

}  // namespace stickslip::report::audit
