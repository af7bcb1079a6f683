// Proves claims in the order in which they need each other, and says how far that is.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

// An audit that says how far it is.

// Called before each claim: its id, how many are done, how many there are.
using Progress = std::function<void(const std::string& id, std::size_t done, std::size_t all)>;

// The audit of claim.hpp; after an interruption the records made before it.
[[nodiscard]] Audit audit(const std::vector<Claim>& claims, const std::set<std::string>& ids,
                          const Progress& progress);

// Proves claims in the order in which they need each other.

class Prover {
 public:
  explicit Prover(const std::vector<Claim>& claims);

  // The record of a claim, proved now unless it was before; where another thread is at it, when that is done.
  // Throws InternalError for an unknown id and for a proof that comes back to its own claim.
  const Record& prove(const std::string& id);
  // The first theorem of the form of it that is proved. Throws KernelError if it has none.
  const kernel::Theorem& theorem(const std::string& id);

  [[nodiscard]] const Claim& claim(const std::string& id) const;
  // The claims that stand before it.
  [[nodiscard]] std::vector<const Claim *> before(const std::string& id) const;

  // Where there may be several threads, others begin with these claims, from the last on; what fails there
  // fails again for who asks for it.
  void begin(const std::vector<std::string>& ids);

 private:
  using Thread = std::thread::id;

  // What it takes, by this thread.
  Record proved(const Claim& claim);
  // Who has the claim under way; and whether that thread waits, perhaps for others that wait, for this one.
  [[nodiscard]] std::optional<Thread> at_work_on(const std::string& id) const;
  [[nodiscard]] bool comes_back(std::string id) const;
  // Adds the hypotheses of all that the outcome uses, takes away those that the claim states; whether all
  // that it uses stands.
  bool inherit(Outcome& outcome, const Claim& claim);
  // The claim that brought in the hypothesis of this text, among these and all that they use.
  std::optional<std::string> origin_of(const std::string& hypothesis, const std::set<std::string>& uses);
  // Has what is proved looked at: whether there is anything that obeys all that is assumed. Where that is
  // neither known nor said to be a contradiction, it is undecided. A refutation of the form as printed says
  // so of what is assumed.
  void look_for_values(Outcome& outcome, const Claim& claim, const std::vector<kernel::Theorem>& refutation);
  // Whether another claim's theorem says that there is something which obeys all that this one assumes.
  bool is_met(const Claim& claim);
  // Has the verdict compared with the claim (gate.hpp), and looked at by two further engines. Throws
  // InternalError if something is not so.
  void confirm(Outcome& outcome, const Claim& claim, const std::vector<symbols::Statement>& form,
               const std::vector<kernel::Theorem>& refutation);

  std::vector<const Claim *> in_order_;
  std::map<std::string, const Claim *> claims_;
  std::map<std::string, std::string> met_by_;  // the claim whose theorem says so

  std::mutex mutex_;  // of all that follows
  std::condition_variable something_is_done_;
  std::map<std::string, Record> records_;
  std::map<Thread, std::vector<std::string>> under_way_;  // each for the one before it
  std::map<Thread, std::string> awaited_;
  std::atomic<std::size_t> left_to_begin_ = 0;
  std::vector<std::jthread> others_;  // the first to end
};

// What a claim offers as a premise: the form that was proved, as printed or corrected. The caller records the
// id.
[[nodiscard]] const std::vector<symbols::Statement>& proved_form(const Record& record);
// Of the corrected form where there is one, else of the printed.
[[nodiscard]] const Outcome& final_outcome(const Record& record);

// Hypotheses joined without repetition, in order of their text; of equal ones the first stays.
[[nodiscard]] std::vector<Hypothesis> joined(std::vector<Hypothesis> a, const std::vector<Hypothesis>& b);

}  // namespace stickslip::proofs::methods
