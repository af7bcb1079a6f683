// Each assumption that a claim is said to need, deleted: without it there is no theorem, or one with another
// hypothesis.
#include <doctest/doctest.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;

namespace {

// The claim in the form that was proved, without an assumption.
Claim without(const Record& record, const std::string& id) {
  Claim claim = record.claim;
  if (record.corrected) {
    claim.printed = claim.corrected;
    claim.prove = claim.prove_corrected ? claim.prove_corrected : claim.prove;
  }
  std::erase_if(claim.assumptions, [&](const Assumption& one) { return one.id == id; });
  return claim;
}

bool has_more_hypotheses(const Outcome& outcome, const Outcome& before) {
  return std::ranges::any_of(outcome.hypotheses, [&](const Hypothesis& one) {
    return std::ranges::none_of(before.hypotheses,
                                [&](const Hypothesis& other) { return other.text == one.text; });
  });
}

}  // namespace

TEST_CASE("no claim is proved without an assumption that it needs") {
  const std::vector<Claim> claims = proofs::pascal2012::paper().claims;
  Prover prover(claims);
  int deleted = 0, by_kernel = 0;
  std::vector<std::string> survivors;
  for (const Claim& claim : claims) {
    const Record& record = prover.prove(claim.id);
    const Outcome& proved = final_outcome(record);
    by_kernel += proved.by_kernel ? 1 : 0;
    for (const Assumption& assumption : claim.assumptions) {
      if (!proved.by_kernel || !proved.assumed.contains(assumption.id)) {
        continue;
      }
      ++deleted;
      const Claim less = without(record, assumption.id);
      Outcome outcome;
      try {
        outcome = less.prove(prover, less);
      } catch (const InternalError&) {
        continue;  // the proof names the assumption
      }
      if (outcome.verdict.truth == Truth::proved && !has_more_hypotheses(outcome, proved)) {
        survivors.push_back(claim.id + " without " + assumption.id);
      }
    }
  }
  CAPTURE(fmt::format("{}", survivors));
  CHECK(survivors.empty());
  CHECK(deleted > 700);
  CHECK(by_kernel > 200);
}
