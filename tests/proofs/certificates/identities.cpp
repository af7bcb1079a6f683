// Identities as certificates that Coq accepts.
#include <doctest/doctest.h>

#include <fstream>

#include "proofs/certificates/certificates.hpp"
#include "tests/cli/program.hpp"
#include "tests/proofs/certificates/coq.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;

namespace {

methods::Claim claim(const std::vector<Formula>& identities) {
  std::vector<Theorem> theorems;
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

TEST_CASE("Coq accepts sums of phases, where the argument of a cosine is a phase of the others" *
          doctest::timeout(600)) {
  const Term omega = Variable{"omega"}, tau = Variable{"tau"}, phi = Variable{"phi"};
  const Term half = omega * tau / 2;
  const certificates::Certificates all = certificates::certificates({claim({
      // 67.cases: omega tau/2 is what omega tau and phi + omega tau/2 are made of.
      equal(sin(omega * tau + phi) + sin(phi), Term(2) * sin(phi + half) * cos(half)),
      equal(cos(omega * tau + phi) - cos(phi), Term(-2) * sin(phi + half) * sin(half)),
      equal(sin(omega * tau), Term(2) * sin(half) * cos(half)),
  })});
  const TemporaryDirectory temporary;
  write_certificates(temporary.path(), all);
  const Run made = run("/usr/bin/make", {"--silent", "--directory=" + temporary.path().string()});
  CAPTURE(made.err);
  CAPTURE(made.out);
  CHECK(made.code == 0);
}
