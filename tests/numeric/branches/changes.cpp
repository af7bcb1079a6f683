// From parts to pieces and changes: what would be false of a branch, or hide something of it, is not said.
#include "numeric/branches/changes.hpp"

#include <doctest/doctest.h>

#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::branches::examples;

namespace {

Part part(State state, int rises, double from, double to) {
  Part result;
  result.state = state;
  result.rises = rises;
  result.value = Ball::hull(Ball(from), Ball(to));
  result.reason = "for a test";
  return result;
}

struct Described {
  Branch branch;
  std::vector<UnresolvedPart> unresolved;
};

// Of parts by hand, on no cells: a gap that is narrow would need some.
Described described(const std::vector<Part>& parts) {
  const BranchQuestion question = along(S(), "omega", "0.5", "0.6");
  const Curve curve = curve_of(question, starts(question, question.from).front().curve.equations);
  Described result;
  result.branch.last.words = "the end of the path";
  describe({curve, {}, {}, parts}, result.branch, result.unresolved);
  return result;
}

}  // namespace

TEST_CASE("an undecided part where the branch may turn is as wide as it is, and marked") {
  // It may reach 0.54 and come back.
  const Described d = described({part(State::stable, 1, 0.5, 0.52), part(State::undecided, 0, 0.52, 0.54),
                                 part(State::unstable, -1, 0.5, 0.52)});
  REQUIRE(d.branch.pieces.size() == 3);
  CHECK(Ball::hull(d.branch.pieces[2].first, d.branch.pieces[2].last).contains(Ball(0.51)));
  const Piece& open = d.branch.pieces[1];
  CHECK(open.state == State::undecided);
  CHECK(open.may_turn);
  CHECK(Ball::hull(open.first, open.last).contains(Ball(0.53)));
  CHECK(d.branch.changes.empty());
  CHECK(d.unresolved.size() == 1);
}

TEST_CASE("orbits are counted only where no branch may turn, and what is open is said") {
  const auto piece = [](State state, double from, double to, bool may_turn = false) {
    return Piece{state, "", Ball(from), Ball(to), {}, may_turn};
  };
  Branch turning, straight;
  turning.pieces = {piece(State::stable, 0.5, 0.52), piece(State::undecided, 0.52, 0.54, true),
                    piece(State::unstable, 0.54, 0.5)};
  straight.pieces = {piece(State::inadmissible, 0.5, 0.56), piece(State::admissible, 0.56, 0.57),
                     piece(State::undecided, 0.57, 0.58)};
  const std::vector<UnresolvedPart> open{{Ball::hull(Ball(0.58), Ball(0.59)), {}, "for a test"}};
  const std::vector<Count> counts = counts_of(along(S(), "omega", "0.5", "0.6"), {turning, straight}, open);
  const auto at = [&](double value) -> const Count * {
    const auto found = std::find_if(counts.begin(), counts.end(), [&](const Count& count) {
      return Ball::hull(count.from, count.to).contains(Ball(value));
    });
    return found == counts.end() ? nullptr : &*found;
  };
  const auto says = [&](double value, int orbits, int admissible, int stable, int unsettled, int undecided,
                        bool more) {
    CAPTURE(value);
    const Count * count = at(value);
    REQUIRE(count != nullptr);
    CHECK(count->orbits == orbits);
    CHECK(count->admissible == admissible);
    CHECK(count->stable == stable);
    CHECK(count->unsettled == unsettled);
    CHECK(count->undecided == undecided);
    CHECK(count->more == more);
  };
  says(0.51, 3, 2, 1, 0, 0, false);
  CHECK(at(0.53) == nullptr);
  says(0.55, 1, 0, 0, 0, 0, false);
  says(0.565, 1, 1, 0, 1, 0, false);
  says(0.575, 0, 0, 0, 0, 1, false);
  says(0.585, 0, 0, 0, 0, 0, true);
  says(0.595, 0, 0, 0, 0, 0, false);
}

TEST_CASE("where a branch may go on that was followed no further it is not said that there are no orbits") {
  Branch branch;
  branch.pieces = {Piece{State::stable, "", Ball(0.52), Ball(0.57), {}, false}};
  branch.first.kind = End::absent;
  BranchQuestion question = along(S(), "omega", "0.5", "0.6");
  question.at = parse_rational("0.55");
  for (const End end : {End::stopped, End::absent}) {
    branch.last.kind = end;
    const std::vector<Count> counts = counts_of(question, {branch}, {});
    REQUIRE(counts.size() == 3);
    for (const Count& count : counts) {
      CHECK(count.more == (end == End::stopped));
    }
  }
}

TEST_CASE("a motion in the first and in the last part of a closed branch is not counted twice") {
  Branch branch;
  branch.pieces = {Piece{State::stable, "", Ball(0.52), Ball(0.57), {}, false},
                   Piece{State::unstable, "", Ball(0.57), Ball(0.51), {}, false},
                   Piece{State::stable, "", Ball(0.51), Ball(0.53), {}, false}};
  const auto most = [&branch] {
    int orbits = 0;
    for (const Count& count : counts_of(along(S(), "omega", "0.5", "0.6"), {branch}, {})) {
      orbits = std::max(orbits, count.orbits);
    }
    return orbits;
  };
  CHECK(most() == 3);
  branch.closed = true;
  CHECK(most() == 2);
}

TEST_CASE("a long decided part between two short undecided ones stays decided") {
  const Described d =
      described({part(State::stable, 1, 0.5, 0.51), part(State::undecided, 1, 0.51, 0.5101),
                 part(State::unstable, 1, 0.5101, 0.53), part(State::undecided, 1, 0.53, 0.5301),
                 part(State::stable, 1, 0.5301, 0.6)});
  REQUIRE(d.branch.pieces.size() == 5);
  CHECK(d.branch.pieces[2].state == State::unstable);
  CHECK(!d.branch.pieces[1].may_turn);
  CHECK(d.unresolved.size() == 2);
}

TEST_CASE("beside a resonance the motions are undecided, not gone") {
  const double omega1 = model::modes<double>(0.5, 3.8).omega1;
  const Described d = described({part(State::stable, 1, 0.6, omega1 - 1e-5),
                                 part(State::undecided, 1, omega1 - 1e-5, omega1 + 1e-5),
                                 part(State::stable, 1, omega1 + 1e-5, 0.62)});
  REQUIRE(d.branch.changes.size() == 1);
  CHECK(d.branch.changes.front().kind == ChangeKind::resonance);
  CHECK(d.branch.changes.front().verdict.truth == Truth::undecided);
  REQUIRE(d.branch.pieces.size() == 3);
  CHECK(d.branch.pieces[1].state == State::undecided);
}

TEST_CASE("a change of stability is proved only where one exit function alone may vanish") {
  const Ball at(0.5);
  const auto proved = [&](const Crossings& crossings) {
    const std::vector<Change> changes = stability_changes(crossings, true, at);
    return std::count_if(changes.begin(), changes.end(),
                         [](const Change& c) { return c.verdict.truth == Truth::proved; });
  };
  CHECK(proved({{Exit::minus_one}, {Exit::minus_one, Exit::pair}}) == 1);
  CHECK(proved({{Exit::minus_one}, {Exit::pair}}) == 0);
  // That of a pair may be the one that vanishes, whether its members are complex or not.
  CHECK(proved({{Exit::plus_one, Exit::pair}, {Exit::plus_one, Exit::minus_one, Exit::pair}}) == 0);
  CHECK(stability_changes({{Exit::pair}, {}}, false, at).front().what == "complex pair");
  CHECK(stability_changes({{Exit::pair}, {}}, false, at).front().words == "stability is gained");
}
