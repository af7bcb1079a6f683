// Identities as certificates that Coq accepts.
#include <doctest/doctest.h>

#include <fstream>

#include "proofs/certificates/certificates.hpp"
#include "proofs/tactics/tactics.hpp"
#include "tests/cli/program.hpp"
#include "tests/proofs/certificates/coq.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;

namespace {

methods::Claim claim(const std::vector<Formula>& identities, std::vector<Theorem> theorems) {
  for (const Formula& one : identities) {
    theorems.push_back(Theorem::combination(one));
  }
  return {.id = "identities", .words = "identities", .prove = [theorems](auto&, const auto&) {
            methods::Outcome outcome;
            outcome.theorems = theorems;
            outcome.by_kernel = true;
            outcome.verdict = Verdict::proved();
            return outcome;
          }};
}

}  // namespace

TEST_CASE(
    "Coq accepts sums of phases, where the argument of a cosine is a phase of the others, and exponentials" *
    doctest::timeout(600)) {
  const Term omega = Variable{"omega"}, tau = Variable{"tau"}, phi = Variable{"phi"};
  const Term half = omega * tau / 2;
  const Variable t{"t"};
  const Term decay = lambda(t, exp(-tau * t) * sin(omega * t));
  const certificates::Certificates all = certificates::certificates({claim(
      {// 67.cases: omega tau/2 is what omega tau and phi + omega tau/2 are made of.
       equal(sin(omega * tau + phi) + sin(phi), Term(2) * sin(phi + half) * cos(half)),
       equal(cos(omega * tau + phi) - cos(phi), Term(-2) * sin(phi + half) * sin(half)),
       equal(sin(omega * tau), Term(2) * sin(half) * cos(half)),
       equal(exp(phi / 2 + pi() / 3) * exp(phi / 2 - 4 * pi() / 3), exp(phi - pi())),
       equal(exp(-tau) * exp(Term(0)) / (exp(tau) + exp(-tau)) * (1 + exp(2 * tau)), 1),
       equal(exp(Term(Rational(3, 2))) * exp(Term(Rational(1, 2))) * cos(tau), exp(Term(2)) * cos(-tau))},
      {Theorem::differentiate(decay, phi), Theorem::continuity(decay, phi, tau),
       tactics::exponential_is_positive(tau), Theorem::sign(less(exp(Term(1)), Rational(11, 4)))})});
  const TemporaryDirectory temporary;
  write_certificates(temporary.path(), all);
  const Run made = run("/usr/bin/make", {"--silent", "--directory=" + temporary.path().string()});
  CAPTURE(made.err);
  CAPTURE(made.out);
  CHECK(made.code == 0);
}
