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

// That the sum of the parts is zero by normal form: records what that divides by.
void require_vanishing(const std::vector<Term>& parts, Step& step) {
  const Term whole = sum(parts);
  const Term looked_into = unfold(whole, step.unfolded);
  step.divisors = divisors(whole);
  const Formulas inside = divisors(looked_into);
  step.divisors.insert(inside.begin(), inside.end());
  require(vanishes(looked_into), "the difference is not zero by normal form");
}

// The number m of a bound that is written m*pi.
Rational multiple_of_pi(const Term& bound) {
  require(
      bound.kind() == Kind::product && bound.parts()[0].kind() == Kind::number && bound.parts()[1] == pi(),
      "a bound is written as a number times pi");
  return bound.parts()[0].value();
}

}  // namespace

Theorem Theorem::combination(const Formula& equation, const std::vector<Multiple>& multiples,
                             const Definitions& unfolded) {
  require(equation.kind() == Kind::equal, "a combination of equations is an equation");
  Step step{.rule = "combination", .data = {equation}, .unfolded = unfolded};
  std::vector<Term> parts{equation.parts()[0] - equation.parts()[1]};
  subtract(multiples, parts, step);
  require_vanishing(parts, step);
  return {step, equation};
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
  require_vanishing(parts, step);
  return {step, inequality};
}

Theorem Theorem::square_root(const Term& a) {
  require(a.type().is_scalar(), "only numbers have square roots");
  const Variable x = fresh(real_number, {a});
  return {{.rule = "square_root", .data = {a}},
          implies(at_most(0, a), kernel::exists(x, all({at_most(0, x), equal(power(x, 2), a)})))};
}

Theorem Theorem::trichotomy(const Term& a, const Term& b) {
  const Formula below = less(a, b), same = equal(a, b), above = less(b, a);
  const auto iff = [](const Formula& left, const Formula& right) {
    return all({implies(left, right), implies(right, left)});
  };
  return {{.rule = "trichotomy", .data = {a, b}},
          all({any({below, same, above}), negation(all({below, same})), negation(all({below, above})),
               negation(all({same, above})), iff(at_most(a, b), any({below, same})),
               iff(at_most(b, a), any({same, above}))})};
}

Theorem Theorem::zeros_between(const Theorem& equation, const Theorem& lower, const Theorem& upper) {
  const auto [function, value] = sides(equation, Kind::equal);
  require((function.kind() == Kind::sine || function.kind() == Kind::cosine) && value == Term(0),
          "the equation is sin x = 0 or cos x = 0");
  const Term& x = function.parts()[0];
  const auto [from, above] = sides(lower, Kind::less);
  const auto [below, to] = sides(upper, Kind::less);
  require(above == x && below == x, "the bounds are of another number");
  const Rational offset = function.kind() == Kind::sine ? Rational(0) : Rational(1, 2);
  const Rational first = multiple_of_pi(from), last = multiple_of_pi(to);
  require(last - first <= 1000, "more than 1000 zeros lie between the bounds");
  mpz_class k;  // the largest with k + offset <= first
  const Rational start = first - offset;
  mpz_fdiv_q(k.get_mpz_t(), start.get_num_mpz_t(), start.get_den_mpz_t());
  std::vector<Formula> cases;
  for (Rational zero = k + 1 + offset; zero < last; zero += 1) {
    cases.push_back(equal(x, Term(zero) * pi()));
  }
  return {{.rule = "zeros_between", .premises = {equation, lower, upper}}, any(cases)};
}

Theorem Theorem::sine_is_positive(const Term& x) {
  return {{.rule = "sine_is_positive", .data = {x}}, implies(between(0, x, pi()), less(0, sin(x)))};
}

}  // namespace stickslip::proofs::kernel
