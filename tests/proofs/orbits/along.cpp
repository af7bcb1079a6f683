#include "proofs/orbits/along.hpp"

#include <doctest/doctest.h>

#include "tests/proofs/orbits/letters.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::orbits;
using namespace stickslip::proofs::orbits::letters;
using Wave = model::Wave<tactics::Symbolic>;

namespace {

// a sin t
Wave a_sine() {
  Wave wave;
  wave.add(1, 0, a);
  return wave;
}

Below question(const Term& bound, const Term& duration) {
  return {a_sine(), bound, duration, {}, {}};
}

}  // namespace

TEST_CASE("an inequality is decided in pieces, and refused where it fails in one of them") {
  Ranges ranges = about_one(a);
  ranges[s] = {0, 3};
  const Term wave = value(a_sine(), s);
  const Theorem theorem = in_pieces(less(wave, Rational(11, 10)), s, ranges);
  CHECK(theorem.conclusion() == less(wave, Rational(11, 10)));
  CHECK(theorem.hypotheses() == Formulas{at_most(0, s), at_most(s, 3), at_most(Rational(999, 1000), a),
                                         at_most(a, Rational(1001, 1000))});
  CHECK_THROWS_AS(static_cast<void>(in_pieces(less(wave, Rational(99, 100)), s, ranges)), KernelError);
  CHECK_THROWS_AS(static_cast<void>(in_pieces(less(wave, 1), s, ranges)), KernelError);
}

TEST_CASE("a wave stays below a bound that it meets at the end, and only where it comes from below") {
  const auto meets = [](Below below, const Term& at) {
    // a sin t = 0 at 0, and at pi.
    const Theorem zero = Theorem::combination(equal(value(below.wave, at), 0));
    (at == Term(0) ? below.meets_at_start : below.meets_at_end) = zero;
    return below;
  };
  // -a sin t < 0 for 0 < t < pi: it meets 0 at both ends.
  Below below = question(0, pi());
  below.wave = model::affine<tactics::Symbolic>(-1, below.wave, 0);
  const Theorem theorem = stays_below(meets(meets(below, 0), pi()), s, about_one(a));
  CHECK(theorem.conclusion() == less(value(below.wave, s), 0));
  CHECK(theorem.hypotheses().contains(less(0, s)));
  CHECK(theorem.hypotheses().contains(less(s, pi())));
  // Neither meets(): the inequality fails at the ends.
  CHECK_THROWS_AS(static_cast<void>(stays_below(below, s, about_one(a))), KernelError);
  CHECK_THROWS_AS(static_cast<void>(stays_below(meets(below, 0), s, about_one(a))), KernelError);
  // a sin t < 0 there is false; so is -a sin t < 0 until 4, and a sin t < 1/2.
  CHECK_THROWS_AS(static_cast<void>(stays_below(meets(meets(question(0, pi()), 0), pi()), s, about_one(a))),
                  KernelError);
  below.duration = 4;
  CHECK_THROWS_AS(static_cast<void>(stays_below(meets(below, 0), s, about_one(a))), KernelError);
  CHECK_THROWS_AS(static_cast<void>(stays_below(question(Rational(1, 2), 3), s, about_one(a))), KernelError);
  // That another wave meets the bound does not help.
  Below other = question(0, pi());
  other.meets_at_end = Theorem::combination(equal(value(below.wave, pi()), 0));
  CHECK_THROWS_AS(static_cast<void>(stays_below(other, s, about_one(a))), KernelError);
}
