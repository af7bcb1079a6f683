// The numbers of machines as functions of data: what they are at some of these, and what is not taken for
// one.
#include "numeric/machines/phases/numbers_in_data.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/error.hpp"

using namespace stickslip;
using namespace stickslip::numeric::machines;

namespace {

// One mass; the friction falls between two relative velocities.
Machine falling_between(const Rational& at_rest, const Rational& force, const Rational& from,
                        const Rational& to) {
  Machine machine;
  auto& o = machine.oscillator;
  o.masses = {Rational(2)};
  o.stiffness = o.damping = model::MatrixX<Rational>::Constant(1, 1, Rational(1));
  o.rubbing = 0;
  o.V = 1;
  o.forward = {at_rest,
               {{Rational(0), Rational(3), Rational(0)},
                {from, Rational(3), Rational((force - 3) / (to - from))},
                {to, force, Rational(0)}}};
  o.backward = o.forward;
  o.loads = {{0, 1, Rational(1), Rational(0)}};
  o.omega = 1;
  return machine;
}

Values numbers_of(const model::FrictionOscillator<Rational>& o) {
  Values numbers;
  (void)model::mapped<Rational>(o, [&](const Rational& x) { return numbers.emplace_back(x); });
  return numbers;
}
std::vector<InData<Ball>> numbers_of(const OscillatorInData& o) {
  std::vector<InData<Ball>> numbers;
  (void)model::mapped<Ball>(o.numbers, [&](const InData<Ball>& x) { return numbers.emplace_back(x).all(); });
  return numbers;
}

std::string why_not(const std::function<void(Machine&, const Values&)>& set, const Values& low,
                    const Values& high) {
  const auto at = [&](const Values& values) {
    Machine machine = falling_between(Rational(4), Rational(2), Rational(1), Rational(2));
    set(machine, values);
    return machine;
  };
  return NumbersInData(at, low, high).why_not();
}

}  // namespace

TEST_CASE("numbers of machines are the functions of the data that they are") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> number(-100, 100);
  // The friction at rest, a force of the law, the velocities between which it falls, a frequency in Hz, a
  // product of two, an inverse.
  const auto at = [](const Values& d) {
    Machine machine = falling_between(d[0], d[1], d[2], d[3]);
    machine.in_turns = true;
    machine.oscillator.omega = d[4];
    machine.oscillator.stiffness(0, 0) = Rational(d[0] * d[4]);
    machine.oscillator.masses[0] = Rational(1 / d[2]);
    return machine;
  };
  const Values low{4, 1, 1, 2, 1}, high{5, 3, Rational(5, 4), Rational(5, 2), 2};
  const NumbersInData numbers(at, low, high);
  CHECK(numbers.why_not() == "");
  for (int round = 0; round < 40; ++round) {
    const int share = 1 << (round % 6);
    Values middle = low, half = high, s, there;
    std::vector<Ball> in_balls;
    for (std::size_t k = 0; k < low.size(); ++k) {
      const Rational width = (high[k] - low[k]) / share;
      middle[k] = low[k] + width / 2 + width * (abs(number(random)) % share);
      half[k] = width / 2;
      s.emplace_back(number(random), 100);
      s.back().canonicalize();
      there.emplace_back(middle[k] + s[k] * half[k]);
      in_balls.emplace_back(s[k]);
    }
    OscillatorInData over = numbers.over({middle, half});
    over.numbers.omega = over.numbers.omega * Ball(Ball(1) / (Ball(2) * Ball::pi()));
    const std::vector<InData<Ball>> found = numbers_of(over);
    const Values exact = numbers_of(at(there).oscillator);
    REQUIRE(found.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      CAPTURE(i);
      CHECK(found[i].at(in_balls).contains(exact[i]));
      CHECK(found[i].all().contains(exact[i]));
      CHECK(found[i].rest.radius().approximate() < 8 * std::pow(share, -4));
    }
  }
}

TEST_CASE("what is no such function is not taken for one") {
  const auto stiffness = [](const auto& f) {
    return [f](Machine& machine, const Values& d) { machine.oscillator.stiffness(0, 0) = f(d); };
  };
  const char * const no_quotient = "a number of the machine is no quotient of linear functions of the data";
  const Values low{1, 1}, high{3, 3};  // with the middle at 2
  CHECK(why_not(stiffness([](const Values& d) { return Rational(1 / (d[0] + d[1])); }), low, high) == "");
  CHECK(why_not(stiffness([](const Values& d) { return Rational(d[0] / d[1]); }), low, high) == "");
  // Along the first alone it does not change; nor in the middle of the second.
  CHECK(why_not(stiffness([](const Values& d) { return Rational((d[1] - 2) / (d[0] + 1)); }), low, high) ==
        "");
  CHECK(why_not(stiffness([](const Values& d) { return Rational(d[0] * d[0]); }), low, high) == no_quotient);
  // Linear where three points are, quotients where four are.
  CHECK(why_not(stiffness([](const Values& d) {
                  const Rational s = d[0] - 2;
                  return Rational(s + s * (s * s - 1));
                }),
                low, high) == no_quotient);
  CHECK(why_not(stiffness([](const Values& d) {
                  const Rational s = d[0] - 2, t = d[1] - 2;
                  return Rational(s + s * t * (s - 1));
                }),
                low, high) == no_quotient);
  // A pole between the points.
  CHECK(why_not(stiffness([](const Values& d) { return Rational(1 / (d[0] - Rational(9, 4))); }), low,
                high) == no_quotient);
  // Differences of quotients need not be monotone, so that the corners do not tell that the law is one.
  CHECK(why_not([](Machine& machine,
                   const Values& d) { machine.oscillator.forward.at_rest = Rational(10 / d[0]); },
                low, high) == no_quotient);
  CHECK(why_not(
            [](Machine& machine, const Values& d) {
              machine.oscillator.loads.push_back({0, d[0] > 2 ? 3 : 2, Rational(0), Rational(0)});
            },
            low, high) == "the machine changes its shape with the data");
  CHECK(why_not(
            [](Machine& machine, const Values& d) {
              machine.oscillator.forward.at_rest = d[0] > 2 ? Rational(d[0] + 1) : Rational(3);
            },
            low, high) == "the machine changes its shape with the data");
  CHECK_THROWS_AS((void)why_not([](Machine& machine,
                                   const Values& d) { machine.oscillator.masses[0] = Rational(d[0] - 1); },
                                low, high),
                  DomainError);
  CHECK_THROWS_AS(
      (void)why_not([](Machine&, const Values&) {}, Values(9, Rational(1)), Values(9, Rational(2))),
      DomainError);
}
