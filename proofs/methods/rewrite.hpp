// Matrix identities as noncommutative polynomials, and proofs by rewriting with premises.
//
// H(tau), H(-t), E, Z0, … are letters that do not commute; scalars are coefficients. Replacing the left side
// of a premise by its right side adds a multiple (from the left and from the right) of the premise, so that
// whatever rewrites to zero follows from the premises used, over any matrices.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/kernel/term.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::methods {

using Word = std::vector<std::string>;            // letters from left to right
using Polynomial = std::map<Word, kernel::Term>;  // without zero coefficients

// Letters are named by symbol or function and the canonical text of the argument: "H(tau - t)". I is the
// empty word. `scalars` reads scalars, in lowest terms.
using Scalars = std::function<kernel::Term(const symbols::Term&)>;
[[nodiscard]] Polynomial polynomial(const symbols::Term& term, const Scalars& scalars);
// left - right.
[[nodiscard]] Polynomial residual(const symbols::Statement& statement, const Scalars& scalars);
[[nodiscard]] std::string text(const Polynomial& polynomial);
// The letters of the term, by name.
void collect_letters(const symbols::Term& term, const Scalars& scalars,
                     std::map<std::string, symbols::Term>& letters);

// A rule applied: coefficient * before * (lead - replacement) * after was taken away.
struct Application {
  kernel::Term coefficient;
  Word before;
  std::size_t rule = 0;  // its place among the rules
  Word after;
};

// lead = replacement. With its premise's residual p, simplified by `trace`: lead - replacement is (p - what
// the trace took away)/scale.
struct Rule {
  Word lead;
  Polynomial replacement;
  std::vector<Application> trace = {};
  Rational scale = 1;
};

// What is left of the polynomial when no rule applies, and how the rules were applied. Throws KernelError
// after 1000 steps: the rules feed themselves.
struct Rewritten {
  Polynomial rest;
  std::vector<Application> trace;
};
[[nodiscard]] Rewritten rewrite(Polynomial polynomial, const std::vector<Rule>& rules);

// The premise (its residual), simplified by the rules so far, solved for the word of `lead`. Nothing if that
// word does not occur with a nonzero rational coefficient. Throws InternalError if `lead` is no single word.
[[nodiscard]] std::optional<Rule> solve(const Polynomial& premise, const Polynomial& lead,
                                        const std::vector<Rule>& rules);

}  // namespace stickslip::proofs::methods
