#include "proofs/orbits/enclosed_matrix.hpp"

#include <doctest/doctest.h>

#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "tests/proofs/orbits/letters.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::orbits;
using namespace stickslip::proofs::orbits::letters;

namespace {

// A number and a matrix, each a definition that speaks of another one.
Term twice(const Term& of) {
  return Definition("twice", {x}, Term(2) * x)({of});
}
Term rows(const Term& of) {
  return Definition("rows", {x}, matrix(2, 1, {twice(x), Term(1) - x}))({of});
}

}  // namespace

TEST_CASE("a sign is decided with what its definitions are, and says so of the definitions") {
  const Term value = entry(rows(x), 0) * twice(twice(x));  // 8 x²
  const Theorem theorem = sign_by_parts(less(value, Rational(81, 10)), about_one(x));
  CHECK(theorem.conclusion() == less(value, Rational(81, 10)));
  CHECK(theorem.hypotheses() == Formulas{at_most(Rational(999, 1000), x), at_most(x, Rational(1001, 1000))});
  CHECK_THROWS_AS(static_cast<void>(sign_by_parts(less(value, Rational(79, 10)), about_one(x))), KernelError);
  CHECK_THROWS_AS(static_cast<void>(sign_by_parts(less(value, 8), about_one(x))), KernelError);
  CHECK_THROWS_AS(static_cast<void>(sign_by_parts(differ(entry(rows(x), 1), 0), about_one(x))), KernelError);
  CHECK_THROWS_AS(static_cast<void>(sign_by_parts(less(value, Term(9) + y), about_one(x))), KernelError);
}

TEST_CASE("bounds of a number are near to what it can be, through its definitions") {
  const Known known = bounded_by_parts(twice(twice(x)), about_one(x));  // 4 x
  CHECK(known.lower.conclusion() == at_most(known.range.first, twice(twice(x))));
  CHECK(known.upper.conclusion() == at_most(twice(twice(x)), known.range.second));
  CHECK(known.range.first.value() <= Rational(3996, 1000));
  CHECK(known.range.second.value() >= Rational(4004, 1000));
  CHECK(known.range.first.value() >= Rational(3980, 1000));
  CHECK(known.range.second.value() <= Rational(4020, 1000));
  CHECK_THROWS_AS(static_cast<void>(bounded_by_parts(twice(y), about_one(x))), KernelError);
}

TEST_CASE("what holds in ranges holds for all in them, and of nothing else") {
  const Theorem theorem = sign_by_parts(less(twice(x), 3), about_one(x));
  const Theorem all = for_all_in(theorem, {x}, about_one(x));
  CHECK(all.hypotheses().empty());
  CHECK(all.conclusion() ==
        for_all(x, implies(within(Rational(999, 1000), x, Rational(1001, 1000)), less(twice(x), 3))));
  // A range that is not the theorem's leaves its hypotheses, in which x is free.
  const Ranges wider{{x, {0, 2}}};
  CHECK_THROWS_AS(static_cast<void>(for_all_in(theorem, {x}, wider)), KernelError);
}

TEST_CASE("numbers at chi and eta are those at frequencies that there are") {
  const auto below = [](const Rational& bound) {
    return pascal2012::at_frequencies(Rational(1, 2), Rational(19, 5), [&](const Ranges& ranges) {
      return Theorem::sign(less(Variable{"omega1"}, bound), {{{"omega1"}, ranges.at({"omega1"})}});
    });
  };
  const Theorem theorem = below(Rational(614, 1000));  // omega1 = 0.6137…
  CHECK(theorem.hypotheses().empty());
  CHECK(theorem.conclusion().kind() == Kind::exists);
  CHECK_THROWS_AS(static_cast<void>(below(Rational(613, 1000))), KernelError);
  const auto at = [](const Rational& chi, const Rational& eta) {
    return pascal2012::at_frequencies(chi, eta, [](const Ranges&) { return Theorem::reflexive(1); });
  };
  for (const auto& [chi, eta] : {std::pair(0, 1), std::pair(1, 1), std::pair(2, 1)}) {
    CHECK_THROWS_AS(static_cast<void>(at(chi, eta)), KernelError);
  }
  CHECK_THROWS_AS(static_cast<void>(at(Rational(1, 2), 0)), KernelError);
  // Not of other frequencies than these: a theorem that supposes what is not so of them is of no use.
  CHECK_THROWS_AS(
      static_cast<void>(pascal2012::at_frequencies(
          Rational(1, 2), 1, [](const Ranges&) { return Theorem::assume(less(Variable{"omega1"}, 0)); })),
      KernelError);
}
