#include "proofs/methods/prover.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "core/ball.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "proofs/checks/cross_check.hpp"
#include "proofs/checks/mutants.hpp"
#include "proofs/checks/premises.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/gate.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/symbols/sample.hpp"

namespace stickslip::proofs::methods {

using namespace checks;
using namespace symbols;

namespace {

// Whether all that it prints is what it assumes.
bool says_what_it_assumes(const Claim& claim) {
  const auto is_assumed = [&](const Statement& one) {
    return std::ranges::any_of(claim.assumptions, [&](const Assumption& assumption) {
      return !is_of_root(assumption) && equal(assumption.statement, one);
    });
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
      return evaluate<Ball>(hypothesis.nonzero, at_point(data))(0, 0).is_nonzero();
    });
  }
  return hypotheses;
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

std::optional<Prover::Thread> Prover::at_work_on(const std::string& id) const {
  for (const auto& [thread, ids] : under_way_) {
    if (std::ranges::find(ids, id) != ids.end()) {
      return thread;
    }
  }
  return std::nullopt;
}

bool Prover::comes_back(std::string id) const {
  for (;;) {
    const std::optional<Thread> at_work = at_work_on(id);
    if (!at_work || *at_work == std::this_thread::get_id()) {
      return at_work.has_value();
    }
    const auto awaited = awaited_.find(*at_work);
    if (awaited == awaited_.end()) {
      return false;
    }
    id = awaited->second;
  }
}

const Record& Prover::prove(const std::string& id) {
  const Claim& wanted = claim(id);
  const Thread me = std::this_thread::get_id();
  std::unique_lock lock(mutex_);
  for (;;) {
    if (const auto known = records_.find(id); known != records_.end()) {
      return known->second;
    }
    if (!at_work_on(id)) {
      break;
    }
    if (comes_back(id)) {
      throw InternalError(
          fmt::format("the proof of {} uses itself: {}", id, fmt::join(under_way_.at(me), " -> ")));
    }
    awaited_[me] = id;
    something_is_done_.wait(lock);
    awaited_.erase(me);
  }
  under_way_[me].push_back(id);
  lock.unlock();
  const auto done = [&] {
    lock.lock();
    under_way_[me].pop_back();
    something_is_done_.notify_all();
  };
  try {
    Record record = proved(wanted);
    done();
    return records_.emplace(id, std::move(record)).first->second;
  } catch (...) {
    done();
    throw;
  }
}

Record Prover::proved(const Claim& claim) {
  Record record{claim, {}, {}, {}, {}};
  const Given has_values(claim);  // none of which goes in a circle: that would be no end
  record.outcome = claim.prove ? claim.prove(*this, claim) : taken_as_given(claim);
  look_for_witness(record.outcome, *this, claim);
  if (record.outcome.verdict.truth == Truth::refuted && claim.prove_corrected) {
    const Claim reading = saying(claim, claim.corrected);
    record.corrected = reading.prove_corrected(*this, reading);
  } else if (record.outcome.verdict.truth == Truth::refuted && !claim.printed.empty()) {
    repair(*this, record);
  }
  if (claim.prove_converse) {
    record.converse = claim.prove_converse(*this, claim);
  }
  const bool premises_stand = inherit(record.corrected ? *record.corrected : record.outcome, claim) &&
                              (!record.converse || inherit(*record.converse, claim));
  confirm(record.outcome, claim, claim.printed, {});
  if (record.corrected) {
    confirm(*record.corrected, saying(claim, record.claim.corrected), record.claim.corrected,
            record.outcome.theorems);
  }
  if (record.converse) {
    confirm(*record.converse, claim, {}, {});
  }
  record.status = status_of(record, premises_stand);
  return record;
}

void Prover::begin(const std::vector<std::string>& ids) {
  const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  left_to_begin_ = ids.size();
  const std::shared_ptr<const Vocabulary> here(std::shared_ptr<void>(), &vocabulary_here());
  const long bits = WorkingPrecision::bits();
  for (std::size_t k = 1; k < threads; ++k) {
    others_.emplace_back([this, ids, here, bits](const std::stop_token& stop) {
      give_numbers_back_at_end();
      const InVocabulary names(here);
      const WorkingPrecision precision(bits);
      while (!stop.stop_requested() && !interrupted()) {
        const std::size_t left = left_to_begin_--;
        if (left == 0 || left > ids.size()) {
          return;
        }
        try {
          static_cast<void>(prove(ids[left - 1]));
        } catch (const std::exception&) {
          continue;
        }
      }
    });
  }
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
  const Claim reading = saying(claim, form);
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

std::vector<Hypothesis> joined(std::vector<Hypothesis> a, const std::vector<Hypothesis>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::stable_sort(a.begin(), a.end(),
                   [](const Hypothesis& x, const Hypothesis& y) { return x.text < y.text; });
  a.erase(std::unique(a.begin(), a.end(),
                      [](const Hypothesis& x, const Hypothesis& y) { return x.text == y.text; }),
          a.end());
  return a;
}

Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids, const Progress& progress) {
  Prover prover(claims);
  for (const std::string& id : ids) {
    (void)prover.claim(id);
  }
  std::vector<std::string> asked;
  for (const Claim& claim : claims) {
    if (ids.empty() || ids.contains(claim.id)) {
      asked.push_back(claim.id);
    }
  }
  prover.begin(asked);
  Audit result;
  for (const std::string& id : asked) {
    progress(id, result.records.size(), asked.size());
    try {
      const Record& record = prover.prove(id);
      if (interrupted()) {
        break;  // what this claim rests on may have been cut short
      }
      result.records.push_back(record);
    } catch (const Error&) {
      if (!interrupted()) {
        throw;
      }
      break;
    }
  }
  for (Record& record : result.records) {
    for (const Record& other : result.records) {
      if (other.outcome.uses.contains(record.claim.id) ||
          (other.corrected && other.corrected->uses.contains(record.claim.id)) ||
          (other.converse && other.converse->uses.contains(record.claim.id))) {
        record.used_by.insert(other.claim.id);
      }
    }
  }
  return result;
}

Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids) {
  return audit(claims, ids, [](const std::string&, std::size_t, std::size_t) {});
}

}  // namespace stickslip::proofs::methods
