// What must be provable, and how long it takes.
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/proofs/kernel/paper.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::paper;

TEST_CASE("(40) holds where lambda1, lambda2 differ and no frequency is zero") {
  const Theorem theorem =
      Theorem::combination(equal(H1(t) * H1(t) - identity(2), H2(t) * H3(t)), {}, {H1_of, H2_of, H3_of});
  for (const Formula& hypothesis : theorem.hypotheses()) {
    MESSAGE(to_string(hypothesis));
  }
}

TEST_CASE("H is a group") {
  const Theorem theorem = Theorem::combination(equal(H(Term(t) + s), H(t) * H(s)), {}, {H_of});
}
