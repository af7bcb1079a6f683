// Branches of orbits through any phases: what they say is what the proof of single orbits says.
#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "numeric/attractors/word_search.hpp"
#include "numeric/branches/setting.hpp"
#include "numeric/machines/orbits/machine_branch.hpp"
#include "numeric/motion/exits.hpp"
#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;
using namespace stickslip::numeric::branches::examples;

namespace {

std::vector<words::WordOrbit> orbits(const words::WordQuestion& machine, const char * word, int periods) {
  return attractors::find_word_orbits({machine, words::Word::parse(word), periods, {}}).orbits;
}

words::WordQuestion machine_of(const OrbitQuestion& q, const char * ur) {
  const model::Parameters<Range>& a = q.parameters;
  return {{a.chi.middle, a.eta.middle, a.us.middle, a.V.middle, a.omega.middle, a.p.middle},
          parse_rational(ur)};
}

BranchQuestion along(const words::WordQuestion& machine, const char * word, const char * parameter,
                     const char * from, const char * to, const Rational& at) {
  BranchQuestion question = word_question(machine, words::Word::parse(word), 1, orbits(machine, word, 1));
  question.parameter = parameter;
  question.from = parse_rational(from);
  question.to = parse_rational(to);
  question.at = at;
  return question;
}

}  // namespace

TEST_CASE("a branch of the word OTS over the friction: its orbits are those of the complete lists") {
  const words::WordQuestion machine = machine_of(O(), "0.44");
  const BranchQuestion question = along(machine, "OTS", "ur", "0.435", "0.442", machine.ur);
  REQUIRE(!question.word->motions.empty());
  const BranchList list = list_branches(question);
  CHECK(!list.complete);
  CHECK(list.resolved());
  int gained = 0;
  int compared = 0;
  for (const Branch& branch : list.branches) {
    for (const Change& change : branch.changes) {
      CHECK(change.verdict.truth == Truth::proved);
      gained += change.kind == ChangeKind::condition && change.what == "crossing" ? 1 : 0;
    }
    for (const Piece& piece : branch.pieces) {
      const Sample& sample = piece.samples.at(piece.samples.size() / 2);
      words::WordQuestion there = machine;
      there.ur = Rational(sample.value);
      // The same orbit, to what a double says of its load's phase, is as admissible and as stable.
      for (const words::WordOrbit& one : orbits(there, "OTS", 1)) {
        const double phi = one.orbit.motion.phases[0].load.approximate();
        const double turn = 6.283185307179586;
        if (std::abs(std::remainder(phi - sample.motion.phases[0].load, turn)) > 1e-6) {
          continue;
        }
        ++compared;
        CHECK((one.orbit.admissible.truth == Truth::proved) == is_admissible(piece.state));
        if (one.orbit.stability) {
          CHECK((one.orbit.stability->kind == motion::StabilityKind::stable) ==
                (piece.state == State::stable));
        }
      }
    }
  }
  CHECK(gained == 1);
  CHECK(compared >= 3);
}

TEST_CASE("the branch of OTS through its fold is that of the overshooting family, from another phase on") {
  const words::WordQuestion machine = machine_of(O(), "0.4585");
  const BranchQuestion question = along(machine, "OTS", "omega", "0.626", "0.634", parse_rational("0.63"));
  const BranchList list = list_branches(question);
  CHECK(list.unresolved.empty());
  OrbitQuestion family = O();
  family.phi = {};
  family.ur = Range{machine.ur};
  BranchQuestion same = examples::along(family, "omega", "0.626", "0.634");
  same.at = question.at;
  const BranchList there = list_branches(same);
  REQUIRE(list.branches.size() == 1);
  REQUIRE(there.branches.size() == 1);
  const std::vector<Change>&here = list.branches[0].changes, &others = there.branches[0].changes;
  REQUIRE(here.size() == 2);
  REQUIRE(others.size() == 2);
  for (const Change& change : here) {
    CHECK(change.verdict.truth == Truth::proved);
    CHECK(std::any_of(others.begin(), others.end(), [&](const Change& other) {
      return other.kind == change.kind && other.at.overlaps(change.at);
    }));
  }
  // The motion begins with the word's first phase, at time 0.
  for (const Piece& piece : list.branches[0].pieces) {
    for (const Sample& sample : piece.samples) {
      double start = 0;
      REQUIRE(sample.motion.phases.size() == 3);
      for (std::size_t k = 0; k < 3; ++k) {
        const motion::PhaseOf<double>& phase = sample.motion.phases[k];
        CHECK(phase.kind == question.word->family->phases[k]);
        CHECK(phase.start == doctest::Approx(start));
        start += phase.duration;
      }
      const model::Parameters<double>& a = sample.motion.oscillator.data;
      CHECK(start * a.omega == doctest::Approx(6.283185307179586));
      // The stick ends where r = ur.
      const motion::PhaseOf<double>& slip = sample.motion.phases[2];
      CHECK(model::friction_at<double>(a, slip.Z, slip.load) == doctest::Approx(0.4585));
    }
  }
}

TEST_CASE("the branch of a machine that is the paper's oscillator changes where the paper's branch does") {
  const words::WordQuestion paper = machine_of(O(), "0.44");
  BranchList list = list_branches(along(paper, "OTS", "ur", "0.435", "0.442", paper.ur));
  const auto at = [&](const Rational& ur) {
    return machines::Machine{model::friction_oscillator<Rational>(paper.data, ur)};
  };
  std::size_t compared = 0;
  for (const words::WordOrbit& orbit : orbits(paper, "OTS", 1)) {
    // Closed, admissible or not.
    const motion::Motion& m = orbit.orbit.motion;
    machines::MachineGuess guess{{}, 1, motion::period(m).approximate()};
    for (const motion::Phase& phase : m.phases) {
      model::Vector4<double> X;
      for (int k = 0; k < 4; ++k) {
        X(k) = Ball(k < 2 ? Ball(phase.Z(k) + m.oscillator.d0(k)) : phase.Z(k)).approximate();
      }
      const double omega = m.oscillator.data.omega.approximate();
      guess.events.push_back(
          {m.phases[0].load.approximate() / omega + phase.start.approximate(), X, {phase.kind, 0}});
    }
    const machines::MachineBranch branch =
        machines::follow_machine_branch({at, Rational("435/1000"), Rational("442/1000"), paper.ur, guess});
    CAPTURE(branch.existence.reason);
    REQUIRE(branch.existence.truth == Truth::proved);
    for (const machines::MachineChange& change : branch.changes) {
      const Ball place = Ball::from_interval(change.first, change.last);
      bool is_one = false;
      for (const Branch& one : list.branches) {
        is_one = is_one || std::ranges::any_of(one.changes, [&](const Change& c) {
                   return c.kind == change.kind && c.at.overlaps(place);
                 });
      }
      CAPTURE(change.words);
      CHECK(is_one);
      ++compared;
    }
    for (std::size_t k = 0; k + 1 < branch.samples.size(); ++k) {
      CHECK(branch.samples[k].value < branch.samples[k + 1].value);
    }
  }
  CHECK(compared >= 1);
}

TEST_CASE("a word with two sticks, whose branches the general multipliers carry") {
  // An orbit of one word taken twice has two sticks: its multipliers are the squares of the single one's.
  const words::WordQuestion machine = machine_of(O(), "0.44");
  const std::vector<words::WordOrbit> single = orbits(machine, "OTS", 1);
  REQUIRE(!single.empty());
  motion::Motion twice = single.front().orbit.motion;
  const std::vector<motion::Phase> once = twice.phases;
  twice.phases.insert(twice.phases.end(), once.begin(), once.end());
  const std::vector<Ball> one = motion::multiplier_coefficients(single.front().orbit.motion);
  const std::vector<Ball> two = motion::multiplier_coefficients(twice);
  REQUIRE(one.size() == 4);
  REQUIRE(two.size() == 4);
  const auto at = [](const std::vector<Ball>& c, const Ball& x) {
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
  };
  // P2(x²) = -P1(x) P1(-x) for polynomials of degree three with leading coefficient 1.
  for (const double x : {0.5, 1.0, 2.0}) {
    const Ball leading = one[3] * one[3];
    CHECK((at(two, Ball(x * x)) * leading + at(one, Ball(x)) * at(one, Ball(-x))).contains_zero());
  }
}

TEST_CASE("a question about a word that is none is refused in words") {
  const words::WordQuestion machine = machine_of(O(), "0.44");
  BranchQuestion question = word_question(machine, words::Word::parse("OTS"), 1, {});
  question.parameter = "ur";
  question.from = parse_rational("0.3");
  question.to = parse_rational("0.4");
  CHECK_THROWS_AS((void)list_branches(question), UsageError);  // no value to begin at
  question.at = question.from;
  const BranchList none = list_branches(question);
  CHECK(!none.resolved());  // and no orbit
  CHECK(none.counts.empty());
  question.from = 0;
  CHECK_THROWS_AS((void)list_branches(question), DomainError);  // ur <= us
}
