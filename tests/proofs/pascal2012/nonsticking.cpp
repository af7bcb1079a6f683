// Section 6, Appendices 4 and 5: what is decided, on what it rests, and that wrong statements do not pass.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/gate.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/met_by_orbits.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/proofs/checks/decided.hpp"
#include "tests/proofs/checks/wrong.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

const std::set<std::string> off_load_resonance{"omega - omega1 != 0", "omega - omega2 != 0"};

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("V = 0 rests on the stated det H_3 != 0 alone, which keeps the load off resonance as well") {
  CHECK(hypotheses("31").empty());
  CHECK(record("31").outcome.assumed.contains("31.regular"));
  CHECK(hypotheses("33.V").empty());
  CHECK(record("33.V").outcome.uses == std::set<std::string>{"33.symmetry"});
}

TEST_CASE("the states of (33) close wherever tan(omega_i pi/(2 omega)) is finite") {
  CHECK(hypotheses("33.back") ==
        std::set<std::string>{"cos(pi*omega1/(2*omega)) != 0", "cos(pi*omega2/(2*omega)) != 0"});
}

TEST_CASE("(35) needs a load that acts on the second mass, which (36) implies") {
  CHECK(hypotheses("35").contains("1 - omega != 0"));
  CHECK(hypotheses("35").contains("p != 0"));
  CHECK(hypotheses("36.load") == off_load_resonance);
}

TEST_CASE("(25), (26) and (36) are the same condition") {
  for (const char * id : {"36", "36.26", "36.back"}) {
    CAPTURE(id);
    CHECK(record(id).outcome.verdict.truth == Truth::proved);
  }
}

TEST_CASE("(37) is necessary but not sufficient, with u_r it is both") {
  CHECK(record("37").status == Status::where_defined);
  CHECK(record("37.enough").status == Status::refuted);
  CHECK(record("37.enough").outcome.verdict.witness.has_value());
  CHECK(record("37.sharp").outcome.verdict.truth == Truth::proved);
  CHECK(record("37.sharp.back").outcome.verdict.truth == Truth::proved);
}

TEST_CASE("the load that a time of the slip asks for is not more, and no less is enough") {
  Claim more = claim_named(paper().claims, "37.slip"), less = claim_named(paper().claims, "37.slip.back");
  for (const Claim& claim : {more, less}) {
    CHECK(record(claim.id).outcome.by_kernel);
    CHECK(record(claim.id).outcome.obeyed == Obeyed::theorem);
  }
  more.printed.front().right = 2 * more.printed.front().right;
  less.assumptions.back().statement.right = less.assumptions.back().statement.right / 2;
  Prover prover(paper().claims);
  for (const Claim& wrong : {more, less}) {
    CAPTURE(wrong.id);
    CHECK(wrong.prove(prover, wrong).verdict.truth != Truth::proved);
  }
}

TEST_CASE("the symmetry of Appendix 4 is a chain from (5) and (27)") {
  CHECK(record("52").outcome.uses == std::set<std::string>{"27", "28.F", "5", "5.F", "52.L", "52.X", "6.H"});
  CHECK(record("54").outcome.uses == std::set<std::string>{"52", "53.F", "53.X"});
}

TEST_CASE("the route through P needs sin(omega_j tau) != 0, the one by half angles only no resonance") {
  CHECK(hypotheses("65").contains("sin(omega1*tau) != 0"));
  CHECK(hypotheses("65").contains("sin(omega2*tau1) != 0"));
  CHECK(record("65").outcome.assumed.contains("65.det"));
  CHECK(hypotheses("65.sharp").empty());
  CHECK(record("65.sharp").outcome.assumed.contains("70.resonance"));
}

TEST_CASE("det(H_1 - I) != 0 is stated for (69), and omega != 1 is an unstated hypothesis of (67) alone") {
  CHECK(record("69").outcome.verdict.truth == Truth::proved);
  CHECK(hypotheses("69").empty());
  CHECK(hypotheses("67.sin").contains("1 - omega != 0"));
}

TEST_CASE(
    "at omega_1 = 2 omega a family of orbits is not symmetric, the mode must be the first, at this "
    "resonance") {
  CHECK(record("33.even").outcome.by_kernel);
  CHECK(record("33.even.orbits").status == Status::proved);
  CHECK(record("7.exception").status == Status::proved);
  CHECK(record("7.always").status == Status::needs_hypotheses);
  CHECK(hypotheses("7.always") ==
        std::set<std::string>{"sin(pi*omega1/omega) != 0", "sin(pi*omega2/omega) != 0"});
  CHECK(record("7.exception").outcome.by_kernel);
  CHECK(record("7.cycles").outcome.theorems.size() == 3);
  const auto altered = [](const std::string& id, const Statement& statement) {
    Claim claim = claim_named(paper().claims, "33.even");
    for (Assumption& one : claim.assumptions) {
      if (one.id == id && equal(one.statement.left, statement.left)) {
        one.statement = statement;
      }
    }
    Prover prover(paper().claims);
    return claim.prove(prover, claim).verdict.truth;
  };
  const Term epsilon = scalar("epsilon");
  CHECK(altered("31.even", equation(omega, omega1 / 2)) == Truth::proved);
  CHECK(altered("31.even", equation(omega, omega1 / 3)) != Truth::proved);
  CHECK(altered("33", equation(z20, q2 * cos(phi) - d02 + epsilon * lambda2)) != Truth::proved);
  CHECK(altered("33", equation(z10, q1 * cos(phi) - d01 - epsilon)) != Truth::proved);
}

TEST_CASE("the family of orbits starts as (34) and (35) say, which are not used where det H_3 = 0") {
  CHECK(record("33.even.start").outcome.by_kernel);
  CHECK(hypotheses("33.even.start") == hypotheses("33.back"));
  CHECK(record("33.even.orbits").outcome.uses ==
        std::set<std::string>{"33.even", "33.even.speed", "33.even.start"});
  CHECK(record("33.even.orbits").outcome.hypotheses.empty());
  int tried = 0;
  const auto survivors = proved_mutants(paper().claims, {"33.even.start"}, tried);
  CHECK(tried > 20);
  // The first row of Lambda is (1, 1), so that it does not see in which row phi_1 and phi_2 stand.
  CHECK(survivors.size() == 2);
  CHECK(
      std::ranges::all_of(survivors, [](const std::string& one) { return one.find("[1, 0]*") != one.npos; }));
  // With the opposite phase the belt would have to move.
  Claim other = claim_named(paper().claims, "33.even.start");
  other.assumptions.back().statement.right = -other.assumptions.back().statement.right;
  Prover prover(paper().claims);
  CHECK(other.prove(prover, other).verdict.truth != Truth::proved);
}

TEST_CASE("without the family of orbits no orbit is proved not to be symmetric") {
  std::vector<Claim> claims = paper().claims;
  const auto orbits =
      std::ranges::find_if(claims, [](const Claim& one) { return one.id == "33.even.orbits"; });
  orbits->prove = [](Prover&, const Claim&) {
    Outcome outcome;
    outcome.verdict = Verdict::undecided("not looked at");
    return outcome;
  };
  CHECK(audit(claims, {"7.exception"}).records.front().status == Status::undecided);
}

TEST_CASE("every claim of these places is decided") {
  for (const Claim& claim : paper().claims) {
    const bool here = claim.place == "sec6" || claim.place == "A4" || claim.place == "A5";
    if (here && claim.kind != Kind::numbers && claim.kind != Kind::check) {
      CAPTURE(claim.id);
      const bool false_as_it_stands = claim.id.ends_with(".enough") || claim.id == "67.branch";
      CHECK(record(claim.id).outcome.verdict.truth == (false_as_it_stands ? Truth::refuted : Truth::proved));
      CHECK(record(claim.id).status != Status::rests_on_unproved);
    }
  }
}

TEST_CASE("every single edit of the identities is refuted, or is no change at all") {
  const Mutants mutants = decide_mutants(
      paper().claims, {"26.tau", "28.F", "29.H", "31.det", "31.rest", "35.def", "36.q2", "37.p", "52.L",
                       "53.F", "61.E", "64.P", "67.cases", "69.det", "70.rho", "70"});
  CHECK(mutants.refuted > 350);
  CHECK(mutants.open == std::vector<std::string>{});
  // cos(omega tau ± phi) agree at omega tau = pi; F repeats itself after two half periods.
  CHECK(mutants.survivors ==
        std::vector<std::string>{
            "26.tau: p*cos(-omega*tau + phi) - eta*(ur + us) = -p*cos(phi) - eta*(ur + us)",
            "26.tau: p*cos(omega*tau - phi) - eta*(ur + us) = -p*cos(phi) - eta*(ur + us)",
            "53.F: F(t - tau) = -F(t)"});
}

TEST_CASE("no single edit of what is proved by rewriting is proved, except what says the same") {
  int tried = 0;
  const std::vector<std::string> survivors = proved_mutants(
      paper().claims, {"28", "28.B", "29", "52", "54", "55", "56", "56.B", "57", "58", "59", "60", "61"},
      tried);
  CHECK(tried > 130);
  // xi_1 = xi_2 makes them interchangeable.
  CHECK(survivors == std::vector<std::string>{"61: xi2 - xi2 = ZB - ZbarB + E*(Z0 - Zbar0)",
                                              "61: xi1 - xi1 = ZB - ZbarB + E*(Z0 - Zbar0)",
                                              "61: xi2 - xi2 = 0", "61: xi1 - xi1 = 0"});
}

TEST_CASE("every single edit of (35) is refuted with the load that (35) asks for") {
  const Term D = (power(omega, 2) - power(omega1, 2)) * (power(omega, 2) - power(omega2, 2));
  const Term load = -D * (b1 * d01 + b2 * d02) / (omega * (1 - power(omega, 2)) * sin(phi));
  const Mutants mutants =
      decide_mutants(paper().claims, "35", by_normal_form(), {{"35.p", equation(p, load)}});
  CHECK(mutants.refuted == 16);
  CHECK(mutants.survivors == std::vector<std::string>{});
  CHECK(mutants.open == std::vector<std::string>{});
}

TEST_CASE("no motion closes at an odd resonance: by 31.modes, and as the friction moves the place of rest") {
  CHECK(record("31.odd").outcome.by_kernel);
  CHECK(record("31.odd").outcome.uses == std::set<std::string>{"31.modes", "31.rest"});
  // With an even multiple motions close (33.even).
  Claim even = claim_named(paper().claims, "31.odd");
  even.assumptions.back().statement = equation((1 - cos(omega1 * tau)) * (1 - cos(omega2 * tau)), 0);
  Prover prover(paper().claims);
  CHECK(even.prove(prover, even).verdict.truth != Truth::proved);
}

TEST_CASE("an orbit obeys what is assumed of it, and not what is assumed with another sign") {
  struct Change {
    const char *example, *claim;
    std::size_t which;
    Statement otherwise;
  };
  for (const auto& [example, id, which, otherwise] :
       {Change{"S", "12.back", 0, equation(chi * eta * (z20 - z10), p * cos(phi) - eta * (ur - us))},
        Change{"S", "13", 0, equation(Z(tau), -E * Z0)}, Change{"O", "20", 3, equation(Z(Theta), -Z0)},
        Change{"P", "25", 0, {chi * (z20 + d02 - z10 - d01) - p / eta * cos(phi), ur, Relation::less}}}) {
    CAPTURE(id);
    std::vector<Claim> claims = paper().claims;
    Claim& claim = *std::ranges::find(claims, std::string(id), &Claim::id);
    const Met met{.example = example,
                  .ids = {id},
                  .premises = std::string(id) == "13" ? std::vector<std::string>{"13.follows"}
                                                      : std::vector<std::string>{}};
    Prover prover(claims);
    const kernel::Theorem theorem = met_theorem(prover, met);
    CHECK(theorem.hypotheses().empty());
    CHECK(says_that_there_are_values(theorem, assumed_by(claim)));
    claim.assumptions.at(which).statement = otherwise;
    CHECK_FALSE(says_that_there_are_values(theorem, assumed_by(claim)));
    CHECK_THROWS_AS((void)met_theorem(prover, met), kernel::KernelError);
  }
}

TEST_SUITE_END();
