// Derivations as proofs in Coq: a lemma for each step, and a theorem that says what the kernel's says.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/statements.hpp"

namespace stickslip::proofs::certificates {

struct Lemma {
  std::string file;
  std::string name;
  Stated stated;
  std::string half = {};  // "proj1", "proj2": what is said is this part of what the lemma says
};
// What has been proved in some file, by what it says: nothing is proved twice.
struct Library {
  std::map<std::pair<kernel::Formulas, kernel::Formula>, Lemma> lemmas;
  std::map<std::string, Lemma> tautologies;
  std::vector<kernel::Theorem> alive;  // so that a step's address is its own
  std::set<std::string> slow;  // files that interval arithmetic is loaded for, which takes half a second

  // Null if it is not there.
  [[nodiscard]] const Lemma * find(const kernel::Theorem& theorem) const;
  // Forgets the lemmas of a file.
  void erase(const std::string& file);
};

// One file of lemmas, which may use those of earlier files.
class Script {
 public:
  Script(const std::string& file, Library& library) : file_(file), library_(library) {}

  // Adds "Theorem name : forall (x : R) …, A -> … -> C", the sequent of the theorem in full, after a comment.
  // Throws KernelError for a rule that has no counterpart in Coq yet.
  void add(const std::string& name, const kernel::Theorem& theorem, const std::string& comment = {});

  [[nodiscard]] const std::string& text() const { return text_; }
  // Other files that it needs.
  [[nodiscard]] const std::set<std::string>& imports() const { return imports_; }
  // Files of the prelude that it needs beyond those that every certificate does.
  [[nodiscard]] const std::set<std::string>& needs() const { return needs_; }
  // Those that the lemmas speak of, each after those that it needs.
  [[nodiscard]] const std::vector<kernel::Definition>& definitions() const { return definitions_; }

 private:
  // What stands around a proof: the names of hypotheses, and the variables.
  struct Scope {
    std::map<kernel::Formula, std::string> hypotheses;
    kernel::Variables variables;
  };
  // Around the proof of what is stated, and "intros x hyp1.", or nothing.
  [[nodiscard]] static std::pair<Scope, std::string> opened_scope(const Stated& stated);
  void count(const kernel::Theorem& theorem);
  // What a file proved that is worth loading for it, or null.
  [[nodiscard]] const Lemma * known(const kernel::Theorem& theorem) const;
  [[nodiscard]] bool is_slow(const std::string& file) const;
  const Lemma& lemma(const kernel::Theorem& theorem);
  // A sign that bounds a number from one side, with another that bounds it from the other: both at once, for
  // Coq reads and encloses the number once then. Whether there is such another.
  bool state_between(const kernel::Theorem& theorem);
  const Lemma& imported(const Lemma& lemma);
  void state(const std::string& word, const Lemma& lemma, const kernel::Theorem& theorem);
  // The lemma applied, with values for its variables.
  [[nodiscard]] std::string applied(const Lemma& lemma, const Scope& scope,
                                    const kernel::Substitution& values = {}) const;
  // A proof of the theorem as a term: a lemma applied, or the step itself where it is no more than a word.
  [[nodiscard]] std::string term(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string inlined(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string hypothesis(const kernel::Formula& formula, const Scope& scope) const;
  // What the formula says: a long conjunction, and a bound that is assumed again and again, under a name of
  // its own, so that Coq reads it once, however many steps assume it.
  [[nodiscard]] std::string said(const kernel::Formula& formula);
  [[nodiscard]] bool is_named_bound(const kernel::Formula& formula) const;
  [[nodiscard]] std::string bounds_opened(const kernel::Theorem& theorem, const Scope& scope) const;
  // Whether no other step, here or in another file, is proved by it.
  [[nodiscard]] bool is_used_here_only(const kernel::Theorem& theorem);
  // A proof as tactics, of the last step.
  [[nodiscard]] std::string tactics(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string witness(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string combination(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string solved(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string order(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string sign(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string lettered(kernel::Formula& said) const;
  // Of a long number of which several signs are found: the name of a lemma that says of which expression it
  // is the value, so that Coq reads it once; else nothing.
  [[nodiscard]] std::string read_once(const kernel::Formula& relation);
  [[nodiscard]] std::string jury(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string one_zero(const kernel::Theorem& theorem);
  [[nodiscard]] std::string consequence(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string calculus(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string zeros_between(const kernel::Theorem& theorem, const Scope& scope);
  [[nodiscard]] std::string by_composition(const kernel::Theorem& theorem, const Scope& scope);
  struct Zeros;
  void add_zero(Zeros& zeros, const kernel::Term& left, const kernel::Theorem& equation,
                const kernel::Term& right, const Scope& scope);
  // left = right by normal form, with the step's definitions unfolded and its divisors.
  [[nodiscard]] std::string normal_form(const kernel::Term& left, const kernel::Term& right,
                                        const kernel::Step& step, const Scope& scope) const;

  std::string fresh(const std::string& word) { return word + std::to_string(++count_); }

  std::string text_;
  std::vector<kernel::Definition> definitions_;
  std::map<const kernel::Step *, int> uses_;
  // The signs that bound a number: its hypotheses, whether they are strict, the number; below, above.
  using Bounded = std::tuple<kernel::Formulas, bool, kernel::Term>;
  std::map<Bounded, std::array<std::optional<kernel::Theorem>, 2>> bounds_;
  [[nodiscard]] static std::optional<std::pair<Bounded, std::size_t>> bounded_by(const kernel::Theorem& sign);
  std::map<kernel::Term, std::set<kernel::Formulas>> signs_;  // of a number: under what each is found
  std::map<kernel::Term, std::string> readings_;              // by numbers: lemmas
  std::map<kernel::Formula, int> assumed_;                    // by how many steps
  std::map<kernel::Formula, std::string> names_;              // of long conjunctions, and of bounds
  std::string file_;
  Library& library_;
  std::set<std::string> imports_;
  std::set<std::string> needs_;
  int count_ = 0;
};

// The files of prelude/, which are part of the program.

// Name and text, each after those that it imports.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prelude();

// rules.mk likewise: the rules of the Makefile beside certificates that are the same in all.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& make_rules();

}  // namespace stickslip::proofs::certificates
