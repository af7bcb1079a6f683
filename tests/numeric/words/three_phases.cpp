// Complete lists of OTS and OST: against Newton's method from a dense grid through the flows, against the
// family of overshooting orbits, and against their mirror images.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/decimal.hpp"
#include "numeric/words/complete_list.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::words;

namespace {

const Word OTS = Word::parse("OTS");
const Word OST = Word::parse("OST");

using Vector6 = Eigen::Matrix<double, 6, 1>;  // tau, tau1, z10, z20, z10', phi
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// What is to vanish, by the flows alone, for the phases first, second, stick.
struct FlowClosing {
  model::Oscillator<double> o;
  double ur, total;
  PhaseKind first;

  [[nodiscard]] Vector6 operator()(const Vector6& x) const {
    const double omega = o.data.omega;
    const PhaseKind second = first == PhaseKind::slip ? PhaseKind::overshoot : PhaseKind::slip;
    const model::Vector4<double> Z0(x(2), x(3), x(4), o.data.V);
    const auto after = motion::flow<double>(o, first, x(5), Z0, x(0));
    const auto later = motion::flow<double>(o, second, x(5) + omega * x(0), after, x(1));
    const auto end = motion::flow<double>(o, PhaseKind::stick, x(5) + omega * (x(0) + x(1)),
                                          {later(0), later(1), later(2), o.data.V}, total - x(0) - x(1));
    const double at_start = first == PhaseKind::slip ? ur : -ur;
    return {after(3) - o.data.V, later(3) - o.data.V,
            end(0) - x(2),       end(1) - x(3),
            end(2) - x(4),       model::friction_at<double>(o.data, Z0, x(5)) - at_start};
  }
};

// For these times nearly: least squares in z and (cos phi, sin phi), in which all six are affine.
Vector6 nearly(const FlowClosing& f, double tau, double tau1) {
  const double half = std::acos(-1.0);
  const auto at = [&](const Eigen::Vector3d& z, double phi) {
    return Vector6(f((Vector6() << tau, tau1, z, phi).finished()));
  };
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Vector6 constant = (at(zero, 0) + at(zero, half)) / 2;
  Eigen::Matrix<double, 6, 5> A;
  for (int k = 0; k < 3; ++k) {
    A.col(k) = at(Eigen::Vector3d::Unit(k), 0) - at(zero, 0);
  }
  A.col(3) = (at(zero, 0) - at(zero, half)) / 2;
  A.col(4) = (at(zero, half / 2) - at(zero, -half / 2)) / 2;
  const Eigen::Matrix<double, 5, 1> u = A.colPivHouseholderQr().solve(-constant);
  return (Vector6() << tau, tau1, u(0), u(1), u(2), std::atan2(u(4), u(3))).finished();
}

std::optional<Vector6> newton(const FlowClosing& f, Vector6 x) {
  for (int step = 0; step < 25; ++step) {
    const Vector6 at_x = f(x);
    Matrix6 J;
    for (int k = 0; k < 6; ++k) {
      Vector6 y = x;
      const double h = 1e-7 * std::max(1.0, std::abs(x(k)));
      y(k) += h;
      J.col(k) = (f(y) - at_x) / h;
    }
    const Vector6 change = J.partialPivLu().solve(at_x);
    x -= change;
    if (!(x.norm() < 1e6)) {
      return std::nullopt;
    }
    if (change.norm() < 1e-9 * (1 + x.norm())) {
      return f(x).norm() < 1e-7 * (1 + x.norm()) ? std::optional(x) : std::nullopt;
    }
  }
  return std::nullopt;
}

// The durations of what Newton's method finds from a grid; phases shorter than this say nothing.
constexpr double shortest = 1e-3;
std::vector<std::pair<double, double>> grid_orbits(const FlowClosing& f, int steps) {
  std::vector<std::pair<double, double>> found;
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; i + j < steps; ++j) {
      const auto x = newton(f, nearly(f, f.total * i / steps, f.total * j / steps));
      if (x && (*x)(0) > shortest && (*x)(1) > shortest && (*x)(0) + (*x)(1) < f.total - shortest) {
        found.emplace_back((*x)(0), (*x)(1));
      }
    }
  }
  return found;
}

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
    const FlowClosing f{model::oscillator<double>(parameters_as<double>(q.data)),
                        scalars::scalar<double>(q.ur), 2 * std::acos(-1.0) / q.data.omega.get_d(), first};
    for (const auto& times : grid_orbits(f, 16)) {
      CAPTURE(times.first);
      CAPTURE(times.second);
      CHECK(is_listed(list, first, times, 1e-4));
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
