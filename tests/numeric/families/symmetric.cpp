// Example S (Fig. 2) and complete lists of symmetric orbits: nothing missing, nothing twice, nothing that
// does not close.
#include "numeric/families/symmetric.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/printed.hpp"
#include "numeric/zeros/krawczyk.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/equations_16.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

OrbitList list_symmetric(const ExactParameters& a, int digits) {
  return listed(symmetric(), a, digits);
}

LoadPhase load_phase(const Orbit& orbit) {
  const Phase& slip = orbit.motion.phases[0];
  const Ball middle = slip.load + orbit.motion.oscillator.data.omega * slip.duration / Ball(2);
  return (middle - Ball::pi()).is_negative() ? LoadPhase::first : LoadPhase::second;
}

// (13), its stick beginning at E Z0; (15); (16).
std::vector<model::Vector4<Ball>> residuals(const ExactParameters& a, const Orbit& orbit) {
  const std::vector<Phase>& phases = orbit.motion.phases;
  const model::Vector4<Ball> EZ0 = model::reversal<Ball>() * phases[0].Z;
  const auto gap = gaps(orbit.motion);
  const model::Vector4<Ball> x(phases[0].duration, phases[0].Z(0), phases[0].Z(1), phases[0].Z(2));
  return {EZ0 - phases[1].Z, gap[0], gap[1], equations_16(a, load_phase(orbit))(x)};
}

void check_closes(const ExactParameters& a, const Orbit& orbit, const char * bound) {
  for (const model::Vector4<Ball>& residual : residuals(a, orbit)) {
    for (int i = 0; i < 4; ++i) {
      CAPTURE(i);
      CHECK(residual(i).contains_zero());
      CHECK((residual(i).radius() - Ball(parse_rational(bound))).is_negative());
    }
  }
}

void check_list(const ExactParameters& a, const OrbitList& list) {
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    const Orbit& orbit = list.orbits[i];
    check_closes(a, orbit, "1e-9");
    CHECK(orbit.value("tau").is_positive());
    CHECK(orbit.value("T").is_positive());
    for (std::size_t j = 0; j < i; ++j) {
      const Orbit& other = list.orbits[j];
      CHECK((load_phase(other) != load_phase(orbit) || !other.value("tau").overlaps(orbit.value("tau"))));
    }
  }
}

OrbitList complete_list(const ExactParameters& a, std::size_t orbits) {
  const OrbitList list = list_symmetric(a, 25);
  CHECK(list.complete());
  CHECK(list.orbits.size() == orbits);
  check_list(a, list);
  return list;
}

bool remarks(const OrbitList& list, Remark remark) {
  return std::count(list.remarks.begin(), list.remarks.end(), remark) == 1;
}

// The orbit of Fig. 2: the paper's load phase, tau near the printed one.
Orbit orbit_S(int digits) {
  return list_symmetric(S(), digits).orbits.at(1);
}

}  // namespace

TEST_CASE("example S closes in all components of (13), (15) and (16)") {
  check_closes(S(), orbit_S(30), "1e-28");
}

TEST_CASE("a thousand digits, and enclosures at different precisions that overlap") {
  const Orbit coarse = orbit_S(20);
  const Orbit fine = orbit_S(1000);
  const WorkingPrecision precision(3500);
  CHECK(coarse.value("tau").overlaps(fine.value("tau")));
  CHECK(coarse.value("ur").overlaps(fine.value("ur")));
  CHECK((fine.value("tau").radius() - Ball(parse_rational("1e-1000"))).is_negative());
  CHECK((fine.value("ur").radius() - Ball(parse_rational("1e-1000"))).is_negative());
  check_closes(S(), fine, "1e-998");
}

TEST_CASE("the paper's (16) has exactly one zero near the orbit, the same one") {
  const Orbit s = orbit_S(20);
  const Box<4> zero(s.value("tau"), s.value("z10"), s.value("z20"), s.value("zdot10"));
  const ZeroProof<4> proof =
      prove_zero_by_inflation<4>(equations_16(S(), LoadPhase::first), midpoint<4>(zero));
  REQUIRE(proof.verdict.truth == Truth::proved);
  for (int i = 0; i < 4; ++i) {
    CHECK(proof.box(i).overlaps(zero(i)));
  }
}

TEST_CASE("a guess that is no orbit is not proved") {
  const Orbit orbit = orbit_S(20);
  Closing f{SymmetricClosing{LoadPhase::first}};
  for (const double shift : {1e-2, -1e-2, 0.3}) {
    CAPTURE(shift);
    Motion guess = orbit.motion;
    guess.phases[0].duration += Ball(shift);
    const ClosedMotion proof = prove_closed(f, {S()}, guess, 20);
    if (proof.existence.truth == Truth::proved) {  // then of the very same orbit
      CHECK(proof.motion.phases[0].duration.overlaps(orbit.value("tau")));
    }
  }
  const ClosedMotion other = prove_closed(SymmetricClosing{LoadPhase::second}, {S()}, orbit.motion, 20);
  if (other.existence.truth == Truth::proved) {  // then of another one
    CHECK_FALSE(other.motion.phases[0].duration.overlaps(orbit.value("tau")));
  }
}

TEST_CASE("the printed values of example S, in the paper's own equations") {
  const Equations16 f = equations_16(S(), LoadPhase::first);
  const auto over = [](const std::array<const char *, 4>& printed) {
    Box<4> intervals;
    std::transform(printed.begin(), printed.end(), intervals.begin(),
                   [](const char * text) { return printed_interval(parse_decimal(text)); });
    return intervals;
  };
  const Box<4> printed = over({"7.749", "1.0609", "1.3615", "0.581"});
  for (int i = 0; i < 4; ++i) {
    CHECK(f(printed)(i).contains(f(midpoint<4>(printed))(i)));
  }
  CHECK(krawczyk_test<4>(f, printed).verdict.truth == Truth::refuted);
  // The same test on intervals around the proved values accepts them.
  const Box<4> right = over({"7.746695", "1.061513", "1.362640", "0.580303"});
  CHECK(krawczyk_test<4>(f, right).verdict.truth != Truth::refuted);
}

TEST_CASE("data outside the domain are refused by name") {
  const auto refuse = [](const ExactParameters& a) { (void)list_symmetric(a, 20); };
  CHECK_THROWS_AS(refuse(parse_parameters("1", "3.8", "0.02", "1", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "0", "0.02", "1", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0", "1", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0.02", "0", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0.02", "1", "0", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "-1")), DomainError);
  // omega1 = 1/2 and omega2 = 2 by (39): chi eta = 13/4, 1 - chi = 4/13.
  CHECK_THROWS_AS(refuse(parse_parameters("9/13", "169/36", "0.02", "1", "0.5", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("9/13", "169/36", "0.02", "1", "2", "0.05")), DomainError);
}

TEST_CASE("example S: two orbits of either load phase, the printed one among them") {
  const OrbitList list = complete_list(S(), 4);
  CHECK(near(list.orbits[1].value("tau"), "7.7467", "0.0001"));
  CHECK(load_phase(list.orbits[1]) == LoadPhase::first);
}

TEST_CASE("lists at other data: none, many, without load, near and at special frequencies") {
  complete_list(O(), 2);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "3", "0.05"), 0);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.1", "0.05"), 22);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "5"), 3);
  complete_list(parse_parameters("0.0001", "3.8", "0.02", "1", "0.6", "0.05"), 0);
  complete_list(parse_parameters("0.9999", "3.8", "0.02", "1", "0.6", "0.05"), 4);
  CHECK(remarks(complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "0"), 2),
                Remark::load_absent));
}

TEST_CASE("omega = 1/k: the eliminant's zero at tau = 0 is no orbit") {
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "1", "0.05"), 0);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "1/2", "0.05"), 4);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.999", "0.05"), 0);
}

TEST_CASE("omega_j = k omega: the closing motion without a stick is told apart") {
  // omega1 = 1/2, omega2 = 2.
  const OrbitList list = complete_list(parse_parameters("9/13", "169/36", "0.02", "1", "2/3", "0.05"), 2);
  CHECK(remarks(list, Remark::closes_without_stick));
  CHECK_FALSE(remarks(complete_list(S(), 4), Remark::closes_without_stick));
  CHECK_THROWS_AS((void)list_symmetric(parse_parameters("9/13", "169/36", "0.02", "1", "1/2", "0.05"), 15),
                  DomainError);
  complete_list(parse_parameters("9/13", "169/36", "0.02", "1", "0.500001", "0.05"), 5);
}

TEST_CASE("what cannot be decided is left open with a reason, and soon") {
  // omega1 = 2 omega, omega2 = 8 omega and omega = 1/4 at once: zeros of high order at the ends and at
  // Theta/2.
  const ExactParameters a = parse_parameters("9/13", "169/36", "0.02", "1", "1/4", "0.05");
  const OrbitList list = list_symmetric(a, 15);
  CHECK_FALSE(list.complete());
  check_list(a, list);
  for (const Unresolved& open : list.unresolved) {
    CHECK_FALSE(open.reason.empty());
    CHECK((open.where.at(0).value.radius() - Ball(0.5)).is_negative());
  }
}

TEST_CASE("random data: the list holds every orbit that a scan in floats can find") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int k = 0; k < 12; ++k) {
    const ExactParameters a = random.parameters();
    CAPTURE(examples::to_string(a));
    const OrbitList list = list_symmetric(a, 15);
    check_list(a, list);
    for (const LoadPhase phase : {LoadPhase::first, LoadPhase::second}) {
      if (!list.complete() || (phase == LoadPhase::second && a.p == 0)) {
        continue;
      }
      // Changes of sign of the eliminant, in double; not where both of C's coefficients are small.
      const SymmetricEliminant f{symmetric_data(a, phase)};
      const auto at = [&](double u) { return f(Box<1>(Ball(u)))(0).approximate(); };
      const int steps = 400;
      for (int i = 0; i < steps; ++i) {
        double below = (i + 1e-3) / steps, above = (i + 1 + 1e-3) / steps;
        if (above > 1 || at(below) * at(above) >= 0) {
          continue;
        }
        for (int step = 0; step < 40; ++step) {
          const double middle = (below + above) / 2;
          (at(below) * at(middle) <= 0 ? above : below) = middle;
        }
        CAPTURE(below);
        CHECK(std::any_of(list.orbits.begin(), list.orbits.end(), [&](const Orbit& orbit) {
          const Ball share = orbit.value("tau") / orbit.value("Theta");
          return load_phase(orbit) == phase && (abs(share - Ball(below)) - Ball(1e-8)).is_negative();
        }));
      }
    }
  }
}
