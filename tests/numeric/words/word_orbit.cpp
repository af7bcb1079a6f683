// Orbits of words: the paper's orbits come out the same, long words are proved, and what is false is refuted.
#include "numeric/words/word_orbit.hpp"

#include <doctest/doctest.h>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/machines/orbits/chain_proof.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"
#include "tests/numeric/words/guesses.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::words;
using machines::ChainProof;
using machines::MachineQuestion;
using machines::Node;
using machines::Nodes;

namespace {

// The admissible orbit of the list, of which there is one.
const Orbit& admissible_one(const OrbitList& list) {
  const auto is_it = [](const Orbit& orbit) { return orbit.admissible.truth == Truth::proved; };
  REQUIRE(std::count_if(list.orbits.begin(), list.orbits.end(), is_it) == 1);
  return *std::find_if(list.orbits.begin(), list.orbits.end(), is_it);
}

// The middle of a ball to as many digits, exactly.
Rational rounded(const Ball& ball, int digits) {
  return parse_rational(to_text(ball, digits).mid);
}

// The values, the verdict and the stability are those of the family, to so many digits.
void check_same(const Orbit& orbit, const WordOrbit& found, const char * error) {
  REQUIRE(found.existence.truth == Truth::proved);
  for (const NamedBall& value : found.orbit.values) {
    CAPTURE(std::string(value.name));
    const Ball difference = value.value - orbit.value(value.name);
    CHECK((abs(difference) - Ball(parse_rational(error))).is_negative());
  }
  CHECK(found.orbit.admissible.truth == orbit.admissible.truth);
  REQUIRE(found.orbit.stability.has_value() == orbit.stability.has_value());
  if (!orbit.stability) {
    return;
  }
  CHECK(found.orbit.stability->kind == orbit.stability->kind);
  for (std::size_t i = 0; i < 4; ++i) {
    const motion::ComplexBall& a = orbit.stability->multipliers[i];
    const motion::ComplexBall& b = found.orbit.stability->multipliers[i];
    CHECK((abs(a.re - b.re) - Ball(1e-15)).is_negative());
    CHECK((abs(a.im - b.im) - Ball(1e-15)).is_negative());
  }
}

// The word's first letter in the alphabet may not be the family's first phase: the family's orbit, from
// there.
Orbit from_phase(Orbit orbit, std::size_t k) {
  motion::Motion& m = orbit.motion;
  std::rotate(m.phases.begin(), m.phases.begin() + static_cast<std::ptrdiff_t>(k), m.phases.end());
  m.phases.front().load -=
      Ball(2) * Ball::pi() * Ball(std::round(m.phases.front().load.approximate() / (2 * std::acos(-1.0))));
  const Ball ur = orbit.value("ur");
  orbit.values = families::start_values(m);
  orbit.values.push_back({"ur", ur});
  return orbit;
}

}  // namespace

TEST_CASE("the paper's orbits come out of their words with the same digits") {
  const WorkingPrecision scope(300);
  const int digits = 50;
  struct Case {
    const char * name;
    const Family& family;
    ExactParameters data;
    std::optional<Rational> phi, ur;
    std::size_t first;
    const char * word;
  };
  for (const Case& c : {Case{"S", families::symmetric(), S(), {}, {}, 0, "ST"},
                        Case{"O", families::overshooting(), O(), Rational(0), {}, 1, "OTS"},
                        Case{"P", families::nonsticking(), P(), {}, parse_rational("0.2996"), 1, "OS"}}) {
    CAPTURE(std::string(c.name));
    const OrbitList list = listed(c.family, c.data, 80, c.phi, c.ur);
    REQUIRE_FALSE(list.orbits.empty());
    int admissible = 0;
    for (const Orbit& orbit : list.orbits) {
      if (orbit.admissible.truth != Truth::proved) {
        continue;
      }
      ++admissible;
      const WordQuestion q{c.data, rounded(orbit.value("ur"), 70), digits};
      const WordOrbit found = prove_word_orbit(q, guess_of(orbit.motion));
      CHECK(found.word.letters() == c.word);
      CHECK(found.periods == 1);
      check_same(from_phase(orbit, c.first), found, "1e-39");
    }
    CHECK(admissible > 0);
  }
}

TEST_CASE("a box that the closed chain does not lie in passes no test") {
  const Orbit orbit = admissible_one(listed(families::overshooting(), O(), 60, Rational(0)));
  const motion::Motion& m = orbit.motion;
  const model::Vector2<Ball>& d0 = m.oscillator.d0;
  MachineQuestion q{{model::friction_oscillator<Rational>(O(), rounded(orbit.value("ur"), 50))}, {}, 1};
  Nodes nodes;
  for (const motion::Phase& phase : m.phases) {
    q.pieces.push_back({phase.kind});
    nodes.emplace_back(4);
    nodes.back() << m.phases.front().load / m.oscillator.data.omega + phase.start, phase.Z(0) + d0(0),
        phase.Z(1) + d0(1), phase.Z(2);
  }
  const ChainProof proof = prove_chain(q, nodes, 128, 128);
  REQUIRE(proof.verdict.truth == Truth::proved);
  for (Node& u : nodes) {
    u = Node(u.unaryExpr([](const Ball& x) { return x.midpoint(); }));
  }
  CHECK(newton_test(q, nodes, -40).verdict.truth == Truth::proved);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (int j = 0; j < 4; ++j) {
      Nodes moved = nodes;
      moved[i](j) += Ball(0x1p-30);
      for (const long exponent : {-16, -20, -24, -28, -34, -40, -60}) {
        const ChainProof wide = newton_test(q, moved, exponent);
        const auto contains_it = [&](const Nodes& box) {
          for (std::size_t k = 0; k < nodes.size(); ++k) {
            for (int l = 0; l < 4; ++l) {
              if (!box[k](l).contains(proof.nodes[k](l).midpoint())) {
                return false;
              }
            }
          }
          return true;
        };
        CHECK((wide.verdict.truth != Truth::proved || (contains_it(wide.unique) && contains_it(wide.nodes))));
        CHECK((exponent > -34 || wide.verdict.truth != Truth::proved));
      }
    }
  }
}

TEST_CASE("conditions of words say what those of the families say, also where these are refuted") {
  RandomData random;
  CAPTURE(random.seed());
  int compared = 0;
  int refuted = 0;
  for (int round = 0; round < 60 && compared < 25; ++round) {
    const ExactParameters data = random.parameters();
    CAPTURE(to_string(data));
    for (const Orbit& orbit : listed(families::symmetric(), data, 40).orbits) {
      const Rational ur = rounded(orbit.value("ur"), 35);
      if (ur <= data.us || orbit.admissible.truth == Truth::undecided) {
        continue;
      }
      const WordOrbit found = prove_word_orbit({data, ur, 20}, guess_of(orbit.motion));
      if (found.existence.truth != Truth::proved) {
        continue;
      }
      ++compared;
      refuted += orbit.admissible.truth == Truth::refuted ? 1 : 0;
      CHECK(found.orbit.admissible.truth == orbit.admissible.truth);
    }
  }
  CHECK(compared > 5);
  CHECK(refuted > 0);
}

TEST_CASE("an orbit taken twice or three times is found to be the shorter one") {
  const OrbitList list = listed(families::overshooting(), O(), 30, Rational(0));
  const Orbit& orbit = admissible_one(list);
  const WordQuestion q{O(), rounded(orbit.value("ur"), 25), 20};
  for (const long again : {2, 3, 6}) {
    const WordOrbit found = prove_word_orbit(q, guess_of(orbit.motion, 1, again));
    REQUIRE(found.existence.truth == Truth::proved);
    CHECK(found.word.letters() == "OTS");
    CHECK(found.periods == 1);
    CHECK(found.orbit.motion.phases.size() == 3);
  }
}

TEST_CASE("eight phases over three periods") {
  const WordQuestion q{P(), parse_rational("0.2996"), 20};
  const WordOrbit found = prove_word_orbit(q, simulated(q, {0.5, 1, 0, -0.2}, 3000, 3));
  REQUIRE(found.existence.truth == Truth::proved);
  CHECK(found.word.letters() == "OSOTSOST");
  CHECK(found.periods == 3);
  CHECK(found.orbit.admissible.truth == Truth::proved);
  CHECK(found.orbit.stability->kind == motion::StabilityKind::stable);
}

TEST_CASE("with a friction at rest above the largest that an orbit allows its crossings are refuted") {
  const OrbitList list = listed(families::nonsticking(), P(), 30);
  const Orbit& orbit = admissible_one(list);
  const Rational largest = rounded(orbit.value("ur_max"), 20);
  const Rational little(1, 1000000000000);
  const WordOrbit below = prove_word_orbit({P(), largest - little, 20}, guess_of(orbit.motion));
  REQUIRE(below.existence.truth == Truth::proved);
  CHECK(below.orbit.admissible.truth == Truth::proved);
  const WordOrbit above = prove_word_orbit({P(), largest + little, 20}, guess_of(orbit.motion));
  REQUIRE(above.existence.truth == Truth::proved);
  CHECK(above.orbit.admissible.truth == Truth::refuted);
  for (std::size_t k = 0; k < above.asked.size(); ++k) {
    const bool crossing = above.asked[k].id == "crossing";
    CHECK(above.orbit.conditions[k].verdict.truth == (crossing ? Truth::refuted : Truth::proved));
  }
}

TEST_CASE("a word of 208 phases over 175 periods is proved, admissible and stable") {
  const WordQuestion q{S(), parse_rational("0.16096526517987741"), 20};
  const WordOrbit found = prove_word_orbit(q, simulated(q, {1, 1.5, 0, 0.5}, 12000, 175));
  REQUIRE(found.existence.truth == Truth::proved);
  CHECK(found.word.size() == 208);
  CHECK(found.periods == 175);
  CHECK(found.orbit.admissible.truth == Truth::proved);
  CHECK(found.orbit.stability->kind == motion::StabilityKind::stable);
}

TEST_CASE("nothing is proved from a motion that does not close, or over another number of periods") {
  const WordQuestion q{S(), parse_rational("0.16096526517987741"), 20};
  const MachineGuess open = simulated(q, {1, 1.5, 0, 0.5}, 200, 7);
  const WordOrbit found = prove_word_orbit(q, open);
  const bool orbit = found.existence.truth == Truth::proved && found.orbit.admissible.truth == Truth::proved;
  CHECK_FALSE(orbit);
  MachineGuess longer = simulated(q, {1, 1.5, 0, 0.5}, 12000, 175);
  longer.periods = 176;
  const WordOrbit other = prove_word_orbit(q, longer);
  const bool too = other.existence.truth == Truth::proved && other.orbit.admissible.truth == Truth::proved;
  CHECK_FALSE(too);
}

TEST_CASE("a closed motion that is late in its own order is refuted") {
  // The phases of orbit O in a wrong kind: slips for overshoots.
  const OrbitList list = listed(families::overshooting(), O(), 30, Rational(0));
  const Orbit& orbit = admissible_one(list);
  MachineGuess guess = guess_of(orbit.motion);
  for (MachineGuess::Event& event : guess.events) {
    PhaseKind& kind = event.begins.kind;
    kind = kind == PhaseKind::slip        ? PhaseKind::overshoot
           : kind == PhaseKind::overshoot ? PhaseKind::slip
                                          : kind;
  }
  const WordOrbit found = prove_word_orbit({O(), rounded(orbit.value("ur"), 25), 20}, guess);
  const bool admissible =
      found.existence.truth == Truth::proved && found.orbit.admissible.truth == Truth::proved;
  CHECK_FALSE(admissible);
}

TEST_CASE("outside the domain words say which parameter") {
  const OrbitList list = listed(families::overshooting(), O(), 30, Rational(0));
  const MachineGuess guess = guess_of(admissible_one(list).motion);
  const auto refused = [&](ExactParameters data, const Rational& ur) {
    CHECK_THROWS_AS((void)prove_word_orbit({data, ur, 20}, guess), DomainError);
  };
  ExactParameters a = O();
  refused(a, a.us);
  a.p = 0;
  refused(a, 1);
  a = O();
  a.chi = 1;
  refused(a, 1);
  // omega² = 1/4 is a root of s² - (1 + chi eta) s + chi eta (1 - chi) = s² - 3/2 s + 5/16.
  refused({Rational(3, 8), Rational(4, 3), Rational(1, 10), 1, Rational(1, 2), 1}, 1);
}
