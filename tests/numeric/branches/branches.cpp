// Branches over one parameter: what they say beside each change is what the complete list of orbits says
// there, and what would be false is refused.
#include "numeric/branches/branches.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "numeric/branches/changes.hpp"
#include "numeric/branches/resonance.hpp"
#include "numeric/branches/search.hpp"
#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::branches::examples;

namespace {

// The list of orbits with the parameter, omega, p or ur, at that value.
OrbitList at(const BranchQuestion& question, const Rational& value) {
  OrbitQuestion q = question.orbits;
  if (question.parameter == "ur") {
    q.ur = Range{value};
  } else {
    (question.parameter == "omega" ? q.parameters.omega : q.parameters.p) = {value};
  }
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
  BranchQuestion question = along(S(), "omega", "0.58", "0.61");
  std::vector<std::size_t> found;  // the changes of each branch, as it is found
  question.found = [&](const Branch& branch) { found.push_back(branch.changes.size()); };
  const BranchList list = list_branches(question);
  CHECK(
      std::ranges::equal(found, list.branches, {}, {}, [](const Branch& one) { return one.changes.size(); }));
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

TEST_CASE("the branch of O and that beside it: two ends at infinity, a fold, a condition, as the lists say") {
  BranchQuestion question = along(O(), "omega", "0.6182", "0.632");
  question.at = parse_rational("0.6289");
  const BranchList list = list_branches(question);
  CHECK(list.resolved());
  REQUIRE(list.branches.size() == 2);
  for (const Branch& branch : list.branches) {
    CHECK(branch.first.kind == End::infinite);
    CHECK(branch.first.at.overlaps(list.branches.front().first.at));
  }
  const std::vector<Change> folds = changes_of(list, ChangeKind::fold);
  REQUIRE(folds.size() == 1);
  CHECK((abs(folds.front().at - Ball(parse_rational("0.618247176"))) - Ball(1e-9)).is_negative());
  const std::vector<Change> lost = changes_of(list, ChangeKind::condition);
  REQUIRE(lost.size() == 1);
  CHECK(lost.front().what == "18");
  CHECK(check_sides(list) == 4);
}

TEST_CASE("symmetric orbits go on through a natural frequency, and what changes beside it is told") {
  // omega1 = 0.6135588581, and a complex pair at 0.6141918868.
  const BranchList list = list_branches(along(S(), "omega", "0.612", "0.616"));
  CHECK(list.complete);
  CHECK(list.unresolved.empty());
  CHECK(changes_of(list, ChangeKind::resonance).empty());
  const std::vector<Change> stability = changes_of(list, ChangeKind::stability);
  REQUIRE(stability.size() == 1);
  CHECK(stability.front().what == "complex pair");
  CHECK(check_sides(list) == 2);
  // So near that the lists decide it at many digits only.
  const Rational omega1 = exact(model::modes<Ball>(Ball(0.5), Ball(parse_rational("3.8"))).omega1);
  for (const Rational& value :
       {Rational(omega1 - Rational(1, 100000)), Rational(omega1 + Rational(1, 100000))}) {
    const std::optional<Numbers> said = numbers(list, value);
    REQUIRE(said);
    CHECK(*said == numbers(at(list.question, value)));
  }
}

TEST_CASE(
    "next to a multiple of omega that is a natural frequency nothing is looked into, and that is said") {
  for (const char * V : {"0.1", "0"}) {
    const OrbitQuestion data =
        examples::data("nonsticking", {"0.3", "4", "0.1", V, "0.4239250651584028", "1"});
    const BranchQuestion question = along(data, "chi", "0.2785", "0.2787");
    const BranchList list = list_branches(question);
    CHECK(list.resolved());
    CHECK(!list.complete);
    REQUIRE(list.unresolved.size() == 1);
    const UnresolvedPart& part = list.unresolved.front();
    CHECK(part.resonance);
    CHECK(part.reason == "the resonance 3 omega = omega2: not looked into next to it");
    CHECK((part.value.radius() - Ball(1e-5)).is_negative());
    REQUIRE(part.where.size() == 1);
    const Ball& at = part.where.front().value;
    CHECK(part.value.contains(at));
    CHECK((at.radius() - Ball(1e-11)).is_negative());
    const auto is_resonant_between = [&](const Ball& low, const Ball& high) {
      const auto over = [&](const Ball& chi) {
        return model::modes<Ball>(chi, Ball(4)).omega2 - Ball(3) * Ball(data.parameters.omega.middle);
      };
      return over(low).is_negative() && over(high).is_positive();
    };
    CHECK(is_resonant_between(at.lower(), at.upper()));
    // Four orbits below and eight above, each on a branch that stops here and goes to the interval's end.
    REQUIRE(list.counts.size() == 2);
    CHECK(list.counts[0].orbits == 4);
    CHECK(list.counts[1].orbits == 8);
    CHECK(list.branches.size() == 12);
    for (const Branch& branch : list.branches) {
      const bool below = branch.first.kind == End::interval;
      const BranchEnd& stop = below ? branch.last : branch.first;
      CHECK((below ? branch.first : branch.last).kind == End::interval);
      CHECK(stop.kind == End::stopped);
      CHECK(stop.resonance);
      CHECK(stop.words == "followed no further: next to the resonance 3 omega = omega2");
      CHECK(part.value.overlaps(stop.at));
    }
    for (const char * chi : {"0.2786", "0.27863"}) {
      OrbitQuestion there = data;
      there.parameters.chi = Range{parse_rational(chi)};
      CHECK(numbers(list, parse_rational(chi)) == numbers(list_orbits(there)));
    }
    // Of the orbits at one value, those on its side.
    BranchQuestion one = question;
    one.at = parse_rational("0.2787");
    const BranchList above = list_branches(one);
    CHECK(above.branches.size() == 8);
    CHECK(above.unresolved.size() == 1);
    one.at = parse_rational("0.27862");
    const BranchList none = list_branches(one);
    CHECK(none.branches.empty());
    CHECK(none.unresolved.size() == 1);
  }
}

TEST_CASE(
    "orbits that never stick are all found on both sides of a natural frequency, where they are infinite") {
  const BranchList list = list_branches(along(P(), "omega", "0.701", "0.7014"));
  CHECK(!list.complete);
  const auto part = std::find_if(list.unresolved.begin(), list.unresolved.end(),
                                 [](const UnresolvedPart& one) { return one.resonance; });
  REQUIRE(part != list.unresolved.end());
  CHECK(part->reason == "the resonance omega = omega1: not looked into next to it");
  // Else only the stability is open, of multipliers near 1 in size.
  for (const UnresolvedPart& one : list.unresolved) {
    CHECK((one.resonance || one.reason == "the stability is undecided"));
  }
  CHECK(list.branches.size() == 4);
  for (const char * omega : {"0.7011", "0.70122", "0.70124", "0.7013"}) {
    const std::optional<Numbers> said = numbers(list, parse_rational(omega));
    REQUIRE(said);
    const Numbers there = numbers(at(list.question, parse_rational(omega)));
    CHECK(said->orbits == there.orbits);
    CHECK(said->admissible == there.admissible);
  }
}

TEST_CASE(
    "multiples of omega that are natural frequencies are found in order, and none where nothing moves them") {
  const std::vector<Multiple> all = multiples_in(along(P(), "omega", "0.3", "0.66"));
  std::vector<std::string> names;
  for (const Multiple& one : all) {
    names.push_back(one.name);
    CHECK(one.from < one.to);
    REQUIRE(one.at);
    CHECK(between(one.from, one.to).contains(*one.at));
  }
  // omega1 = 0.7012, omega2 = 1.3070.
  CHECK(names == std::vector<std::string>{"4 omega = omega2", "2 omega = omega1", "3 omega = omega2",
                                          "2 omega = omega2"});
  CHECK(multiples_in(along(P(), "omega", "0.71", "0.8")).empty());
  const std::vector<Multiple> first = multiples_in(along(P(), "omega", "0.66", "0.8"));
  REQUIRE(first.size() == 1);
  CHECK(first.front().name == "omega = omega1");
  CHECK(multiples_in(along(P(), "p", "0.4", "1")).empty());
  CHECK(multiples_in(along(S(), "omega", "0.3", "0.66")).empty());
  // Where the interval begins at the resonance.
  const std::vector<Multiple> cut =
      multiples_in(along(data("nonsticking", {"0.3", "4", "0.1", "0", "0.4239250651584028", "1"}), "chi",
                         "0.27862001", "0.2787"));
  REQUIRE(cut.size() == 1);
  CHECK(!cut.front().at);
  CHECK(cut.front().from == parse_rational("0.27862001"));
}

TEST_CASE(
    "overshooting orbits are not looked into next to resonances, and on both sides are as the lists say") {
  const auto overshooting = [](const char * phi, const char * ur) {
    OrbitQuestion q = O();
    q.phi = phi != nullptr ? std::optional(Range{parse_rational(phi)}) : std::nullopt;
    q.ur = ur != nullptr ? std::optional(Range{parse_rational(ur)}) : std::nullopt;
    return q;
  };
  struct Across {
    const char *phi, *ur, *from, *to, *name;
  };
  // omega1 = 0.6983476480, omega2 = 1.1455612435. Where ur is given cos psi and sin psi are hardly determined
  // beside omega1, and the search may not divide by what determines them.
  for (const Across& a : {Across{"0", nullptr, "0.572", "0.5735", "2 omega = omega2"},
                          Across{"0", nullptr, "0.9991", "1.001", "omega = 1"},
                          Across{nullptr, "0.4585", "0.5718", "0.5738", "2 omega = omega2"},
                          Across{nullptr, "0.4585", "0.3482", "0.3502", "2 omega = omega1"},
                          Across{nullptr, "0.4585", "0.2318", "0.2338", "3 omega = omega1"}}) {
    CAPTURE(std::string(a.name));
    const BranchList list = list_branches(along(overshooting(a.phi, a.ur), "omega", a.from, a.to));
    CHECK(list.resolved());
    CHECK(!list.complete);
    REQUIRE(list.unresolved.size() == 1);
    const UnresolvedPart& part = list.unresolved.front();
    CHECK(part.resonance);
    CHECK(part.reason == std::string("the resonance ") + a.name + ": not looked into next to it");
    REQUIRE(part.where.size() == 1);
    CHECK(part.value.contains(part.where.front().value));
    CHECK((part.value.radius() - Ball(a.ur != nullptr ? 0x1p-10 : 0x1p-16) * part.value).is_negative());
    int compared = 0;
    for (const Count& count : list.counts) {
      const Rational value = exact((count.from + count.to) / Ball(2));
      const OrbitList there = at(list.question, value);
      if (there.complete()) {
        CHECK(numbers(list, value) == numbers(there));
        ++compared;
      }
    }
    CHECK(compared >= 2);
  }
}

TEST_CASE("the search for orbits on no branch has one limit of cells for all of its parts, and says so") {
  OrbitQuestion data =
      examples::data("overshooting", {"0.7126", "2.9317", "0.0701", "1.8803", "0.151723", "0.03"});
  data.ur = Range{parse_rational("0.162")};
  const zeros::Effort little(1000, {});
  const AllFollowed all = follow_all(along(data, "omega", "0.151723", "0.152093"));
  CHECK(!all.complete);
  CHECK(all.cells >= 1000);
  CHECK(all.cells < 3000);
  CHECK(std::any_of(all.unresolved.begin(), all.unresolved.end(), [](const UnresolvedPart& part) {
    return part.reason ==
           "there may be orbits that are on no branch: the search was stopped at its limit of cells";
  }));
}

TEST_CASE("a branch that comes back with the load's phase a turn further is a closed curve, counted once") {
  // At any phase of the load there are two orbits, each at its own ur, which is periodic in the phase.
  OrbitQuestion data =
      examples::data("overshooting", {"0.3351", "5.424", "0.3421", "0.184", "1.037", "0.02293"});
  data.ur = Range{parse_rational("0.6165")};
  BranchQuestion question = along(data, "ur", "0.6", "0.63");
  for (const char * from : {"", "0.6165"}) {
    question.at = *from != 0 ? std::optional(parse_rational(from)) : std::nullopt;
    const BranchList list = list_branches(question);
    CHECK(list.unresolved.empty());
    CHECK(list.complete == !question.at);
    REQUIRE(list.branches.size() == 1);
    const Branch& branch = list.branches.front();
    CHECK(branch.closed);
    CHECK(branch.first.kind == End::closed);
    CHECK(branch.last.kind == End::closed);
    CHECK(branch.changes.size() == 2);
    CHECK(changes_of(list, ChangeKind::fold).size() == 2);
    CHECK(check_sides(list) == 4);
    // Also next to where it begins, and where the phase is pi.
    for (const char * value : {"0.605", "0.613", "0.61495654", "0.6149999999", "0.6150000001", "0.616499999",
                               "0.616500001", "0.619", "0.625"}) {
      CHECK(numbers(list, parse_rational(value)) == numbers(at(question, parse_rational(value))));
    }
  }
}

TEST_CASE("a branch that does not come back within the interval is not called closed") {
  // The same loop, cut by the interval's end: two orbits come in and meet in a fold.
  OrbitQuestion data =
      examples::data("overshooting", {"0.3351", "5.424", "0.3421", "0.184", "1.037", "0.02293"});
  data.ur = Range{parse_rational("0.6165")};
  const BranchList list = list_branches(along(data, "ur", "0.6", "0.617"));
  CHECK(list.complete);
  REQUIRE(list.branches.size() == 1);
  CHECK(!list.branches.front().closed);
  CHECK(list.branches.front().first.kind == End::interval);
  CHECK(list.branches.front().last.kind == End::interval);
  CHECK(changes_of(list, ChangeKind::fold).size() == 1);
  CHECK(check_sides(list) == 2);
}

TEST_CASE("all of S beside each of its changes is as the lists say") {
  const BranchList list = list_branches(along(S(), "omega", "0.505", "0.59"));
  CHECK(list.complete);
  CHECK(check_sides(list) >= 8);
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

TEST_CASE(
    "where the friction stops an orbit that never sticks at V = 0, (25), (26) and (36) are all decided") {
  OrbitQuestion orbits = data("nonsticking", {"0.3", "4", "0.1", "0", "0.6", "1"});
  const BranchList list = list_branches(along(orbits, "ur", "0.25", "0.35"));
  CHECK(list.complete);
  CHECK(list.resolved());
  std::vector<std::string> lost;
  for (const Change& change : changes_of(list, ChangeKind::condition)) {
    CHECK(change.verdict.truth == Truth::proved);
    CHECK(change.at.overlaps(changes_of(list, ChangeKind::condition).front().at));
    lost.push_back(change.what);
  }
  CHECK(lost == std::vector<std::string>{"25", "26", "36"});
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

TEST_CASE("the stability of an orbit that hardly sticks is decided, with a multiplier near 1") {
  // 3 omega = omega2 at 0.529522, where T = 0.
  const BranchList list = list_branches(along(S(), "omega", "0.529", "0.5295"));
  CHECK(list.complete);
  CHECK(list.resolved());
}

TEST_CASE("the exit functions of symmetric orbits are those of all orbits, but for positive factors") {
  for (const char * omega : {"0.51", "0.528", "0.5295", "0.6"}) {
    const BranchQuestion question = along(S(), "omega", "0.5", "0.61");
    for (const Orbit& orbit : at(question, parse_rational(omega)).orbits) {
      const ExitFactors<Ball> all = exit_factors(orbit.motion), few = exit_factors(orbit.motion, true);
      const model::Modes<Ball>& m = orbit.motion.oscillator.modes;
      const Ball d = m.lambda2 - m.lambda1;
      const Ball scale = Ball(8) / (d * d * m.omega1 * m.omega2);
      const Ball N = few[Exit::plus_one].at(1);
      CHECK((few[Exit::plus_one].at(0) * N * scale - all[Exit::plus_one].front()).contains_zero());
      CHECK((N.radius() - Ball(1e-12)).is_negative());
      // By the closing condition of a mode: F, c, B, rest with N B = omega² c rest.
      for (const std::size_t j : {0U, 1U}) {
        const std::vector<Ball> by_mode = SymmetricExits<Ball>(orbit.motion).at_one_by_mode(j);
        const Ball& omega_j = j == 0 ? m.omega1 : m.omega2;
        CHECK((by_mode.at(0) - few[Exit::plus_one].at(0)).contains_zero());
        CHECK((N * by_mode.at(2) - omega_j * omega_j * by_mode.at(1) * by_mode.at(3)).contains_zero());
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
