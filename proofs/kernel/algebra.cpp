#include <algorithm>

#include "proofs/kernel/normal_form.hpp"
#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

// Adds the multiples of the premises' residuals to a sum that is to vanish, and the premises to the step.
void subtract(const std::vector<Multiple>& multiples, std::vector<Term>& parts, Step& step) {
  for (const Multiple& multiple : multiples) {
    const auto [left, right] = sides(multiple.equation, Kind::equal);
    parts.push_back(-(multiple.left * (left - right) * multiple.right));
    step.premises.push_back(multiple.equation);
    step.data.push_back(multiple.left);
    step.data.push_back(multiple.right);
  }
}

// That the sum of the parts is zero by normal form: records what that divides by, and returns all hypotheses.
Formulas hypotheses_of_vanishing(const std::vector<Term>& parts, Step& step) {
  const Term whole = sum(parts);
  const Term looked_into = unfold(whole, step.unfolded);
  step.divisors = divisors(whole);
  const std::set<Formula> inside = divisors(looked_into);
  step.divisors.insert(inside.begin(), inside.end());
  require(vanishes(looked_into), "the difference is not zero by normal form");
  Formulas hypotheses = hypotheses_of(step.premises);
  hypotheses.insert(step.divisors.begin(), step.divisors.end());
  return hypotheses;
}

}  // namespace

Theorem Theorem::combination(const Formula& equation, const std::vector<Multiple>& multiples,
                             const Definitions& unfolded) {
  require(equation.kind() == Kind::equal, "a combination of equations is an equation");
  Step step{.rule = "combination", .data = {equation}, .unfolded = unfolded};
  std::vector<Term> parts{equation.parts()[0] - equation.parts()[1]};
  subtract(multiples, parts, step);
  const Formulas hypotheses = hypotheses_of_vanishing(parts, step);
  return {step, hypotheses, equation};
}

Theorem Theorem::inverse_of(const Theorem& product) {
  const auto [left, right] = sides(product, Kind::equal);
  require(left.kind() == Kind::product, "an inverse is known by a product of two matrices");
  const Term a = left.parts()[0], b = left.parts()[1];
  require(a.type().rows == a.type().columns && a.type().rows == b.type().rows &&
              b.type().rows == b.type().columns,
          "only a square matrix is inverted, by one of its shape");
  require(right == identity(a.type().rows), "the product is not literally the identity");
  return {{.rule = "inverse_of", .premises = {product}}, product.hypotheses(), equal(inverse(a), b)};
}

Theorem Theorem::zero_product(const Term& a, const Term& b) {
  require(a.type().is_scalar() && b.type().is_scalar(), "only a product of numbers has a zero factor");
  return {{.rule = "zero_product", .data = {a, b}},
          {},
          implies(equal(a * b, 0), any({equal(a, 0), equal(b, 0)}))};
}

Theorem Theorem::order(const Formula& inequality, const std::vector<Positive>& positives,
                       const std::vector<Multiple>& multiples, const Definitions& unfolded) {
  require(inequality.kind() == Kind::less || inequality.kind() == Kind::at_most,
          "only an inequality follows from inequalities");
  Step step{.rule = "order", .data = {inequality}, .unfolded = unfolded};
  std::vector<Term> parts{inequality.parts()[1] - inequality.parts()[0]};
  bool some_strict = false;
  for (const Positive& positive : positives) {
    require(positive.factor > 0, "the factor of a product of inequalities is positive");
    require(positive.square.type().is_scalar(), "only numbers have squares that are not negative");
    Term product = Term(positive.factor) * power(positive.square, 2);
    bool strict = positive.square == Term(1);
    for (const Theorem& premise : positive.inequalities) {
      const Kind kind = premise.conclusion().kind();
      require(kind == Kind::less || kind == Kind::at_most, "a premise is no inequality");
      strict = strict && kind == Kind::less;
      product = product * (premise.conclusion().parts()[1] - premise.conclusion().parts()[0]);
      step.premises.push_back(premise);
    }
    some_strict = some_strict || strict;
    parts.push_back(-product);
    step.data.emplace_back(positive.factor);
    step.data.push_back(positive.square);
    step.data.emplace_back(static_cast<long>(positive.inequalities.size()));
  }
  require(some_strict || inequality.kind() == Kind::at_most,
          "a strict inequality needs a product of strict inequalities");
  subtract(multiples, parts, step);
  const Formulas hypotheses = hypotheses_of_vanishing(parts, step);
  return {step, hypotheses, inequality};
}

Theorem Theorem::square_root(const Term& a) {
  require(a.type().is_scalar(), "only numbers have square roots");
  const Variable x = fresh(real_number, {a});
  return {{.rule = "square_root", .data = {a}},
          {},
          implies(at_most(0, a), kernel::exists(x, all({at_most(0, x), equal(power(x, 2), a)})))};
}

Theorem Theorem::trichotomy(const Term& a, const Term& b) {
  const Formula below = less(a, b), same = equal(a, b), above = less(b, a);
  const auto iff = [](const Formula& left, const Formula& right) {
    return all({implies(left, right), implies(right, left)});
  };
  return {{.rule = "trichotomy", .data = {a, b}},
          {},
          all({any({below, same, above}), negation(all({below, same})), negation(all({below, above})),
               negation(all({same, above})), iff(at_most(a, b), any({below, same})),
               iff(at_most(b, a), any({same, above}))})};
}

}  // namespace stickslip::proofs::kernel
