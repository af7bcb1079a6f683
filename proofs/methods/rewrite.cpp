#include "proofs/methods/rewrite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

using Coefficient = kernel::Term;

Coefficient in_lowest_terms(const Coefficient& a) {
  return a.kind() == kernel::Kind::number ? a : tactics::quotient(a, 1);
}

void add(Polynomial& sum, const Word& word, const Coefficient& coefficient) {
  const auto known = sum.find(word);
  const Coefficient total = in_lowest_terms(known == sum.end() ? coefficient : known->second + coefficient);
  if (known != sum.end()) {
    sum.erase(known);
  }
  if (!(total == Coefficient(0))) {
    sum.emplace(word, total);
  }
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [left, x] : a) {
    for (const auto& [right, y] : b) {
      Word word = left;
      word.insert(word.end(), right.begin(), right.end());
      add(result, word, x * y);
    }
  }
  return result;
}

Polynomial scaled(const Polynomial& a, const Coefficient& factor) {
  return product({{{}, factor}}, a);
}

Polynomial sum(const Polynomial& a, const Polynomial& b) {
  Polynomial result = a;
  for (const auto& [word, coefficient] : b) {
    add(result, word, coefficient);
  }
  return result;
}

std::string letter(const Term& term, const Scalars& scalars) {
  if (term.op() == Op::function) {
    return fmt::format("{}({})", term.name(), to_string(scalars(term.arguments().front())));
  }
  return text(term);
}

Polynomial power_of(const Term& term, const Scalars& scalars) {
  const long exponent = term.number().get_num().get_si();
  if (exponent < 0) {
    return {{{letter(term, scalars)}, 1}};
  }
  Polynomial result{{{}, 1}};
  for (long i = 0; i < exponent; ++i) {
    result = product(result, polynomial(term.arguments().front(), scalars));
  }
  return result;
}

// Where `lead` stands inside `word`, if it does.
std::optional<std::size_t> find(const Word& word, const Word& lead) {
  const auto found = std::search(word.begin(), word.end(), lead.begin(), lead.end());
  return found == word.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - word.begin()));
}

// One replacement in one word.
Polynomial replaced(const Word& word, const Coefficient& coefficient, std::size_t place, const Rule& rule) {
  const Word before(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(place));
  const Word after(word.begin() + static_cast<std::ptrdiff_t>(place + rule.lead.size()), word.end());
  return product(product({{before, coefficient}}, rule.replacement), {{after, 1}});
}

// Applies the first rule that fits somewhere; false if none does.
bool step(Rewritten& rewritten, const std::vector<Rule>& rules) {
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const Rule& rule = rules[i];
    for (const auto& [word, coefficient] : rewritten.rest) {
      if (const auto place = find(word, rule.lead)) {
        const auto begin = word.begin() + static_cast<std::ptrdiff_t>(*place);
        const auto end = begin + static_cast<std::ptrdiff_t>(rule.lead.size());
        rewritten.trace.push_back({coefficient, {word.begin(), begin}, i, {end, word.end()}});
        const Polynomial change = replaced(word, coefficient, *place, rule);
        rewritten.rest.erase(Word(word));
        rewritten.rest = sum(rewritten.rest, change);
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Polynomial polynomial(const Term& term, const Scalars& scalars) {
  if (term.is_zero()) {
    return {};
  }
  if (term.shape().is_scalar()) {
    return scaled({{{}, 1}}, scalars(term));
  }
  Polynomial result;
  switch (term.op()) {
    case Op::sum:
      for (const Term& argument : term.arguments()) {
        result = sum(result, polynomial(argument, scalars));
      }
      return result;
    case Op::product:
      result = {{{}, 1}};
      for (const Term& argument : term.arguments()) {
        result = product(result, polynomial(argument, scalars));
      }
      return result;
    case Op::negate:
      return scaled(polynomial(term.arguments().front(), scalars), -1);
    case Op::quotient:
      return scaled(polynomial(term.arguments()[0], scalars), 1 / scalars(term.arguments()[1]));
    case Op::power:
      return power_of(term, scalars);
    default:
      return term.op() == Op::symbol && term.name() == "I" ? Polynomial{{{}, 1}}
                                                           : Polynomial{{{letter(term, scalars)}, 1}};
  }
}

void collect_letters(const Term& term, const Scalars& scalars, std::map<std::string, Term>& letters) {
  const bool composed = term.op() == Op::sum || term.op() == Op::product || term.op() == Op::negate ||
                        term.op() == Op::quotient || (term.op() == Op::power && term.number() >= 0);
  if (term.shape().is_scalar() || term.is_zero()) {
    return;
  }
  if (!composed) {
    letters.emplace(letter(term, scalars), term);
    return;
  }
  for (const Term& argument : term.arguments()) {
    collect_letters(argument, scalars, letters);
  }
}

Polynomial residual(const Statement& statement, const Scalars& scalars) {
  return sum(polynomial(statement.left, scalars), scaled(polynomial(statement.right, scalars), -1));
}

std::string text(const Polynomial& polynomial) {
  std::string result;
  for (const auto& [word, coefficient] : polynomial) {
    result += fmt::format("{}({}){}{}", result.empty() ? "" : " + ", to_string(coefficient),
                          word.empty() ? "" : " ", fmt::join(word, " "));
  }
  return result.empty() ? "0" : result;
}

Rewritten rewrite(Polynomial polynomial, const std::vector<Rule>& rules) {
  constexpr int most_steps = 1000;
  Rewritten result{std::move(polynomial), {}};
  for (int i = 0; i < most_steps; ++i) {
    if (!step(result, rules)) {
      return result;
    }
  }
  throw kernel::KernelError(fmt::format("rewriting does not end after {} steps", most_steps));
}

std::optional<Rule> solve(const Polynomial& premise, const Polynomial& lead, const std::vector<Rule>& rules) {
  Rewritten simplified = rewrite(premise, rules);
  if (lead.size() != 1) {
    throw InternalError(fmt::format("{} is not a product of letters", text(lead)));
  }
  const Word& word = lead.begin()->first;
  const auto found = simplified.rest.find(word);
  if (found == simplified.rest.end() || found->second.kind() != kernel::Kind::number) {
    return std::nullopt;
  }
  const Rational coefficient = found->second.value();
  simplified.rest.erase(found);
  return Rule{word, scaled(simplified.rest, Coefficient(Rational(-1 / coefficient))),
              std::move(simplified.trace), coefficient};
}

}  // namespace stickslip::proofs::methods
