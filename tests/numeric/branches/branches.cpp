// Branches over one parameter: what they say beside each change is what the complete list of orbits says
// there, and what would be false is refused.
#include "numeric/branches/branches.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "numeric/branches/crossing.hpp"
#include "numeric/branches/search.hpp"
#include "numeric/branches/setting.hpp"
#include "numeric/families/family.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;

namespace {

OrbitQuestion data(const char * family, const std::array<const char *, 6>& values) {
  const auto range = [&](std::size_t k) { return Range{parse_rational(values[k])}; };
  return {&family_named(family), {range(0), range(1), range(2), range(3), range(4), range(5)}, {}, {}, 20};
}
OrbitQuestion S() {
  return data("symmetric", {"0.5", "3.8", "0.02", "1", "0.6", "0.05"});
}
OrbitQuestion O() {
  OrbitQuestion q = data("overshooting", {"0.2", "4", "0.05", "1", "0.6289", "0.05"});
  q.phi = Range{0};
  return q;
}
OrbitQuestion P() {
  return data("nonsticking", {"0.3", "4", "0.1", "0.1", "0.6", "1"});
}

BranchQuestion along(OrbitQuestion orbits, const char * parameter, const char * from, const char * to) {
  return {std::move(orbits), parameter, parse_rational(from), parse_rational(to), {}};
}

// The list of orbits with the parameter, omega or p, at that value.
OrbitList at(const BranchQuestion& question, const Rational& value) {
  OrbitQuestion q = question.orbits;
  (question.parameter == "omega" ? q.parameters.omega : q.parameters.p) = {value};
  return list_orbits(q);
}

Rational exact(const Ball& x) {
  return Rational(x.approximate());
}

struct Numbers {
  int orbits = 0, admissible = 0, stable = 0;
  friend bool operator==(const Numbers&, const Numbers&) = default;
};
Numbers numbers(const OrbitList& list) {
  Numbers n;
  for (const Orbit& orbit : list.orbits) {
    ++n.orbits;
    n.admissible += orbit.admissible.truth == Truth::proved ? 1 : 0;
    n.stable += orbit.stability && orbit.stability->kind == motion::StabilityKind::stable ? 1 : 0;
  }
  return n;
}

// What the branches say of the value; nothing when it is too near an end of what they say.
std::optional<Numbers> numbers(const BranchList& list, const Rational& value) {
  for (const Count& count : list.counts) {
    if ((Ball(value) - count.from).is_positive() && (count.to - Ball(value)).is_positive()) {
      return Numbers{count.orbits, count.admissible, count.stable};
    }
  }
  return std::nullopt;
}

// On both sides of each change, at a distance of 1e-9, the complete list has as many orbits, admissible and
// stable ones as the branches. Returns how many sides were looked at.
int check_sides(const BranchList& list) {
  int sides = 0;
  for (const Branch& branch : list.branches) {
    for (const Change& change : branch.changes) {
      if (change.kind == ChangeKind::resonance) {
        continue;
      }
      CAPTURE(to_string(change.kind) + " " + change.what + " at " + to_string(change.at, 14));
      CHECK(change.verdict.truth == Truth::proved);
      CHECK((change.at.radius() - Ball(1e-10)).is_negative());
      for (const double distance : {-1e-9, 1e-9}) {
        const Rational value = exact(change.at) + Rational(distance);
        const std::optional<Numbers> said = numbers(list, value);
        if (said && value > list.question.from && value < list.question.to) {
          const OrbitList orbits = at(list.question, value);
          CHECK(orbits.complete());
          CHECK(numbers(orbits) == *said);
          ++sides;
        }
      }
    }
  }
  return sides;
}

std::vector<Change> changes_of(const BranchList& list, ChangeKind kind) {
  std::vector<Change> found;
  for (const Branch& branch : list.branches) {
    std::copy_if(branch.changes.begin(), branch.changes.end(), std::back_inserter(found),
                 [&](const Change& change) { return change.kind == kind; });
  }
  return found;
}

}  // namespace

TEST_CASE("symmetric orbits over omega: a fold, a birth and a loss of stability, as the lists beside them") {
  const BranchList list = list_branches(along(S(), "omega", "0.58", "0.61"));
  CHECK(list.resolved());
  CHECK(list.complete);
  CHECK(changes_of(list, ChangeKind::fold).size() == 1);
  CHECK(changes_of(list, ChangeKind::birth).size() == 1);
  const std::vector<Change> stability = changes_of(list, ChangeKind::stability);
  REQUIRE(stability.size() == 1);
  CHECK(stability.front().what == "real -1");
  CHECK(check_sides(list) == 6);
  // The same at values that are none of those at which the search looked.
  for (const char * value : {"0.5801", "0.5907", "0.6001", "0.6087"}) {
    const std::optional<Numbers> said = numbers(list, parse_rational(value));
    REQUIRE(said);
    CHECK(*said == numbers(at(list.question, parse_rational(value))));
  }
}

TEST_CASE("orbits that never stick over p: folds of both kinds and conditions gained") {
  const BranchList list = list_branches(along(P(), "p", "0.4", "1"));
  CHECK(list.resolved());
  CHECK(list.complete);
  CHECK(changes_of(list, ChangeKind::fold).size() == 4);
  CHECK(check_sides(list) >= 8);
}

TEST_CASE("the branch of O loses condition 18 where the lists say so") {
  BranchQuestion question = along(O(), "omega", "0.63", "0.632");
  question.at = parse_rational("0.6305");
  const BranchList list = list_branches(question);
  CHECK(list.resolved());
  const std::vector<Change> lost = changes_of(list, ChangeKind::condition);
  REQUIRE(lost.size() == 1);
  CHECK(lost.front().what == "18");
  CHECK(check_sides(list) == 2);
}

TEST_CASE("over a natural frequency the interval is split, and the branch goes on") {
  const BranchList list = list_branches(along(S(), "omega", "0.612", "0.616"));
  const std::vector<Change> resonances = changes_of(list, ChangeKind::resonance);
  REQUIRE(!resonances.empty());
  for (const Change& change : resonances) {
    CHECK(change.what == "omega1");
    CHECK(change.verdict.truth == Truth::undecided);
    CHECK(change.at.contains(exact(model::modes<Ball>(Ball(0.5), Ball(parse_rational("3.8"))).omega1)));
  }
}

TEST_CASE("pieces, changes and unresolved parts leave no gap on a branch") {
  for (const BranchQuestion& question : {along(S(), "omega", "0.6", "0.607"),
                                         along(S(), "us", "0.01", "0.05"), along(P(), "p", "0.5", "0.7")}) {
    const BranchList list = list_branches(question);
    for (const Branch& branch : list.branches) {
      for (std::size_t k = 0; k + 1 < branch.pieces.size(); ++k) {
        const Ball end = branch.pieces[k].last, begin = branch.pieces[k + 1].first;
        const Ball gap = Ball::hull(end, begin);
        const auto fills = [&](const Ball& at) { return at.contains(end) && at.contains(begin); };
        const bool by_change = std::any_of(branch.changes.begin(), branch.changes.end(),
                                           [&](const Change& c) { return fills(c.at); });
        const bool open = std::any_of(list.unresolved.begin(), list.unresolved.end(),
                                      [&](const UnresolvedPart& part) { return fills(part.value); });
        CAPTURE(to_string(gap));
        CHECK((by_change || open));
      }
    }
  }
}

TEST_CASE("a question that is none is refused in words") {
  CHECK_THROWS_AS((void)list_branches(along(S(), "omega", "0.6", "0.5")), UsageError);
  CHECK_THROWS_AS((void)list_branches(along(S(), "omega", "0.5", "0.5")), UsageError);
  CHECK_THROWS_AS((void)list_branches(along(S(), "mass", "0.5", "0.6")), UsageError);
  CHECK_THROWS_AS((void)list_branches(along(S(), "ur", "0.5", "0.6")), UsageError);
  CHECK_THROWS_AS((void)list_branches(along(S(), "chi", "0.5", "1")), DomainError);
  CHECK_THROWS_AS((void)list_branches(along(S(), "V", "0", "1")), DomainError);
  BranchQuestion outside = along(S(), "omega", "0.5", "0.6");
  outside.at = Rational(1);
  CHECK_THROWS_AS((void)list_branches(outside), UsageError);
  BranchQuestion box = along(S(), "omega", "0.5", "0.6");
  box.orbits.parameters.chi.radius = Rational(1, 100);
  CHECK_THROWS_AS((void)list_branches(box), UsageError);
}

TEST_CASE("a cell refuses the motion of another branch, however near") {
  const OrbitQuestion q = S();
  const families::Found found =
      q.family->search({{Rational(1, 2), parse_rational("3.8"), parse_rational("0.02"), 1,
                         parse_rational("0.6"), parse_rational("0.05")},
                        {},
                        {}});
  std::vector<Curve> curves;
  std::vector<Point> points;
  for (const families::Candidate& candidate : found.candidates) {
    const motion::Given<Ball> given{{Ball(0.5), Ball(parse_rational("3.8")), Ball(parse_rational("0.02")),
                                     Ball(1), Ball(parse_rational("0.6")), Ball(parse_rational("0.05"))},
                                    {},
                                    {}};
    curves.push_back({candidate.equations, candidate.equations.parameters(given), 4, parse_rational("0.59"),
                      parse_rational("0.605")});
    const ProvedPoint point =
        prove_at(curves.back(), parse_rational("0.6"), candidate.equations.unknowns(candidate.guess));
    REQUIRE(point.verdict.truth == Truth::proved);
    points.push_back(point.point);
  }
  REQUIRE(points.size() == 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Path path = follow(curves[i], parse_rational("0.6"), points[i], 1);
    REQUIRE(!path.cells.empty());
    CHECK(path.end == End::interval);
    for (std::size_t j = 0; j < points.size(); ++j) {
      for (const Cell& cell : path.cells) {
        if (i != j) {
          CHECK(!is_on(cell, points[j]));
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

TEST_CASE("a quantity that may turn, or stand still, is not said to cross") {
  using zeros::ParameterJet;
  motion::MotionOf<ParameterJet> m;
  const motion::Requirement slipping{"us", "", motion::Quantity::slipping_friction};
  const Ball around_zero = Ball::hull(Ball(-1e-3), Ball(1e-3));
  const auto trend = [&](const Ball& value, const Ball& slope) {
    m.oscillator.data.us = ParameterJet(value);
    m.oscillator.data.us.partials = {slope};
    return trend_of(slipping, m, {});
  };
  CHECK(trend(around_zero, Ball(1)) == Trend::rising);
  CHECK(trend(around_zero, Ball(-1)) == Trend::falling);
  CHECK(trend(around_zero, around_zero) == Trend::unknown);
  CHECK(trend(around_zero, Ball(0)) == Trend::unknown);
  CHECK(trend(Ball(1), around_zero) == Trend::above);
}

TEST_CASE("the exit functions vanish exactly at their multipliers") {
  // (x - 2)(x - 3)(x - 5), and that with x - 7, the leading coefficient first 4, then 1.
  const std::vector<Ball> three{Ball(-120), Ball(124), Ball(-40), Ball(4)};
  const std::vector<Ball> four{Ball(210), Ball(-247), Ball(101), Ball(-17), Ball(1)};
  const auto is = [](const Ball& x, int value) {
    return (x - Ball(value)).contains_zero() && (x.radius() - Ball(1e-20)).is_negative();
  };
  CHECK(is(exit_function(Exit::plus_one, three), 4 * (1 - 2) * (1 - 3) * (1 - 5)));
  CHECK(is(exit_function(Exit::minus_one, three), 4 * (1 + 2) * (1 + 3) * (1 + 5)));
  CHECK(is(exit_function(Exit::pair, three), 16 * (1 - 6) * (1 - 10) * (1 - 15)));
  CHECK(is(exit_function(Exit::plus_one, four), (1 - 2) * (1 - 3) * (1 - 5) * (1 - 7)));
  CHECK(is(exit_function(Exit::minus_one, four), (1 + 2) * (1 + 3) * (1 + 5) * (1 + 7)));
  CHECK(is(exit_function(Exit::pair, four), (1 - 6) * (1 - 10) * (1 - 15) * (1 - 14) * (1 - 21) * (1 - 35)));
}

TEST_CASE("every orbit at any value is on a branch, and leaving out a branch is noticed") {
  // No branch that begins between the ends of the interval is met at them.
  const BranchQuestion question = along(S(), "omega", "0.58", "0.61");
  const AllFollowed all = follow_all(question);
  CHECK(all.complete);
  CHECK(all.unresolved.empty());
  const families::StripQuestion strip = strip_question(question);
  for (const families::Strip& one : question.orbits.family->strips(strip)) {
    const auto sheet = std::find_if(all.sheets.begin(), all.sheets.end(),
                                    [&](const Sheet& s) { return s.system == one.system; });
    REQUIRE(sheet != all.sheets.end());
    // The strip around each orbit of the list at a value, between the branches' own cells.
    for (const char * text : {"0.5907", "0.60628", "0.6072"}) {
      const Rational value = parse_rational(text);
      const OrbitList list = at(question, value);
      for (const Orbit& orbit : list.orbits) {
        const motion::Phase& slip = orbit.motion.phases[0];
        const Ball u = slip.duration / motion::period(orbit.motion);
        const Ball share = Ball(Rational((value - question.from) / (question.to - question.from))) *
                           Ball(families::length_of(strip));
        const Ball little = Ball::hull(Ball(-1e-9), Ball(1e-9));
        families::StripBox box;
        box << u.midpoint() + little, Ball(0), share.midpoint() + little;
        const std::optional<families::Strip::View> view = one.look(box);
        const bool first = (orbit.motion.phases[0].load - Ball(2)).is_negative();
        if (first != (one.system == 0)) {
          continue;  // it is an orbit at the other phase of the load
        }
        REQUIRE(view);  // an orbit is not excluded
        int holding = 0;
        for (const Followed& branch : sheet->branches) {
          holding += branch.tubes.hold(view->x, view->parameter) ? 1 : 0;
        }
        CHECK(holding == 1);
      }
    }
  }
}

TEST_CASE("a tube holds nothing that reaches beyond it") {
  const AllFollowed all = follow_all(along(S(), "omega", "0.595", "0.6"));
  for (const Sheet& sheet : all.sheets) {
    for (const Followed& branch : sheet.branches) {
      const Cell& cell = branch.cells[branch.cells.size() / 2];
      std::vector<families::Bounds> x;
      for (const Ball& side : cell.proof.at_middle) {
        x.push_back(scalars::ends(side));
      }
      const double value = cell.range.approximate();
      const families::Bounds here{value, value};
      CHECK(branch.tubes.hold(x, here));
      CHECK(!branch.tubes.hold({}, here));
      CHECK(!branch.tubes.hold(x, {value, 0.7}));
      for (std::size_t i = 0; i < x.size(); ++i) {
        std::vector<families::Bounds> wide = x;
        wide[i].second += 10;
        CHECK(!branch.tubes.hold(wide, here));
        wide[i] = {x[i].first, HUGE_VAL};
        CHECK(!branch.tubes.hold(wide, here));
      }
    }
  }
}

TEST_CASE("a branch listed twice is not taken for two") {
  const BranchQuestion question = along(S(), "omega", "0.595", "0.6");
  const AllFollowed all = follow_all(question);
  CHECK(all.complete);
  for (const Sheet& sheet : all.sheets) {
    for (const Followed& one : sheet.branches) {
      for (const Followed& other : sheet.branches) {
        const bool same = &one == &other;
        const bool meets = std::any_of(other.cells.begin(), other.cells.end(),
                                       [&](const Cell& cell) { return may_meet(cell, one.ends[0]); });
        CHECK(meets == same);
      }
    }
  }
}

TEST_CASE(
    "where a branch at a given load phase turns, the map between starts at that phase has a fixed "
    "direction") {
  // At 0.618247176 two orbits meet.
  const BranchQuestion question = along(O(), "omega", "0.6182", "0.6183");
  const OrbitList orbits = at(question, parse_rational("0.6182473"));
  REQUIRE(orbits.orbits.size() == 2);
  const Ball a = turn_at_given_phase<Ball>(orbits.orbits[0].motion);
  const Ball b = turn_at_given_phase<Ball>(orbits.orbits[1].motion);
  CHECK((a * b).is_negative());
}
