// What machines do: the attractors of the paper's data, proved; the same whatever the number of threads.
#include "numeric/attractors/attractors.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "numeric/attractors/settle.hpp"
#include "numeric/attractors/word_search.hpp"
#include "numeric/machines/attractors/machine_attractors.hpp"
#include "numeric/motion/stability.hpp"
#include "numeric/simulation/simulation.hpp"
#include "tests/numeric/examples.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::attractors;
using motion::StabilityKind;

namespace {

const Attractor * with_word(const AttractorList& list, const std::string& word, long periods) {
  const auto found = std::find_if(list.attractors.begin(), list.attractors.end(),
                                  [&](const Attractor& a) { return a.word == word && a.periods == periods; });
  return found == list.attractors.end() ? nullptr : &*found;
}

// Each periodic attractor is proved and stable, all starts are placed, the shares are their shares.
void check_sound(const AttractorList& list) {
  long placed = 0;
  for (const Attractor& a : list.attractors) {
    placed += a.count;
    CHECK(a.least <= a.share);
    CHECK(a.share <= a.most);
    CHECK((a.kind == Kind::periodic) == !a.word.empty());
    if (a.kind == Kind::periodic) {
      REQUIRE(a.orbit);
      CHECK(a.orbit->existence.truth == Truth::proved);
      CHECK(a.orbit->orbit.admissible.truth == Truth::proved);
      CHECK(a.orbit->orbit.stability->kind == StabilityKind::stable);
    }
  }
  CHECK(placed == list.question.starts);
}

// m1 = 0.37, m2 = 1.9 kg, k1 = 8300, k2 = 2650.5 N/m, 13.1 and 21.7 N, belt 0.213 m/s, 44.4 N at 5.15 Hz,
// near the first natural frequency: 20000 periods of the load are not enough.
words::WordQuestion slow_machine() {
  return {{Rational(5301, 21901), Rational(37, 190), Rational(26200, 21901),
           parse_rational("1.2381221429252405841"), parse_rational("0.18809228597721180517"),
           Rational(328560, 416119)},
          Rational(43400, 21901)};
}

}  // namespace

TEST_CASE("at the paper's P no start ends on its orbit, at a smaller friction all do") {
  const AttractorList list = find_attractors({{P(), parse_rational("0.2996"), 20}, 100, 1, 20000});
  check_sound(list);
  CHECK(with_word(list, "OS", 1) == nullptr);
  const Attractor * three = with_word(list, "OSOTSOST", 3);
  REQUIRE(three);
  CHECK(three->count > 50);
  CHECK(three->family.empty());
  const AttractorList other = find_attractors({{P(), parse_rational("0.25"), 20}, 100, 1, 20000});
  check_sound(other);
  const Attractor * one = with_word(other, "OS", 1);
  REQUIRE(one);
  CHECK(one->count == 100);
  CHECK(one->family == "nonsticking");
}

TEST_CASE("at the paper's O most starts end on its orbit and some on one of period 6") {
  const AttractorList list = find_attractors({{O(), parse_rational("0.4585"), 20}, 100, 1, 2000});
  check_sound(list);
  const Attractor * one = with_word(list, "OTS", 1);
  REQUIRE(one);
  CHECK(one->count > 40);
  CHECK(one->family == "overshooting");
  CHECK(with_word(list, "OTSTSTSTSTS", 6));
}

TEST_CASE("an asymmetric orbit that no family lists") {
  const ExactParameters data = parse_parameters("0.4", "10", "0.2", "1", "0.7", "2");
  const AttractorList list = find_attractors({{data, Rational(1, 2), 20}, 40, 1, 5000});
  check_sound(list);
  const Attractor * one = with_word(list, "ST", 1);
  REQUIRE(one);
  CHECK(one->family.empty());
  CHECK(near(one->orbit->orbit.motion.phases[0].duration, "4.90262", "1e-5"));
  CHECK(near(one->orbit->orbit.motion.phases[1].duration, "4.07336", "1e-5"));
}

TEST_CASE("the number of threads changes nothing") {
  const AttractorQuestion q{{P(), parse_rational("0.2996"), 20}, 60, 3, 5000};
  const AttractorList all = find_attractors(q);
  const AttractorList one = [&] {
    const Jobs limit(1);
    return find_attractors(q);
  }();
  REQUIRE(all.attractors.size() == one.attractors.size());
  CHECK(all.simulated == one.simulated);
  for (std::size_t i = 0; i < all.attractors.size(); ++i) {
    CHECK(all.attractors[i].count == one.attractors[i].count);
    CHECK(all.attractors[i].word == one.attractors[i].word);
    CHECK(all.attractors[i].state == one.attractors[i].state);
  }
}

TEST_CASE(
    "a load at a natural frequency that the friction cannot hold drives all motions beyond all bounds") {
  // omega1 = 1/2, omega2 = 2; the bound is p > 4 eta ur/pi = 0.1793 at ur = 0.03.
  const auto machine = [](const char * omega, const char * V, const char * p) {
    return words::WordQuestion{motion::parse_parameters("9/13", "169/36", "0.02", V, omega, p),
                               parse_rational("0.03"), 20};
  };
  for (const char * omega : {"1/2", "2"}) {
    for (const char * V : {"100", "0.1", "0"}) {
      for (const char * p : {"1", "0.18"}) {
        const words::WordQuestion q = machine(omega, V, p);
        const AttractorList list = find_attractors({q, 20, 1, 20000});
        REQUIRE(list.attractors.size() == 1);
        CHECK(list.attractors.front().kind == Kind::grows);
        CHECK(list.attractors.front().count == 20);
        CHECK(list.attractors.front().state.allFinite());
        CHECK(list.simulated == 0);
        CHECK(find_attractor(q, {0, 0, 0, 0}).kind == Kind::grows);
        // The simulated motion's amplitude in that mode grows as fast as the proof says, or faster.
        const auto a = motion::parameters_as<double>(q.data);
        const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
        const double det = m.lambda2 - m.lambda1;
        const double other = a.omega < 1 ? m.lambda2 : m.lambda1;
        simulation::Simulation s(a, 0.03, 0, {0, 0, 0, 0});
        const auto amplitude = [&] {
          const model::Vector4<double> X = s.state();
          return std::hypot(a.omega * (other * X(0) - X(1)), other * X(2) - X(3)) / std::abs(det);
        };
        const double begin = amplitude();
        const double rate = (a.p / 2 - 2 * a.eta * 0.03 / std::acos(-1.0)) / std::abs(det);
        for (int k = 0; k < 400; ++k) {
          s.advance(s.period());
        }
        CHECK(amplitude() - begin > rate * s.time());
      }
    }
  }
  // What the friction may hold is simulated; nothing is proved of it.
  for (const char * V : {"0.1", "0"}) {
    const words::WordQuestion q = machine("1/2", V, "0.05");
    const AttractorList list = find_attractors({q, 20, 1, 2000});
    CHECK(list.simulated > 0);
    CHECK(list.followed == 20);
    for (const Attractor& a : list.attractors) {
      CHECK(a.kind != Kind::grows);
      CHECK(a.kind != Kind::slides);
      CHECK(a.state.lpNorm<Eigen::Infinity>() < 1e3);
      if (a.kind == Kind::periodic) {
        REQUIRE(a.orbit);
        CHECK(a.orbit->existence.truth == Truth::undecided);
        CHECK(a.word == "ST");  // once, although some starts are seen to return after five periods
        CHECK(a.periods == 1);
        CHECK(a.orbit->existence.reason.find("natural frequency") != std::string::npos);
      }
    }
  }
  words::WordQuestion wrong = machine("1/2", "100", "1");
  wrong.ur = wrong.data.us;
  CHECK_THROWS_AS((void)find_attractors({wrong, 20, 1, 20000}), DomainError);
  wrong = machine("1/2", "100", "1");
  wrong.data.eta = -wrong.data.eta;
  CHECK_THROWS_AS((void)find_attractors({wrong, 20, 1, 20000}), DomainError);
  CHECK(find_attractors({machine("0.50001", "100", "1"), 2, 1, 20}).attractors.front().kind != Kind::grows);
}

TEST_CASE("Wilson's interval") {
  CHECK(wilson(0, 500).least == 0);
  CHECK(wilson(0, 500).most == doctest::Approx(0.007624).epsilon(1e-3));
  CHECK(wilson(250, 500).least == doctest::Approx(0.456352).epsilon(1e-4));
  CHECK(wilson(250, 500).most == doctest::Approx(0.543648).epsilon(1e-4));
  CHECK(wilson(500, 500).most == 1);
}

TEST_CASE("an unstable orbit is found near a state on it, and called unstable, no start ends on it") {
  const OrbitList family = listed(families::symmetric(), S(), 40);
  const Orbit * orbit = nullptr;
  for (const Orbit& o : family.orbits) {
    orbit = o.admissible.truth == Truth::proved ? &o : orbit;
  }
  REQUIRE(orbit);
  // The state when the load's phase is 0, so long after the slip began.
  const motion::Motion& m = orbit->motion;
  const Ball after = motion::period(m) - m.phases[0].load / m.oscillator.data.omega;
  const Ball stuck = after - m.phases[0].duration;
  const model::Vector4<Ball> Z =
      stuck.is_positive() ? motion::state(m, 1, stuck) : motion::state(m, 0, after);
  const model::Vector4<double> X(Ball(Z(0) + m.oscillator.d0(0)).approximate(),
                                 Ball(Z(1) + m.oscillator.d0(1)).approximate(), Z(2).approximate(),
                                 Z(3).approximate());
  const Rational ur = parse_rational(to_text(orbit->value("ur"), 17).mid);
  const WordOrbits found = find_word_orbits({{S(), ur, 20}, words::Word::parse("TS"), 1, X});
  REQUIRE(found.orbits.size() == 1);
  CHECK(found.orbits[0].orbit.admissible.truth == Truth::proved);
  CHECK(found.orbits[0].orbit.stability->kind == StabilityKind::unstable);
  CHECK(found.seen.empty());
  // A simulation of it seems to return for hundreds of periods.
  const Attractor end = find_attractor({S(), ur, 20}, X, 5000);
  CHECK(end.word != "ST");
  CHECK((end.kind != Kind::periodic || end.orbit->orbit.stability->kind == StabilityKind::stable));
}

TEST_CASE("where there is no orbit of the word it is said what was met") {
  const WordOrbits far = find_word_orbits(
      {{P(), parse_rational("0.25"), 20}, words::Word::parse("ST"), 1, model::Vector4<double>(9, 9, 9, 9)});
  CHECK(far.orbits.empty());
  CHECK(far.seen == "the motion from there settles on OS with the period 1");
  const WordOrbits none =
      find_word_orbits({{P(), parse_rational("0.25"), 20}, words::Word::parse("OSOSOT"), 1, {}});
  CHECK(none.orbits.empty());
  CHECK_FALSE(none.complete());
  CHECK(none.seen == "100 random starts end on: OS with the period 1");
  const WordOrbits all =
      find_word_orbits({{P(), parse_rational("0.25"), 20}, words::Word::parse("ST"), 1, {}});
  CHECK(all.complete());
  CHECK(all.seen == "x2' <= V <= 0 all along, so x2 falls and does not return");
}

TEST_CASE("a word that repeats a shorter one is answered with that one's orbit") {
  const WordOrbits found = find_word_orbits({{P(), parse_rational("0.25"), 20},
                                             words::Word::parse("SOSO"),
                                             2,
                                             model::Vector4<double>(0.5, 1, 0, 0)});
  REQUIRE(found.orbits.size() == 1);
  CHECK(found.orbits[0].word.letters() == "OS");
  CHECK(found.orbits[0].periods == 1);
  // Two turns of the word in one period are another matter.
  CHECK(find_word_orbits({{P(), parse_rational("0.25"), 20}, words::Word::parse("SOSO"), 1, {}})
            .orbits.empty());
}

TEST_CASE("what nears a stable orbit slowly is not called quasi-periodic") {
  const AttractorList list = find_attractors({slow_machine(), 10, 1, 20000});
  check_sound(list);
  REQUIRE(list.attractors.size() == 1);
  CHECK(list.attractors[0].word == "OS");
  CHECK(list.followed == 10);
  CHECK(list.simulated == 10 * 20000);
}

TEST_CASE("as a machine, the oscillator does the same from the same starts, also what it nears slowly") {
  const words::WordQuestion leaving{P(), parse_rational("0.2996"), 20};
  for (const words::WordQuestion& q : {slow_machine(), leaving}) {
    const auto starts = random_starts_in(start_box(motion::parameters_as<double>(q.data)), 20, 1);
    const AttractorList list = find_attractors_from({q, 20, 1, 20000}, starts);
    const machines::Machine machine{model::friction_oscillator<Rational>(q.data, q.ur), false};
    const machines::MachineAttractors same =
        machines::find_attractors_from({.machine = machine}, {starts.begin(), starts.end()});
    CHECK(same.followed == 20);
    CHECK(same.simulated == list.simulated);
    REQUIRE(same.attractors.size() == list.attractors.size());
    for (std::size_t i = 0; i < list.attractors.size(); ++i) {
      const machines::MachineAttractor& a = same.attractors[i];
      CHECK(a.kind == list.attractors[i].kind);
      CHECK(a.word == list.attractors[i].word);
      CHECK(a.periods == list.attractors[i].periods);
      CHECK(std::ranges::is_permutation(a.members, list.attractors[i].members));
      CHECK(a.orbit.has_value() == list.attractors[i].orbit.has_value());
      CHECK((!a.orbit || a.orbit->stability->kind == StabilityKind::stable));
    }
  }
}

TEST_CASE("a motion nears a stable orbit at the pace of its multiplier, and nothing else") {
  const words::WordQuestion machine = slow_machine();
  const auto data = motion::parameters_as<double>(machine.data);
  const AttractorList list = find_attractors({machine, 1, 1, 20000});
  REQUIRE(list.attractors.front().word == "OS");
  const model::Vector4<double> X = list.attractors.front().state;
  simulation::Simulation near(data, machine.ur.get_d(), 0, X + model::Vector4<double>(1, 1, 0, 0));
  near.advance(20000 * near.period());  // until what falls faster is gone
  const double mu = 0.999985;
  const Follower follower(data, machine.ur.get_d(), near.state());
  CHECK(follower.nears(X, mu, 1, 5000));
  CHECK_FALSE(follower.nears(X, 0.9999, 1, 5000));    // too slow for that orbit
  CHECK_FALSE(follower.nears(X, 0.999998, 1, 5000));  // too fast
  CHECK_FALSE(follower.nears(1.1 * X, mu, 1, 5000));
  const auto once = follower.steady_word();
  REQUIRE(once);
  CHECK(once->word == "OS");
  CHECK(once->guess.periods == 1);
}

TEST_CASE("without a load no orbit is alone") {
  ExactParameters data = O();
  data.p = 0;
  CHECK_THROWS_AS((void)find_attractors({{data, Rational(1, 2), 20}, 10, 1, 100}), DomainError);
}

TEST_CASE("the paper's P is left by a disturbance a little larger than its contact margin") {
  const OrbitList list = listed(families::nonsticking(), P(), 20, {}, parse_rational("0.2996"));
  const auto P_orbit = std::find_if(list.orbits.begin(), list.orbits.end(),
                                    [](const Orbit& o) { return o.admissible.truth == Truth::proved; });
  REQUIRE(P_orbit != list.orbits.end());
  const std::optional<Contact> contact = contact_of(P_orbit->conditions);
  REQUIRE(contact.has_value());
  CHECK(near(contact->margin, "2.8859e-4", "1e-8"));
  // From the beginning of the orbit on to the next time when the load's phase is 0.
  const double phi = P_orbit->value("phi").approximate();
  const auto end = [&](double disturbance) {
    const model::Vector4<double> X(P_orbit->value("x10").approximate() + disturbance,
                                   P_orbit->value("x20").approximate(),
                                   P_orbit->value("xdot10").approximate(), 0);
    simulation::Simulation motion(parameters_as<double>(P()), 0.2996, phi, X);
    motion.advance((2 * std::acos(-1.0) - phi) / 0.6);
    return find_attractor({P(), parse_rational("0.2996"), 20}, motion.state()).word;
  };
  CHECK(end(1e-4) == "OS");
  CHECK(end(1e-3) == "OSOTSOST");
}
