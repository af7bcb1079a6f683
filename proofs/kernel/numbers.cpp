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
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
  const Formula& compared = differs ? relation.parts()[0] : relation;
  require(compared.parts()[0].type().is_scalar() && compared.parts()[1].type().is_scalar(),
          "only numbers have signs");
  Step step{.rule = "sign", .data = {relation, bits}};
  Formulas hypotheses;
  std::map<Variable, std::vector<Ball>> values;
  const WorkingPrecision scope(bits);
  for (const auto& [variable, range] : ranges) {
    require(variable.type.is_scalar(), "only numbers have ranges");
    check(range);
    values[variable] = {Ball::from_interval(range.first, range.second)};
    hypotheses.insert(at_most(number(range.first), variable));
    hypotheses.insert(at_most(variable, number(range.second)));
    step.data.insert(step.data.end(), {variable, number(range.first), number(range.second)});
  }
  const Ball difference = evaluated<Ball>(compared.parts()[1] - compared.parts()[0], values, true)[0];
  require(differs ? difference.is_nonzero() : difference.is_positive(), "the balls do not decide the sign");
  return {step, hypotheses, relation};
}

Theorem Theorem::jury(const Term& coefficients, long bits) {
  const Formula conclusion = inside_unit_circle(coefficients);
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
  const WorkingPrecision scope(bits);
  require(passes_jury(evaluated<Ball>(coefficients, {}, true)), "Jury's test does not prove it");
  return {{.rule = "jury", .data = {coefficients, bits}}, {}, conclusion};
}

}  // namespace stickslip::proofs::kernel
