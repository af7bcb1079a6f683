// The ways in which the suite proves a statement of the paper. Each returns a proof to be put into a claim.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

class Derivation;

// Every printed equation holds identically, by normal form. Assumptions whose left side is a scalar symbol
// (phi = (pi - omega*tau)/2) are put in where that helps. What is not proved may be refuted by a witness.
[[nodiscard]] Proof by_normal_form();

// The same, and also for these equations, which say what the printed ones, or the words, mean.
[[nodiscard]] Proof by_normal_form(std::vector<symbols::Statement> meaning);

// Where nothing is printed: terms that are equal by normal form, numbers or matrices of them; a variable is
// the symbol of its name. A theorem of the kernel for each entry.
struct Equal {
  kernel::Term left, right;
};
using Compare = std::function<std::vector<Equal>(Derivation&)>;
[[nodiscard]] Outcome compared(const std::string& route, Prover& prover, const Claim& claim,
                               const Compare& compare);
// The printed equations hold identically, and what they speak of comes out of a derivation that shares no
// formula with the model: the same.
[[nodiscard]] Proof by_derivation(const std::string& route, Compare derive);

// A premise of a proof by rewriting: a claim, or one of the claim's own assumptions, with symbols of time
// replaced (from("5").at("t", tau - t)), solved for its left side or for another product of letters.
struct Premise {
  std::string id;
  bool assumed = false;
  symbols::Replacements replacements = {};
  std::optional<symbols::Term> lead = {};
  std::optional<symbols::Term> factor = {};
  std::map<std::string, std::string> supplied =
      {};  // what the premise assumes, by id, and the claim that proves it

  // The premise multiplied from the left by the inverse of a matrix; the claim must assume that its
  // determinant is not zero.
  [[nodiscard]] Premise divided_by(const symbols::Term& square) const;
  [[nodiscard]] Premise at(const std::string& symbol, const symbols::Term& value) const;
  // What the premise assumes under this id need not be assumed here: the claim named proves that very
  // statement.
  [[nodiscard]] Premise given(const std::string& assumption, const std::string& claim) const;
  [[nodiscard]] Premise solved_for(const symbols::Term& product) const;
};
[[nodiscard]] Premise from(const std::string& id);
[[nodiscard]] Premise assuming(const std::string& id);

// The printed equations follow from the premises by replacing equals by equals, for any matrices whatever;
// only premises that were needed are recorded.
[[nodiscard]] Proof by_rewriting(std::vector<Premise> premises);

// Each printed statement is one that a premise makes: what the premises assume and the claim does not is
// supplied by other claims. All premises must be needed.
[[nodiscard]] Proof by_premises(std::vector<Premise> premises);

}  // namespace stickslip::proofs::methods
