// Complete lists of ST: against an independent dense search through the flows, and against the families.
// Words that no motion goes through, and words without a stick.
#include "numeric/words/complete_list.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/motion/closing.hpp"
#include "numeric/simulation/simulation.hpp"
#include "numeric/words/pure.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::words;

namespace {

const Word ST = Word::parse("ST");

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

// They are affine in z and in cos phi, sin phi: c² + s² - 1 of their only solution, and the determinant;
// zeros where doubles cannot tell it, as at short slips.
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
  const Eigen::FullPivLU<Matrix5> lu(A);
  if (lu.rcond() < 1e-10) {
    return {0, 0};
  }
  const Vector5 u = lu.solve(-constant);
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
  // At the friction of the paper's S there are two, and the list is complete.
  std::vector<WordQuestion> questions{{S(), parse_rational("0.16096526517987741"), 20}};
  while (questions.size() < 12) {
    const ExactParameters data = random.parameters();
    questions.push_back({data, data.us * random.between(1.1, 6), 20});
  }
  int found = 0;
  int complete = 0;
  for (std::size_t round = 0; round < questions.size(); ++round) {
    const WordQuestion& q = questions[round];
    const long n = 1 + static_cast<long>(round % 3);
    CAPTURE(to_string(q.data));
    CAPTURE(stickslip::to_string(q.ur));
    CAPTURE(n);
    const WordList list = all_orbits(q, ST, n);
    const double total = 2 * std::acos(-1.0) * static_cast<double>(n) / q.data.omega.get_d();
    constexpr int steps = 4000;
    std::vector<double> listed;
    for (const WordOrbit& orbit : list.orbits) {
      listed.push_back(orbit.orbit.motion.phases[0].duration.approximate());
    }
    for (const double tau : dense_zeros(q, n, steps)) {
      const bool open =
          std::any_of(list.unresolved.begin(), list.unresolved.end(), [&](const families::Unresolved& part) {
            return abs(part.where[0].value - Ball(tau)).lower().approximate() <= 2 * total / steps;
          });
      CHECK((open || has_near(listed, tau, 2 * total / steps)));
    }
    found += static_cast<int>(listed.size());
    complete += list.unresolved.empty() ? 1 : 0;
  }
  CHECK(found > 0);
  CHECK(complete > 0);
}

TEST_CASE("at the friction of the paper's S there are two, one of them born in a fold") {
  const OrbitList family = listed(families::symmetric(), S(), 40);
  const WordQuestion q{S(), parse_rational("0.16096526517987741"), 20};
  const WordList list = all_orbits(q, ST, 1);
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
  CHECK(all_orbits({S(), parse_rational("0.155"), 20}, ST, 1).orbits.empty());
  CHECK(all_orbits({S(), parse_rational("0.1605"), 20}, ST, 1).orbits.size() == 2);
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
      const WordList list = all_orbits({data, ur, 20}, ST, 1);
      const auto near_it = [&](const Ball& tau) {
        return (abs(tau - orbit.value("tau")).lower() - Ball(1e-9)).is_negative();
      };
      const bool there =
          std::any_of(list.orbits.begin(), list.orbits.end(),
                      [&](const WordOrbit& o) { return near_it(o.orbit.motion.phases[0].duration); }) ||
          std::any_of(list.unresolved.begin(), list.unresolved.end(),
                      [&](const families::Unresolved& part) { return near_it(part.where[0].value); });
      CHECK(there);
      ++compared;
    }
  }
  CHECK(compared > 0);
}

// Not at omega = 1, where the load acts on no equation and the dense search sees noise.
TEST_CASE(
    "with n/omega a whole number lists of ST are complete, and no orbit slips for less than half a turn") {
  RandomData random;
  CAPTURE(random.seed());
  int complete = 0;
  for (int round = 0; round < 6; ++round) {
    ExactParameters data = random.parameters();
    const long n = 1 + round % 2;
    data.omega = Rational(n, 3 + 2 * (round % 3));
    CAPTURE(to_string(data));
    const WordQuestion q{data, data.us * random.between(1.1, 6), 20};
    const WordList list = all_orbits(q, ST, n);
    if (!list.unresolved.empty()) {  // an orbit at the edge of its conditions, say: about one list of sixty
      continue;
    }
    ++complete;
    const double total = 2 * std::acos(-1.0) * static_cast<double>(n) / q.data.omega.get_d();
    constexpr int steps = 4000;
    for (const double tau : dense_zeros(q, n, steps)) {
      const bool listed = std::any_of(list.orbits.begin(), list.orbits.end(), [&](const WordOrbit& o) {
        return std::abs(o.orbit.motion.phases[0].duration.approximate() - tau) < 2 * total / steps;
      });
      CHECK(listed);
    }
  }
  CHECK(complete >= 3);
}

TEST_CASE("no motion goes through a word in which x2 only falls or only rises") {
  const WordQuestion still{P(), Rational(3, 10), 20};
  CHECK(all_orbits(still, ST, 1).why_none.find("falls") != std::string::npos);
  CHECK(all_orbits(still, Word::parse("OT"), 1).why_none.find("rises") != std::string::npos);
  const WordQuestion moving{P("0.1"), Rational(3, 10), 20};
  CHECK(all_orbits(moving, Word::parse("OT"), 2).why_none.find("rises") != std::string::npos);
  CHECK(why_no_motion(Rational(1, 10), ST).empty());
  CHECK(why_no_motion(Rational(0), Word::parse("OTS")).empty());
  CHECK(why_no_motion(Rational(-1), Word::parse("OT")).empty());
}

TEST_CASE("the friction of a motion through OT, whose stick ends with r = -ur, is ur") {
  const WordQuestion q{motion::parse_parameters("0.57", "4.97", "0.074", "-0.132", "1.117", "1.33"),
                       parse_rational("0.097"), 20};
  const WordList list = all_orbits(q, Word::parse("OT"), 1);
  REQUIRE(list.orbits.size() == 1);
  CHECK(families::is_admissible(list.orbits[0].orbit));
  CHECK(motion::taken_as_closed(list.orbits[0].orbit.motion).friction[0].contains(q.ur));
}

TEST_CASE("OS: the orbit of the family, at any friction, and none of two periods") {
  const WordQuestion q{P(), parse_rational("0.2996"), 20};
  const Word OS = Word::parse("OS");
  const WordList list = all_orbits(q, OS, 1);
  CHECK(list.unresolved.empty());
  const OrbitList family = listed(families::nonsticking(), P(), 20, {}, q.ur);
  REQUIRE(list.orbits.size() == family.orbits.size());
  long admissible = 0;
  for (const WordOrbit& orbit : list.orbits) {
    const Ball& slip = orbit.orbit.motion.phases[1].duration;
    const bool same = std::any_of(family.orbits.begin(), family.orbits.end(), [&](const Orbit& o) {
      return o.value("tau").overlaps(slip) && o.admissible.truth == orbit.orbit.admissible.truth;
    });
    CHECK(same);
    admissible += orbit.orbit.admissible.truth == Truth::proved ? 1 : 0;
  }
  CHECK(admissible == 1);
  const WordList twice = all_orbits(q, OS, 2);
  CHECK(twice.orbits.empty());
  CHECK(twice.unresolved.empty());
  CHECK_FALSE(twice.why_none.empty());
  // At omega = 1 the load does not act on x2.
  ExactParameters idle = P();
  idle.omega = 1;
  const WordList still = all_orbits({idle, q.ur, 20}, OS, 1);
  CHECK(still.orbits.empty());
  CHECK(still.unresolved.empty());
  CHECK(still.why_none.find("friction") != std::string::npos);
  // Two crossings more in a period are not looked for, but that motion would be a second one.
  const Word OSOS = Word::parse("OSOS");
  CHECK(has_complete_list(q, OSOS, 2));
  CHECK(has_complete_list(q, OSOS, 1));
  CHECK(all_orbits(q, OSOS, 1).why_none.find("no other motion") != std::string::npos);
  // Where the orbit of OS breaks (25) nothing is known.
  CHECK_FALSE(has_complete_list({P(), parse_rational("0.31"), 20}, OSOS, 1));
}

TEST_CASE("OS over two periods stays open where twice a natural frequency is a multiple of the load's") {
  // omega1 = 1/2, omega2 = 3/2.
  ExactParameters data{Rational(5, 8),  Rational(12, 5), Rational(1, 10),
                       Rational(1, 10), Rational(1),     Rational(1)};
  const WordQuestion q{data, Rational(1, 5), 20};
  const Word OS = Word::parse("OS");
  CHECK(all_orbits(q, OS, 1).unresolved.empty());
  const WordList open = all_orbits(q, OS, 2);
  REQUIRE(open.unresolved.size() == 1);
  CHECK(open.unresolved[0].reason.find("2 omega1 = 1 omega") != std::string::npos);
  CHECK(all_orbits(q, OS, 3).unresolved.empty());
}

TEST_CASE("some motions slip for ever at S and O, and none at P, where the load alone is too fast") {
  CHECK(pure_slip(S()).exists.truth == Truth::proved);
  CHECK(near(pure_slip(S()).forced, "0.54", "0.01"));
  CHECK(pure_slip(O()).exists.truth == Truth::proved);
  CHECK(near(pure_slip(O()).forced, "0.22", "0.01"));
  CHECK(pure_slip(P("0.1")).exists.truth == Truth::refuted);
  CHECK(pure_slip(P()).exists.truth == Truth::refuted);
  // The third harmonic of the load may take from its peaks: omega1 = 3 omega.
  ExactParameters third{Rational(5, 8),  Rational(12, 5), Rational(1, 10),
                        Rational(1, 10), Rational(1, 6),  Rational(9)};
  CHECK((pure_slip(third).forced - Ball(third.V)).is_positive());
  CHECK(pure_slip(third).exists.truth == Truth::undecided);
  third.omega = Rational(7, 40);
  CHECK(pure_slip(third).exists.truth == Truth::refuted);
}

TEST_CASE("overshoots for ever are slips for ever on a belt that runs backwards") {
  ExactParameters back = S();
  back.V = -back.V;
  CHECK(pure_slip(S(), PhaseKind::overshoot).exists.truth == Truth::refuted);
  CHECK(pure_slip(back, PhaseKind::slip).exists.truth == Truth::refuted);
  CHECK(pure_slip(back, PhaseKind::overshoot).exists.truth == Truth::proved);
  CHECK(pure_slip(back, PhaseKind::overshoot).room.overlaps(pure_slip(S()).room));
}

TEST_CASE(
    "a motion slips for ever where the free amplitudes leave room, and touches the belt where they do not") {
  const auto a = parameters_as<double>(S());
  const double room = pure_slip(S()).room.approximate();
  const auto o = model::oscillator<double>(a);
  const auto slips = [&](double amplitude) {
    // The first mode alone, with this amplitude of x2', begun at rest.
    const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
    const double x2 = amplitude / m.omega1;
    simulation::Simulation motion(a, 0.16, 0,
                                  {o.d0(0) + o.Q(0) + x2 / m.lambda1, o.d0(1) + o.Q(1) + x2, 0, 0});
    std::vector<simulation::Transition> log;
    for (int k = 0; k < 2000; ++k) {
      motion.advance(motion.period(), &log);
    }
    return log.empty();
  };
  CHECK(slips(0.99 * room));
  CHECK_FALSE(slips(1.02 * room));
}

TEST_CASE("motions that stick for ever: at P's data, not on a moving belt, and a simulation agrees") {
  const Rational ur = parse_rational("0.2996");
  CHECK(pure_stick(P(), ur).truth == Truth::proved);
  CHECK(pure_stick(P("0.1"), ur).truth == Truth::refuted);
  CHECK(pure_stick(P(), Rational(1, 4)).truth == Truth::undecided);  // p/eta = ur
  CHECK(pure_stick(P(), Rational(1, 5)).truth == Truth::refuted);
  ExactParameters half = P();
  half.omega = Rational(1, 2);  // the free oscillation may take from the load's peaks
  CHECK(pure_stick(half, Rational(1, 5)).truth == Truth::undecided);
  const auto sticks = [&](double amplitude, double x2) {
    const auto a = parameters_as<double>(P());
    simulation::Simulation motion(a, 0.2996, 0, {a.chi * x2 + amplitude, x2, 0, 0});
    std::vector<simulation::Transition> log;
    for (int k = 0; k < 500; ++k) {
      motion.advance(motion.period(), &log);
    }
    return log.empty() && motion.phase() == PhaseKind::stick;
  };
  // chi (1 - chi) |x2| + chi a < ur - p/eta = 0.0496
  CHECK(sticks(0.09, 0.1));        // 0.048
  CHECK_FALSE(sticks(0.12, 0.1));  // 0.057
}
