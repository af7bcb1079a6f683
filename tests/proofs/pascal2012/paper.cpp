#include "proofs/pascal2012/paper.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/examples/symmetric_list.hpp"
#include "tests/proofs/checks/decided.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using numeric::Orbit;
using numeric::OrbitList;

namespace {

// All numbers l in l < x.
void numbers_below(const kernel::Term& term, std::vector<double>& found) {
  if (term.kind() == kernel::Kind::less && term.parts()[0].kind() == kernel::Kind::number) {
    found.push_back(term.parts()[0].value().get_d());
  }
  for (const kernel::Term& part : term.parts()) {
    numbers_below(part, found);
  }
}

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("a result of the audit is a claim that stands, or the refutation of one of the paper's") {
  for (const Result& result : paper().results) {
    CAPTURE(result.id);
    const Record theorem = record(result.claims.front());
    CHECK((theorem.claim.origin == Origin::new_result ? theorem.outcome.verdict.truth == Truth::proved
                                                      : theorem.status == Status::refuted));
    for (const std::string& id : result.claims) {
      CAPTURE(id);
      CHECK(facts(record(id).status).decided);
    }
  }
}

TEST_CASE("the slip solution needs the load to be off resonance, which the paper does not say") {
  CHECK(record("7").status == Status::where_defined);
  CHECK(record("7").outcome.hypotheses.size() == 2);
  CHECK(record("17.slip").status == Status::where_defined);
  CHECK(record("10").status == Status::as_printed);
}

TEST_CASE("(17) is proved from Appendix 2, link by link") {
  CHECK(record("17.slip").outcome.uses ==
        std::set<std::string>{"13.E", "38.commute", "43", "44.E", "44.F", "44.F0", "44.H", "5"});
  CHECK(record("17.slip").outcome.assumed.contains("13"));
  CHECK(record("17.stick").outcome.uses ==
        std::set<std::string>{"4.stick", "41.commute", "45", "46.E", "46.group"});
  CHECK(record("17.stick").outcome.assumed ==
        std::set<std::string>{"13", "15", "4.T", "9.stick", "t.from", "t.to"});
}

TEST_CASE("that no slip at the data of Fig. 2 leaves the load's phase free needs a load on both modes") {
  CHECK(record("S.lag").outcome.uses == std::set<std::string>{"4.lag.needed", "7.modal"});
}

TEST_CASE("without one of its premises (17) is not proved") {
  std::vector<Claim> claims = paper().claims;
  for (const std::string cut : {"13.E", "44.E", "44.H"}) {
    CAPTURE(cut);
    std::vector<Claim> mutilated = claims;
    for (Claim& claim : mutilated) {
      if (claim.id == cut) {
        claim.prove = [](Prover&, const Claim&) { return Outcome{.verdict = Verdict::undecided("cut")}; };
      }
    }
    CHECK(audit(mutilated, {"17.slip"}).records.front().status == Status::undecided);
  }
}

TEST_CASE("(45) as the source prints it is a misprint") {
  CHECK(record("45").status == Status::misprint_corrected);
  REQUIRE(record("45").outcome.verdict.witness.has_value());
  CHECK_FALSE(
      record("45").outcome.verdict.witness->left.overlaps(record("45").outcome.verdict.witness->right));
}

TEST_CASE("example S: the orbit is proved, the period is right, other digits are off") {
  CHECK(record("S.orbit").status == Status::as_printed);
  CHECK(record("S.Theta").status == Status::as_printed);
  for (const char * id : {"S.tau", "S.T", "S.z10", "S.z20", "S.zdot10", "S.ur"}) {
    CAPTURE(id);
    CHECK(record(id).status == Status::digits_off);
    REQUIRE(record(id).outcome.comparisons.size() == 1);
    CHECK(record(id).outcome.comparisons.front().units_off.is_finite());
  }
}

TEST_CASE("(16) is necessary for the orbit of Section 4, not sufficient, the time lag is nearly forced") {
  CHECK(record("16").status == Status::necessary_not_sufficient);
  CHECK(record("16.back").outcome.verdict.truth == Truth::proved);
  std::set<std::string> exceptions;
  for (const Hypothesis& hypothesis : record("16.back").outcome.hypotheses) {
    exceptions.insert(hypothesis.text);
  }
  CHECK(exceptions ==
        std::set<std::string>{"cos(T/2) != 0", "cos(omega1*tau/2) != 0", "cos(omega2*tau/2) != 0"});
  CHECK(record("4.lag.needed").outcome.verdict.truth == Truth::proved);
}

TEST_CASE("examples: the printed orbits obey every condition, and it is told what was computed from what") {
  for (const char * id : {"S.list", "P.list", "S.if.slip", "S.if.f1", "S.from.T", "S.from.z20", "S.from.ur",
                          "P.orbit", "P.if.25", "P.if.overshoot", "P.x10", "P.from.ur"}) {
    CAPTURE(id);
    CHECK(record(id).status ==
          (proofs::methods::is_stated(pascal2012::paper(), id) ? Status::as_printed : Status::proved));
  }
  CHECK(record("P.x20").status == Status::digits_off);
}

TEST_CASE("the kernel's list of symmetric orbits has those found in balls, and refuses fewer") {
  const OrbitList& list = orbits_of(example_named("S")).list;
  REQUIRE(list.orbits.size() == 4);
  std::vector<double> lower;  // bounds of the theorem
  numbers_below(list_of_S().prove(list).conclusion(), lower);
  for (const Orbit& orbit : list.orbits) {
    const double tau = orbit.value("tau").approximate();
    CAPTURE(tau);
    CHECK(std::ranges::count_if(lower, [&](double l) { return l < tau && tau < l + 4e-9; }) == 1);
    OrbitList fewer = list;
    std::erase_if(fewer.orbits, [&](const Orbit& other) { return other.value("tau").approximate() == tau; });
    CHECK(fewer.orbits.size() == 3);
    CHECK_THROWS_AS((void)list_of_S().prove(fewer), kernel::KernelError);
  }
  CHECK(record("S.list").outcome.by_kernel);
}

TEST_CASE("the kernel's list of nonsticking orbits has those found in balls, and refuses fewer") {
  const Example& example = example_named("P");
  const OrbitList& list = orbits_of(example).list;
  REQUIRE(list.orbits.size() == 2);
  std::vector<double> lower;
  numbers_below(list_of_P().prove(list).conclusion(), lower);
  for (std::size_t k : {0, 1}) {
    const Orbit& orbit = list.orbits[k];
    // mu, between -pi and pi.
    const double middle =
        orbit.phi().approximate() + example.data.omega.get_d() * orbit.value("tau").approximate() / 2;
    const double mu = std::remainder(middle, 2 * std::numbers::pi);
    CAPTURE(mu);
    CHECK(std::ranges::count_if(lower, [&](double l) { return l < mu && mu < l + 4e-9; }) == 1);
    OrbitList fewer = list;
    fewer.orbits.erase(fewer.orbits.begin() + static_cast<std::ptrdiff_t>(k));
    CHECK_THROWS_AS((void)list_of_P().prove(fewer), kernel::KernelError);
  }
  CHECK(record("P.list").outcome.by_kernel);
}

TEST_CASE("every claim stands in a section of the paper, section by section") {
  std::size_t section = 0;
  for (const Claim& claim : paper().claims) {
    while (section < paper().sections.size() && paper().sections[section].id != claim.place) {
      ++section;
    }
    CAPTURE(claim.id);
    REQUIRE(section < paper().sections.size());
  }
  CHECK(section + 1 == paper().sections.size());
}

TEST_CASE("words name claims, equations with their parts, and places") {
  const std::vector<Claim> claims = paper().claims;
  CHECK(ids_named(claims, "40") == std::set<std::string>{"40"});
  CHECK(ids_named(claims, "44") == std::set<std::string>{"44.E", "44.F", "44.F0", "44.H"});
  CHECK(ids_named(claims, "44.H") == std::set<std::string>{"44.H"});
  CHECK(ids_named(claims, "A2").contains("17.slip"));
  CHECK_FALSE(ids_named(claims, "4").contains("40"));
  CHECK_THROWS_AS((void)ids_named(claims, "99"), UsageError);
  CHECK_THROWS_AS((void)ids_named(claims, ""), UsageError);
}

TEST_SUITE_END();
