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
  Formulas hypotheses;
  std::vector<Term> data;
  std::map<Variable, std::vector<Ball>> values;
};

Ranged ranged(const std::map<Variable, Interval>& ranges) {
  Ranged result;
  for (const auto& [variable, range] : ranges) {
    require(variable.type.is_scalar(), "only numbers have ranges");
    check(range);
    const Term lower = number(range.first), upper = number(range.second);
    result.values[variable] = {Ball::from_interval(range.first, range.second)};
    result.hypotheses.insert({at_most(lower, variable), at_most(variable, upper)});
    result.data.insert(result.data.end(), {variable, lower, upper});
  }
  return result;
}

void check_precision(long bits) {
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
}

}  // namespace

Formula inside(const Term& x, const Box& box) {
  std::vector<Formula> parts;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Term side = entry(x, static_cast<int>(i));
    parts.push_back(within(number(box[i].first), side, number(box[i].second)));
  }
  return all(parts);
}

Formula exactly_one(const Variable& x, const Box& box, const Formula& a) {
  const Variable y = fresh(x.type, {x, a});
  const Formula here = all({inside(x, box), a});
  const Formula there = substitute(here, {{x, y}});
  return all({exists(x, here), for_all(x, for_all(y, implies(all({here, there}), equal(x, y))))});
}

Theorem Theorem::sign(const Formula& relation, const std::map<Variable, Interval>& ranges, long bits) {
  const bool differs = relation.kind() == Kind::negation && relation.parts()[0].kind() == Kind::equal;
  require(differs || relation.kind() == Kind::less || relation.kind() == Kind::at_most,
          "the sign rule is of <, <= and of two numbers that differ");
  check_precision(bits);
  const Formula& compared = differs ? relation.parts()[0] : relation;
  require(compared.parts()[0].type().is_scalar() && compared.parts()[1].type().is_scalar(),
          "only numbers have signs");
  const WorkingPrecision scope(bits);
  const Ranged known = ranged(ranges);
  Step step{.rule = "sign", .data = {relation, bits}};
  step.data.insert(step.data.end(), known.data.begin(), known.data.end());
  const Ball difference = evaluated<Ball>(compared.parts()[1] - compared.parts()[0], known.values)[0];
  require(differs ? difference.is_nonzero() : difference.is_positive(), "the balls do not decide the sign");
  return {step, known.hypotheses, relation};
}

Theorem Theorem::jury(const Term& coefficients, const std::map<Variable, Interval>& ranges, long bits) {
  const Formula conclusion = inside_unit_circle(coefficients);
  check_precision(bits);
  const WorkingPrecision scope(bits);
  const Ranged known = ranged(ranges);
  Step step{.rule = "jury", .data = {coefficients, bits}};
  step.data.insert(step.data.end(), known.data.begin(), known.data.end());
  require(passes_jury(evaluated<Ball>(coefficients, known.values)), "Jury's test does not prove it");
  return {step, known.hypotheses, conclusion};
}

}  // namespace stickslip::proofs::kernel
