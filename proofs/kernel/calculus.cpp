#include <algorithm>

#include "proofs/kernel/normal_form.hpp"
#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

bool is_zero(const Term& term) {
  return term == zero(term.type());
}

// The derivative of a term in the variable `time`, at the point.
class Derivative {
 public:
  Derivative(const Variable& time, const Term& point, const std::vector<Theorem>& premises)
      : time_(time), point_(point), premises_(premises) {}

  // At time, not yet at the point.
  Term of(const Term& term) {
    const auto found = known_.find(term);
    return found != known_.end() ? found->second : known_.emplace(term, rate(term)).first->second;
  }

  [[nodiscard]] const Formulas& divisors_met() const { return divisors_; }

 private:
  Term rate(const Term& term) {
    if (!term.variables().contains(time_)) {
      return zero(real_matrix(term.type().rows, term.type().columns));
    }
    const std::vector<Term>& parts = term.parts();
    switch (term.kind()) {
      case Kind::variable:
        return 1;
      case Kind::sum: {
        std::vector<Term> rates;
        for (const Term& part : parts) {
          if (const Term rate = of(part); !is_zero(rate)) {
            rates.push_back(rate);
          }
        }
        return rates.empty() ? zero(term.type()) : sum(rates);
      }
      case Kind::product:
        return plus(times(of(parts[0]), parts[1], term), times(parts[0], of(parts[1]), term));
      case Kind::power: {
        const long exponent = term.value().get_num().get_si();
        return exponent == 0 ? Term(0) : Term(exponent) * power(parts[0], exponent - 1) * of(parts[0]);
      }
      case Kind::inverse: {
        const Formulas divisor = divisors(term);
        divisors_.insert(divisor.begin(), divisor.end());
        return -(term * of(parts[0]) * term);
      }
      case Kind::cosine:
        return -(sin(parts[0]) * of(parts[0]));
      case Kind::sine:
        return cos(parts[0]) * of(parts[0]);
      case Kind::exponential:
        return term * of(parts[0]);
      case Kind::matrix: {
        std::vector<Term> rates;
        std::transform(parts.begin(), parts.end(), std::back_inserter(rates),
                       [&](const Term& part) { return of(part); });
        return matrix(term.row(), term.column(), rates);
      }
      case Kind::entry:
        return entry(of(parts[0]), term.row(), term.column());
      case Kind::defined:
        return of(term.definition().unfolded(parts));
      case Kind::apply:
        return known_rate(parts[0], parts[1]) * of(parts[1]);
      default:
        throw KernelError("such a term has no derivative");
    }
  }

  // g'(u(point)) by a premise; g is a variable, for a lambda applied is its body.
  [[nodiscard]] Term known_rate(const Term& function, const Term& inner) const {
    const Term place = substitute(inner, {{time_, point_}});
    for (const Theorem& premise : premises_) {
      const Formula& known = premise.conclusion();
      require(known.kind() == Kind::derivative, "a premise is no derivative");
      if (known.parts()[0] == function && known.parts()[1] == place) {
        return known.parts()[2];
      }
    }
    throw KernelError("no premise gives the derivative of " + function.name() + " where it is needed");
  }

  static Term times(const Term& a, const Term& b, const Term& whole) {
    return is_zero(a) || is_zero(b) ? zero(whole.type()) : a * b;
  }
  static Term plus(const Term& a, const Term& b) { return is_zero(a) ? b : is_zero(b) ? a : a + b; }

  Variable time_;
  Term point_;
  std::vector<Theorem> premises_;
  Formulas divisors_;
  std::map<Term, Term, Before> known_;
};

std::vector<Term> conclusions(const std::vector<Theorem>& premises, std::vector<Term> also) {
  for (const Theorem& premise : premises) {
    also.push_back(premise.conclusion());
  }
  return also;
}

}  // namespace

Term partial_derivative(const Term& term, const Variable& x) {
  return Derivative(x, x, {}).of(term);
}

Theorem Theorem::differentiate(const Term& function, const Term& point,
                               const std::vector<Theorem>& premises) {
  require(function.type().sort == Sort::function, "only a function has a derivative");
  require(function.is_closed() && point.is_closed() && point.type().is_scalar(),
          "a derivative is taken at a number");
  const Variable time = fresh(real_number, conclusions(premises, {function, point}));
  const Term body = apply(function, time);
  Derivative rule(time, point, premises);
  const Term value = substitute(rule.of(body), {{time, point}});
  Step step{.rule = "differentiate", .premises = premises, .data = {function, point}};
  Formulas met = divisors(body);
  met.insert(rule.divisors_met().begin(), rule.divisors_met().end());
  for (const Formula& divisor : met) {
    step.divisors.insert(substitute(divisor, {{time, point}}));
  }
  return {step, kernel::derivative(function, point, value)};
}

Theorem Theorem::unique_derivative(const Theorem& one, const Theorem& other) {
  const Formula& a = one.conclusion();
  const Formula& b = other.conclusion();
  require(a.kind() == Kind::derivative && b.kind() == Kind::derivative && a.parts()[0] == b.parts()[0] &&
              a.parts()[1] == b.parts()[1],
          "these are not derivatives of one function at one point");
  return {{.rule = "unique_derivative", .premises = {one, other}}, equal(a.parts()[2], b.parts()[2])};
}

Theorem Theorem::same_derivative(const Theorem& derivative, const Theorem& agreement, const Theorem& lower,
                                 const Theorem& upper) {
  const Formula& known = derivative.conclusion();
  require(known.kind() == Kind::derivative, "the first premise is no derivative");
  const auto [a, above] = sides(lower, Kind::less);
  const auto [below, b] = sides(upper, Kind::less);
  require(above == known.parts()[1] && below == known.parts()[1], "the bounds are of another point");
  const Formula& claim = agreement.conclusion();
  const Variable t = fresh(real_number, {claim, known, a, b});
  require(claim.kind() == Kind::for_all && claim.binds() == real_number, "the functions agree at all times");
  const Formula body = opened(claim, t);
  require(body.kind() == Kind::implication && body.parts()[0] == between(a, t, b) &&
              body.parts()[1].kind() == Kind::equal &&
              body.parts()[1].parts()[0] == apply(known.parts()[0], t),
          "the functions do not agree on this interval, the known one on the left");
  const Term other = lambda(t, body.parts()[1].parts()[1]);
  return {{.rule = "same_derivative", .premises = {derivative, agreement, lower, upper}},
          kernel::derivative(other, known.parts()[1], known.parts()[2])};
}

Theorem Theorem::constant(const Theorem& continuity, const Theorem& no_derivative) {
  const Formula& known = continuity.conclusion();
  require(known.kind() == Kind::continuous, "the first premise is no continuity");
  const Term &f = known.parts()[0], &a = known.parts()[1], &b = known.parts()[2];
  const Variable t = fresh(real_number, {known});
  const Term nothing = zero(real_matrix(f.type().rows, f.type().columns));
  const Formula everywhere = for_all(t, implies(between(a, t, b), kernel::derivative(f, t, nothing)));
  const Formula but_finitely =
      kernel::finite(t, all({between(a, t, b), negation(kernel::derivative(f, t, nothing))}));
  require(no_derivative.conclusion() == everywhere || no_derivative.conclusion() == but_finitely,
          "the derivative of this function is not known to be 0 inside this interval");
  return {{.rule = "constant", .premises = {continuity, no_derivative}},
          for_all(t, implies(within(a, t, b), equal(apply(f, t), apply(f, a))))};
}

Theorem Theorem::monotone(const Theorem& continuity, const Theorem& few_exceptions) {
  const Formula& known = continuity.conclusion();
  require(known.kind() == Kind::continuous, "the first premise is no continuity");
  const Term &f = known.parts()[0], &a = known.parts()[1], &b = known.parts()[2];
  require(f.type().rows == 1 && f.type().columns == 1, "only numbers grow");
  const Variable t = fresh(real_number, {known});
  const Variable v = fresh(real_number, {known, t});
  const Formula grows = exists(v, all({kernel::derivative(f, t, v), at_most(0, v)}));
  require(few_exceptions.conclusion() == kernel::finite(t, all({between(a, t, b), negation(grows)})),
          "the derivative is not known to be at least 0 but at finitely many times");
  return {{.rule = "monotone", .premises = {continuity, few_exceptions}},
          implies(at_most(a, b), at_most(apply(f, a), apply(f, b)))};
}

Theorem Theorem::mean_value(const Theorem& continuity, const Theorem& derivative, const Theorem& order) {
  const Formula& known = continuity.conclusion();
  require(known.kind() == Kind::continuous, "the first premise is no continuity");
  const Term &f = known.parts()[0], &a = known.parts()[1], &b = known.parts()[2];
  require(f.type().rows == 1 && f.type().columns == 1,
          "the mean value theorem is of numbers, not of vectors");
  require(order.conclusion() == less(a, b), "the interval is not known to have a length");
  const Formula& rates = derivative.conclusion();
  const Variable c = fresh(real_number, {known, rates});
  require(rates.kind() == Kind::for_all && rates.binds() == real_number,
          "the derivative is not given everywhere");
  const Formula at_c = opened(rates, c);
  require(at_c.kind() == Kind::implication && at_c.parts()[0] == between(a, c, b) &&
              at_c.parts()[1].kind() == Kind::derivative && at_c.parts()[1].parts()[0] == f &&
              at_c.parts()[1].parts()[1] == Term(c),
          "the derivative of this function is not given inside this interval");
  return {{.rule = "mean_value", .premises = {continuity, derivative, order}},
          exists(c, all({between(a, c, b),
                         equal(apply(f, b) - apply(f, a), at_c.parts()[1].parts()[2] * (b - a))}))};
}

Theorem Theorem::intermediate_value(const Theorem& continuity, const Theorem& start, const Theorem& end,
                                    const Theorem& order) {
  const Formula& known = continuity.conclusion();
  require(known.kind() == Kind::continuous, "the first premise is no continuity");
  const Term &f = known.parts()[0], &a = known.parts()[1], &b = known.parts()[2];
  require(f.type().rows == 1 && f.type().columns == 1,
          "the intermediate value theorem is of numbers, not of vectors");
  require(order.conclusion() == less(a, b), "the interval is not known to have a length");
  require(start.conclusion() == less(apply(f, a), 0) && end.conclusion() == less(0, apply(f, b)),
          "the values at the ends are not known to be below and above zero");
  const Variable c = fresh(real_number, {known});
  return {{.rule = "intermediate_value", .premises = {continuity, start, end, order}},
          exists(c, all({between(a, c, b), equal(apply(f, c), 0)}))};
}

}  // namespace stickslip::proofs::kernel
