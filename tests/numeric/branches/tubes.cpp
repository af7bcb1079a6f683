// The tubes around branches, which are left out of the search for more: what would hide an orbit that is on
// no branch is refused.

#include <doctest/doctest.h>

#include "numeric/branches/law.hpp"
#include "numeric/branches/search.hpp"
#include "numeric/families/through_phases/one_stick_reduced.hpp"
#include "numeric/orbits.hpp"
#include "numeric/words/complete_list.hpp"
#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;
using namespace stickslip::numeric::branches::examples;

namespace {

std::vector<families::Bounds> bounds(const zeros::Vector& x) {
  std::vector<families::Bounds> all;
  for (const Ball& side : x) {
    all.push_back(scalars::ends(side));
  }
  return all;
}

// Whether the tubes hold the motion of the cell at that value of the parameter, which drives it.
bool hold_motion(const Tubes& tubes, const Curve& curve, const Cell& cell, const Rational& value) {
  const ProvedPoint point = prove_at(curve, value, cell.proof.at_middle);
  REQUIRE(point.verdict.truth == Truth::proved);
  REQUIRE(is_on(cell, point.point));
  return tubes.hold(bounds(point.point.x), scalars::ends(Ball(value)));
}

// The equations of ST over the share of its slip and an interval of ur.
struct StripOfST {
  template <class T, class S>
  [[nodiscard]] families::Reduced<T> operator()(const motion::Given<T>& given, const T& share,
                                                const T& /*none*/) const {
    return families::reduced_at_friction<1, T, S>(
        {model::reduced_data<T>(given.data, T(scalars::pi<S>())), *given.ur}, Eigen::Matrix<T, 1, 1>(share));
  }
};

}  // namespace

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
      OrbitQuestion orbits_at = question.orbits;
      orbits_at.parameters.omega = {value};
      const OrbitList list = list_orbits(orbits_at);
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

TEST_CASE("a box of a strip with an orbit is not left out, however wide it is") {
  // Overshooting orbits at a given ur: of a box what its rows say of the load's phase is looked at, too.
  OrbitQuestion data = examples::data("overshooting", {"0.2", "4", "0.05", "1", "0.63", "0.05"});
  data.ur = Range{parse_rational("0.4585")};
  const BranchQuestion question = along(data, "omega", "0.62", "0.64");
  const families::StripQuestion strip = strip_question(question);
  int orbits = 0;
  for (const families::Strip& one : data.family->strips(strip)) {
    for (const char * text : {"0.627", "0.63", "0.635"}) {
      const Rational value = parse_rational(text);
      data.parameters.omega = {value};
      for (const Orbit& orbit : list_orbits(data).orbits) {
        ++orbits;
        const std::vector<motion::Phase>& phases = orbit.motion.phases;
        const Ball slips = phases[0].duration + phases[1].duration;
        const Ball share = Ball(Rational((value - question.from) / (question.to - question.from))) *
                           Ball(families::length_of(strip));
        for (const double radius : {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 3e-2}) {
          CAPTURE(radius);
          const Ball around = Ball::hull(Ball(-radius), Ball(radius));
          families::StripBox box;
          box << slips / motion::period(orbit.motion) + around, phases[1].duration / slips + around,
              share + around;
          const std::optional<families::Strip::View> view = one.look(box);
          REQUIRE(view);
          CHECK(view->rest(0).overlaps(slips / motion::period(orbit.motion)));
          CHECK(view->rest(1).overlaps(phases[1].duration / slips));
        }
      }
    }
  }
  CHECK(orbits >= 6);
}

TEST_CASE("a tube holds nothing that reaches beyond it") {
  const AllFollowed all = follow_all(along(S(), "omega", "0.595", "0.6"));
  for (const Sheet& sheet : all.sheets) {
    for (const Followed& branch : sheet.branches) {
      const Cell& cell = branch.cells[branch.cells.size() / 2];
      const std::vector<families::Bounds> x = bounds(cell.proof.at_middle);
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

TEST_CASE("where a branch stops its tubes stop, however short its last cell is") {
  const BranchQuestion question = along(S(), "omega", "0.59", "0.605");
  const Rational at = parse_rational("0.6");
  for (const Start& start : starts(question, at)) {
    for (const int direction : {1, -1}) {
      const Path path = follow(start.curve, at, start.point, direction);
      REQUIRE(path.cells.size() >= 3);
      // As if the third cell had been followed for a thousandth of its length and no further.
      std::vector<Cell> cells(path.cells.begin(), path.cells.begin() + 3);
      const Cell whole = cells[2];
      REQUIRE(whole.driver == by_parameter);
      Cell& last = cells[2];
      last.last = whole.first + (whole.last - whole.first) / 1000;
      last.range = between(last.first, last.last);
      last.proof = proof_on(start.curve, whole, last.first, last.last);
      REQUIRE(last.proof.verdict.truth == Truth::proved);
      const auto along_whole = [&](int percent) {
        return Rational(whole.first + (whole.last - whole.first) * percent / 100);
      };
      for (const bool turned_round : {false, true}) {
        const Tubes tubes(start.curve, turned_round ? reversed(cells) : cells);
        CHECK(hold_motion(tubes, start.curve, cells[1], (cells[1].first + cells[1].last) / 2));
        // The cells' common ends are held, too.
        CHECK(hold_motion(tubes, start.curve, cells[1], cells[1].first));
        CHECK(hold_motion(tubes, start.curve, cells[1], cells[1].last));
        for (const int percent : {1, 5, 20}) {
          CHECK(!hold_motion(tubes, start.curve, whole, along_whole(percent)));
        }
      }
    }
  }
}

TEST_CASE("tubes in the units of large motions hold these, and nothing at the other side of infinity") {
  BranchQuestion question = along(O(), "omega", "0.6182485", "0.619");
  question.at = parse_rational("0.6185");
  int looked = 0;
  for (const Sheet& sheet : follow_all(question).sheets) {
    for (const Followed& branch : sheet.branches) {
      const Tubes tubes(sheet.curve, branch.cells);
      for (const Cell& cell : branch.cells) {
        if (!cell.in_units) {
          continue;
        }
        ++looked;
        const Units& units = *cell.in_units->units;
        const auto place = static_cast<std::size_t>(units.place);
        std::vector<families::Bounds> x = bounds(cell.proof.at_middle);
        const families::Bounds parameter = x[place];
        x[place] = scalars::ends(cell.proof.p0(0));
        CHECK(tubes.hold(units, x, parameter));
        CHECK(!tubes.hold(x, parameter));
        CHECK(!tubes.hold(Units{units.place, -units.sign, units.growing}, x, parameter));
        CHECK(!tubes.hold(Units{units.place, units.sign, {}}, x, parameter));
        std::vector<families::Bounds> beyond = x;
        beyond[place].first = -1e-3;
        CHECK(!tubes.hold(units, beyond, parameter));
        beyond = x;
        beyond[place].second += 1;
        CHECK(!tubes.hold(units, beyond, parameter));
      }
    }
  }
  CHECK(looked >= 1);
}

TEST_CASE("a strip of ST keeps each orbit with bounds around it, and leaves out most of the rest") {
  // Each at the middle of the interval.
  const motion::ExactParameters a = motion::parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "0.05");
  const Rational ur = parse_rational("0.16");
  const families::StripQuestion q{{a, {}, ur}, 7, ur - Rational(1, 1000), ur + Rational(1, 1000)};
  const families::Strip strip = families::strip_of(q, 0, 4, {{0, 0, 0}, {1, 0, 1}}, StripOfST{});
  const words::WordList list = words::all_orbits({a, ur, 20}, words::Word::parse("ST"), 1);
  REQUIRE(list.unresolved.empty());
  REQUIRE(!list.orbits.empty());
  constexpr int count = 512;
  int left = 0;
  std::size_t held = 0;
  for (int k = 0; k < count; ++k) {
    const Ball share = Ball::hull(Ball(Rational(k, count)), Ball(Rational(k + 1, count)));
    families::StripBox box;
    box << share, Ball(0), Ball::hull(Ball(0), Ball(families::length_of(q)));
    const std::optional<families::Strip::View> view = strip.look(box);
    left += view ? 1 : 0;
    for (const words::WordOrbit& o : list.orbits) {
      const motion::Phase& slip = o.orbit.motion.phases[0];
      if (!(slip.duration / motion::period(o.orbit.motion)).overlaps(share)) {
        continue;
      }
      ++held;
      REQUIRE(view);
      CHECK(view->rest(0).overlaps(slip.duration / motion::period(o.orbit.motion)));
      if (view->x.empty()) {
        continue;
      }
      const auto in = [&](std::size_t i) {
        return Ball::hull(Ball(view->x.at(i).first), Ball(view->x.at(i).second));
      };
      CHECK(in(0).overlaps(slip.duration));
      const Ball turns = (in(4) - slip.load) / (Ball(2) * Ball::pi());
      CHECK((turns - Ball(std::round(turns.approximate()))).contains_zero());
    }
  }
  CHECK(held >= list.orbits.size());
  CHECK(left < count / 4);
}
