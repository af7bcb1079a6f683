#include "proofs/methods/implications.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/methods/prover.hpp"
#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/signs.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

using GiNaC::ex;

Statement statement_of(Prover& prover, const Claim& claim, const Multiple& multiple) {
  const std::vector<Statement> statements = statements_of(prover, claim, multiple.premise);
  if (multiple.statement >= statements.size()) {
    throw InternalError(fmt::format("claim {}: the premise {} has no statement {}", claim.id,
                                    multiple.premise.id, multiple.statement));
  }
  return statements[multiple.statement];
}

bool is_inequality(Relation relation) {
  return relation != Relation::equal && relation != Relation::not_equal;
}

bool is_strict(Relation relation) {
  return relation == Relation::less || relation == Relation::greater;
}

bool points_up(Relation relation) {
  return relation == Relation::greater || relation == Relation::greater_or_equal;
}

// a - b; a plain 0 takes the shape of the other side.
Term difference(const Term& a, const Term& b) {
  return b.is_zero() ? a : a.is_zero() ? -b : a - b;
}

// What is zero for an equation, positive or not negative for an inequality.
Term difference(const Statement& statement) {
  return points_up(statement.relation) || statement.relation == Relation::equal
             ? difference(statement.left, statement.right)
             : difference(statement.right, statement.left);
}

bool is_one(const Term& term) {
  return term.op() == Op::number && term.shape().is_scalar() && term.number() == 1;
}

Term times(const Term& a, const Term& b) {
  return is_one(a) ? b : is_one(b) ? a : a * b;
}

Term sum_of(const std::vector<Term>& terms) {
  Term sum = terms.front();
  for (std::size_t i = 1; i < terms.size(); ++i) {
    sum = sum + terms[i];
  }
  return sum;
}

// Collects the premises that a proof looked at.
struct Premises {
  Prover& prover;
  const Claim& claim;
  Outcome& outcome;

  Statement operator()(const Multiple& multiple) const {
    record_premise(outcome, prover, claim, multiple.premise);
    return statement_of(prover, claim, multiple);
  }
};

Term multiple_of_equation(const Premises& premises, const Multiple& multiple) {
  const Statement statement = premises(multiple);
  if (statement.relation != Relation::equal) {
    throw InternalError(fmt::format("claim {}: {} is no equation", premises.claim.id, text(statement)));
  }
  return times(multiple.left, times(difference(statement), multiple.right));
}

// A combination that does not come out refutes nothing.
Verdict undecided_if_refuted(const Verdict& verdict, const std::string& what) {
  return verdict.truth == Truth::refuted ? Verdict::undecided(what + " does not come out identically")
                                         : verdict;
}

void require_count(const Claim& claim, std::size_t count) {
  if (count != claim.printed.size()) {
    throw InternalError(
        fmt::format("claim {} prints {} statements, {} are proved", claim.id, claim.printed.size(), count));
  }
}

}  // namespace

Proof by_combination(std::vector<std::vector<Multiple>> combinations) {
  return [combinations = std::move(combinations)](Prover& prover, const Claim& claim) {
    require_count(claim, combinations.size());
    Outcome outcome;
    outcome.route = "each equation is a combination of the premises, identically";
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < combinations.size(); ++i) {
      std::vector<Term> terms;
      for (const Multiple& multiple : combinations[i]) {
        terms.push_back(multiple_of_equation({prover, claim, outcome}, multiple));
      }
      decide(outcome, claim, equation(difference(claim.printed[i]), sum_of(terms)));
      verdicts.push_back(undecided_if_refuted(outcome.verdict, "the combination"));
    }
    outcome.verdict = all_of(verdicts);
    return outcome;
  };
}

namespace {

// A sum of positive products, and whether it is certain to be so.
struct PositiveSum {
  Term sum = 1;
  Verdict verdict = Verdict::proved();
  bool strict = false;
};

Verdict coefficient_is_positive(const Premises& premises, const Term& coefficient) {
  const Given given(premises.claim);
  const auto nonzero =
      symbolic::algebra::positive_unless_zero(evaluate<ex>(coefficient, given.lookup())(0, 0));
  if (!nonzero) {
    return Verdict::undecided("the coefficient " + text(coefficient) + " is not known to be positive");
  }
  for (const ex& factor : *nonzero) {
    record_nonzero(premises.outcome, premises.claim, factor);
  }
  return Verdict::proved();
}

PositiveSum positive_sum(const Premises& premises, const std::vector<Positive>& products) {
  PositiveSum result;
  std::vector<Term> terms;
  std::vector<Verdict> verdicts;
  for (const Positive& product : products) {
    Term term = product.coefficient;
    bool strict = true;
    for (const Multiple& factor : product.factors) {
      const Statement statement = premises(factor);
      if (!is_inequality(statement.relation)) {
        throw InternalError(fmt::format("claim {}: {} is no inequality", premises.claim.id, text(statement)));
      }
      term = times(term, difference(statement));
      strict = strict && is_strict(statement.relation);
    }
    verdicts.push_back(coefficient_is_positive(premises, product.coefficient));
    terms.push_back(term);
    result.strict = result.strict || strict;
  }
  result.sum = sum_of(terms);
  result.verdict = all_of(verdicts);
  return result;
}

bool is_absolute_value(const Term& term) {
  return term.op() == Op::function && term.name() == "abs";
}

// |x| < y as x^2 < y^2, which says the same where y > 0; also y - |x| < 0 turned round, x^2 > y^2.
Statement without_absolute_value(const Statement& statement) {
  const auto squared = [](const Term& side) {
    return power(is_absolute_value(side) ? side.arguments().front() : side, 2);
  };
  return {squared(statement.left), squared(statement.right), statement.relation};
}

// The printed inequality, without its absolute value; the premise that this needs must say that the other
// side is positive.
Statement in_squares(const Premises& premises, const Statement& printed,
                     const std::optional<Premise>& positive_side) {
  if (!is_absolute_value(printed.left) && !is_absolute_value(printed.right)) {
    return printed;
  }
  const Term& other = is_absolute_value(printed.left) ? printed.right : printed.left;
  if (is_one(other)) {
    return without_absolute_value(printed);
  }
  if (!positive_side) {
    throw InternalError("claim " + premises.claim.id +
                        ": which premise says that the other side is positive?");
  }
  const Statement sign = premises({*positive_side});
  if (sign.relation != Relation::greater || !equal(sign.left, other) || !sign.right.is_zero()) {
    throw InternalError(fmt::format("claim {}: {} does not say that {} is positive", premises.claim.id,
                                    text(sign), text(other)));
  }
  return without_absolute_value(printed);
}

Verdict follows(const Premises& premises, const Statement& printed, const Certificate& certificate) {
  if (!is_inequality(printed.relation)) {
    throw InternalError(fmt::format("claim {}: {} is no inequality", premises.claim.id, text(printed)));
  }
  const PositiveSum positive = positive_sum(premises, certificate.positive);
  std::vector<Term> right{positive.sum};
  for (const Multiple& multiple : certificate.equations) {
    right.push_back(multiple_of_equation(premises, multiple));
  }
  Term left = difference(printed);
  Verdict divisors_are_positive = Verdict::proved();
  if (!certificate.divisors.empty()) {
    const PositiveSum divisor = positive_sum(premises, certificate.divisors);
    divisors_are_positive = divisor.verdict;
    left = times(divisor.sum, left);
    if (!divisor.strict) {
      return Verdict::undecided("the divisor may be zero");
    }
  }
  if (is_strict(printed.relation) && !positive.strict) {
    return Verdict::undecided("the premises do not give a strict inequality");
  }
  decide(premises.outcome, premises.claim, equation(left, sum_of(right)));
  return all_of({positive.verdict, divisors_are_positive,
                 undecided_if_refuted(premises.outcome.verdict, "the positive combination")});
}

}  // namespace

Proof by_positive_combination(std::vector<Certificate> certificates, std::optional<Premise> positive_side) {
  return [certificates = std::move(certificates), positive_side = std::move(positive_side)](
             Prover& prover, const Claim& claim) {
    require_count(claim, certificates.size());
    Outcome outcome;
    outcome.route = "the difference of the sides is a positive combination of the premises, identically";
    const Premises premises{prover, claim, outcome};
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < certificates.size(); ++i) {
      verdicts.push_back(
          follows(premises, in_squares(premises, claim.printed[i], positive_side), certificates[i]));
    }
    outcome.verdict = all_of(verdicts);
    return outcome;
  };
}

namespace {

// "symbol = value" as replacements; a vector also gives the values of its components.
void add_replacements(Replacements& replacements, const Statement& statement) {
  const Term& symbol = statement.left;
  if (statement.relation != Relation::equal || symbol.op() != Op::symbol) {
    throw InternalError(text(statement) + " does not say what a symbol is");
  }
  replacements.insert_or_assign(symbol.name(), statement.right);
  if (symbol.shape().is_scalar()) {
    return;
  }
  const Value<ex> components = evaluate<ex>(symbol, symbolically());
  const int size = symbol.shape().rows;
  for (int i = 0; i < size; ++i) {
    if (!GiNaC::is_a<GiNaC::symbol>(components(i))) {
      throw InternalError(symbol.name() + " is not a vector of unknowns");
    }
    std::vector<Term> row(static_cast<std::size_t>(size), Term(0));
    row[static_cast<std::size_t>(i)] = 1;
    replacements.insert_or_assign(GiNaC::ex_to<GiNaC::symbol>(components(i)).get_name(),
                                  block(1, std::move(row)) * statement.right);
  }
}

}  // namespace

Proof by_putting_in(std::vector<Premise> premises) {
  return [premises = std::move(premises)](Prover& prover, const Claim& claim) {
    Outcome outcome;
    outcome.route = "both sides have the same normal form once the premises are put in";
    Replacements replacements;
    for (const Premise& premise : premises) {
      record_premise(outcome, prover, claim, premise);
      for (const Statement& statement : statements_of(prover, claim, premise)) {
        add_replacements(replacements, statement);
      }
    }
    std::vector<Verdict> verdicts;
    for (const Statement& printed : claim.printed) {
      decide(outcome, claim, substitute(printed, replacements));
      verdicts.push_back(outcome.verdict);
    }
    outcome.verdict = all_of(verdicts);
    return outcome;
  };
}

Proof by_inverse(std::vector<Premise> premises) {
  return [prove = by_rewriting(std::move(premises))](Prover& prover, const Claim& claim) {
    Claim products = claim;
    products.printed.clear();
    for (const Statement& printed : claim.printed) {
      if (printed.left.op() != Op::power || printed.left.number() != -1) {
        throw InternalError(text(printed) + " does not say what an inverse is");
      }
      const Term& A = printed.left.arguments().front();
      const Term I = identity(A.shape().rows);
      products.printed.push_back(equation(A * printed.right, I));
      products.printed.push_back(equation(printed.right * A, I));
    }
    Outcome outcome = prove(prover, products);
    outcome.route = "multiplied from either side it gives $I$";
    return outcome;
  };
}

Proof by_rate_of_change(const Term& quantity, std::vector<Statement> motion) {
  return [quantity, motion = std::move(motion)](Prover&, const Claim& claim) {
    const Given given(claim);
    Outcome outcome;
    const ex value = evaluate<ex>(quantity, given.lookup())(0, 0);
    ex rate = 0;
    for (const Statement& equation : motion) {
      const ex symbol = symbolically()(equation.left.name());
      rate += value.diff(GiNaC::ex_to<GiNaC::symbol>(symbol)) *
              evaluate<ex>(equation.right, given.lookup())(0, 0);
    }
    require_count(claim, 1);
    const Term& changing = claim.printed.front().left;
    if (changing.op() != Op::derivative) {
      throw InternalError(text(changing) + " is no rate of change");
    }
    decide(outcome, claim, equation(changing.arguments().front(), quantity));
    const Verdict is_quantity = outcome.verdict;
    decide(outcome, claim, symbolic::algebra::Matrix::Constant(1, 1, rate),
           evaluate<ex>(claim.printed.front().right, given.lookup()));
    outcome.verdict = all_of({is_quantity, outcome.verdict});
    outcome.route = "the chain rule along the equations of motion";
    return outcome;
  };
}

Proof by_zero_of_cosine(const Term& angle, const std::string& assumption, const Term& lower,
                        const Term& upper) {
  return [=](Prover& prover, const Claim& claim) {
    require_count(claim, 1);
    const Statement& printed = claim.printed.front();
    const Given given(claim);
    const auto angle_at = [&](const Term& value) {
      return evaluate<ex>(substitute(angle, {{printed.left.name(), value}}), given.lookup())(0, 0).normal();
    };
    const Statement zero = statements_of(prover, claim, assuming(assumption)).front();
    const ex slope = evaluate<ex>(angle, given.lookup())(0, 0).diff(
        GiNaC::ex_to<GiNaC::symbol>(symbolically()(printed.left.name())));
    const ex begin = angle_at(lower) / GiNaC::Pi, end = angle_at(upper) / GiNaC::Pi;
    const ex found = angle_at(printed.right) / GiNaC::Pi;
    if (!equal(zero.left, cos(angle)) || !zero.right.is_zero() ||
        slope.has(symbolically()(printed.left.name())) || !begin.info(GiNaC::info_flags::rational) ||
        !end.info(GiNaC::info_flags::rational) || !found.info(GiNaC::info_flags::rational)) {
      throw InternalError(
          fmt::format("claim {}: {} does not run from one multiple of pi to another", claim.id, text(angle)));
    }
    Outcome outcome;
    outcome.assumed.insert(assumption);
    record_assumptions(outcome, claim, upper);
    outcome.route = "cos vanishes at the odd multiples of $pi/2$, one of which lies between the ends";
    // Zeros are at k + 1/2; one of them lies strictly between the ends, and it is the value printed.
    const GiNaC::numeric b = GiNaC::ex_to<GiNaC::numeric>(begin), e = GiNaC::ex_to<GiNaC::numeric>(end),
                         f = GiNaC::ex_to<GiNaC::numeric>(found), whole(1), half_turn(1, 2);
    const bool alone = b < f && f < e && (f - half_turn).is_integer() && f - whole <= b && f + whole >= e;
    outcome.verdict =
        alone ? Verdict::proved() : Verdict::undecided("the value printed is not the only zero in between");
    return outcome;
  };
}

Proof by_definition() {
  return [](Prover&, const Claim& claim) {
    for (const Statement& printed : claim.printed) {
      if (printed.left.op() != Op::symbol && printed.left.op() != Op::function) {
        throw InternalError(text(printed) + " does not introduce a name");
      }
    }
    Outcome outcome;
    outcome.verdict = Verdict::proved();
    outcome.introduces_names = true;
    outcome.route = "a definition: it introduces the names on the left";
    return outcome;
  };
}

}  // namespace stickslip::proofs::methods
