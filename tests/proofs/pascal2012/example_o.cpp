#include <doctest/doctest.h>

#include "proofs/methods/motions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/pascal2012/examples/example_o_closing.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "proofs/tactics/closed.hpp"
#include "tests/proofs/checks/decided.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::pascal2012;

namespace {

const numeric::Orbit& orbit_of_O() {
  return methods::printed_orbit(example_named("O"));
}
Rational of_orbit_of_O(const char * name) {
  return Rational(orbit_of_O().value(name).approximate());
}

// That (23) has no solution with these times, each as near to this as a decimal of so many places says.
kernel::Theorem no_solution(const Rational& of_tau, const Rational& of_tau1) {
  const auto& data = example_named("O").data;
  return at_frequencies(data.chi, data.eta, [&](orbits::Ranges ranges) {
    const kernel::Variable tau{"tau"}, tau1{"tau1"};
    const Rational half(1, 2000), less(1, 20000);
    ranges.emplace(tau, kernel::Interval{of_tau - half, of_tau + half});
    ranges.emplace(tau1, kernel::Interval{of_tau1 - less, of_tau1 + less});
    return orbits::for_all_in(incompatible(ranges), {tau, tau1}, ranges);
  });
}

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("O.23 is a theorem at the printed times, and at none with another digit that gives a solution") {
  const Rational printed(4909, 1000), printed1(28275, 10000);
  const methods::Outcome& outcome = record("O.23").outcome;
  REQUIRE(outcome.theorems.size() == 1);
  CHECK(outcome.theorems[0].hypotheses().empty());
  CHECK(outcome.theorems[0].conclusion() == no_solution(printed, printed1).conclusion());
  // The orbit's own tau_1, with as many digits.
  const Rational right(std::lround(10000 * of_orbit_of_O("tau1").get_d()), 10000);
  CHECK(right != printed1);
  CHECK(abs(of_orbit_of_O("tau") - printed) < Rational(1, 2000));
  CHECK_THROWS_AS(static_cast<void>(no_solution(printed, right)), kernel::KernelError);
  CHECK_THROWS_AS(static_cast<void>(no_solution(of_orbit_of_O("tau"), of_orbit_of_O("tau1"))),
                  kernel::KernelError);
}

TEST_CASE("the coefficients of (21) at the data of Fig. 3 are in definitions what they are in balls") {
  const auto& modes = orbit_of_O().motion.oscillator.modes;
  const std::map<kernel::Variable, Rational, kernel::Before> values{
      {{"omega1"}, Rational(modes.omega1.approximate())}, {{"omega2"}, Rational(modes.omega2.approximate())}};
  const Rational t(49, 10), t1(28, 10);
  for (const auto reading : {model::Reading::derived, model::Reading::printed}) {
    const auto said = closing_of_O(kernel::Term(t), kernel::Term(t1), reading);
    const auto known = closing_of_O(Ball(t), Ball(t1), reading);
    for (const auto& [terms, balls] : {std::pair(&said.a, &known.a), std::pair(&said.b, &known.b),
                                       std::pair(&said.c, &known.c), std::pair(&said.d, &known.d)}) {
      for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        CHECK(tactics::estimated(terms->at(i).term, values) ==
              doctest::Approx(balls->at(i).approximate()).epsilon(1e-12));
      }
    }
  }
}

TEST_SUITE_END();
