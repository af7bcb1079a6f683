// Lists of words of four phases: no box loses what Newton's method finds from a grid through the flows alone.
#include <doctest/doctest.h>

#include <random>

#include "core/decimal.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/through_phases/two_sticks.hpp"
#include "numeric/words/complete_list.hpp"
#include "numeric/zeros/effort.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"
#include "tests/numeric/words/flow_closing.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::words;

namespace {

// Data where a strong load moves all, so that closed motions are frequent.
std::vector<WordQuestion> questions() {
  const auto at = [](const char * chi, const char * eta, const char * us, const char * V, const char * omega,
                     const char * p, const char * ur) {
    return WordQuestion{parse_parameters(chi, eta, us, V, omega, p), parse_rational(ur), 20};
  };
  return {at("0.4", "10", "0.2", "1", "0.7", "2", "0.5"), at("0.3", "4", "0.1", "0", "0.6", "1", "0.2996"),
          at("0.35", "3", "0.1", "0.2", "0.8", "1.5", "0.25"),
          at("0.5", "6", "0.05", "0.4", "1.3", "3", "0.3")};
}

// The unknowns of the problems for these durations.
Eigen::Vector3d shares(const families::OneStick<3, families::Datum::friction> * /*kind*/,
                       const Eigen::Vector3d& t, double total) {
  return {(t(0) + t(1)) / total, t(1) / (t(0) + t(1)), t(2) / (total - t(0) - t(1))};
}
Eigen::Vector3d shares(const families::TwoSticks * /*kind*/, const Eigen::Vector3d& t, double total) {
  return {(t(0) + t(1)) / total, t(0) / (t(0) + t(1)), t(2) / (total - t(0) - t(1))};
}

struct Counts {
  int orbits = 0, decided = 0;
};

// No box around what Newton's method finds loses it, and that it is a zero is decided in small ones.
template <class P>
Counts check_boxes(const P& problem, const FlowClosing& f, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-0.9, 0.9);
  Counts counts;
  for (const Eigen::Vector3d t : grid_orbits(f, 7)) {
    const Eigen::Vector3d x = shares(static_cast<const P *>(nullptr), t, f.total);
    CAPTURE(t.transpose());
    for (const double radius : {0.3, 0.05, 1e-2, 1e-3, 1e-4}) {
      zeros::Box<3> X;
      for (int i = 0; i < 3; ++i) {
        const double middle = x(i) + radius * uniform(generator);
        X(i) = Ball::hull(Ball(std::max(middle - radius, 0.0)), Ball(std::min(middle + radius, 1.0)));
      }
      const auto rest = families::LinearEliminant<P>::contract(problem, X);
      REQUIRE(rest.has_value());
      for (int i = 0; i < 3; ++i) {
        CHECK((*rest)(i).overlaps(Ball(x(i)) + Ball::hull(Ball(-1e-6), Ball(1e-6))));
      }
    }
    zeros::Box<3> X;
    for (int i = 0; i < 3; ++i) {
      X(i) = Ball(x(i)) + Ball::hull(Ball(-1e-6), Ball(1e-6));
    }
    const zeros::ZeroProof<3> decision = families::LinearEliminant<P>::decide(problem, X);
    CHECK(decision.verdict.truth != Truth::refuted);
    counts.decided += decision.verdict.truth == Truth::proved ? 1 : 0;
    ++counts.orbits;
  }
  return counts;
}

}  // namespace

TEST_CASE("two sticks: no box around a closed motion loses it") {
  const WorkingPrecision scope(64);
  std::mt19937 generator(7);
  Counts all;
  for (const WordQuestion& q : questions()) {
    for (const PhaseKind second : {PhaseKind::slip, PhaseKind::overshoot}) {
      CAPTURE(to_string(q.data));
      const FlowClosing f(q, {PhaseKind::slip, PhaseKind::stick, second, PhaseKind::stick});
      const model::Parameters<Ball> a = parameters_as<Ball>(q.data);
      const families::TwoSticks problem(
          {{a, model::modes<Ball>(a.chi, a.eta), Ball(2) * Ball::pi() / a.omega},
           Ball(q.ur),
           {1, second == PhaseKind::slip ? 1 : -1}});
      const Counts found = check_boxes(problem, f, generator);
      all.orbits += found.orbits;
      all.decided += found.decided;
    }
  }
  CHECK(all.orbits > 0);
  CHECK(all.decided > 0);
}

TEST_CASE("slip, overshoot, slip, stick: no box around a closed motion loses it") {
  const WorkingPrecision scope(64);
  std::mt19937 generator(7);
  Counts all;
  for (const WordQuestion& q : questions()) {
    CAPTURE(to_string(q.data));
    const FlowClosing f(q, {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::slip, PhaseKind::stick});
    const families::OneStick<3, families::Datum::friction> problem(
        {families::overshooting_data<Ball>(q.data), Ball(q.ur)}, true);
    const Counts found = check_boxes(problem, f, generator);
    all.orbits += found.orbits;
    all.decided += found.decided;
  }
  CHECK(all.orbits > 0);
  CHECK(all.decided > 0);
}

TEST_CASE("OTST: a complete list holds the one orbit that Newton's method finds from a grid") {
  const WordQuestion q{parse_parameters("0.462", "2.5", "0.185", "1.12", "1.67", "1.25"),
                       parse_rational("0.5069"), 20};
  const WordList list = all_orbits(q, Word::parse("OTST"), 1);
  CHECK(list.unresolved.empty());
  REQUIRE(list.orbits.size() == 1);
  const std::vector<PhaseKind> phases{PhaseKind::slip, PhaseKind::stick, PhaseKind::overshoot,
                                      PhaseKind::stick};
  // The orbit's durations from its slip on.
  const auto& all = list.orbits[0].orbit.motion.phases;
  REQUIRE(all.size() == 4);
  REQUIRE(all[2].kind == PhaseKind::slip);
  const Eigen::Vector3d times(all[2].duration.approximate(), all[3].duration.approximate(),
                              all[0].duration.approximate());
  const std::vector<Eigen::VectorXd> found = grid_orbits(FlowClosing(q, phases), 8);
  CHECK_FALSE(found.empty());
  for (const Eigen::Vector3d t : found) {
    CHECK((t - times).norm() < 1e-6);
  }
}

TEST_CASE("OSOT on a belt that runs backwards: the one orbit that Newton's method finds from a grid") {
  const WordQuestion q{parse_parameters("0.47", "4.69", "0.181", "-0.64", "2.12", "1.37"),
                       parse_rational("0.38915"), 20};
  const WordList list = all_orbits(q, Word::parse("OSOT"), 1);
  CHECK(list.unresolved.empty());
  REQUIRE(list.orbits.size() == 1);
  // The word's first rotation is OSOT.
  const auto& all = list.orbits[0].orbit.motion.phases;
  const Eigen::Vector3d times(all[0].duration.approximate(), all[1].duration.approximate(),
                              all[2].duration.approximate());
  const std::vector<Eigen::VectorXd> found = grid_orbits(
      FlowClosing(q, {PhaseKind::overshoot, PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}), 8);
  CHECK_FALSE(found.empty());
  for (const Eigen::Vector3d t : found) {
    CHECK((t - times).norm() < 1e-6);
  }
}

TEST_CASE("STST: a complete list is empty where Newton's method finds none from a grid") {
  const WordQuestion q{parse_parameters("0.5", "3.8", "0.02", "1", "1.3", "0.05"), parse_rational("0.16"),
                       20};
  const WordList list = all_orbits(q, Word::parse("STST"), 1);
  CHECK(list.unresolved.empty());
  CHECK(list.orbits.empty());
  CHECK(grid_orbits(FlowClosing(q, {PhaseKind::slip, PhaseKind::stick, PhaseKind::slip, PhaseKind::stick}), 8)
            .empty());
}

TEST_CASE("STST in two periods: the orbits of ST taken twice are not listed again, nor left open") {
  const WordQuestion q{parse_parameters("0.5", "3.8", "0.02", "1", "1.3", "0.05"), parse_rational("1.1"), 20};
  CHECK(all_orbits(q, Word::parse("ST"), 1).orbits.size() == 2);
  const WordList list = all_orbits(q, Word::parse("STST"), 2);
  CHECK(list.orbits.empty());
  CHECK(list.unresolved.empty());
}

TEST_CASE("a search of four phases that is stopped says what it leaves open") {
  const zeros::Effort few(100, std::nullopt);
  const WordQuestion q{parse_parameters("0.462", "2.5", "0.185", "1.12", "1.67", "1.25"),
                       parse_rational("0.5069"), 20};
  const WordList list = all_orbits(q, Word::parse("OTST"), 1);
  CHECK(list.orbits.empty());
  CHECK_FALSE(list.unresolved.empty());
}
