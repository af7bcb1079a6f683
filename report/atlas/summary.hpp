// An atlas for readers: in words, as JSON, as a table, as a map.
#pragma once

#include <string>
#include <vector>

#include "numeric/atlas/work.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::atlas {

// The sentences of all reasons that a box of the family may be left open for, by their numbers.
[[nodiscard]] std::vector<std::string> all_reasons(const numeric::families::Family& family);

// How much is decided, and what is found where; for leaves that need not cover the whole.
[[nodiscard]] std::string terminal_report(const numeric::atlas::Question& question,
                                          const std::vector<numeric::atlas::Leaf>& leaves,
                                          const tools::Style& style);

// Volumes are exact fractions of the whole.
[[nodiscard]] tools::Json to_json(const numeric::atlas::Question& question,
                                  const std::vector<numeric::atlas::Leaf>& leaves);

// What came of proving boxes of an atlas again.
struct Verification {
  std::size_t boxes = 0;  // that the atlas has
  std::size_t confirmed = 0, not_decided_again = 0;
  std::vector<numeric::atlas::Leaf> contradicted;

  [[nodiscard]] std::size_t proved_again() const {
    return confirmed + not_decided_again + contradicted.size();
  }
};
[[nodiscard]] std::string terminal_report(const numeric::atlas::Question& question,
                                          const Verification& found);
// With what stands in a contradicted box.
[[nodiscard]] tools::Json to_json(const numeric::atlas::Question& question, const Verification& found,
                                  const std::string& command);
// Of both.
[[nodiscard]] std::vector<tools::File> schemas();

// A row for each leaf: the exact ends of its axes, and what is found.
[[nodiscard]] std::string to_csv(const numeric::atlas::Question& question,
                                 const std::vector<numeric::atlas::Leaf>& leaves);

// For gnuplot, of an atlas with two axes. Throws UsageError for another.
[[nodiscard]] std::string plot_script(const numeric::atlas::Question& question,
                                      const std::vector<numeric::atlas::Leaf>& leaves,
                                      tools::PlotFormat format);

// The boxes as a mesh for ParaView and other readers of VTK's legacy format: lines, rectangles or cuboids in
// the space of the axes (of which x is the first), with orbits, admissible, stable (-1: not known) and the
// number of the reason (0: decided). Throws UsageError for more than three axes.
[[nodiscard]] std::string to_vtk(const numeric::atlas::Question& question,
                                 const std::vector<numeric::atlas::Leaf>& leaves);

}  // namespace stickslip::report::atlas
