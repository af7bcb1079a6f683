// What single motions settle on, and the exponents of motions whose multipliers are known.
#include "numeric/attractors/settle.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/decimal.hpp"
#include "numeric/attractors/follower.hpp"
#include "tests/numeric/examples.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::attractors;

namespace {

model::Parameters<double> in_double(const ExactParameters& a) {
  return parameters_as<double>(a);
}

// On the forced slip, away from it by `more` in x2.
model::Vector4<double> sliding(const model::Parameters<double>& a, double more) {
  const model::Oscillator<double> o = model::oscillator<double>(a);
  return {o.d0(0) + o.Q(0), o.d0(1) + o.Q(1) + more, 0, 0};
}

}  // namespace

TEST_CASE("a slip whose speeds cannot add up to the belt's slides for ever, one whose speeds can does not") {
  const model::Parameters<double> a = in_double(S());
  Follower calm(a, 0.16, sliding(a, 0.01));
  calm.follow(100, 1e-6);
  CHECK(calm.kind() == Kind::slides);
  CHECK(calm.periods() == 1);
  // x2 = 3 away from rest oscillates with speeds above V = 1.
  Follower wild(a, 0.16, sliding(a, 3));
  wild.follow(1, 1e-6);
  CHECK(wild.kind() == Kind::unsettled);
}

TEST_CASE("a mass on a belt that stands still is stuck if the load cannot move it, and is not if it can") {
  const model::Parameters<double> a = in_double(P());  // p/eta = 0.25, V = 0
  Follower held(a, 0.2996, {0, 0, 0, 0});
  held.follow(100, 1e-6);
  CHECK(held.kind() == Kind::stuck);
  CHECK(held.periods() == 1);
  Follower moved(a, 0.2499, {0, 0, 0, 0});
  moved.follow(300, 1e-6);
  CHECK(moved.kind() != Kind::stuck);
}

TEST_CASE("a motion is carried on to the next time of load phase 0, from any phase") {
  const model::Parameters<double> a = in_double(O());
  simulation::Simulation whole(a, 0.4585, 0, {0.1, 0.2, 0.3, 0.4});
  simulation::Simulation part = whole;
  whole.advance(whole.period());
  part.advance(0.3 * part.period());
  const double turn = 2 * std::acos(-1.0);
  for (const double phi : {0.3 * turn, -0.7 * turn, 5.3 * turn}) {
    CHECK(distance(at_phase_0({a, 0.4585, phi, part.state()}), whole.state()) < 1e-9);
  }
  CHECK(distance(at_phase_0({a, 0.4585, 0, part.state()}), part.state()) < 1e-14);
}

TEST_CASE("the period and the word of a motion that settles") {
  Follower three(in_double(P()), 0.2996, {0.5, 1, 0, -0.2});
  three.follow(20000, 1e-6);
  REQUIRE(three.kind() == Kind::periodic);
  const auto seen = three.returned();
  REQUIRE(seen);
  CHECK(seen->guess.periods == 3);
  CHECK(seen->word == "OSOTSOST");
  CHECK(seen->once.size() == 3);
}

TEST_CASE("the exponent of a periodic motion is the logarithm of its largest multiplier, over its period") {
  Follower three(in_double(P()), 0.2996, {0.5, 1, 0, -0.2});
  three.follow(20000, 1e-6);
  const Exponent exponent = three.exponent(5000);
  CHECK(exponent.is_negative());
  CHECK_FALSE(exponent.is_positive());
  CHECK(exponent.value == doctest::Approx(std::log(0.654462) / 3).epsilon(0.01));
}

TEST_CASE("a motion that neighbours leave exponentially is irregular") {
  const auto starts = random_starts_in(start_box(in_double(O())), 12, 1);
  int irregular = 0;
  for (const auto& X : starts) {
    Follower follower(in_double(O()), 0.4585, X);
    follower.follow(2000, 1e-6);
    follower.classify(5000);
    irregular += follower.kind() == Kind::irregular ? 1 : 0;
    if (follower.kind() == Kind::irregular) {
      CHECK(*follower.lyapunov() > 0.001);
    }
  }
  CHECK(irregular > 0);
}

TEST_CASE("random starts are the same for the same seed, and the first ones for any number") {
  const model::Parameters<double> a = in_double(O());
  const auto few = random_starts_in(start_box(a), 10, 7);
  const auto many = random_starts_in(start_box(a), 20, 7);
  const auto others = random_starts_in(start_box(a), 10, 8);
  for (std::size_t i = 0; i < few.size(); ++i) {
    CHECK(few[i] == many[i]);
    CHECK(few[i] != others[i]);
    CHECK(std::abs(few[i](2)) <= 1.5);  // V = 1 is the largest of the speeds
    CHECK(std::abs(few[i](3)) <= 1.5);
  }
}

TEST_CASE("a load that is too slow to be followed is given up, and what sticks for good is seen at once") {
  ExactParameters slow = O();
  slow.omega = parse_rational("1e-44");
  Follower slips(parameters_as<double>(slow), 0.45, {0.1, 0.2, 0, 0});
  slips.follow(100, 1e-6);
  CHECK(slips.is_too_slow());
  CHECK(slips.kind() == Kind::unsettled);
  slips.classify(1000);
  CHECK(slips.kind() == Kind::unsettled);
  slow.V = 0;
  Follower sticks(parameters_as<double>(slow), 0.45, {0.1, 0.2, 0, 0});
  sticks.follow(100, 1e-6);
  CHECK(sticks.kind() == Kind::stuck);
}
