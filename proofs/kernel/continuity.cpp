#include <algorithm>

#include "proofs/kernel/normal_form.hpp"
#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

// Goes through a term in the variable `time` and finds a reason why each part is continuous on [a, b].
class Continuity {
 public:
  Continuity(const Variable& time, const Term& a, const Term& b, const std::vector<Theorem>& premises)
      : time_(time), a_(a), b_(b), premises_(premises) {}

  void check(const Term& term) {
    if (!term.variables().contains(time_)) {
      return;
    }
    switch (term.kind()) {
      case Kind::variable:
        return;
      case Kind::defined:
        check(term.definition().unfolded(term.parts()));
        return;
      case Kind::apply:
        check_applied(term.parts()[0], term.parts()[1]);
        check(term.parts()[1]);
        return;
      case Kind::inverse: {
        const Formulas divisor = divisors(term);
        divisors_.insert(divisor.begin(), divisor.end());
        break;
      }
      case Kind::sum:
      case Kind::product:
      case Kind::power:
      case Kind::cosine:
      case Kind::sine:
      case Kind::exponential:
      case Kind::matrix:
      case Kind::entry:
        break;
      default:
        throw KernelError("such a term is not known to be continuous");
    }
    for (const Term& part : term.parts()) {
      check(part);
    }
  }

  [[nodiscard]] const Formulas& divisors_met() const { return divisors_; }

 private:
  void check_applied(const Term& function, const Term& inner) const {
    for (const Theorem& premise : premises_) {
      const Formula& known = premise.conclusion();
      if (known.kind() != Kind::continuous || known.parts()[0] != function) {
        continue;
      }
      const Term &c = known.parts()[1], &d = known.parts()[2];
      if ((inner == Term(time_) && c == a_ && d == b_) || stays_within(inner, c, d)) {
        return;
      }
    }
    throw KernelError("no premise says that " + function.name() + " is continuous where it is needed");
  }

  [[nodiscard]] bool stays_within(const Term& inner, const Term& c, const Term& d) const {
    const Formula wanted = for_all(time_, implies(within(a_, time_, b_), within(c, inner, d)));
    return std::any_of(premises_.begin(), premises_.end(),
                       [&](const Theorem& premise) { return premise.conclusion() == wanted; });
  }

  Variable time_;
  Term a_, b_;
  const std::vector<Theorem>& premises_;
  Formulas divisors_;
};

}  // namespace

Theorem Theorem::continuity(const Term& function, const Term& a, const Term& b,
                            const std::vector<Theorem>& premises) {
  require(function.type().sort == Sort::function, "only a function is continuous");
  require(function.is_closed() && a.is_closed() && b.is_closed(), "an interval's ends are numbers");
  std::vector<Term> used{function, a, b};
  for (const Theorem& premise : premises) {
    used.push_back(premise.conclusion());
  }
  const Variable time = fresh(real_number, used);
  const Term body = apply(function, time);
  Continuity rule(time, a, b, premises);
  rule.check(body);
  Step step{.rule = "continuity", .premises = premises, .data = {function, a, b}};
  Formulas met = divisors(body);
  met.insert(rule.divisors_met().begin(), rule.divisors_met().end());
  for (const Formula& divisor : met) {
    const bool varies = divisor.variables().contains(time);
    step.divisors.insert(varies ? for_all(time, implies(within(a, time, b), divisor)) : divisor);
  }
  return {step, continuous(function, a, b)};
}

Theorem Theorem::continuous_within(const Theorem& theorem, const Theorem& lower, const Theorem& upper) {
  const Formula& known = theorem.conclusion();
  require(known.kind() == Kind::continuous, "the first premise is no continuity");
  const auto [a, c] = sides(lower, Kind::at_most);
  const auto [d, b] = sides(upper, Kind::at_most);
  require(a == known.parts()[1] && b == known.parts()[2], "the interval is not known to lie inside");
  return {{.rule = "continuous_within", .premises = {theorem, lower, upper}},
          continuous(known.parts()[0], c, d)};
}

Theorem Theorem::finite_part(const Theorem& finite, const Theorem& part) {
  const Formula& claim = part.conclusion();
  const Variable t = fresh(real_number, {claim, finite.conclusion()});
  require(finite.conclusion().kind() == Kind::finite, "the first premise is of no finite set");
  require(claim.kind() == Kind::for_all && claim.binds() == real_number,
          "the second premise is not of all times");
  const Formula body = opened(claim, t);
  require(body.kind() == Kind::implication && body.parts()[1] == opened(finite.conclusion(), t),
          "the set is not known to be part of the finite one");
  return {{.rule = "finite_part", .premises = {finite, part}}, kernel::finite(t, body.parts()[0])};
}

Theorem Theorem::finite_union(const Theorem& one, const Theorem& other) {
  require(one.conclusion().kind() == Kind::finite && other.conclusion().kind() == Kind::finite,
          "a premise is of no finite set");
  const Variable t = fresh(real_number, {one.conclusion(), other.conclusion()});
  return {{.rule = "finite_union", .premises = {one, other}},
          kernel::finite(t, any({opened(one.conclusion(), t), opened(other.conclusion(), t)}))};
}

Theorem Theorem::finite_shift(const Theorem& finite, const Term& c) {
  require(finite.conclusion().kind() == Kind::finite, "the premise is of no finite set");
  require(c.is_closed() && c.type().is_scalar(), "times are shifted by a number");
  const Variable t = fresh(real_number, {finite.conclusion(), c});
  return {{.rule = "finite_shift", .premises = {finite}, .data = {c}},
          kernel::finite(t, opened(finite.conclusion(), Term(t) + c))};
}

}  // namespace stickslip::proofs::kernel
