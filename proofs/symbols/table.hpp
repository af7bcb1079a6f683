// The table of the paper's symbols. Its rows stand in table.cpp; what can be asked about a symbol by its name
// is asked here.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::symbols {

struct Symbol {
  std::string name;  // in ASCII; latex_name() of symbolic/typeset/names.hpp makes LaTeX of it
  Shape shape = {};
  bool of_time = false;  // a function of one scalar, as H(t)
  // The claim that says what it is, if it needs one; the claim that gives it by a formula of model/
  // (sample.hpp) and stays closed unless an identity needs to look inside.
  std::string defined_in = {}, formula_in = {};
  std::optional<Term> value = {};  // what it stands for; nothing for itself, or for a formula of model/
  // What a misprint may put in its place: names that differ in the index, and of other things of its shape.
  std::vector<std::string> other_indices = {}, other_letters = {};
  std::string rate_of = {};  // z_10 of z_10'; empty for what no prime can be left out of
  bool is_duration = false;
  // The same, of a function at the time t; of a scalar, as a name that stays closed unless a proof needs to
  // look inside.
  std::optional<Term> means = {};
  bool is_motion = false;  // a function of time of which no more is known
};

// Symbols by name and shape, quantities apart from functions of time.
class Symbols {
 public:
  // Throws InternalError if two are the same.
  explicit Symbols(std::vector<Symbol> rows);
  // The row of a symbol or function; nullptr where there is none, and for every other term.
  [[nodiscard]] const Symbol * find(const Term& term) const;
  [[nodiscard]] std::vector<Symbol>::const_iterator begin() const { return rows_.begin(); }
  [[nodiscard]] std::vector<Symbol>::const_iterator end() const { return rows_.end(); }

 private:
  std::vector<Symbol> rows_;
  std::unordered_map<std::string, std::vector<std::size_t>> places_;  // of the rows of a name
};

// What names mean in a paper.
class Vocabulary {
 public:
  // Its symbols; the domain of its parameters, "0 < omega1" or "omega1 < 1", which every statement that
  // speaks of them supposes; whether what model/ has a formula for by name (chi, K, H(t), …) means that.
  Vocabulary(Symbols table, std::vector<Statement> domain, bool of_model);

  [[nodiscard]] const Symbols& table() const { return table_; }
  [[nodiscard]] const std::vector<Statement>& domain() const { return domain_; }
  [[nodiscard]] bool is_of_model() const { return of_model_; }
  // No two have the same: what is kept of one is kept by it.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  Symbols table_;
  std::vector<Statement> domain_;
  bool of_model_;
  std::size_t number_;
};

// The vocabulary in which terms are read and evaluated in this thread: the oscillator's, unless an
// InVocabulary says otherwise.
[[nodiscard]] const Vocabulary& vocabulary_here();

// While it lives, and in its thread, names mean what the vocabulary says; with none, what they mean anyway.
class InVocabulary {
 public:
  explicit InVocabulary(std::shared_ptr<const Vocabulary> vocabulary);
  ~InVocabulary();
  InVocabulary(const InVocabulary&) = delete;
  InVocabulary& operator=(const InVocabulary&) = delete;

 private:
  std::shared_ptr<const Vocabulary> vocabulary_;
  const Vocabulary * before_;
};

// Its table.
[[nodiscard]] const Symbols& symbol_table();

// What a scalar is written for, as phi_B is for omega tau + phi; nothing for any other term.
[[nodiscard]] std::optional<Term> abbreviated(const Term& term);

// The claims that define what a term speaks of: 38 for H_1, 41 for Gamma_2, … (cos, t and the parameters need
// none).
[[nodiscard]] std::set<std::string> definitions_in(const Term& term);

}  // namespace stickslip::proofs::symbols
