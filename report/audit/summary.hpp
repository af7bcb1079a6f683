// What an audit comes to: counts, findings, and whether everything is decided.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::report::audit {

// A paper, and an audit of it.
struct Audited {
  const proofs::methods::Paper& paper;
  const proofs::methods::Audit& audit;
};

struct StatusCount {
  proofs::methods::Status status = proofs::methods::Status::undecided;
  std::size_t count = 0;
};

// The statuses that occur among the paper's statements, from the best to the worst.
[[nodiscard]] std::vector<StatusCount> count_statements(const Audited& all);

// The claims of one origin.
struct OriginCount {
  proofs::methods::Origin origin = proofs::methods::Origin::paper;
  std::size_t count = 0;
  std::vector<StatusCount> statuses;  // that occur, from the best to the worst
};

// The origins that occur among the claims.
[[nodiscard]] std::vector<OriginCount> count_origins(const proofs::methods::Audit& audit);

// Whose statements are audited: "the paper", or where no claim is of a paper's print "text books".
[[nodiscard]] std::string source_of(const proofs::methods::Audit& audit);

// Worth a reader's attention: everything that is neither proved as it stands nor part of the model. A claim
// that only inherits another claim's hypothesis is not a finding of its own.
[[nodiscard]] bool is_finding(const proofs::methods::Record& record);

// The results whose claims all are in the audit, and none of them undecided.
[[nodiscard]] std::vector<proofs::methods::Result> results_in(const Audited& all);

// The sentence with what claims found in the place of their ids in braces: "both occur: {S.lag}". Where the
// audit has no such claim: "both occur: see S.lag".
[[nodiscard]] std::string with_answers(const std::string& sentence, const proofs::methods::Audit& audit);

// The other claims that hold only under a hypothesis which this claim's proof brought in.
[[nodiscard]] std::set<std::string> inheriting(const proofs::methods::Audit& audit,
                                               const proofs::methods::Record& record);

// Whether every question is answered, one way or the other.
[[nodiscard]] bool all_decided(const proofs::methods::Audit& audit);

// A sentence for each claim that has another status than it is expected to have.
[[nodiscard]] std::vector<std::string> unexpected(const proofs::methods::Audit& audit);

// Whether some statement is refuted (printed digits included) without a corrected form that is proved.
[[nodiscard]] bool any_refuted(const proofs::methods::Audit& audit);

// How two further engines looked at a verdict: "3 formulas agree exactly at 2 rational points and in balls at
// 2 real points", or why they did not.
[[nodiscard]] std::string cross_check_line(const proofs::methods::CrossCheck& check);

// "64 statements of the paper: 57 as printed, 2 model, 5 misprint corrected. Beside them 3 converses: 3
// proved." Of an audit that is not whole, where a statement may have other claims as well: "4 claims of the
// paper: 4 as printed; 1 converse: 1 proved."
[[nodiscard]] std::string summary_line(const Audited& all);

// The consecutive records of one place.
struct PlaceRecords {
  std::string id;
  std::string title;  // of the section, else the id
  std::vector<const proofs::methods::Record *> records;
};

// The records by place, in the order in which places first occur. Points into the audit.
[[nodiscard]] std::vector<PlaceRecords> by_place(const Audited& all);

// What an audit found, in words and in the order in which a reader wants it.

// "The paper holds, with corrections.": what the worst status of its statements comes to, as far as they are
// stated by claims.
[[nodiscard]] std::string verdict_lead(const Audited& all);

// One sentence with the number of the paper's statements of each status; empty if the audit answers none.
[[nodiscard]] std::string verdict_sentence(const Audited& all);

// One sentence with the number of claims that are not the paper's, by origin; empty if there are none.
[[nodiscard]] std::string sentence_of_ours(const proofs::methods::Audit& audit);

// How findings, refuted ones among them and statements are related, in a sentence; empty if nothing is found.
[[nodiscard]] std::string sentence_of_findings(const Audited& all);

// Those with remarks first, in the order of their weight, except for what the paper does not say, which is
// last. Points into the audit.
[[nodiscard]] std::vector<const proofs::methods::Record *> findings_by_weight(const Audited& all);

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
