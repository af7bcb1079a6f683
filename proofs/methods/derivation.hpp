// A claim's proof in the kernel: what it assumes as formulas, its premises as theorems, what follows by
// rules, and what that says of the claim.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proofs/kernel/term.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/tactics/slopes.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::methods {

class Derivation {
 public:
  // What the claim assumes and no formula can say is not at hand.
  Derivation(Prover& prover, const Claim& claim);

  [[nodiscard]] Prover& prover() const { return prover_; }
  [[nodiscard]] const Claim& claim() const { return claim_; }

  [[nodiscard]] kernel::Term read(const symbols::Term& printed) { return read_(printed); }
  [[nodiscard]] kernel::Formula read(const symbols::Statement& statement) { return read_(statement); }

  // What the claim prints, by its number from 0.
  [[nodiscard]] kernel::Formula printed(std::size_t which) { return read_(claim_.printed[which]); }
  // With the values that the claim's assumptions give ("tau = pi/omega") wherever their symbols stand.
  [[nodiscard]] kernel::Term with_values(kernel::Term term) const;

  // The claim's assumptions.
  [[nodiscard]] kernel::Formulas assumed() const;

  // The premise's statement of this number, from 0, with what the premise replaces. Throws KernelError if its
  // claim has no theorem that says so.
  [[nodiscard]] kernel::Theorem premise(const Premise& premise, std::size_t which = 0);

  // By the kernel's rules of these names, with as few definitions opened and as few of the given values
  // ("tau = pi/omega") put in as it takes. Throw KernelError. The equation may hold with derivatives that
  // there are (Reader).
  [[nodiscard]] kernel::Theorem combination(const kernel::Formula& equation,
                                            const std::vector<kernel::Multiple>& multiples = {});
  [[nodiscard]] kernel::Theorem order(const kernel::Formula& inequality,
                                      const std::vector<kernel::Positive>& positives = {},
                                      const std::vector<kernel::Multiple>& multiples = {});
  // An inequality or an equation, or several, from what the claim assumes.
  [[nodiscard]] kernel::Theorem follows(const kernel::Formula& formula);
  // An inequality or an equation as tactics/relations finds it from all that is known, all definitions looked
  // into.
  [[nodiscard]] kernel::Theorem related(const kernel::Formula& formula);
  // An equation between numbers as a combination of those that the claim assumes, which is looked for
  // (letters.hpp).
  [[nodiscard]] kernel::Theorem combined(const kernel::Formula& equation);
  // That there are derivatives with which something holds, by how that is shown of them.
  [[nodiscard]] kernel::Theorem with_derivatives(const kernel::Formula& formula, const tactics::Shown& shown);
  // What the work makes where the inequality is known, too: it is a hypothesis then.
  [[nodiscard]] kernel::Theorem supposing(const kernel::Formula& inequality,
                                          const std::function<kernel::Theorem()>& work);
  // All definitions in these formulas, to be looked into.
  [[nodiscard]] kernel::Definitions open(const std::vector<kernel::Formula>& formulas);
  // a = b: b is put in for a wherever that stands.
  void give(const kernel::Theorem& equation) { given_.push_back({"", equation}); }
  // Divisors are discharged with a theorem d ≠ 0, too.
  void know(const kernel::Theorem& nonzero) { stated_.push_back(nonzero); }
  // 0 < a, under hypotheses that its factors are not zero. That sin x is positive follows from 0 < x < pi.
  [[nodiscard]] kernel::Theorem positive(const kernel::Term& a);

  // Theorems of what the claim prints, in its order: the verdict, and what it assumes and divides by. Throws
  // KernelError if one of them says something else or rests on what the claim does not assume.
  void conclude(Outcome& outcome, const std::vector<kernel::Theorem>& theorems);
  // Of a theorem that rests on no more than that, and on what is allowed besides: what it assumes, divides by
  // and uses. Throws KernelError likewise.
  void record(Outcome& outcome, const kernel::Theorem& theorem, const kernel::Formulas& allowed = {});
  // The theorem without hypotheses that follow from what the claim assumes, or from claims that supply them.
  [[nodiscard]] kernel::Theorem settled(const kernel::Theorem& theorem);
  // The theorem with fewer and simpler hypotheses d ≠ 0: less what the parameters' domain and the claim's
  // assumptions imply, the irreducible factors of the rest, and of these the strongest.
  [[nodiscard]] kernel::Theorem without_divisors(const kernel::Theorem& theorem);
  // From now on nothing is looked for that takes long, as related() does.
  void hurry() { hurries_ = true; }
  // From now on d ≠ 0 may also follow from a sign of d that is looked for (tactics/relations).
  void look_for_signs() { looks_for_signs_ = true; }
  // From now on all d ≠ 0 stay as they are: for who puts numbers in.
  void leave_divisors() { divisors_stay_ = true; }

 private:
  bool divisors_stay_ = false, looks_at_sines_ = false, hurries_ = false, looks_for_signs_ = false;
  struct Given {
    std::string id;
    kernel::Theorem equation;
    [[nodiscard]] const kernel::Term& symbol() const { return equation.conclusion().parts()[0]; }
    [[nodiscard]] const kernel::Term& value() const { return equation.conclusion().parts()[1]; }
  };
  struct Problem {
    kernel::Formula goal;
    std::vector<kernel::Multiple> multiples = {};
    std::vector<kernel::Positive> positives = {};
  };
  using Rule = std::function<kernel::Theorem(const Problem&)>;

  void look_at_roots();
  void look_into_stated();
  [[nodiscard]] std::vector<kernel::Theorem> inequalities() const;  // of the domain and of what is known
  [[nodiscard]] std::optional<kernel::Theorem> differs_by_sign(const kernel::Formula& divisor) const;
  [[nodiscard]] std::vector<kernel::Theorem> positive_sines(const kernel::Term& term);
  [[nodiscard]] static std::vector<kernel::Term> terms_of(const Problem& problem);
  [[nodiscard]] static std::vector<kernel::Term> residual(const Problem& problem);
  [[nodiscard]] kernel::Theorem solved(const Problem& problem, bool is_order);
  [[nodiscard]] kernel::Theorem with_fewest_given(const Problem& problem, const Rule& rule);
  [[nodiscard]] kernel::Theorem with_given(const Problem& problem, const std::set<std::string>& ids,
                                           const Rule& rule, std::set<std::string>& used, int depth = 0);

  Prover& prover_;
  const Claim& claim_;
  Reader read_;
  std::map<kernel::Formula, std::string> assumed_;  // formulas, and the ids of the assumptions
  std::vector<Given> given_;
  std::vector<kernel::Theorem> stated_;  // d ≠ 0, not looked into yet
  std::vector<kernel::Theorem> opened_stated_;
  kernel::Formulas stated_nonzero_;        // d ≠ 0 that the claim assumes
  std::vector<kernel::Theorem> known_;     // inequalities that the claim assumes
  std::vector<kernel::Theorem> supplied_;  // of claims that take the place of a premise's assumptions
  tactics::Domain domain_;
  std::set<std::string> uses_;  // claims that were premises, or whose definitions were looked into
};

// How one of the printed statements, by its number from 0, is derived.
using Derive = std::function<kernel::Theorem(Derivation&, std::size_t)>;

// What the work says where it throws KernelError, or symbols::NoValue; nothing where it does not.
std::optional<std::string> failure_of(const std::function<void()>& work);

// 0 < 0, or 1 = 0, from what the claim assumes: nothing obeys it. Nothing where no contradiction is found.
[[nodiscard]] std::optional<kernel::Theorem> contradiction(Prover& prover, const Claim& claim);

// What the claim prints, as the kernel derives it; undecided where it does not.
[[nodiscard]] Outcome derived(const std::string& route, Prover& prover, const Claim& claim,
                              const Derive& derive);
[[nodiscard]] Proof by_kernel(const std::string& route, const Derive& derive);

// Whether the part stands somewhere in the term.
[[nodiscard]] bool occurs(const kernel::Term& part, const kernel::Term& term);
// The parts of the term, itself among them, of which this is so.
[[nodiscard]] std::set<kernel::Term> parts_that(const kernel::Term& term,
                                                const std::function<bool(const kernel::Term&)>& are_so);
using tactics::gap_of, tactics::is_inequality;

// Products that are not negative.

// 0 ≤ a, for the kernel's rule `order`: a as a positive number times a square times what is positive. All
// definitions are looked into. Throws KernelError where the sign of a factor is not known.
[[nodiscard]] kernel::Positive not_negative(Derivation& derivation, const kernel::Term& a);

// Which definitions a proof may look into.

// The definitions in some formulas, and in one another, by what a proof opens them for.
struct Openings {
  static constexpr const char * coefficients = "21";  // what the coefficients of (21) stand under in `closed`

  kernel::Definitions names;     // of what is put together: Z_0, Q, delta_0
  kernel::Definitions formulas;  // of matrices and functions of the model: H(t), F(t), Gamma(t)
  std::map<std::string, kernel::Definitions> closed;  // of scalars, by the claim that says what they are

  [[nodiscard]] kernel::Definitions all() const;
  // All but the coefficients of (21), which are long and irreducible enough as names.
  [[nodiscard]] kernel::Definitions in_parameters() const;
  // All but those closed scalars whose claim is not among these.
  [[nodiscard]] kernel::Definitions with(const std::set<std::string>& ids) const;
};
[[nodiscard]] Openings openings(const std::vector<kernel::Formula>& formulas);

}  // namespace stickslip::proofs::methods
