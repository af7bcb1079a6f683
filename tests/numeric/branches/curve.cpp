// Branches as chains of cells: two branches cannot be joined.
#include "numeric/branches/curve.hpp"

#include <doctest/doctest.h>

#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;
using namespace stickslip::numeric::branches::examples;

TEST_CASE("a cell refuses the motion of another branch, however near") {
  const Rational at = parse_rational("0.6");
  const std::vector<Start> all = starts(along(S(), "omega", "0.59", "0.605"), at);
  REQUIRE(all.size() == 4);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Path path = follow(all[i].curve, at, all[i].point, 1);
    REQUIRE(!path.cells.empty());
    CHECK(path.end == End::interval);
    for (std::size_t j = 0; j < all.size(); ++j) {
      for (const Cell& cell : path.cells) {
        if (i != j) {
          CHECK(!is_on(cell, all[j].point));
        }
      }
    }
    // Neighbours meet in a motion that is the only one of both: the proof of the one at their common end lies
    // in the box of the other.
    for (std::size_t k = 0; k + 1 < path.cells.size(); ++k) {
      CHECK(zeros::intersection<Eigen::Dynamic>(path.cells[k].proof.unique, path.cells[k + 1].proof.unique));
    }
  }
}

TEST_CASE("a branch is not followed back where an unknown turns sharply") {
  // Along omega the size of the motions changes its direction at once at 0.3288: by the scalar product of the
  // tangents the branch seemed to turn.
  const Rational at = parse_rational("0.3");
  const std::vector<Start> all = starts(along(S(), "omega", "0.3", "0.9"), at);
  REQUIRE(!all.empty());
  for (const Start& start : all) {
    const Path path = follow(start.curve, at, start.point, 1);
    for (std::size_t k = 0; k + 1 < path.cells.size(); ++k) {
      const Cell &cell = path.cells[k], &next = path.cells[k + 1];
      if (cell.driver == next.driver && cell.in_units == next.in_units) {
        CHECK((cell.first < cell.last) == (next.first < next.last));
      }
    }
  }
}
