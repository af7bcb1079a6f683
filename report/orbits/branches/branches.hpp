// Branches of orbits, for readers, for programs and as a bifurcation diagram.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "numeric/branches/branches.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/page.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// The question, then each branch with its pieces and the changes between them, then how many orbits there
// are between changes.
[[nodiscard]] std::string terminal_report(const numeric::branches::BranchList& list,
                                          const tools::Style& style);

// Names, then a line for an orbit of each part of each branch, in the middle of the part: the parameter,
// branch and piece (1, 2, …), state, the durations of the phases, phi, x10, x20, xdot10; with 17 digits.
[[nodiscard]] std::string to_csv(const numeric::branches::BranchList& list);

// What these and the page are made of, rows of cells. Of a branch: how it begins and ends; from, to and state
// of each piece; place, name and verdict, or its reason, of each change. For machines of any number of masses
// (report/machines/rows.hpp), too.
struct BranchRows {
  std::string heading;
  std::vector<tools::Row> pieces, changes;
};
[[nodiscard]] BranchRows rows_of(const numeric::branches::Branch& branch,
                                 const numeric::branches::BranchQuestion& question);
// The question and its result, a label and a sentence each; what is unresolved, where and why; from, to, and
// how many orbits there are between, how many admissible and stable.
[[nodiscard]] std::vector<tools::Row> rows_of(const numeric::branches::BranchList& list);
[[nodiscard]] std::vector<tools::Row> unresolved_rows(const numeric::branches::BranchList& list);
[[nodiscard]] std::vector<tools::Row> count_rows(const numeric::branches::BranchList& list);

// An orbit of a part of a branch, which is on a piece (1, 2, ...): how long its phases last, by their names,
// and its start, as the paper names it: all in SI units along a value of a machine, else dimensionless.
struct OrbitOfBranch {
  std::size_t piece = 1;
  numeric::branches::State state = numeric::branches::State::undecided;
  double value = 0;
  Named<double> durations = {};
  double phi = 0, x10 = 0, x20 = 0, xdot10 = 0;
};
[[nodiscard]] std::vector<OrbitOfBranch> orbits_of(const numeric::branches::Branch& branch,
                                                   const numeric::branches::BranchQuestion& question);
// The same of where in the motion something changes, and of where there may be orbits.
[[nodiscard]] std::optional<Ball> time_of(const numeric::branches::BranchQuestion& question,
                                          const numeric::branches::Change& change);
[[nodiscard]] std::vector<numeric::NamedBall> where(const numeric::branches::BranchQuestion& question,
                                                    const numeric::branches::UnresolvedPart& part);

// What stays, by its name: a number or, of a machine, the interval in which it follows what varies.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> parameters_of(
    const numeric::branches::BranchQuestion& question);
// What varies: "omega", "load_frequency in Hz".
[[nodiscard]] std::string parameter_of(const numeric::branches::BranchQuestion& question);

[[nodiscard]] tools::Json to_json(const numeric::branches::BranchList& list);
[[nodiscard]] tools::File branches_schema();

// A script for gnuplot: x2 where the first phase begins against the parameter, stable, unstable,
// inadmissible and unsettled pieces by their strokes, changes by their marks. Empty when there is nothing to
// draw.
[[nodiscard]] std::string plot_script(const numeric::branches::BranchList& list, tools::PlotFormat format,
                                      tools::PlotShape shape = tools::PlotShape::wide);

// A bifurcation diagram from its points.
class BranchCurves {
 public:
  // A branch begins; a point of the curve, in the order of the branch; the curve ends here.
  void begin();
  void add(numeric::branches::State state, double parameter, double x);
  void end();
  // Where something changes: at the point of the branch that is nearest, if it has any.
  void mark(numeric::branches::ChangeKind kind, double parameter);

  struct Labels {
    std::string orbits;     // whose branches they are
    std::string parameter;  // of the axes
    std::string x;
    std::string parameters;  // that stay
    double from, to;
  };
  // Empty when there is nothing to draw.
  [[nodiscard]] std::string script(const Labels& labels, tools::PlotFormat format,
                                   tools::PlotShape shape) const;

 private:
  std::array<std::string, 4> curves_;
  std::array<std::string, 5> marks_;
  std::vector<std::pair<double, double>> points_;  // of the branch
  int now_ = -1;
};

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::branches::BranchQuestion& question);

// Branches of orbits as a page for the browser, with the bifurcation diagram.

// The files of one directory: index.html with its style sheets, branches.json and branches.csv, and the
// diagram if there is something to draw, as branches.svg, branches-narrow.svg and branches.pdf. Throws
// InputOutputError if a program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> pages(const numeric::branches::BranchList& list,
                                             const PageFrame& frame = {});

}  // namespace stickslip::report::orbits
