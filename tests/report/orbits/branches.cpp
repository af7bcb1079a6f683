// Branches as JSON: how each ends; the rows that terminal and page share.
#include "report/orbits/branches/branches.hpp"

#include <doctest/doctest.h>

#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

using namespace stickslip;
using namespace stickslip::numeric::branches;
using namespace stickslip::report::orbits;
using report::tools::Json;

namespace {

BranchList ending(End first, End last) {
  BranchList list;
  list.question = {proofs::methods::question_of(proofs::pascal2012::example_named("S")),
                   "omega",
                   Rational(1, 2),
                   Rational(3, 5),
                   {}};
  Branch branch;
  branch.first = {Ball(Rational(1, 2)), "begins", first};
  branch.last = {Ball(Rational(3, 5)), "ends", last};
  list.branches.push_back(branch);
  return list;
}

}  // namespace

TEST_CASE("the JSON of a branch says of each end what it is, and only where it stopped that it may go on") {
  for (const auto& [end, kind] : {std::pair(End::interval, "interval"), std::pair(End::absent, "birth"),
                                  std::pair(End::closed, "closed"), std::pair(End::infinite, "infinity"),
                                  std::pair(End::stopped, "stopped")}) {
    const Json ends = to_json(ending(End::interval, end)).at("branches").at(0).at("ends");
    CHECK(ends.at(0).at("kind") == "interval");
    CHECK(ends.at(1).at("kind") == kind);
    CHECK(ends.at(1).at("resolved") == (end != End::stopped));
    CHECK(ends.at(1).at("reason") == "ends");
  }
}

TEST_CASE("a change that is not proved bears its reason where another is called proved") {
  const BranchList list = ending(End::interval, End::interval);
  Branch branch = list.branches.front();
  branch.changes.push_back({ChangeKind::fold, "", "turns", Ball(1), {}, Verdict::proved()});
  branch.changes.push_back({ChangeKind::fold, "", "turns", Ball(1), {}, Verdict::undecided("too near")});
  const BranchRows rows = rows_of(branch, list.question);
  REQUIRE(rows.changes.size() == 2);
  CHECK(rows.changes[0].back().text == "proved");
  CHECK(rows.changes[1].back().text == "too near");
}
