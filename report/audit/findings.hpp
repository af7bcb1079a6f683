// What an audit found, in words and in the order in which a reader wants it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::report::audit {

// "The paper holds, with corrections.": what the worst status of its statements comes to, as far as they are
// stated by claims.
[[nodiscard]] std::string verdict_lead(const proofs::methods::Paper& paper,
                                       const proofs::methods::Audit& audit);

// One sentence with the number of the paper's statements of each status; empty if the audit answers none.
[[nodiscard]] std::string verdict_sentence(const proofs::methods::Paper& paper,
                                           const proofs::methods::Audit& audit);

// One sentence with the number of claims that are not the paper's, by origin; empty if there are none.
[[nodiscard]] std::string sentence_of_ours(const proofs::methods::Audit& audit);

// How findings, refuted ones among them and statements are related, in a sentence; empty if nothing is found.
[[nodiscard]] std::string sentence_of_findings(const proofs::methods::Paper& paper,
                                               const proofs::methods::Audit& audit);

// Those with remarks first, in the order of their weight, except for what the paper does not say, which is
// last. Points into the audit.
[[nodiscard]] std::vector<const proofs::methods::Record *> findings_by_weight(
    const proofs::methods::Paper& paper, const proofs::methods::Audit& audit);

// The same things that must not vanish, brought in by the proofs of some claims and inherited by others.
struct HypothesisGroup {
  std::vector<proofs::methods::Hypothesis> hypotheses;
  std::vector<const proofs::methods::Record *> origins;
  std::set<std::string> inherited_by;  // ids

  // That of a claim which needs nothing else.
  [[nodiscard]] proofs::methods::Status status() const;
};

// All hypotheses beyond the paper's, each once, those with most statements behind them first. Points into the
// audit.
[[nodiscard]] std::vector<HypothesisGroup> hypothesis_groups(const proofs::methods::Audit& audit);

}  // namespace stickslip::report::audit
