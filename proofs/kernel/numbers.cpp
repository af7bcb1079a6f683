#include <algorithm>

#include "proofs/kernel/balls.hpp"

namespace stickslip::proofs::kernel {

namespace {

// Every member of the polynomial with these coefficients, from c0 up, has all zeros inside the unit circle:
// |c0| < |cn|, and so has the polynomial (cn p - c0 p*)/z, where p* is p with the coefficients turned round.
bool passes_jury(std::vector<Ball> c) {
  while (c.size() > 1) {
    const Ball first = c.front(), last = c.back();
    if (!(last * last - first * first).is_positive()) {
      return false;
    }
    std::vector<Ball> next;
    for (std::size_t k = 1; k < c.size(); ++k) {
      next.push_back(last * c[k] - first * c[c.size() - 1 - k]);
    }
    c = std::move(next);
  }
  return true;
}

// Variables in ranges, for the rules that hold for all their values: hypotheses l ≤ x, x ≤ u.
struct Ranged {
  Formulas hypotheses = {};
  Balls::Values values = {};

  // Adds them to the step's data.
  Ranged(const Ranges& ranges, Step& step) {
    for (const auto& [variable, range] : ranges) {
      require(variable.type.is_scalar(), "only numbers have ranges");
      const Term lower = range.first, upper = range.second;
      values[variable] = {ball(range)};
      hypotheses.insert({at_most(lower, variable), at_most(variable, upper)});
      step.data.insert(step.data.end(), {variable, lower, upper});
    }
  }
};

}  // namespace

Theorem Theorem::sign(const Formula& relation, const Ranges& ranges, long bits) {
  const bool differs = relation.kind() == Kind::negation && relation.parts()[0].kind() == Kind::equal;
  require(differs || relation.kind() == Kind::less || relation.kind() == Kind::at_most,
          "the sign rule is of <, <= and of two numbers that differ");
  require_precision(bits);
  const Formula& compared = differs ? relation.parts()[0] : relation;
  require(compared.parts()[0].type().is_scalar() && compared.parts()[1].type().is_scalar(),
          "only numbers have signs");
  const WorkingPrecision scope(bits);
  Step step{.rule = "sign", .data = {relation, bits}};
  const Ranged known(ranges, step);
  const Ball difference = InBalls({known.values})(compared.parts()[1] - compared.parts()[0])[0];
  require(differs ? difference.is_nonzero() : difference.is_positive(), "the balls do not decide the sign");
  return {step, known.hypotheses, relation};
}

Theorem Theorem::jury(const Term& coefficients, const Ranges& ranges, long bits) {
  const Formula conclusion = inside_unit_circle(coefficients);
  require_precision(bits);
  const WorkingPrecision scope(bits);
  Step step{.rule = "jury", .data = {coefficients, bits}};
  const Ranged known(ranges, step);
  require(passes_jury(InBalls({known.values})(coefficients)), "Jury's test does not prove it");
  return {step, known.hypotheses, conclusion};
}

}  // namespace stickslip::proofs::kernel
