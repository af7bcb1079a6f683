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

namespace stickslip::proofs::text {

using namespace methods;
using symbols::Op;
using symbols::Statement;
using symbols::Term;

namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

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

class Lines {
 public:
  explicit Lines(const ProofPlace& place) : place_(place) {}

  // The statements of an assumption of the claim, or of a claim before it.
  [[nodiscard]] std::vector<Statement> statements_of(const std::string& id) const {
    std::vector<Statement> result;
    for (const Assumption& one : place_.claim.assumptions) {
      if (one.id == id) {
        result.push_back(one.statement);
      }
    }
    if (result.empty()) {
      const auto found = std::ranges::find(place_.before, id, &Claim::id);
      if (found == place_.before.end()) {
        throw UsageError(
            fmt::format("'{}' is neither assumed by {} nor a claim before it", id, place_.claim.id));
      }
      result = found->corrected.empty() ? found->printed : found->corrected;
    }
    return result;
  }

  [[nodiscard]] Premise premise_named(const std::string& id) const {
    (void)statements_of(id);
    const bool assumed =
        std::ranges::any_of(place_.claim.assumptions, [&](const Assumption& one) { return one.id == id; });
    return assumed ? assuming(id) : from(id);
  }

  [[nodiscard]] Term term(const std::string& text) const { return symbols::parse_term(text, place_.names); }

  // "id at t = tau1, s = 0 for H(t) over H2(t) given step by 13".
  [[nodiscard]] Premise premise(const std::string& text) const {
    std::string rest = text;
    std::map<std::string, std::string> clauses;
    for (const char * word : {"given", "over", "for", "at"}) {  // from the end
      const auto place = rest.rfind(fmt::format(" {} ", word));
      if (place != std::string::npos) {
        clauses[word] = trimmed(rest.substr(place + 2 + std::string(word).size()));
        rest = trimmed(rest.substr(0, place));
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

  [[nodiscard]] Sum sum(const std::string& text) const {
    Sum result;
    symbols::Names names = place_.names;
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '@') {
        plain += text[i];
        continue;
      }
      std::size_t end = i + 1;
      const auto belongs = [&](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '#';
      };
      while (end < text.size() && belongs(text[end])) {
        ++end;
      }
      const std::string cite = text.substr(i + 1, end - i - 1), id = cite.substr(0, cite.find('#'));
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
      result.cites.emplace(
          letter, Cite{premise_named(id), which - 1, statement.relation == symbols::Relation::equal});
      plain += " " + letter + " ";
      i = end - 1;
    }
    const Term whole = symbols::parse_term(plain, names);
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

  [[nodiscard]] std::vector<methods::Multiple> multiples(const std::string& text) const {
    const Sum read = sum(text);
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

  [[nodiscard]] Counterexample counterexample(const std::string& text) const {
    if (!text.starts_with("at ")) {
      throw UsageError("a counterexample is 'at NAME = NUMBER, …'");
    }
    Counterexample result;
    for (const std::string& part : parts_of(text.substr(3), ',')) {
      const auto equals = part.find('=');
      const std::string name = trimmed(part.substr(0, equals));
      if (equals == std::string::npos || !place_.names.quantities.contains(name)) {
        throw UsageError(fmt::format("'{}': a symbol of a number, '=' and its value", part));
      }
      result.point.push_back({name, parse_rational(trimmed(part.substr(equals + 1)))});
    }
    for (const Assumption& one : place_.claim.assumptions) {
      result.true_there.push_back(one.statement);
    }
    result.false_there = place_.claim.printed;
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

  const ProofPlace& place_;
};

// One for each statement.
template <class Part, class Make>
std::vector<Part> for_each_statement(const ProofPlace& place, const std::string& text, const Make& make) {
  std::vector<Part> result;
  for (const std::string& part : parts_of(text, ';')) {
    result.push_back(make(part));
  }
  if (result.size() != place.claim.printed.size()) {
    throw UsageError(fmt::format("{} states {} things, and its proof is of {}", place.claim.id,
                                 place.claim.printed.size(), result.size()));
  }
  return result;
}

}  // namespace

Proof proof_of(const ProofPlace& place, const std::string& line) {
  const Lines lines(place);
  using Make = std::function<Proof(const std::string&)>;
  const std::vector<std::pair<std::string, Make>> known{
      {"normal form", [&](const std::string&) { return by_normal_form(); }},
      {"definition", [&](const std::string&) { return by_definition(); }},
      {"rewriting", [&](const std::string& rest) { return by_rewriting(lines.premises(rest)); }},
      {"premises", [&](const std::string& rest) { return by_premises(lines.premises(rest)); }},
      {"putting in", [&](const std::string& rest) { return by_putting_in(lines.premises(rest)); }},
      {"inverse", [&](const std::string& rest) { return by_inverse(lines.premise(rest)); }},
      {"combination",
       [&](const std::string& rest) {
         return by_combination(for_each_statement<std::vector<methods::Multiple>>(
             place, rest, [&](const std::string& part) { return lines.multiples(part); }));
       }},
      {"order",
       [&](const std::string& rest) {
         return by_positive_combination(for_each_statement<Certificate>(
             place, rest, [&](const std::string& part) { return lines.certificate(part); }));
       }},
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
