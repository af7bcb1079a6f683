// Complete lists of ST: against an independent dense search through the flows, and against the families.
#include "numeric/words/stick_slip.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/words/pure_slip.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::words;

namespace {

using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

// The closing conditions and r = ur by the flows alone, at (z10, z20, z10') and the load's phase phi.
Vector5 conditions(const model::Oscillator<double>& o, double ur, double total, double tau,
                   const Eigen::Vector3d& z, double phi) {
  const model::Vector4<double> Z0(z(0), z(1), z(2), o.data.V);
  const model::Vector4<double> after = motion::flow<double>(o, PhaseKind::slip, phi, Z0, tau);
  const model::Vector4<double> end = motion::flow<double>(
      o, PhaseKind::stick, phi + o.data.omega * tau, {after(0), after(1), after(2), o.data.V}, total - tau);
  return {end(0) - z(0), end(1) - z(1), end(2) - z(2), after(3) - o.data.V,
          model::friction_at<double>(o.data, Z0, phi) - ur};
}

// They are affine in z and in cos phi, sin phi: c² + s² - 1 of their only solution, and the determinant.
std::pair<double, double> circle(const model::Oscillator<double>& o, double ur, double total, double tau) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const double half = std::acos(-1.0);
  const auto at = [&](double phi) { return conditions(o, ur, total, tau, zero, phi); };
  const Vector5 constant = (at(0) + at(half)) / 2;
  Matrix5 A;
  for (int k = 0; k < 3; ++k) {
    A.col(k) = conditions(o, ur, total, tau, Eigen::Vector3d::Unit(k), 0) - at(0);
  }
  A.col(3) = (at(0) - at(half)) / 2;
  A.col(4) = (at(half / 2) - at(-half / 2)) / 2;
  const Vector5 u = A.fullPivLu().solve(-constant);
  return {u(3) * u(3) + u(4) * u(4) - 1, A.determinant()};
}

// The zeros of the dense search, up to their spacing.
std::vector<double> dense_zeros(const WordQuestion& q, long n, int steps) {
  const auto o = model::oscillator<double>(parameters_as<double>(q.data));
  const double ur = scalars::scalar<double>(q.ur);
  const double total = 2 * std::acos(-1.0) * static_cast<double>(n) / o.data.omega;
  std::vector<double> zeros;
  auto before = circle(o, ur, total, total / steps / 2);
  for (int k = 1; k < steps; ++k) {
    const double tau = total * (k + 0.5) / steps;
    const auto now = circle(o, ur, total, tau);
    // A change of sign through a pole is none.
    if (before.first * now.first < 0 && before.second * now.second > 0) {
      zeros.push_back(tau);
    }
    before = now;
  }
  return zeros;
}

bool has_near(const std::vector<double>& all, double tau, double distance) {
  return std::any_of(all.begin(), all.end(), [&](double x) { return std::abs(x - tau) < distance; });
}

}  // namespace

TEST_CASE("the list of ST holds what an independent dense search finds, n = 1, 2, 3") {
  RandomData random;
  CAPTURE(random.seed());
  int found = 0;
  int complete = 0;
  for (int round = 0; round < 12; ++round) {
    const ExactParameters data = random.parameters();
    const WordQuestion q{data, data.us * random.between(1.1, 6), 20};
    const long n = 1 + round % 3;
    CAPTURE(to_string(data));
    CAPTURE(stickslip::to_string(q.ur));
    CAPTURE(n);
    const WordList list = all_stick_slip_orbits(q, n);
    const double total = 2 * std::acos(-1.0) * static_cast<double>(n) / data.omega.get_d();
    constexpr int steps = 4000;
    std::vector<double> listed;
    for (const WordOrbit& orbit : list.orbits) {
      listed.push_back(orbit.orbit.motion.phases[0].duration.approximate());
    }
    for (const double tau : dense_zeros(q, n, steps)) {
      const bool open =
          std::any_of(list.unresolved.begin(), list.unresolved.end(), [&](const OpenPart& part) {
            return abs(part.tau - Ball(tau)).lower().approximate() <= 2 * total / steps;
          });
      CHECK((open || has_near(listed, tau, 2 * total / steps)));
    }
    found += static_cast<int>(listed.size());
    complete += list.unresolved.empty() ? 1 : 0;
  }
  CHECK(found > 0);
  CHECK(complete >= 6);
}

TEST_CASE("at the friction of the paper's S there are two, one of them born in a fold") {
  const OrbitList family = listed(families::symmetric(), S(), 40);
  const WordQuestion q{S(), parse_rational("0.16096526517987741"), 20};
  const WordList list = all_stick_slip_orbits(q, 1);
  CHECK(list.unresolved.empty());
  REQUIRE(list.orbits.size() == 2);
  CHECK(near(list.orbits[0].orbit.motion.phases[0].duration, "7.6267944317", "1e-9"));
  CHECK(near(list.orbits[0].orbit.motion.phases[1].duration, "2.84518108", "1e-8"));
  // The other is the symmetric one, at whose friction to 17 digits we are.
  bool same = false;
  for (const Orbit& orbit : family.orbits) {
    const Ball difference = orbit.value("tau") - list.orbits[1].orbit.motion.phases[0].duration;
    same = same || (orbit.admissible.truth == Truth::proved && (abs(difference) - Ball(1e-12)).is_negative());
  }
  CHECK(same);
  // Before the fold there is none, after it there are two.
  CHECK(all_stick_slip_orbits({S(), parse_rational("0.155"), 20}, 1).orbits.empty());
  CHECK(all_stick_slip_orbits({S(), parse_rational("0.1605"), 20}, 1).orbits.size() == 2);
}

TEST_CASE("every symmetric orbit is in the list at its own friction") {
  RandomData random;
  CAPTURE(random.seed());
  int compared = 0;
  for (int round = 0; round < 6; ++round) {
    const ExactParameters data = random.parameters();
    CAPTURE(to_string(data));
    for (const Orbit& orbit : listed(families::symmetric(), data, 40).orbits) {
      const Rational ur = parse_rational(to_text(orbit.value("ur"), 35).mid);
      if (ur <= data.us) {
        continue;
      }
      const WordList list = all_stick_slip_orbits({data, ur, 20}, 1);
      const auto near_it = [&](const Ball& tau) {
        return (abs(tau - orbit.value("tau")).lower() - Ball(1e-9)).is_negative();
      };
      const bool there =
          std::any_of(list.orbits.begin(), list.orbits.end(),
                      [&](const WordOrbit& o) { return near_it(o.orbit.motion.phases[0].duration); }) ||
          std::any_of(list.unresolved.begin(), list.unresolved.end(),
                      [&](const OpenPart& part) { return near_it(part.tau); });
      CHECK(there);
      ++compared;
    }
  }
  CHECK(compared > 0);
}

TEST_CASE("on a belt that stands still no complete list of ST is promised") {
  CHECK_THROWS_AS((void)all_stick_slip_orbits({P(), Rational(3, 10), 20}, 1), DomainError);
}

TEST_CASE(
    "some motions slip for ever at S and O, and nothing is said at P, where the load alone is too fast") {
  CHECK(pure_slip(S()).exists.truth == Truth::proved);
  CHECK(near(pure_slip(S()).forced, "0.54", "0.01"));
  CHECK(pure_slip(O()).exists.truth == Truth::proved);
  CHECK(near(pure_slip(O()).forced, "0.22", "0.01"));
  CHECK(pure_slip(P("0.1")).exists.truth == Truth::undecided);
}
