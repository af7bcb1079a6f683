#include "proofs/text/proof_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "proofs/methods/automatic.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/motions.hpp"

namespace stickslip::proofs::text {

using namespace methods;
using symbols::Op;
using symbols::Statement;
using symbols::Term;

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

namespace {

// The parts between separators that stand in no brackets.
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
    if (c == separator && depth <= 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) {
    part = trimmed(part);
  }
  return parts;
}

// The text before the last such word between blanks, and what follows it, if it is there.
std::pair<std::string, std::optional<std::string>> with_clause(const std::string& text,
                                                               const std::string& word) {
  const auto place = text.rfind(fmt::format(" {} ", word));
  return place == std::string::npos ? std::pair(text, std::optional<std::string>())
                                    : std::pair(trimmed(text.substr(0, place)),
                                                std::optional(trimmed(text.substr(place + word.size() + 2))));
}

class Lines {
 public:
  Lines(const Claim& claim, const ProofContext& context) : claim_(claim), context_(context) {}

  // The statements of an assumption of the claim, or of a claim before it.
  [[nodiscard]] std::vector<Statement> statements_of(const std::string& id) const {
    std::vector<Statement> result;
    for (const Assumption& one : claim_.assumptions) {
      if (one.id == id) {
        result.push_back(one.statement);
      }
    }
    if (result.empty()) {
      const auto found = context_.said.find(without_claim(id));
      if (found == context_.said.end()) {
        throw UsageError(fmt::format("'{}' is neither assumed by {} nor a claim before it", id, claim_.id));
      }
      result = found->second;
    }
    return result;
  }

  [[nodiscard]] Premise premise_named(const std::string& id) const {
    (void)statements_of(id);
    return is_assumed(id) ? assuming(id) : from(without_claim(id));
  }

  // Of what the claim assumes.
  [[nodiscard]] std::string assumed(const std::string& id) const {
    if (!is_assumed(id)) {
      throw UsageError(fmt::format("{} assumes nothing as '{}'", claim_.id, id));
    }
    return id;
  }

  [[nodiscard]] Term term(const std::string& text) const { return symbols::parse_term(text, context_.names); }

  // "id at t = tau1, s = 0 for H(t) over H2(t) given step by 13".
  [[nodiscard]] Premise premise(const std::string& text) const {
    std::string rest = text;
    std::map<std::string, std::string> clauses;
    for (const char * word : {"given", "over", "for", "at"}) {  // from the end
      const auto [before, clause] = with_clause(rest, word);
      if (clause) {
        clauses[word] = *clause;
        rest = before;
      }
    }
    Premise result = premise_named(rest);
    for (const auto& [word, clause] : clauses) {
      if (word == "for") {
        result = result.solved_for(term(clause));
      } else if (word == "over") {
        result = result.divided_by(term(clause));
      } else {
        for (const std::string& part : parts_of(clause, ',')) {
          result = word == "at" ? at(result, part) : given(result, part);
        }
      }
    }
    return result;
  }

  [[nodiscard]] std::vector<Premise> premises(const std::string& text) const {
    std::vector<Premise> result;
    for (const std::string& part : parts_of(text, ';')) {
      result.push_back(premise(part));
    }
    return result;
  }

  [[nodiscard]] std::vector<Statement> statements(const std::string& text) const {
    std::vector<Statement> result;
    for (const std::string& part : parts_of(text, ';')) {
      for (const Statement& one : symbols::parse_statements(part, context_.names)) {
        result.push_back(one);
      }
    }
    return result;
  }

  // A sum of products with cites, the cites in them as letters of their own.
  struct Cite {
    Premise premise;
    std::size_t statement = 0;
    bool is_equation = true;
  };
  struct Sum {
    std::vector<Term> products;
    std::map<std::string, Cite> cites;  // by letter
  };

  [[nodiscard]] Sum sum(const std::string& text, const symbols::Shape& shape = {}) const {
    Sum result;
    symbols::Names names = context_.names;
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '@') {
        plain += text[i];
        continue;
      }
      std::size_t end = i + 1;
      const auto pass = [&](const std::string& more) {
        const std::size_t from = end;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                                     more.find(text[end]) != std::string::npos)) {
          ++end;
        }
        return text.substr(from, end - from);
      };
      const std::string id = pass("_.");
      std::string values;  // "t = tau"
      if (end < text.size() && text[end] == '[') {
        const std::size_t closing = text.find(']', end);
        if (closing == std::string::npos) {
          throw UsageError(fmt::format("'@{}[': the bracket is not closed", id));
        }
        values = text.substr(end + 1, closing - end - 1);
        end = closing + 1;
      }
      const std::string cite = id + (end < text.size() && text[end] == '#' ? pass("#") : "");
      const std::string letter = fmt::format("cited_statement_{}", result.cites.size() + 1);
      const std::vector<Statement> said = statements_of(id);
      const std::size_t which = id.size() == cite.size() ? 1 : number(cite.substr(id.size() + 1));
      if (which < 1 || which > said.size()) {
        throw UsageError(fmt::format("'@{}': {} says {} things", cite, id, said.size()));
      }
      if (said.size() > 1 && id.size() == cite.size()) {
        throw UsageError(
            fmt::format("'@{}': {} says {} things: which of them, @{}#1 …?", cite, id, said.size(), id));
      }
      const Statement& statement = said[which - 1];
      names.quantities.insert_or_assign(
          letter, statement.left.is_zero() ? statement.right.shape() : statement.left.shape());
      Premise premise = premise_named(id);
      for (const std::string& value : values.empty() ? std::vector<std::string>{} : parts_of(values, ',')) {
        premise = at(premise, value);
      }
      result.cites.emplace(letter, Cite{premise, which - 1, statement.relation == symbols::Relation::equal});
      plain += " " + letter + " ";
      i = end - 1;
    }
    const Term whole = symbols::parse_term(plain, names, shape);
    collect(whole, 1, result.products);
    return result;
  }

  // The product as factors before, a letter, and factors after; the letters that are cites.
  struct Product {
    Term left = 1, right = 1;
    std::vector<std::string> letters;
  };
  [[nodiscard]] static Product product(const Term& term, const std::map<std::string, Cite>& cites) {
    Product result;
    const auto multiply = [](Term& into, const Term& factor) {
      into = equal(into, Term(1)) ? factor : into * factor;
    };
    const std::function<void(const Term&)> take = [&](const Term& one) {
      if (one.op() == Op::product) {
        std::ranges::for_each(one.arguments(), take);
      } else if (one.op() == Op::negate) {
        multiply(result.letters.empty() ? result.left : result.right, -1);
        take(one.arguments().front());
      } else if (one.op() == Op::quotient) {
        take(one.arguments()[0]);
        multiply(result.letters.empty() ? result.left : result.right, 1 / one.arguments()[1]);
      } else if (one.op() == Op::symbol && cites.contains(one.name())) {
        result.letters.push_back(one.name());
      } else {
        multiply(result.letters.empty() ? result.left : result.right, one);
      }
    };
    take(term);
    return result;
  }

  // Of "0" none: the sides have the same normal form.
  [[nodiscard]] std::vector<methods::Multiple> multiples(const std::string& text,
                                                         const Statement& printed) const {
    if (text == "0") {
      return {};
    }
    const Sum read = sum(text, printed.left.is_zero() ? printed.right.shape() : printed.left.shape());
    std::vector<methods::Multiple> result;
    for (const Term& one : read.products) {
      const Product factors = product(one, read.cites);
      if (factors.letters.size() != 1) {
        throw UsageError(fmt::format("each product of a combination has one @id, and '{}' has {}",
                                     shown(one, read), factors.letters.size()));
      }
      const Cite& cite = read.cites.at(factors.letters.front());
      result.push_back({cite.premise, cite.statement, factors.left, factors.right});
    }
    return result;
  }

  [[nodiscard]] Certificate certificate(const std::string& text) const {
    const auto times = text.find(" times ");
    Certificate result = products(text.substr(0, times));
    if (times != std::string::npos) {
      const Certificate divisors = products(text.substr(times + 7));
      if (!divisors.equations.empty()) {
        throw UsageError(fmt::format("'{}': after 'times' stands what is positive", text));
      }
      result.divisors = divisors.positive;
    }
    return result;
  }

  [[nodiscard]] Counterexample counterexample(const std::string& text) const {
    if (!text.starts_with("at ")) {
      throw UsageError("a counterexample is 'at NAME = NUMBER, …'");
    }
    const std::vector<std::string> parts = parts_of(text, ';');
    Counterexample result;
    for (const std::string& part : parts_of(parts.front().substr(3), ',')) {
      const auto equals = part.find('=');
      const std::string name = trimmed(part.substr(0, equals));
      if (equals == std::string::npos || !context_.names.quantities.contains(name)) {
        throw UsageError(fmt::format("'{}': a symbol of a number, '=' and its value", part));
      }
      result.point.push_back({name, parse_rational(trimmed(part.substr(equals + 1)))});
    }
    std::map<std::string, std::vector<Statement>> clauses;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const std::string word = parts[i].substr(0, parts[i].find(' '));
      if (word != "where" && word != "with" && word != "not") {
        throw UsageError(
            fmt::format("'{}': a counterexample goes on with 'where', 'with' or 'not'", parts[i]));
      }
      std::vector<Statement>& clause = clauses[word];
      for (const std::string& part : parts_of(trimmed(parts[i].substr(word.size())), ',')) {
        const std::vector<Statement> more = statements(part);
        clause.insert(clause.end(), more.begin(), more.end());
      }
    }
    for (const Assumption& one : claim_.assumptions) {
      result.true_there.push_back(one.statement);
    }
    result.values = clauses["where"];
    result.true_there = clauses.contains("with") ? clauses["with"] : result.true_there;
    result.false_there = clauses.contains("not") ? clauses["not"] : claim_.printed;
    return result;
  }

  // One for each statement that the claim prints.
  template <class Part, class Make>
  [[nodiscard]] std::vector<Part> for_each_statement(const std::string& text, const Make& make) const {
    const std::vector<std::string> parts = parts_of(text, ';');
    const std::vector<Statement>& printed = claim_.printed;
    if (parts.size() != printed.size()) {
      throw UsageError(fmt::format("{} states {} things, and its proof is of {}", claim_.id, printed.size(),
                                   parts.size()));
    }
    std::vector<Part> result;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      result.push_back(make(parts[i], printed[i]));
    }
    return result;
  }

 private:
  [[nodiscard]] static std::size_t number(const std::string& text) {
    const bool is_number = !text.empty() && text.size() < 4 && std::ranges::all_of(text, [](char c) {
      return std::isdigit(static_cast<unsigned char>(c)) != 0;
    });
    return is_number ? std::stoul(text) : 0;
  }

  [[nodiscard]] static std::string shown(const Term& term, const Sum& sum) {
    std::string text = symbols::text(term);
    for (const auto& [letter, cite] : sum.cites) {
      if (const auto place = text.find(letter); place != std::string::npos) {
        text.replace(place, letter.size(), "@" + cite.premise.id);
      }
    }
    return text;
  }

  [[nodiscard]] static std::string without_claim(const std::string& id) {
    return id.starts_with("claim ") ? trimmed(id.substr(6)) : id;
  }
  [[nodiscard]] bool is_assumed(const std::string& id) const {
    return std::ranges::find(claim_.assumptions, id, &Assumption::id) != claim_.assumptions.end();
  }

  // What is positive, and equations.
  [[nodiscard]] Certificate products(const std::string& text) const {
    const Sum read = sum(text);
    Certificate result;
    for (const Term& one : read.products) {
      const Product factors = product(one, read.cites);
      const auto cite_of = [&](const std::string& letter) { return read.cites.at(letter); };
      if (factors.letters.size() == 1 && cite_of(factors.letters.front()).is_equation) {
        const Cite cite = cite_of(factors.letters.front());
        result.equations.push_back({cite.premise, cite.statement, factors.left, factors.right});
        continue;
      }
      methods::Positive positive{factors.left * factors.right, {}};
      for (const std::string& letter : factors.letters) {
        if (cite_of(letter).is_equation) {
          throw UsageError(
              fmt::format("'{}': an equation stands in a product without other @id", shown(one, read)));
        }
        positive.factors.push_back({cite_of(letter).premise, cite_of(letter).statement});
      }
      result.positive.push_back(positive);
    }
    return result;
  }

  static void collect(const Term& term, const Term& factor, std::vector<Term>& products) {
    if (term.op() == Op::sum) {
      for (const Term& one : term.arguments()) {
        collect(one, factor, products);
      }
    } else if (term.op() == Op::negate && term.arguments().front().op() == Op::sum) {
      collect(term.arguments().front(), -factor, products);
    } else {
      products.push_back(equal(factor, Term(1)) ? term : factor * term);
    }
  }

  [[nodiscard]] Premise at(const Premise& premise, const std::string& text) const {
    const auto equals = text.find('=');
    if (equals == std::string::npos) {
      throw UsageError(fmt::format("'{}': after 'at' stand a symbol, '=' and its value", text));
    }
    return premise.at(trimmed(text.substr(0, equals)), term(text.substr(equals + 1)));
  }
  [[nodiscard]] Premise given(const Premise& premise, const std::string& text) const {
    const auto by = text.find(" by ");
    if (by == std::string::npos) {
      throw UsageError(fmt::format("'{}': after 'given' stand an assumption, 'by' and a claim", text));
    }
    const std::string claim = trimmed(text.substr(by + 4));
    (void)statements_of(claim);
    return premise.given(trimmed(text.substr(0, by)), claim);
  }

  const Claim& claim_;
  const ProofContext& context_;
};

// Exactly so many parts, between semicolons.
std::vector<std::string> parts_of(const std::string& text, std::size_t count, const char * what) {
  const std::vector<std::string> parts = parts_of(text, ';');
  if (parts.size() != count) {
    throw UsageError(fmt::format("'{}': there stand {}", text, what));
  }
  return parts;
}

Proof order(const Lines& lines, const std::string& text) {
  const auto [sums, positive] = with_clause(text, "positive");
  return by_positive_combination(
      lines.for_each_statement<Certificate>(
          sums, [&](const std::string& part, const Statement&) { return lines.certificate(part); }),
      positive ? std::optional(lines.premise(*positive)) : std::nullopt);
}

Proof flow(const Lines& lines, const std::string& text) {
  const auto [rest, initial] = with_clause(text, "from");
  const std::vector<std::string> parts =
      parts_of(rest, 3, "the flow, the forced motion, and what is assumed of the phase");
  return by_differential_equation({lines.assumed(parts[2]), initial ? lines.assumed(*initial) : "",
                                   lines.term(parts[0]), lines.term(parts[1])});
}

Proof mean_value(const Lines& lines, const std::string& text) {
  const std::vector<std::string> parts =
      parts_of(text, 6, "a row, and what is assumed of phase, slope, beginning, end and duration");
  return by_mean_value({lines.assumed(parts[1]), lines.assumed(parts[2]), lines.assumed(parts[3]),
                        lines.assumed(parts[4]), lines.assumed(parts[5]), lines.term(parts[0])});
}

Proof zero_of_cosine(const Lines& lines, const std::string& text) {
  const std::vector<std::string> parts =
      parts_of(text, 4, "an angle, a premise, and two numbers between which angle/pi lies");
  return by_zero_of_cosine(
      {lines.term(parts[0]), lines.premise(parts[1]), parse_rational(parts[2]), parse_rational(parts[3])});
}

Proof nonzero(const Lines& lines, const std::string& text) {
  const auto [id, multiplier] = with_clause(text, "times");
  if (!multiplier) {
    throw UsageError(fmt::format("'{}': after the assumption stand 'times' and a multiplier", text));
  }
  return by_nonzero_multiple(lines.assumed(id), lines.term(*multiplier));
}

Proof chain_rule(const Lines& lines, const std::string& text) {
  const auto [premises, later] = with_clause(text, "later");
  return by_chain_rule(lines.premises(premises), later ? std::optional(lines.term(*later)) : std::nullopt);
}

Proof decrease(const Lines& lines, const std::string& text) {
  const std::vector<std::string> parts = parts_of(text, 2, "a premise and a weight");
  return by_decrease(lines.premise(parts[0]), lines.term(parts[1]));
}

Proof periodic_decrease(const Lines& lines, const std::string& text) {
  const std::vector<std::string> parts = parts_of(text, ';');
  if (parts.size() < 3) {
    throw UsageError(fmt::format("'{}': there stand a premise, a weight and what returns", text));
  }
  PeriodicDecrease step{lines.premise(parts[0]), {}, lines.term(parts[1])};
  for (std::size_t i = 2; i < parts.size(); ++i) {
    step.returns.push_back(lines.assumed(parts[i]));
  }
  return by_periodic_decrease(step);
}

// PREMISE [times EXPRESSION] [with NAME = EXPRESSION, …] [supplied PREMISE, …]; …
Proof instances(const Lines& lines, const std::string& text) {
  std::vector<Instance> all;
  for (const std::string& part : parts_of(text, ';')) {
    const auto [rest, supplied] = with_clause(part, "supplied");
    const auto [product, functions] = with_clause(rest, "with");
    const auto [premise, left] = with_clause(product, "times");
    Instance one{lines.premise(premise), {}, {}, left ? lines.term(*left) : Term(1)};
    for (const std::string& function : parts_of(functions.value_or(""), ',')) {
      const auto equals = function.find('=');
      if (functions && equals == std::string::npos) {
        throw UsageError(
            fmt::format("'{}': after 'with' stand a function, '=' and its value at t", function));
      }
      if (functions) {
        one.functions.emplace(trimmed(function.substr(0, equals)), lines.term(function.substr(equals + 1)));
      }
    }
    if (supplied) {
      for (const std::string& more : parts_of(*supplied, ',')) {
        one.supplied.push_back(lines.premise(more));
      }
    }
    all.push_back(one);
  }
  return by_instances(all);
}

}  // namespace

Proof proof_of(const Claim& claim, const ProofContext& context, const std::string& line) {
  const Lines lines(claim, context);
  using Make = std::function<Proof(const std::string&)>;
  const std::vector<std::pair<std::string, Make>> known{
      {"normal form of", [&](const std::string& rest) { return by_normal_form(lines.statements(rest)); }},
      {"normal form", [&](const std::string&) { return by_normal_form(); }},
      {"definition", [&](const std::string&) { return by_definition(); }},
      {"rewriting", [&](const std::string& rest) { return by_rewriting(lines.premises(rest)); }},
      {"premises", [&](const std::string& rest) { return by_premises(lines.premises(rest)); }},
      {"putting in", [&](const std::string& rest) { return by_putting_in(lines.premises(rest)); }},
      {"inverse", [&](const std::string& rest) { return by_inverse(lines.premise(rest)); }},
      {"combination",
       [&](const std::string& rest) {
         return by_combination(lines.for_each_statement<std::vector<methods::Multiple>>(
             rest, [&](const std::string& part, const Statement& printed) {
               return lines.multiples(part, printed);
             }));
       }},
      {"order", [&](const std::string& rest) { return order(lines, rest); }},
      {"nonzero", [&](const std::string& rest) { return nonzero(lines, rest); }},
      {"zero of cosine", [&](const std::string& rest) { return zero_of_cosine(lines, rest); }},
      {"flow", [&](const std::string& rest) { return flow(lines, rest); }},
      {"mean value", [&](const std::string& rest) { return mean_value(lines, rest); }},
      {"chain rule", [&](const std::string& rest) { return chain_rule(lines, rest); }},
      {"decrease", [&](const std::string& rest) { return decrease(lines, rest); }},
      {"instances", [&](const std::string& rest) { return instances(lines, rest); }},
      {"periodic decrease", [&](const std::string& rest) { return periodic_decrease(lines, rest); }},
      {"counterexample",
       [&](const std::string& rest) { return by_counterexample(lines.counterexample(rest)); }},
  };
  if (line.empty()) {
    return automatically();
  }
  std::vector<std::string> names;
  for (const auto& [name, make] : known) {
    if (line == name || line.starts_with(name + " ")) {
      return make(trimmed(line.substr(name.size())));
    }
    names.push_back(name);
  }
  throw UsageError(fmt::format("'{}' is no method of proof: there are {}", line, fmt::join(names, ", ")));
}

}  // namespace stickslip::proofs::text
