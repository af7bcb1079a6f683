#include "proofs/methods/reading.hpp"

#include <algorithm>
#include <numeric>

#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;

symbols::Term printed_term(const Term& term) {
  const auto part = [&](std::size_t k) { return printed_term(term.parts()[k]); };
  switch (term.kind()) {
    case kernel::Kind::variable:
      return root_of({term.name(), term.type()}).value_or(symbols::scalar(term.name()));
    case kernel::Kind::number:
      return symbols::Term(term.value());
    case kernel::Kind::pi:
      return symbols::pi();
    case kernel::Kind::sum: {
      symbols::Term sum = part(0);
      for (std::size_t k = 1; k < term.parts().size(); ++k) {
        sum = sum + part(k);
      }
      return sum;
    }
    case kernel::Kind::product:
      return part(0) * part(1);
    case kernel::Kind::power:
      return symbols::power(part(0), static_cast<int>(term.value().get_num().get_si()));
    case kernel::Kind::inverse:
      return 1 / part(0);
    case kernel::Kind::cosine:
      return symbols::cos(part(0));
    case kernel::Kind::sine:
      return symbols::sin(part(0));
    case kernel::Kind::exponential:
      return symbols::exp(part(0));
    case kernel::Kind::defined:
      if (term.type().is_scalar()) {
        return symbols::scalar(term.definition().name());
      }
      [[fallthrough]];
    default:
      throw symbols::NoValue("no print: " + to_string(term));
  }
}

namespace {

symbols::Term neat_letter(const Term& letter) {
  switch (letter.kind()) {
    case kernel::Kind::cosine:
      return symbols::cos(neat_term(letter.parts()[0]));
    case kernel::Kind::sine:
      return symbols::sin(neat_term(letter.parts()[0]));
    case kernel::Kind::exponential:
      return symbols::exp(neat_term(letter.parts()[0]));
    default:
      return printed_term(letter);
  }
}

symbols::Term product_of(const Monomial& monomial, const std::vector<Term>& letters) {
  std::vector<std::size_t> order(letters.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t k) { return letters[k].kind() == kernel::Kind::pi; });
  const Rational size = abs(monomial.coefficient);
  std::optional<symbols::Term> product;
  if (size != 1) {
    product = symbols::Term(size);
  }
  for (const std::size_t k : order) {
    if (monomial.degrees[k] > 0) {
      const symbols::Term letter = neat_letter(letters[k]);
      const symbols::Term factor =
          monomial.degrees[k] == 1 ? letter : symbols::power(letter, monomial.degrees[k]);
      product = product ? *product * factor : factor;
    }
  }
  return product.value_or(1);
}

// The terms of low degree first.
std::vector<Monomial> in_order(const Polynomial& polynomial) {
  std::vector<Monomial> result = monomials(polynomial);
  std::ranges::stable_sort(result, {}, [](const Monomial& one) {
    return std::accumulate(one.degrees.begin(), one.degrees.end(), 0);
  });
  return result;
}

symbols::Term sum_of(const Polynomial& polynomial, const tactics::Letters& letters) {
  std::optional<symbols::Term> sum;
  for (const Monomial& one : in_order(polynomial)) {
    const symbols::Term product = product_of(one, letters.terms());
    const bool is_negative = one.coefficient < 0;
    sum = sum ? (is_negative ? *sum - product : *sum + product) : is_negative ? -product : product;
  }
  return sum.value_or(0);
}

}  // namespace

symbols::Term neat_term(const Term& number) {
  const tactics::Letters letters({number});
  auto [above, below] = letters.fraction(number);
  if (is_constant(below) && leading_coefficient(below) == 1) {
    return sum_of(above, letters);
  }
  const bool is_negative = in_order(above).front().coefficient < 0;
  above *= letters.ring().constant(is_negative ? -1 : 1);
  const symbols::Term size = sum_of(above, letters) / sum_of(below, letters);
  return is_negative ? -size : size;
}

Hypothesis hypothesis(const Term& factor, const std::string& origin) {
  const tactics::Letters letters({factor});
  const auto [above, below] = letters.fraction(factor);
  symbols::Term nonzero = neat_term(factor);  // of a quotient all of it: where it is not defined, too
  if (is_constant(below)) {
    Polynomial primitive = tactics::factored(above, letters).product;
    const int sign = above.is_zero() ? 1 : sgn(in_order(primitive).front().coefficient);
    primitive *= letters.ring().constant(sign);
    nonzero = sum_of(primitive, letters);
  }
  return {nonzero, text(nonzero) + " != 0", latex(nonzero) + " \\neq 0", origin};
}

}  // namespace stickslip::proofs::methods
