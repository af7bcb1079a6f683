// Complete lists of OTS and OST: against Newton's method from a dense grid through the flows, against the
// family of overshooting orbits, and against their mirror images.
#include <doctest/doctest.h>

#include "core/decimal.hpp"
#include "numeric/zeros/effort.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"
#include "tests/numeric/words/flow_closing.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::words;

namespace {

const Word OTS = Word::parse("OTS");
const Word OST = Word::parse("OST");

std::pair<double, double> durations(const WordOrbit& orbit, PhaseKind first) {
  const auto of = [&](PhaseKind kind) {
    for (const Phase& phase : orbit.orbit.motion.phases) {
      if (phase.kind == kind) {
        return phase.duration.approximate();
      }
    }
    return 0.0;
  };
  const PhaseKind second = first == PhaseKind::slip ? PhaseKind::overshoot : PhaseKind::slip;
  return {of(first), of(second)};
}

bool is_listed(const WordList& list, PhaseKind first, const std::pair<double, double>& times,
               double distance) {
  const auto is_near = [&](const WordOrbit& orbit) {
    const auto [tau, tau1] = durations(orbit, first);
    return std::abs(tau - times.first) + std::abs(tau1 - times.second) < distance;
  };
  const auto is_open = [&](const families::Unresolved& part) {
    return part.where[0].value.overlaps(Ball(times.first)) &&
           part.where[1].value.overlaps(Ball(times.second));
  };
  return std::any_of(list.orbits.begin(), list.orbits.end(), is_near) ||
         std::any_of(list.unresolved.begin(), list.unresolved.end(), is_open);
}

}  // namespace

TEST_CASE("the lists of OTS and OST hold what Newton's method finds from a dense grid") {
  RandomData random;
  CAPTURE(random.seed());
  // The paper's O, of which there are orbits and a complete list; then data where a strong load moves all, so
  // that closed motions are frequent.
  std::vector<WordQuestion> questions{{O(), parse_rational("0.45899365993320057"), 20}};
  while (questions.size() < 5) {
    const ExactParameters data{
        random.between(0.2, 0.5),   random.between(2, 8),
        random.between(0.02, 0.2),  questions.size() == 3 ? Rational(0) : random.between(0.01, 0.5),
        random.between(0.55, 0.95), random.between(0.5, 2)};
    if (!is_resonant(data)) {
      questions.push_back({data, data.us * random.between(1.1, 4), 20});
    }
  }
  int found = 0;
  int complete = 0;
  for (std::size_t round = 0; round < questions.size(); ++round) {
    const WordQuestion& q = questions[round];
    CAPTURE(to_string(q.data));
    CAPTURE(stickslip::to_string(q.ur));
    const bool slips_first = round % 2 == 0;
    const PhaseKind first = slips_first ? PhaseKind::slip : PhaseKind::overshoot;
    const WordList list = all_orbits(q, slips_first ? OTS : OST, 1);
    const PhaseKind second = slips_first ? PhaseKind::overshoot : PhaseKind::slip;
    for (const Eigen::Vector2d times : grid_orbits(FlowClosing(q, {first, second, PhaseKind::stick}), 16)) {
      CAPTURE(times.transpose());
      CHECK(is_listed(list, first, {times(0), times(1)}, 1e-4));
      ++found;
    }
    complete += list.unresolved.empty() ? 1 : 0;
  }
  CHECK(found > 0);
  CHECK(complete > 0);
}

TEST_CASE("OTS at the paper's O: the paper's orbit is the only admissible one") {
  const OrbitList family = listed(families::overshooting(), O(), 40, Rational(0));
  const auto paper = std::find_if(family.orbits.begin(), family.orbits.end(),
                                  [](const Orbit& o) { return o.admissible.truth == Truth::proved; });
  REQUIRE(paper != family.orbits.end());
  const WordQuestion q{O(), parse_rational("0.45899365993320057"), 20};
  const WordList list = all_orbits(q, OTS, 1);
  CHECK(list.unresolved.empty());
  REQUIRE(list.orbits.size() == 2);
  CHECK(list.orbits[0].orbit.admissible.truth == Truth::refuted);
  CHECK(list.orbits[1].orbit.admissible.truth == Truth::proved);
  CHECK(is_listed(list, PhaseKind::slip,
                  {paper->value("tau").approximate(), paper->value("tau1").approximate()}, 1e-9));
  CHECK(all_orbits(q, OST, 1).orbits.empty());
}

TEST_CASE("on a belt that stands still OST lists the mirror images of OTS") {
  ExactParameters data = P();
  data.omega = Rational(11, 10);
  const WordQuestion q{data, parse_rational("0.3"), 20};
  const WordList one = all_orbits(q, OTS, 1);
  const WordList other = all_orbits(q, OST, 1);
  CHECK(one.unresolved.empty());
  CHECK(other.unresolved.empty());
  CHECK(one.orbits.size() == 2);
  REQUIRE(one.orbits.size() == other.orbits.size());
  for (const WordOrbit& orbit : one.orbits) {
    CHECK(is_listed(other, PhaseKind::overshoot, durations(orbit, PhaseKind::slip), 1e-9));
  }
}

TEST_CASE("with 1/omega a whole number OTS is complete, and agrees with the family") {
  ExactParameters data = O();
  data.omega = Rational(1, 2);
  const Rational ur = parse_rational("0.4");
  const WordList list = all_orbits({data, ur, 20}, OTS, 1);
  CHECK(list.unresolved.empty());
  const OrbitList family = listed(families::overshooting(), data, 20, {}, ur);
  CHECK(family.complete());
  for (const Orbit& orbit : family.orbits) {
    const std::pair times{orbit.value("tau").approximate(), orbit.value("tau1").approximate()};
    CHECK((is_listed(list, PhaseKind::slip, times, 1e-9) || std::max(times.first, times.second) < 3.1416));
  }
}

TEST_CASE("a list of OTS, too, says why it stays open at T = 0 where 2 omega is a natural frequency") {
  // omega1 = 1/2.
  const WordQuestion q{
      {Rational(5, 8), Rational(12, 5), Rational(1, 10), Rational(1, 10), Rational(1, 4), Rational(1)},
      Rational(3, 10),
      20};
  const zeros::Effort few{1000, {}};
  const auto at_end = [](const families::Unresolved& part) {
    return part.reason.find("$2 omega$ is a natural frequency") != std::string::npos;
  };
  CHECK(std::ranges::any_of(all_orbits(q, OTS, 1).unresolved, at_end));
}
