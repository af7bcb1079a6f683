#include "core/verdict.hpp"

#include <doctest/doctest.h>

using namespace stickslip;

TEST_CASE("a conjunction is as good as its worst member") {
  const Verdict good = Verdict::proved();
  const Verdict bad = Verdict::refuted("no");
  const Verdict open = Verdict::undecided("perhaps");
  CHECK(all_of({good, good}).truth == Truth::proved);
  CHECK(all_of({good, open, bad}).truth == Truth::refuted);
  CHECK(all_of({open, good}).reason == "perhaps");
  CHECK(all_of({good, Verdict::assumed("given"), Verdict::checked("agrees")}).truth == Truth::checked);
  CHECK(all_of({good, Verdict::assumed("given")}).truth == Truth::assumed);
  CHECK(all_of({}).truth == Truth::undecided);
}

TEST_CASE("a refutation names its point and both sides") {
  const Verdict verdict = Verdict::refuted(
      Witness{{{"omega1", Rational(1, 2)}, {"t", Rational(1, 3)}}, "(2,1)", Ball(1), Ball(2)});
  CHECK(verdict.truth == Truth::refuted);
  CHECK(verdict.reason ==
        "entry (2,1): the left side is 1 and the right side is 2 at $omega1 = 0.5$, $t = 1/3$");
  CHECK(plain(verdict.reason) ==
        "entry (2,1): the left side is 1 and the right side is 2 at omega1 = 0.5, t = 1/3");
}

TEST_CASE("a refutation shows as many digits as tell both sides apart") {
  const Ball pi = Ball::pi(), near = pi + Ball(1) / Ball(1000000000) / Ball(1000000000);
  const std::string reason = Verdict::refuted(Witness{{}, "", pi, near}).reason;
  CHECK(reason.starts_with("the left side is 3.1415926535897932385 "));
  CHECK(reason.find("the right side is 3.1415926535897932395 ") != std::string::npos);
  CHECK(Verdict::refuted(Witness{{}, "", pi, pi}).reason.starts_with("the left side is 3.141592654 "));
  // 1 is exact, and 1.000000000 would say the same.
  const Ball beside = Ball(1) + Ball(1) / Ball(1000000000) / Ball(10000);
  CHECK(Verdict::refuted(Witness{{}, "", Ball(1), beside}).reason.find("is 1.0000000000001") !=
        std::string::npos);
}
