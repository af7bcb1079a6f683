#include "proofs/methods/prover.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/checks/cross_check.hpp"
#include "proofs/checks/premise_point.hpp"
#include "proofs/checks/repair.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/gate.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/methods/visible.hpp"
#include "proofs/symbols/point.hpp"
#include "symbolic/algebra/hypotheses.hpp"
#include "symbolic/algebra/signs.hpp"
#include "symbolic/typeset/latex.hpp"

namespace stickslip::proofs::methods {

using namespace checks;
using namespace symbols;

namespace {

// Whether all that it prints is what it assumes.
bool says_what_it_assumes(const Claim& claim) {
  const auto is_assumed = [&](const Statement& one) {
    return std::ranges::any_of(
        claim.assumptions, [&](const Assumption& assumption) { return equal(assumption.statement, one); });
  };
  return !claim.printed.empty() && std::ranges::all_of(claim.printed, is_assumed);
}

Status status_of(const Record& record, bool premises_stand) {
  const bool repaired = record.corrected && record.corrected->verdict.truth == Truth::proved;
  switch (record.outcome.verdict.truth) {
    case Truth::proved:
      if (!premises_stand) {
        return Status::rests_on_unproved;
      }
      if (record.converse && record.converse->verdict.truth != Truth::proved) {
        return record.converse->verdict.truth == Truth::refuted ? Status::necessary_not_sufficient
                                                                : Status::undecided;
      }
      if (!record.outcome.hypotheses.empty()) {
        return needing(record.outcome.hypotheses);
      }
      if (says_what_it_assumes(record.claim)) {
        return Status::premise;
      }
      if (!record.outcome.by_kernel) {
        return Status::decided_in_balls;
      }
      return record.claim.origin == Origin::paper ? Status::as_printed : Status::proved;
    case Truth::refuted:
      if (record.claim.kind == Kind::numbers) {
        return Status::digits_off;
      }
      return repaired && premises_stand ? Status::misprint_corrected : Status::refuted;
    case Truth::assumed:
      return Status::model;
    case Truth::checked:
      return Status::checked;
    case Truth::undecided:
      break;
  }
  return Status::undecided;
}

Outcome taken_as_given(const Claim& claim) {
  Outcome outcome;
  outcome.verdict =
      Verdict::assumed(claim.kind == Kind::definition ? "a definition of names: there is nothing to prove"
                                                      : "an equation of the model, taken as given");
  return outcome;
}

// The hypotheses that are not met at the data; all of them where the proof is for all data.
std::vector<Hypothesis> open_at(std::vector<Hypothesis> hypotheses, const std::vector<Coordinate>& data) {
  if (!data.empty()) {
    std::erase_if(hypotheses, [&](const Hypothesis& hypothesis) {
      return evaluate(hypothesis.nonzero, at_point(data)).is_nonzero();
    });
  }
  return hypotheses;
}

// Whether the relation excludes that both sides are equal.
bool keeps_apart(Relation relation) {
  return relation == Relation::not_equal || relation == Relation::less || relation == Relation::greater;
}

// What a claim assumes not to be zero, with all that it assumes put in, and with each of its "symbol = value"
// alone (Theta may be given both as tau + tau_1 and as 2 pi/omega).
std::vector<GiNaC::ex> readings(const Claim& claim, const Term& nonzero) {
  std::vector<GiNaC::ex> result{evaluate<GiNaC::ex>(nonzero, Given(claim).lookup())(0, 0)};
  for (const Assumption& assumption : claim.assumptions) {
    if (is_substitution(assumption)) {
      const Replacements alone{{assumption.statement.left.name(), assumption.statement.right}};
      result.push_back(evaluate<GiNaC::ex>(substitute(nonzero, alone), symbolically())(0, 0));
    }
  }
  return result;
}

// Takes away the hypotheses that the claim itself states: where one fails, something is zero that the claim
// assumes is not.
void discharge_stated(Outcome& outcome, const Claim& claim) {
  for (const Assumption& assumption : claim.assumptions) {
    const Term nonzero = assumption.statement.left - assumption.statement.right;
    if (outcome.hypotheses.empty() || !keeps_apart(assumption.statement.relation) || !is_in_field(nonzero)) {
      continue;
    }
    const std::vector<GiNaC::ex> stated = readings(claim, nonzero);
    const auto discharged = std::erase_if(outcome.hypotheses, [&](const Hypothesis& hypothesis) {
      return std::any_of(stated.begin(), stated.end(), [&](const GiNaC::ex& one) {
        return symbolic::algebra::vanishes_with(one, hypothesis.nonzero);
      });
    });
    if (discharged > 0) {
      outcome.assumed.insert(assumption.id);
    }
  }
}

// Takes away the hypotheses that another one contains, as sin(2x) != 0 contains sin(x) != 0.
void keep_strongest(std::vector<Hypothesis>& hypotheses) {
  const std::vector<Hypothesis> all = hypotheses;
  std::erase_if(hypotheses, [&](const Hypothesis& weak) {
    return std::any_of(all.begin(), all.end(), [&](const Hypothesis& strong) {
      return strong.text != weak.text && symbolic::algebra::vanishes_with(strong.nonzero, weak.nonzero) &&
             !symbolic::algebra::vanishes_with(weak.nonzero, strong.nonzero);
    });
  });
}

// Whether it is said that the assumptions contradict one another: 0 > 0.
bool says_contradiction(const std::vector<Statement>& form) {
  return form.size() == 1 && equal(form[0].left, form[0].right) &&
         (form[0].relation == Relation::less || form[0].relation == Relation::greater);
}

}  // namespace

Prover::Prover(const std::vector<Claim>& claims) {
  for (const Claim& claim : claims) {
    in_order_.push_back(&claim);
    if (!claims_.emplace(claim.id, &claim).second) {
      throw InternalError("two claims have the id " + claim.id);
    }
    for (const std::string& met : claim.meets) {
      met_by_.emplace(met, claim.id);
    }
  }
}

const Claim& Prover::claim(const std::string& id) const {
  const auto found = claims_.find(id);
  if (found == claims_.end()) {
    throw InternalError("there is no claim " + id);
  }
  return *found->second;
}

std::vector<const Claim *> Prover::before(const std::string& id) const {
  return {in_order_.begin(), std::ranges::find(in_order_, id, &Claim::id)};
}

const Record& Prover::prove(const std::string& id) {
  if (const auto known = records_.find(id); known != records_.end()) {
    return known->second;
  }
  if (std::find(under_way_.begin(), under_way_.end(), id) != under_way_.end()) {
    throw InternalError(fmt::format("the proof of {} uses itself: {}", id, fmt::join(under_way_, " -> ")));
  }
  under_way_.push_back(id);
  Record record{claim(id), {}, {}, {}, {}};
  const Given has_values(record.claim);  // none of which goes in a circle: that would be no end
  record.outcome = outcome_of(record.claim);
  look_for_witness(record.outcome, *this, record.claim);
  if (record.outcome.verdict.truth == Truth::refuted && record.claim.prove_corrected) {
    Claim reading = record.claim;
    reading.printed = reading.corrected;
    record.corrected = reading.prove_corrected(*this, reading);
  } else if (record.outcome.verdict.truth == Truth::refuted && !record.claim.printed.empty()) {
    repair(*this, record);
  }
  if (record.claim.prove_converse) {
    record.converse = record.claim.prove_converse(*this, record.claim);
  }
  const bool premises_stand = inherit(record.corrected ? *record.corrected : record.outcome, record.claim) &&
                              (!record.converse || inherit(*record.converse, record.claim));
  confirm(record.outcome, record.claim, record.claim.printed, {});
  if (record.corrected) {
    confirm(*record.corrected, record.claim, record.claim.corrected, record.outcome.theorems);
  }
  if (record.converse) {
    confirm(*record.converse, record.claim, {}, {});
  }
  record.status = status_of(record, premises_stand);
  under_way_.pop_back();
  return records_.emplace(id, std::move(record)).first->second;
}

void Prover::begin(const std::vector<std::string>& ids) {
  if (tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) < 2) {
    return;
  }
  std::vector<std::packaged_task<Outcome()>> tasks;
  for (const std::string& id : ids) {
    if (claim(id).compute) {
      tasks.emplace_back(claim(id).compute);
      begun_.emplace(id, tasks.back().get_future());
    }
  }
  computing_ = std::async(std::launch::async, [tasks = std::move(tasks)]() mutable {
    for (std::packaged_task<Outcome()>& task : tasks) {
      task();
    }
  });
}

Outcome Prover::outcome_of(const Claim& claim) {
  if (!claim.compute) {
    return claim.prove ? claim.prove(*this, claim) : taken_as_given(claim);
  }
  const auto begun = begun_.find(claim.id);
  Outcome outcome = begun != begun_.end() ? begun->second.get() : claim.compute();
  if (claim.prove || !outcome.theorems.empty()) {
    throw InternalError(claim.id + " is computed, and makes theorems or has a proof");
  }
  return outcome;
}

const kernel::Theorem& Prover::theorem(const std::string& id) {
  const std::vector<kernel::Theorem>& theorems = final_outcome(prove(id)).theorems;
  if (theorems.empty()) {
    throw kernel::KernelError("of " + id + " there is no theorem");
  }
  return theorems.front();
}

void Prover::confirm(Outcome& outcome, const Claim& claim, const std::vector<Statement>& form,
                     const std::vector<kernel::Theorem>& refutation) {
  const Truth truth = outcome.verdict.truth;
  if (truth != Truth::proved && truth != Truth::refuted) {
    outcome.cross_check.unchecked = "it is neither proved nor refuted";
    return;
  }
  pass_gate(*this, claim, form, outcome);
  Claim reading = claim;
  reading.printed = form;
  outcome.cross_check = cross_check(*this, reading, outcome);
  if (truth == Truth::proved) {
    look_for_values(outcome, reading, refutation);
  }
}

bool Prover::is_met(const Claim& claim) {
  const auto by = met_by_.find(claim.id);
  if (by == met_by_.end()) {
    return false;
  }
  const std::vector<kernel::Theorem>& theorems = prove(by->second).outcome.theorems;
  if (theorems.empty()) {
    return false;  // its proof failed, and its own status says so
  }
  if (!says_that_there_are_values(theorems.front(), assumed_by(claim))) {
    throw InternalError(
        fmt::format("{} does not say that what {} assumes can be obeyed", by->second, claim.id));
  }
  return true;
}

// Points in balls are those at which all that can be evaluated holds: motions may be left out of that.
void Prover::look_for_values(Outcome& outcome, const Claim& claim,
                             const std::vector<kernel::Theorem>& refutation) {
  if (claim.assumptions.empty()) {
    return;
  }
  if (says_contradiction(claim.printed)) {
    outcome.obeyed = Obeyed::by_contradiction;
    return;
  }
  outcome.obeyed = Obeyed::unknown;
  const bool refuted_there = std::ranges::any_of(refutation, [&](const kernel::Theorem& theorem) {
    return says_that_there_are_values(theorem, assumed_by(claim));
  });
  if (refuted_there || is_met(claim) || obeying_values(*this, claim, outcome.hypotheses)) {
    outcome.obeyed = Obeyed::theorem;
    return;
  }
  Outcome alone;  // of what the claim assumes, and not of what its proof uses
  alone.hypotheses = outcome.hypotheses;
  const Premises premises = premises_of(*this, claim, alone);
  const bool seen = outcome.cross_check.premise_points > 0 || !premise_points(premises, 1).empty();
  if (!seen && obeying_point(*this, claim, outcome.hypotheses)) {
    outcome.obeyed = Obeyed::theorem;
  } else if (contradiction(*this, claim)) {
    outcome.verdict = Verdict::undecided("vacuous: what is assumed contradicts itself, and nothing obeys it");
  } else if (!seen || !premises.left_out.empty()) {  // a motion may obey no two laws at one time
    outcome.verdict =
        Verdict::undecided("vacuous or unknown: nothing is known with which all that is assumed holds");
  } else {
    outcome.obeyed = Obeyed::balls;
  }
}

std::optional<std::string> Prover::origin_of(const std::string& hypothesis,
                                             const std::set<std::string>& uses) {
  for (const std::string& used : uses) {
    const Outcome& premise = final_outcome(prove(used));
    for (const Hypothesis& one : premise.hypotheses) {
      if (one.text == hypothesis) {
        return one.origin;
      }
    }
    if (const auto deeper = origin_of(hypothesis, premise.uses)) {
      return deeper;
    }
  }
  return std::nullopt;
}

bool Prover::inherit(Outcome& outcome, const Claim& claim) {
  bool all_stand = true;
  for (const std::string& used : outcome.uses) {
    const Record& premise = prove(used);
    all_stand = all_stand && facts(premise.status).stands;
    const std::vector<Hypothesis>& from = final_outcome(premise).hypotheses;
    if (!outcome.by_kernel) {
      outcome.hypotheses = joined(open_at(from, outcome.at), outcome.hypotheses);
    }
  }
  if (outcome.by_kernel) {
    // A theorem has all its hypotheses itself; what stood in a premise comes from there.
    for (Hypothesis& own : outcome.hypotheses) {
      own.origin = origin_of(own.text, outcome.uses).value_or(own.origin);
    }
  } else {
    discharge_stated(outcome, claim);
    keep_strongest(outcome.hypotheses);
  }
  for (Hypothesis& one : outcome.hypotheses) {
    one.visible = is_seen(one, claim, this->claim(one.origin));
  }
  return all_stand;
}

const std::vector<Statement>& proved_form(const Record& record) {
  return record.corrected ? record.claim.corrected : record.claim.printed;
}

const Outcome& final_outcome(const Record& record) {
  return record.corrected ? *record.corrected : record.outcome;
}

Hypothesis hypothesis(const GiNaC::ex& nonzero, const std::string& origin) {
  return {nonzero, symbolic::typeset::text(nonzero) + " != 0", symbolic::typeset::latex(nonzero) + " \\neq 0",
          origin};
}

std::vector<Hypothesis> joined(std::vector<Hypothesis> a, const std::vector<Hypothesis>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::stable_sort(a.begin(), a.end(),
                   [](const Hypothesis& x, const Hypothesis& y) { return x.text < y.text; });
  a.erase(std::unique(a.begin(), a.end(),
                      [](const Hypothesis& x, const Hypothesis& y) { return x.text == y.text; }),
          a.end());
  return a;
}

}  // namespace stickslip::proofs::methods
