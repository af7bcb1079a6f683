#include "proofs/orbits/all_zeros.hpp"

#include <doctest/doctest.h>

#include "tests/proofs/orbits/letters.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::orbits;
using namespace stickslip::proofs::orbits::letters;

namespace {

// The frequency is 1, nearly.
const Ranges nearly_one{{a, {Rational(1) - Rational(1, 1L << 40), Rational(1) + Rational(1, 1L << 40)}}};
const Rational half_turn(31415926536, 10000000000);

AllZeros zeros(const Term& f, const Interval& ends, const std::vector<Rational>& nearly) {
  return all_zeros(differentiable({"f", {a, t}, f}), {a}, t, ends, nearly_one, nearly);
}
// sin(a t)
Term sine() {
  return kernel::sin(Term(a) * t);
}

}  // namespace

TEST_CASE("all zeros of a function between two ends are enclosed, one after the other") {
  const AllZeros found = zeros(sine(), {1, 8}, {2 * half_turn, half_turn});  // falls, and rises
  REQUIRE(found.zeros.size() == 2);
  const Variable first{"t_1"}, second{"t_2"};
  CHECK(found.only.conclusion() == any({equal(t, first), equal(t, second)}));
  Formulas expected{at_most(1, t), at_most(t, 8)};
  for (std::size_t k : {0, 1}) {
    const EnclosedZero& zero = found.zeros[k];
    const Rational where = Rational(static_cast<long>(k) + 1) * half_turn;
    CHECK(zero.x == (k == 0 ? first : second));
    CHECK(zero.bounds.first < where);
    CHECK(where < zero.bounds.second);
    CHECK(zero.bounds.second - zero.bounds.first < Rational(1, 100000000));
    CHECK(zero.exists.conclusion() == exists(zero.x, zero.says));
    CHECK(zero.exists.hypotheses().size() == 2);  // the range of a
    expected.insert(zero.says);
  }
  for (const Formula& said : expected) {
    CHECK(found.only.hypotheses().contains(said));
  }
  // The range of a, and that f(t) = 0, are all that is said besides.
  CHECK(found.only.hypotheses().size() == expected.size() + 3);
}

TEST_CASE("zeros are refused where there is another, where there is none, and where one is double") {
  const auto refused = [](const Term& f, const Interval& ends, const std::vector<Rational>& nearly) {
    CHECK_THROWS_AS(static_cast<void>(zeros(f, ends, nearly)), KernelError);
  };
  refused(sine(), {1, 8}, {half_turn});     // 2 pi is another
  refused(sine(), {1, 8}, {half_turn, 5});  // 5 is none
  refused(sine(), {1, 8}, {half_turn, half_turn, 2 * half_turn});
  refused(sine(), {0, 4}, {half_turn});  // 0 is a zero at the end
  refused(sine() + 2, {0, 4}, {});       // none is given
  refused(kernel::power(sine(), 2), {1, 4}, {half_turn});
  // Two zeros, 2e-3 apart, pass for two, not for one.
  const Term close = (Term(t) - 2) * (Term(t) - Rational(2002, 1000)) * a;
  refused(close, {0, 4}, {2});
  CHECK(zeros(close, {0, 4}, {2, Rational(2002, 1000)}).zeros.size() == 2);
}
