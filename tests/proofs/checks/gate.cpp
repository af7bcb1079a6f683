// Wrong statements must not be proved: a sample of all single edits of all statements, put to the claims' own
// proofs. `script/mutants` takes all of them. STICKSLIP_SEED in the environment sets the sample.
#include <doctest/doctest.h>

#include <algorithm>

#include "proofs/checks/mutants.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::proofs::checks;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Gate gate_of(const Claim& claim, const Sampling& sampling = {}) {
  std::vector<Claim> claims = paper().claims;
  claims.push_back(claim);
  return mutant_gate(claims, {claim.id}, sampling, [](const std::string&, std::size_t, std::size_t) {});
}

std::size_t count(const Gate& gate, Fate fate) {
  return static_cast<std::size_t>(std::count_if(gate.mutants.begin(), gate.mutants.end(),
                                                [&](const Mutant& m) { return m.fate == fate; }));
}

Claim reversal(const Proof& prove) {
  return {.id = "reversal", .place = "test", .printed = {equation(H(-t) * E, E * H(t))}, .prove = prove};
}

// The paper with a proof that gives up.
std::vector<Claim> without(const std::string& id) {
  std::vector<Claim> claims = paper().claims;
  for (Claim& claim : claims) {
    if (claim.id == id) {
      claim.prove = [](Prover&, const Claim&) { return Outcome{.verdict = Verdict::undecided("cut")}; };
    }
  }
  return claims;
}

std::map<std::string, Record> records(const std::vector<Claim>& claims, const std::set<std::string>& ids) {
  std::map<std::string, Record> result;
  for (const Record& record : audit(claims, ids).records) {
    result.emplace(record.claim.id, record);
  }
  return result;
}

}  // namespace

TEST_CASE("of a sample of wrong statements none is proved, and the true twins are") {
  const unsigned seed = examples::RandomData().seed();
  MESSAGE("STICKSLIP_SEED=", seed);
  const unsigned one_in = 160 / static_cast<unsigned>(examples::more());
  const Gate gate = mutant_gate(paper().claims, {}, {seed, std::max(1u, one_in)},
                                [](const std::string&, std::size_t, std::size_t) {});
  for (const Mutant& mutant : gate.mutants) {
    CAPTURE(mutant.claim);
    CAPTURE(mutant.statement);
    CHECK(mutant.fate != Fate::survived);
    CHECK(mutant.reason != "");
  }
  CHECK(count(gate, Fate::refuted) * 10 > gate.mutants.size() * 6);  // about 8: where the assumptions hold
  const auto proved = std::count_if(gate.twins.begin(), gate.twins.end(),
                                    [](const Twin& twin) { return twin.verdict.truth == Truth::proved; });
  CHECK(proved * 10 > static_cast<std::ptrdiff_t>(gate.twins.size()) * 9);
}

TEST_CASE("every edit of an identity is refuted or true, every twin proved") {
  const Gate gate = gate_of(reversal(by_normal_form()));
  CHECK(count(gate, Fate::refuted) == gate.mutants.size());
  CHECK(gate.mutants.size() > 5);
  CHECK(gate.twins.size() > 3);
  CHECK(std::all_of(gate.twins.begin(), gate.twins.end(),
                    [](const Twin& twin) { return twin.verdict.truth == Truth::proved; }));
}

TEST_CASE("every single edit of Appendix 1 is refuted, or says something that is true") {
  const Gate gate = mutant_gate(paper().claims, ids_named(paper().claims, "A1"), {},
                                [](const std::string&, std::size_t, std::size_t) {});
  CHECK(count(gate, Fate::refuted) > 400);
  CHECK(count(gate, Fate::refuted) + count(gate, Fate::equivalent) + count(gate, Fate::stillborn) +
            count(gate, Fate::unproved) ==
        gate.mutants.size());
  CHECK(count(gate, Fate::unproved) == 0);
}

TEST_CASE("a proof that does not look at the statement lets its mutants live, and that is seen") {
  const Gate gate =
      gate_of(reversal([](Prover&, const Claim&) { return Outcome{.verdict = Verdict::proved()}; }));
  CHECK(count(gate, Fate::survived) == gate.mutants.size());
}

TEST_CASE("an edit that divides by zero or changes nothing is no wrong statement") {
  const Gate void_gate = gate_of({.id = "void",
                                  .place = "test",
                                  .printed = {equation(1 / (tau + tau), 1 / (2 * tau))},
                                  .prove = by_normal_form()});
  CHECK(count(void_gate, Fate::stillborn) > 0);
  CHECK(count(void_gate, Fate::survived) == 0);
  const Gate true_gate = gate_of(
      {.id = "true", .place = "test", .printed = {equation(H2(0), zero(2, 2))}, .prove = by_normal_form()});
  CHECK(count(true_gate, Fate::equivalent) > 0);
  CHECK(count(true_gate, Fate::survived) == 0);
}

TEST_CASE("the same seed draws the same sample") {
  const Gate all = gate_of(reversal(by_normal_form())), one = gate_of(reversal(by_normal_form()), {1, 3}),
             same = gate_of(reversal(by_normal_form()), {1, 3});
  CHECK(one.mutants.size() < all.mutants.size());
  REQUIRE(one.mutants.size() == same.mutants.size());
  CHECK(std::equal(one.mutants.begin(), one.mutants.end(), same.mutants.begin(),
                   [](const Mutant& a, const Mutant& b) { return a.statement == b.statement; }));
}

TEST_CASE("a broken claim takes down those that use it, and no others") {
  std::set<std::string> ids;
  for (const char * place : {"sec3", "A1", "A2", "A4", "A5"}) {
    ids.merge(ids_named(paper().claims, place));
  }
  const auto whole = records(paper().claims, ids);
  for (const std::string cut : {"13.E", "62"}) {
    CAPTURE(cut);
    std::set<std::string> users{cut}, changed{cut};
    for (std::size_t before = 0; before != users.size();) {
      before = users.size();
      for (const auto& [id, record] : whole) {
        const auto used = [&](const Outcome& outcome) {
          return std::any_of(outcome.uses.begin(), outcome.uses.end(),
                             [&](const std::string& one) { return users.contains(one); });
        };
        if (used(final_outcome(record)) || (record.converse && used(*record.converse))) {
          users.insert(id);
        }
      }
    }
    for (const auto& [id, record] : records(without(cut), ids)) {
      if (record.status != whole.at(id).status) {
        changed.insert(id);
      }
    }
    CHECK(changed == users);
  }
}
