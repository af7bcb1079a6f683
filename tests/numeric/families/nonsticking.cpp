// Orbits that never stick: example P, and those with V not 0.
#include "numeric/families/nonsticking.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "tests/numeric/families/composed.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

Verdict admissible_at(const Orbit& orbit, const std::optional<Ball>& ur) {
  return admissible(conditions(nonsticking(), taken_as_closed(orbit.motion), ur));
}

OrbitList list_nonsticking(const ExactParameters& a, int digits) {
  return listed(nonsticking(), a, digits);
}

std::vector<Orbit> admissible_orbits(const OrbitList& list) {
  std::vector<Orbit> result;
  for (const Orbit& orbit : list.orbits) {
    if (orbit.admissible.truth == Truth::proved) {
      result.push_back(orbit);
    }
  }
  return result;
}

void check_closes(const Orbit& orbit, const char * bound) {
  for (const model::Vector4<Ball>& gap : gaps(orbit.motion)) {
    for (int i = 0; i < 4; ++i) {
      CAPTURE(i);
      CHECK(gap(i).contains_zero());
      CHECK((gap(i).radius() - Ball(parse_rational(bound))).is_negative());
    }
  }
  const Ball V = orbit.motion.oscillator.data.V;
  CHECK((state(orbit.motion, 0, orbit.value("tau"))(3) - V).contains_zero());
  CHECK((state(orbit.motion, 1, orbit.value("tau1"))(3) - V).contains_zero());
}

}  // namespace

TEST_CASE("example P: both branches of cos(phi) close in all components of (28), one is admissible") {
  const OrbitList list = list_nonsticking(P(), 30);
  CHECK(list.complete());
  REQUIRE(list.orbits.size() == 2);
  for (const Orbit& orbit : list.orbits) {
    check_closes(orbit, "1e-28");
    CHECK(orbit.value("tau").overlaps(orbit.value("Theta") / Ball(2)));
  }
  const Orbit& orbit = list.orbits[0];
  CHECK(near(orbit.value("phi"), "0.3925", "0.0002"));
  CHECK(near(orbit.value("x10"), "1.5608", "0.0001"));
  CHECK(near(orbit.value("x20"), "3.3295", "0.0003"));
  CHECK(near(orbit.value("xdot10"), "0.1523", "0.0002"));
  const std::vector<Condition> all =
      conditions(nonsticking(), taken_as_closed(orbit.motion), Ball(parse_rational("0.2996")));
  CHECK(admissible(all).truth == Truth::proved);
  CHECK(all.back().id == "36");
  CHECK(admissible_at(list.orbits[1], Ball(parse_rational("0.2996"))).truth == Truth::refuted);
  CHECK(admissible_at(list.orbits[1], std::nullopt).truth == Truth::refuted);
}

TEST_CASE("the closed form (34), (35) is the orbit found by the search") {
  const OrbitList list = list_nonsticking(P(), 30);
  const TwoSlips f = two_slips_of(parameters_as<Ball>(P()));
  const model::HalfPeriod<Ball> h =
      model::half_period<Ball>(f.o.data.chi, f.o.modes, f.o.d0, f.o.data.omega, f.pi);
  const Ball sin_phi = -h.friction_speed / (f.o.Q(1) * f.o.data.omega);
  REQUIRE(list.orbits.size() == 2);
  for (int k = 0; k < 2; ++k) {
    const Orbit& orbit = list.orbits[static_cast<std::size_t>(k)];
    const Ball cos_phi = Ball(1 - 2 * k) * sqrt(Ball(1) - sin_phi * sin_phi);
    const model::Vector4<Ball> Z0 =
        model::half_period_start<Ball>(h, f.o.Q, f.o.d0, f.o.data.omega, cos_phi, sin_phi);
    CHECK(sin(orbit.value("phi")).overlaps(sin_phi));
    CHECK(cos(orbit.value("phi")).overlaps(cos_phi));
    for (int i = 0; i < 4; ++i) {
      CHECK(orbit.motion.phases[0].Z(i).overlaps(Z0(i)));
    }
    // (36): ur_max = (chi (q2 - q1) - p/eta) cos(phi) = omega² q2 cos(phi)/eta.
    const Ball omega = f.o.data.omega;
    CHECK(orbit.value("ur_max").overlaps(omega * omega * f.o.Q(1) * cos_phi / f.o.data.eta));
  }
}

TEST_CASE("(54) holds along P, and not along an orbit with V not 0") {
  const Orbit at_rest = list_nonsticking(P(), 30).orbits[0];
  const std::vector<Orbit> moving = admissible_orbits(list_nonsticking(P("0.1"), 30));
  REQUIRE(moving.size() == 1);
  const auto position = [](const Orbit& orbit, const Ball& t) {
    const bool slips = (t - orbit.value("tau")).is_negative();
    return state(orbit.motion, slips ? 0 : 1, slips ? t : Ball(t - orbit.value("tau")))(1) +
           orbit.motion.oscillator.d0(1);
  };
  for (const char * text : {"0.3", "1.7", "4.4"}) {
    const Ball t(parse_rational(text));
    const auto sum = [&](const Orbit& orbit) {
      return position(orbit, t) + position(orbit, t + orbit.value("Theta") / Ball(2));
    };
    CHECK(sum(at_rest).contains_zero());
    CHECK(sum(moving[0]).is_nonzero());
  }
}

TEST_CASE("orbits that never stick exist with V not 0, with tau above Theta/2 for V > 0") {
  for (const char * V : {"0.1", "-0.1", "0.001", "0.4"}) {
    CAPTURE(V);
    const OrbitList list = list_nonsticking(P(V), 30);
    CHECK(list.complete());
    const std::vector<Orbit> found = admissible_orbits(list);
    REQUIRE(found.size() == 1);
    check_closes(found[0], "1e-28");
    const Ball excess = found[0].value("tau") - found[0].value("tau1");
    CHECK((V[0] == '-' ? excess.is_negative() : excess.is_positive()));
    CHECK(admissible_at(found[0], found[0].value("ur_max") - Ball(1e-6)).truth == Truth::proved);
    CHECK(admissible_at(found[0], found[0].value("ur_max") + Ball(1e-6)).truth == Truth::refuted);
    // x2(tau) - x2(0) = (2 V/omega) tan(omega tau/2).
    const auto& o = found[0].motion.oscillator;
    const Ball half = o.data.omega * found[0].value("tau") / Ball(2);
    const Ball moved = found[0].motion.phases[1].Z(1) - found[0].motion.phases[0].Z(1);
    CHECK(moved.overlaps(Ball(2) * o.data.V / o.data.omega * tan(half)));
  }
}

TEST_CASE("V and -V: the same orbit with its halves exchanged") {
  const Orbit a = admissible_orbits(list_nonsticking(P("0.2"), 30)).at(0);
  const Orbit b = admissible_orbits(list_nonsticking(P("-0.2"), 30)).at(0);
  CHECK(a.value("tau").overlaps(b.value("tau1")));
  CHECK(a.value("ur_max").overlaps(b.value("ur_max")));
  const Ball x20_mirrored = b.motion.phases[1].Z(1) + b.motion.oscillator.d0(1);
  CHECK(a.value("x20").overlaps(-x20_mirrored));
}

TEST_CASE("random data: the lists are complete, and never two orbits are admissible") {
  const unsigned seed = 55;
  INFO("seed ", seed);
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) -> Rational {
    return Rational(
               std::round(1000 * (low + (high - low) * std::uniform_real_distribution<>(0, 1)(random)))) /
           1000;
  };
  int admissible_lists = 0;
  for (int run = 0; run < 25; ++run) {
    const ExactParameters a{between(0.1, 0.9),  between(0.5, 5),
                            between(0.01, 0.2), run % 3 == 0 ? Rational(0) : between(-0.5, 0.5),
                            between(0.4, 2.5),  between(0.2, 2)};
    CAPTURE(run);
    const OrbitList list = list_nonsticking(a, 20);
    CHECK(list.complete());
    const std::vector<Orbit> found = admissible_orbits(list);
    CHECK(found.size() <= 1);
    admissible_lists += static_cast<int>(found.size());
    for (const Orbit& orbit : list.orbits) {
      check_closes(orbit, "1e-15");
    }
    if (a.V == 0) {
      continue;
    }
    // Another way to count: mu eliminated, V² = (A² - (sigma/sin delta)²) cos² delta has as many zeros delta.
    const TwoSlips f = two_slips_of(parameters_as<Ball>(a));
    const double A = (f.o.Q(1) * f.o.data.omega).approximate();
    const double V = f.o.data.V.approximate();
    const auto G = [&](double delta) {
      const double s =
          model::friction_speed<Ball>(f.o.modes, f.c, f.o.data.omega, f.pi, Ball(delta)).approximate();
      return V * V - (A * A - s * s) * std::cos(delta) * std::cos(delta);
    };
    std::size_t changes = 0;
    const double step = f.pi.approximate() / 3000;
    for (int i = 0; i < 3000; ++i) {
      changes += G(i * step) * G((i + 1) * step) < 0 ? 1U : 0U;
    }
    CHECK(changes == list.orbits.size());
  }
  CHECK(admissible_lists >= 3);
}

TEST_CASE("the least load: (37) is necessary, (36) needs more") {
  const ExactParameters a = P();
  const TwoSlips f = two_slips_of(parameters_as<Ball>(a));
  const model::HalfPeriod<Ball> h =
      model::half_period<Ball>(f.o.data.chi, f.o.modes, f.o.d0, f.o.data.omega, f.pi);
  const Ball ur(parse_rational("0.2"));
  const Ball needed = sqrt(model::least_load_squared<Ball>(f.o.data, f.o.modes, h, ur));
  const Ball printed = sqrt(model::least_load_squared<Ball>(f.o.data, f.o.modes, h, Ball(0)));
  CHECK((needed - printed).is_positive());
  const auto at_load = [&](const Ball& p) {
    ExactParameters b = a;
    b.p = Rational(p.approximate());
    return list_nonsticking(b, 20);
  };
  for (const Orbit& orbit : at_load(printed * Ball(0.999)).orbits) {
    CHECK_FALSE(orbit.value("tau").overlaps(orbit.value("tau1")));
    CHECK(admissible_at(orbit, std::nullopt).truth == Truth::refuted);
  }
  for (const Orbit& orbit : at_load(printed * Ball(1.001)).orbits) {
    CHECK((orbit.value("ur_max") - ur).is_negative());
  }
  for (const Orbit& orbit : at_load(needed * Ball(0.999)).orbits) {
    CHECK((orbit.value("ur_max") - ur).is_negative());
  }
  CHECK((at_load(needed * Ball(1.001)).orbits[0].value("ur_max") - ur).is_positive());
}

TEST_CASE("without their poles the two equations are the same times what has no zero off resonance") {
  const TwoSlips f = two_slips_of(parameters_as<Ball>(P("0.1")));
  const model::Parameters<Ball>& a = f.o.data;
  const model::Modes<Ball>& m = f.o.modes;
  const auto D = [&](const Ball& omega_j) { return a.omega * a.omega - omega_j * omega_j; };
  const auto sine = [&](const Ball& omega_j) { return sin(omega_j * f.pi / a.omega); };
  for (const auto& [delta, mu] : {std::pair(0.3, 2.0), std::pair(1.7, -0.4), std::pair(2.9, 0.1)}) {
    const Box<2> with = f(Box<2>(Ball(delta), Ball(mu)));
    const Box<2> without = model::two_slips_without_poles<Ball>(a, m, f.c, f.pi, Ball(delta), Ball(mu));
    CHECK(without(0).overlaps(with(0) * D(m.omega1) * D(m.omega2)));
    CHECK(without(1).overlaps(with(1) * sine(m.omega1) * sine(m.omega2)));
    CHECK(without(0).is_nonzero());
    CHECK(without(1).is_nonzero());
    // At resonance they are finite: omega = omega1, 2 omega = omega2.
    for (const Ball& omega : {m.omega1, Ball(m.omega2 / Ball(2))}) {
      model::Parameters<Ball> there = a;
      there.omega = omega;
      for (const Ball& value :
           model::two_slips_without_poles<Ball>(there, m, f.c, f.pi, Ball(delta), Ball(mu))) {
        CHECK((value.radius() - Ball(1e-10)).is_negative());
      }
    }
  }
}

TEST_CASE("a box moved by ten radii holds no zero") {
  const Orbit orbit = list_nonsticking(P("0.1"), 30).orbits[0];
  const TwoSlips f = two_slips_of(parameters_as<Ball>(P("0.1")));
  const Ball delta = orbit.motion.oscillator.data.omega * orbit.value("tau") / Ball(2);
  Box<2> moved = box_around<2>(Box<2>(delta, orbit.value("phi") + delta), 1e-20);
  CHECK(krawczyk_test<2>(f, moved).verdict.truth == Truth::proved);
  moved(1) += Ball(parse_rational("1e-19"));
  CHECK(krawczyk_test<2>(f, moved).verdict.truth == Truth::refuted);
}

TEST_CASE("degenerate data: resonance and a bad domain are refused, no load on x2 is answered") {
  CHECK_THROWS_AS((void)list_nonsticking(parse_parameters("1.5", "4", "0.1", "0", "0.6", "1"), 20),
                  DomainError);
  // omega1 = 1/2 and omega2 = 2, by (39) inverted.
  const Rational chi = model::chi_from_frequencies<Rational>(Rational(1, 2), Rational(2));
  const Rational eta = model::eta_from_frequencies<Rational>(Rational(1, 2), Rational(2));
  for (const char * omega : {"1/2", "2"}) {
    CAPTURE(omega);
    const ExactParameters a{chi, eta, Rational(1, 10), Rational(0), parse_rational(omega), Rational(1)};
    CHECK_THROWS_AS((void)list_nonsticking(a, 20), DomainError);
  }
  const OrbitList none = list_nonsticking(parse_parameters("0.3", "4", "0.1", "0.1", "1", "1"), 20);
  CHECK(none.complete());
  CHECK(none.orbits.empty());
  for (const char * omega : {"0.6", "1"}) {
    const OrbitList still =
        list_nonsticking(parse_parameters("0.3", "4", "0.1", "0", omega, *omega == '1' ? "1" : "0"), 20);
    CHECK(still.complete());
    CHECK(still.orbits.empty());
    CHECK(still.remarks == std::vector{families::Remark::nothing_drives});
  }
  CHECK(list_nonsticking(parse_parameters("0.3", "4", "0.1", "0.1", "0.6", "0"), 20).orbits.empty());
}

TEST_CASE(
    "where a multiple of omega is a natural frequency: none for odd ones and V = 0, else families, and "
    "where") {
  // omega1 = 0.7.
  const auto at = [](const Rational& omega, const Rational& V) {
    return list_nonsticking(
        {Rational(3519, 11800), Rational(13924, 3519), Rational(1, 10), V, omega, Rational(3)}, 20);
  };
  const auto beside = [&](const Rational& omega) {  // orbits that obey the law, on both sides
    std::ptrdiff_t count = 0;
    for (const char * factor : {"0.999999999", "1.000000001"}) {
      const OrbitList list = at(omega * parse_rational(factor), 0);
      count += std::ranges::count_if(
          list.orbits, [](const Orbit& orbit) { return orbit.admissible.truth != Truth::refuted; });
    }
    return count;
  };
  const OrbitList odd = at(Rational(7, 30), 0);
  CHECK(odd.complete());
  CHECK(odd.orbits.empty());
  CHECK(odd.remarks == std::vector{families::Remark::odd_resonance});
  CHECK(beside(Rational(7, 30)) == 0);
  // At an even one the orbit that is its own mirror image goes on, with its neighbours' values.
  const OrbitList even = at(Rational(7, 20), 0);
  CHECK(even.complete());
  CHECK(even.remarks == std::vector{families::Remark::closes_without_stick});
  REQUIRE(even.orbits.size() == 2);
  const auto obeys = [](const Orbit& orbit) { return orbit.admissible.truth == Truth::proved; };
  CHECK(std::ranges::count_if(even.orbits, obeys) == 1);
  CHECK(beside(Rational(7, 20)) == 2);
  const OrbitList next = at(Rational(7, 20) * parse_rational("1.000000001"), 0);
  const Orbit& orbit = *std::ranges::find_if(even.orbits, obeys);
  const Orbit& neighbour = *std::ranges::find_if(next.orbits, obeys);
  for (const char * name : {"tau", "phi", "z10", "z20", "zdot10", "ur_max"}) {
    CHECK((abs(orbit.value(name) - neighbour.value(name)) - Ball(1e-7)).is_negative());
  }
  check_closes(orbit, "1e-18");
  // On a belt that moves a little for some members of a box nothing is proved.
  CHECK_FALSE(list_orbits({&families::nonsticking(),
                           {{Rational(3519, 11800)},
                            {Rational(13924, 3519)},
                            {Rational(1, 10)},
                            {Rational(0), Rational(1, 1000000)},
                            {Rational(7, 20)},
                            {Rational(3)}},
                           {},
                           {},
                           20})
                  .complete());
  // On a moving belt tau is Theta/3 or twice that.
  CHECK(at(Rational(7, 30), Rational(1, 10)).unresolved.size() == 2);
}

TEST_CASE("simple zeros at one of whose coordinates doubles end are told from multiple ones") {
  const OrbitList list =
      list_nonsticking(parse_parameters("0.645302", "12.2157", "0.679586", "0", "0.101344", "0.0498587"), 20);
  CHECK(list.complete());
  for (const char * tau : {"55.6521559", "55.7233098"}) {
    CHECK(std::any_of(list.orbits.begin(), list.orbits.end(),
                      [&](const Orbit& orbit) { return near(orbit.value("tau"), tau, "1e-6"); }));
  }
}

TEST_CASE("digits as asked, precisions overlap") {
  const Orbit narrow = list_nonsticking(P("0.1"), 15).orbits[1];
  for (const int digits : {80, 300}) {
    const Orbit orbit = list_nonsticking(P("0.1"), digits).orbits[1];
    const WorkingPrecision precision(4L * digits);
    CHECK(orbit.value("tau").overlaps(narrow.value("tau")));
    CHECK(orbit.value("ur_max").overlaps(narrow.value("ur_max")));
    Ball bound(1);
    for (int i = 0; i < digits; ++i) {
      bound /= Ball(10);
    }
    CHECK((orbit.value("x10").radius() - bound).is_negative());
    CHECK((orbit.value("phi").radius() - bound).is_negative());
  }
}
