
#include <fmt/format.h>

#include <algorithm>

#include "numeric/families/family.hpp"
#include "report/orbits/branches/branches.hpp"
#include "report/orbits/page.hpp"

namespace stickslip::report::orbits {

using namespace numeric::branches;
using namespace tools;

namespace {

// Whether of all its orbits the state is known, and of each change that it happens there once.
bool is_decided(const Branch& branch) {
  return branch.first.resolved() && branch.last.resolved() &&
         std::ranges::none_of(branch.pieces,
                              [](const Piece& piece) {
                                return piece.state == State::undecided || piece.state == State::admissible;
                              }) &&
         std::ranges::all_of(branch.changes,
                             [](const Change& change) { return change.verdict.truth == Truth::proved; });
}

Json branch_data(const Branch& branch, const BranchQuestion& q, std::size_t number) {
  const BranchRows told = rows_of(branch, q);
  const bool decided = is_decided(branch);
  Json data = {{"number", number},
               {"tone", decided ? "proved" : "undecided"},
               {"tell", decided ? "everything on it proved" : "undecided in part"},
               {"heading", told.heading},
               {"pieces", cells(told.pieces, {"from", "to", "state"})},
               {"changes", cells(told.changes, {"at", "words", "verdict"})}};
  for (std::size_t k = 0; k < branch.changes.size(); ++k) {
    data["changes"][k]["tone"] = to_string(branch.changes[k].verdict.truth);
  }
  return data;
}

}  // namespace

std::vector<File> pages(const BranchList& list, const PageFrame& frame) {
  const BranchQuestion& q = list.question;
  Json data = page_data(
      frame, "Branches along " + q.parameter, command_of(q),
      fmt::format("motions that close are followed and their conditions decided in balls, "
                  "changes but resonances enclosed to {}; the diagram and the table of orbits are drawn "
                  "from values in floating point",
                  resolution));
  const std::vector<Row> facts = rows_of(list);
  data["tables"].push_back(table("question", "Question", facts));
  data["family"] = q.orbits.family->title;
  data["parameter"] = parameter_of(q);
  data["picture_in_words"] =
      fmt::format("x2 where the first phase begins against {}: {}. The tables below say the same.",
                  parameter_of(q), facts.back()[1].text);
  data["branches"] = Json::array();
  data["at_values"] = false;
  data["what_is_drawn"] = "$x2$ where the first phase begins, of an orbit of each part of the proof";
  for (const Branch& branch : list.branches) {
    data["branches"].push_back(branch_data(branch, q, data["branches"].size() + 1));
  }
  data["counts"] = cells(count_rows(list), {"from", "to", "orbits", "admissible", "stable"});
  data["unresolved"] = rows_data(unresolved_rows(list));
  std::vector<File> files = pictures(
      [&](PlotFormat format, PlotShape shape) { return plot_script(list, format, shape); }, "branches");
  data["picture"] = !files.empty();
  files.push_back({"branches.csv", to_csv(list)});
  files.push_back(json_file("branches.json", to_json(list), frame));
  return with_page("branches.html", data, std::move(files));
}

}  // namespace stickslip::report::orbits
