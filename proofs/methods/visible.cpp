#include "proofs/methods/visible.hpp"

#include <algorithm>

#include "proofs/methods/openings.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

// All that is divided by in the term, or below the bar of a tangent.
std::vector<Term> divisors_in(const Term& term) {
  std::vector<Term> all;
  const std::vector<Term>& parts = term.arguments();
  if (term.op() == Op::quotient) {
    all.push_back(parts.at(1));
  } else if (term.op() == Op::power && term.number() < 0) {
    all.push_back(term.shape().is_scalar() ? parts.at(0) : determinant(parts.at(0)));
  } else if (term.op() == Op::function && term.name() == "tan") {
    all.push_back(cos(parts.at(0)));
  }
  for (const Term& part : parts) {
    const std::vector<Term> deeper = divisors_in(part);
    all.insert(all.end(), deeper.begin(), deeper.end());
  }
  return all;
}

}  // namespace

bool is_seen(const Hypothesis& hypothesis, const Claim& needing, const Claim& origin) {
  if (origin.id != needing.id && facts(origin.origin).source == nullptr) {
    return false;
  }
  Reader read;
  const auto opened = [&](const Term& term) {
    const kernel::Term made = read(term);
    return unfold(made, openings({made}).in_parameters());
  };
  const kernel::Term needed = opened(hypothesis.nonzero);
  for (const Statement& one : origin.printed) {
    for (const Term& side : {one.left, one.right}) {
      for (const Term& divisor : divisors_in(side)) {
        if (is_in_field(divisor) && tactics::implies_nonzero(opened(divisor), needed, parameters())) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace stickslip::proofs::methods
