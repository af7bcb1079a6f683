#include "proofs/methods/implications.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/tactics/letters.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

void require_count(const Claim& claim, std::size_t count) {
  if (count != claim.printed.size()) {
    throw InternalError(
        fmt::format("claim {} prints {} statements, {} are proved", claim.id, claim.printed.size(), count));
  }
}

// Which entry of a row or a column of zeros is its one; nothing for another.
std::optional<int> unit_of(const kernel::Term& term) {
  const std::vector<kernel::Term>& parts = term.parts();
  if (term.kind() != kernel::Kind::matrix || std::ranges::count(parts, kernel::Term(1)) != 1 ||
      std::ranges::count(parts, kernel::Term(0)) + 1 != std::ssize(parts)) {
    return std::nullopt;
  }
  return static_cast<int>(std::ranges::find(parts, kernel::Term(1)) - parts.begin());
}

// The term with (unit row) M (unit column) for the entry of M that it is, where M is written out.
kernel::Term with_entries(kernel::Term term) {
  std::map<kernel::Term, kernel::Term> entries;
  tactics::each_part({term}, [&](const kernel::Term& part) {
    if (part.is_closed() && part.kind() == kernel::Kind::product &&
        part.parts()[0].kind() == kernel::Kind::product) {
      const kernel::Term &row = part.parts()[0].parts()[0], &M = part.parts()[0].parts()[1],
                         &column = part.parts()[1];
      const std::optional<int> i = unit_of(row), j = unit_of(column);
      if (i && j && M.kind() == kernel::Kind::matrix && row.type().rows == 1 && column.type().columns == 1) {
        entries.emplace(part, M.parts()[static_cast<std::size_t>(*i * M.type().columns + *j)]);
      }
    }
    return part.is_closed();
  });
  for (const auto& [product, entry] : entries) {
    term = replaced(term, product, entry);
  }
  return term;
}

std::vector<kernel::Multiple> multiples_of(Derivation& derivation, const std::vector<Multiple>& multiples) {
  std::vector<kernel::Multiple> result;
  for (const Multiple& multiple : multiples) {
    result.push_back({derivation.premise(multiple.premise, multiple.statement),
                      with_entries(derivation.read(multiple.left)),
                      with_entries(derivation.read(multiple.right))});
  }
  return result;
}

// ⊢ 0 < coefficients, or 0 ≤ if that is enough, and the premises, as factors of one product.
kernel::Positive positive_of(Derivation& derivation, const Positive& product, bool strictly = true) {
  kernel::Positive result{{}};
  const kernel::Term coefficient = derivation.read(product.coefficient);
  if (coefficient.kind() == kernel::Kind::number && coefficient.value() > 0) {
    result.factor = coefficient.value();
  } else {
    const kernel::Theorem positive = derivation.positive(coefficient);
    const bool is_everywhere = std::ranges::none_of(positive.hypotheses(), tactics::is_divisor);
    if (strictly || is_everywhere) {
      result.inequalities.push_back(positive);
    } else {
      result = not_negative(derivation, coefficient);
    }
  }
  for (const Multiple& factor : product.factors) {
    result.inequalities.push_back(derivation.premise(factor.premise, factor.statement));
  }
  return result;
}

kernel::Theorem by_certificate(Derivation& derivation, const kernel::Formula& goal,
                               const Certificate& certificate) {
  std::vector<kernel::Positive> positives;
  for (const Positive& product : certificate.positive) {
    positives.push_back(positive_of(derivation, product, goal.kind() == kernel::Kind::less));
  }
  std::vector<kernel::Multiple> equations = multiples_of(derivation, certificate.equations);
  if (!certificate.divisors.empty()) {
    std::vector<kernel::Positive> parts;
    std::vector<kernel::Term> terms;
    for (const Positive& product : certificate.divisors) {
      parts.push_back(positive_of(derivation, product));
      const kernel::Positive& part = parts.back();
      kernel::Term value = part.factor;
      for (const kernel::Theorem& inequality : part.inequalities) {
        value = value * gap_of(inequality.conclusion());
      }
      terms.push_back(value);
    }
    const kernel::Theorem divisor = derivation.order(kernel::less(0, kernel::sum(terms)), parts);
    const kernel::Theorem inverse = tactics::inverse_is_positive(divisor);
    derivation.know(tactics::different(divisor));
    for (kernel::Positive& positive : positives) {
      positive.inequalities.push_back(inverse);
    }
    for (kernel::Multiple& equation : equations) {
      equation.left = inverse.conclusion().parts()[1] * equation.left;
    }
  }
  return derivation.order(goal, positives, equations);
}

// |x| < y from x² < y² and 0 < y, where the printed statement is one of an absolute value.
kernel::Theorem in_squares(Derivation& derivation, const kernel::Formula& printed,
                           const kernel::Theorem& positive_side, const Certificate& certificate) {
  const kernel::Formula& upper = printed.parts()[1];  // x < y
  const kernel::Term x = upper.parts()[0], y = upper.parts()[1];
  const kernel::Theorem squares =
      by_certificate(derivation, kernel::less(power(x, 2), power(y, 2)), certificate);
  std::vector<kernel::Theorem> both_sides;
  for (const kernel::Formula& side : printed.parts()) {
    const kernel::Term a = side.parts()[0], b = side.parts()[1];
    const kernel::Formula wrong = kernel::at_most(b, a);
    const kernel::Theorem assumed = kernel::Theorem::assume(wrong);
    const kernel::Theorem too_large = derivation.order(
        kernel::at_most(power(y, 2), power(x, 2)),
        {kernel::Positive{{assumed, assumed}}, kernel::Positive{{assumed, positive_side}, 2}});
    both_sides.push_back(kernel::Theorem::consequence(
        {kernel::Theorem::discharge(too_large, wrong), squares,
         kernel::Theorem::trichotomy(power(x, 2), power(y, 2)), kernel::Theorem::trichotomy(a, b)},
        side));
  }
  return tactics::both(both_sides);
}

}  // namespace

Proof by_combination(std::vector<std::vector<Multiple>> combinations) {
  return by_kernel("each equation is a combination of the premises, identically",
                   [combinations = std::move(combinations)](Derivation& derivation, std::size_t which) {
                     require_count(derivation.claim(), combinations.size());
                     return derivation.combination(derivation.printed(which),
                                                   multiples_of(derivation, combinations[which]));
                   });
}

Proof by_positive_combination(std::vector<Certificate> certificates, std::optional<Premise> positive_side) {
  const auto derive = [certificates = std::move(certificates), positive_side = std::move(positive_side)](
                          Derivation& derivation, std::size_t which) {
    require_count(derivation.claim(), certificates.size());
    const kernel::Formula printed = derivation.printed(which);
    if (printed.kind() != kernel::Kind::conjunction) {
      return by_certificate(derivation, printed, certificates[which]);
    }
    const kernel::Theorem positive =
        positive_side ? derivation.premise(*positive_side) : kernel::Theorem::sign(kernel::less(0, 1));
    return in_squares(derivation, printed, positive, certificates[which]);
  };
  return by_kernel("the difference of the sides is a positive combination of the premises, identically",
                   derive);
}

Proof by_putting_in(std::vector<Premise> premises) {
  return by_kernel("both sides have the same normal form once the premises are put in",
                   [premises = std::move(premises)](Derivation& derivation, std::size_t which) {
                     for (const Premise& premise : premises) {
                       derivation.give(derivation.premise(premise));
                     }
                     return derivation.combination(derivation.printed(which));
                   });
}

Proof by_inverse(Premise product) {
  return by_kernel("multiplied it gives $I$",
                   [product = std::move(product)](Derivation& derivation, std::size_t) {
                     return tactics::inverse_of(derivation.premise(product));
                   });
}

Proof by_zero_of_cosine(const ZeroOfCosine& step) {
  const auto derive = [=](Derivation& derivation, std::size_t which) {
    const kernel::Formula printed = derivation.printed(which);
    const kernel::Term x = derivation.read(step.angle);
    const auto turns = [](const Rational& number) { return kernel::Term(number) * kernel::pi(); };
    kernel::Theorem zero = derivation.premise(step.zero);
    kernel::Theorem cases =
        kernel::Theorem::zeros_between(zero, derivation.follows(kernel::less(turns(step.lower), x)),
                                       derivation.follows(kernel::less(x, turns(step.upper))));
    if (cases.conclusion().kind() == kernel::Kind::disjunction && cases.conclusion().parts().size() == 1) {
      cases = kernel::Theorem::consequence({cases}, cases.conclusion().parts()[0]);
    }
    if (cases.conclusion().kind() != kernel::Kind::equal) {
      throw kernel::KernelError("there is more than one zero in between");
    }
    // The angle is a multiple of what is printed.
    return derivation.combination(printed, {{cases, tactics::quotient(printed.parts()[0], x)}});
  };
  return by_kernel("cos vanishes at the odd multiples of $pi/2$, one of which lies between the ends", derive);
}

Proof by_nonzero_multiple(const std::string& assumption, const Term& multiplier) {
  const auto derive = [=](Derivation& derivation, std::size_t which) {
    using kernel::Theorem;
    const Theorem stated = derivation.premise(assuming(assumption));
    const kernel::Formula printed = derivation.printed(which);
    const kernel::Formula zero = printed.parts().at(0);  // A = 0
    const kernel::Term B = stated.conclusion().parts().at(0).parts().at(0);
    const Theorem square =
        derivation.combination(equal(B * B, 0), {{Theorem::assume(zero), derivation.read(multiplier)}});
    return Theorem::consequence({Theorem::discharge(square, zero), tactics::zero_product(B, B), stated},
                                printed);
  };
  return by_kernel("where the left side vanishes, so does what is assumed not to: its square is a multiple",
                   derive);
}

Proof by_theorem(const std::string& route, kernel::Theorem (*make)()) {
  return [=](Prover&, const Claim&) {
    Outcome outcome;
    outcome.route = route;
    try {
      const kernel::Theorem theorem = make();
      for (const kernel::Formula& hypothesis : theorem.hypotheses()) {
        if (!is_inequality(hypothesis)) {
          throw kernel::KernelError("it rests on more than ranges: " + to_string(hypothesis));
        }
      }
      outcome.theorems = {theorem};
      outcome.by_kernel = true;
      outcome.verdict = Verdict::proved();
    } catch (const kernel::KernelError& error) {
      outcome.verdict = Verdict::undecided(error.what());
    }
    return outcome;
  };
}

Proof by_definition() {
  return by_kernel("a definition: the names on the left stand for this",
                   [](Derivation& derivation, std::size_t which) {
                     return derivation.combination(derivation.printed(which));
                   });
}

}  // namespace stickslip::proofs::methods
