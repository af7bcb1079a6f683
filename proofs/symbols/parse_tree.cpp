#include "proofs/symbols/parse_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "core/decimal.hpp"

namespace stickslip::proofs::symbols::parsing {
namespace {

// What nobody writes, and what would end in no time or no stack.
constexpr int deepest = 200, greatest_exponent = 200;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t before = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = before + (a[i] == b[j] ? 0 : 1);
      before = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// "; there are H1, H2 and H3": the names most like this one.
std::string names_like(const std::string& name, const Names& names) {
  std::vector<std::tuple<std::size_t, bool, std::string>> near;  // of the same first letter first
  const auto add_near = [&](const auto& map) {
    for (const auto& entry : map) {
      const std::size_t distance = edit_distance(name, entry.first);
      if (distance <= (name.size() > 1 ? 2U : 1U)) {
        near.emplace_back(distance, entry.first.front() != name.front(), entry.first);
      }
    }
  };
  add_near(names.quantities);
  add_near(names.functions);
  add_near(names.abbreviations);
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  constexpr std::size_t most = 6;
  std::vector<std::string> shown;
  for (const auto& one : near) {
    if (shown.size() < most) {
      shown.push_back(std::get<2>(one));
    }
  }
  return shown.empty()
             ? ""
             : fmt::format("; there {} {}", shown.size() > 1 ? "are" : "is", fmt::join(shown, ", "));
}

class Parser {
 public:
  Parser(std::string_view line, const Names& names) : line_(line), names_(names), tokens_(tokens_of(line)) {}

  [[nodiscard]] Relations relations() {
    Relations result{{expression()}, {}, {}, {}, false};
    while (const std::optional<Relation> relation = relation_here()) {
      result.between.push_back(*relation);
      result.sides.push_back(expression());
    }
    if (result.between.empty()) {
      expected("=, !=, <, <=, > or >= and what stands on its other side");
    }
    times(result);
    at_end();
    return result;
  }

  [[nodiscard]] Node whole_expression() {
    Node result = expression();
    at_end();
    return result;
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& what) const { throw ParseError(line_, at, what); }
  [[noreturn]] void expected(const std::string& what) const {
    const Token& token = here();
    const std::string found =
        token.kind == Kind::end ? "the line ends" : fmt::format("there is '{}'", token.text);
    fail(token.at, fmt::format("{}, where one expects {}", found, what));
  }

  [[nodiscard]] const Token& here() const { return tokens_[next_]; }
  [[nodiscard]] bool is(std::string_view sign, std::size_t ahead = 0) const {
    const std::size_t k = std::min(next_ + ahead, tokens_.size() - 1);
    return tokens_[k].kind == Kind::sign && tokens_[k].text == sign;
  }
  [[nodiscard]] bool is_word(std::string_view word) const {
    return here().kind == Kind::name && here().text == word;
  }
  [[nodiscard]] bool take(std::string_view sign) {
    const bool there = is(sign);
    next_ += there ? 1 : 0;
    return there;
  }
  void take_words(std::string_view words) {
    while (!words.empty()) {
      const std::string_view word = words.substr(0, words.find(' '));
      if (!is_word(word)) {
        expected(fmt::format("'{}'", words));
      }
      ++next_;
      words.remove_prefix(std::min(words.size(), word.size() + 1));
    }
  }
  void close(std::string_view sign) {
    if (!take(sign)) {
      expected(fmt::format("'{}'", sign));
    }
  }
  void at_end() const {
    if (here().kind != Kind::end) {
      expected("the end of the statement");
    }
  }

  [[nodiscard]] std::optional<Relation> relation_here() {
    static const std::map<std::string, Relation, std::less<>> known{
        {"=", Relation::equal},   {"!=", Relation::not_equal},     {"<", Relation::less},
        {">", Relation::greater}, {"<=", Relation::less_or_equal}, {">=", Relation::greater_or_equal}};
    const auto found = here().kind == Kind::sign ? known.find(here().text) : known.end();
    if (found == known.end()) {
      return std::nullopt;
    }
    ++next_;
    return found->second;
  }

  // ", a < t < b" and "for almost all a < t < b".
  void times(Relations& result) {
    if (is_word("for")) {
      ++next_;
      if (is_word("almost")) {
        take_words("almost all");
        result.almost = true;
      }
    } else if (!take(",")) {
      return;
    }
    Node from = expression();
    close("<");
    take_words("t");
    close("<");
    result.times = {std::move(from), expression()};
    if (is_word("but")) {
      take_words("but for finitely many t");
      result.almost = true;
    }
    if (take(",")) {
      take_words("continuous on");
      close("[");
      Node first = expression();
      close(",");
      result.continuous = {std::move(first), expression()};
      close("]");
    }
  }

  [[nodiscard]] Node expression() {
    if (++depth_ > deepest) {
      fail(here().at, fmt::format("brackets stand in one another at most {} deep", deepest));
    }
    Node result = signed_product();
    if (is("+") || is("-")) {
      result = {Op::sum, result.at, {}, 0, {std::move(result)}};
    }
    while (is("+") || is("-")) {
      const std::size_t at = here().at;
      const bool minus = is("-");
      ++next_;
      Node summand = product();
      result.parts.push_back(minus ? Node{Op::negate, at, {}, 0, {std::move(summand)}} : std::move(summand));
    }
    --depth_;
    return result;
  }

  [[nodiscard]] Node signed_product() {
    const std::size_t at = here().at;
    if (!take("-")) {
      return product();
    }
    const std::size_t closing = closing_bracket();
    Node result = product();
    const bool is_bracketed = closing != 0 && next_ == closing + 1;  // -(a b), the negative of a product
    Node& negative = result.op == Op::product && !is_bracketed ? result.parts.front() : result;
    negative = {Op::negate, at, {}, 0, {std::move(negative)}};
    return result;
  }

  // Where the bracket that opens here closes, among the tokens; 0 if none does.
  [[nodiscard]] std::size_t closing_bracket() const {
    int depth = 0;
    for (std::size_t k = next_; k < tokens_.size() && (depth > 0 || k == next_); ++k) {
      depth += tokens_[k].text == "(" ? 1 : tokens_[k].text == ")" ? -1 : 0;
      if (depth == 0) {
        return k == next_ ? 0 : k;
      }
    }
    return 0;
  }

  [[nodiscard]] bool begins_factor() const {
    static constexpr std::array<std::string_view, 4> opening{"(", "[", "d/dt[", "d^2/dt^2["};
    return (here().kind == Kind::name && !is_word("for") && !is_word("but")) ||
           (here().kind == Kind::sign && std::ranges::find(opening, here().text) != opening.end());
  }

  [[nodiscard]] Node product() {
    Node result = factor();
    bool after_fraction = false;
    for (int fractions = 0;;) {
      const std::size_t at = here().at;
      const bool star = take("*");
      if (!star && take("/")) {
        if (++fractions > deepest) {
          fail(at, fmt::format("at most {} fractions one after the other", deepest));
        }
        result = {Op::quotient, result.at, {}, 0, {std::move(result), factor()}};
        after_fraction = true;
      } else if (star || begins_factor()) {
        if (!star && after_fraction) {
          fail(at, "a product after a fraction: write a/b*c or a/(b c)");
        }
        append_factor(result, factor());
        after_fraction = after_fraction && !star;
      } else {
        if (here().kind == Kind::number) {
          fail(at, "a number after a factor: write the number first, or '*' between");
        }
        return result;
      }
    }
  }

  // A product in brackets with a minus sign in front is the negative of one: it is no part of that around it.
  [[nodiscard]] static Node negative_as_a_whole(Node node) {
    if (node.op != Op::product || node.parts.front().op != Op::negate) {
      return node;
    }
    node.parts.front() = Node(node.parts.front().parts.front());
    return {Op::negate, node.at, {}, 0, {std::move(node)}};
  }

  // Products are written without brackets.
  static void append_factor(Node& product, Node factor) {
    if (product.op != Op::product) {
      product = {Op::product, product.at, {}, 0, {std::move(product)}};
    }
    if (factor.op != Op::product) {
      product.parts.push_back(std::move(factor));
      return;
    }
    std::ranges::move(factor.parts, std::back_inserter(product.parts));
  }

  // The exponent after "^"; nothing where there is none.
  [[nodiscard]] std::optional<long> exponent() {
    if (!take("^")) {
      return std::nullopt;
    }
    const bool minus = take("-");
    const std::size_t at = here().at;
    const std::string digits = here().text;
    if (here().kind != Kind::number || digits.find('.') != std::string::npos) {
      expected("a whole number as exponent");
    }
    ++next_;
    if (digits.size() > 4 || std::stol(digits) > greatest_exponent) {
      fail(at, fmt::format("an exponent is at most {}", greatest_exponent));
    }
    return minus ? -std::stol(digits) : std::stol(digits);
  }

  [[nodiscard]] static Node raised(Node base, std::optional<long> exponent) {
    if (!exponent) {
      return base;
    }
    return {Op::power, base.at, {}, Rational(*exponent), {std::move(base)}};
  }

  [[nodiscard]] Node factor() {
    Node base = primary();
    Node result = raised(std::move(base), exponent());
    if (is("^")) {
      expected("one exponent: write (a^b)^c");
    }
    return result;
  }

  [[nodiscard]] Node primary() {
    const Token token = here();
    if (token.kind == Kind::number) {
      ++next_;
      return {Op::number, token.at, {}, parse_decimal(token.text).value, {}};
    }
    if (token.kind == Kind::name) {
      return named();
    }
    if (take("(")) {
      Node result = expression();
      close(")");
      return negative_as_a_whole(std::move(result));
    }
    if (take("|")) {
      Node inside = expression();
      close("|");
      return {Op::function, token.at, "abs", 0, {std::move(inside)}};
    }
    if (take("[")) {
      return blocks(token.at);
    }
    const bool twice = is("d^2/dt^2[");
    if (take("d/dt[") || take("d^2/dt^2[")) {
      Node inside = expression();
      close("]");
      return rate(rate({std::move(inside)}, token.at, 1), token.at, twice ? 1 : 0);
    }
    expected("a number, a symbol, a function or a bracket");
  }

  [[nodiscard]] static Node rate(Node of, std::size_t at, int times) {
    return times == 0 ? of : rate({Op::derivative, at, {}, 0, {std::move(of)}}, at, times - 1);
  }

  [[nodiscard]] Node blocks(std::size_t at) {
    Node result{Op::block, at, {}, 1, {}};
    std::size_t in_row = 0, per_row = 0;
    while (true) {
      result.parts.push_back(expression());
      ++in_row;
      if (take(",")) {
        continue;
      }
      if (per_row != 0 && in_row != per_row) {
        fail(here().at, fmt::format("a row of {}, and the first row has {}", in_row, per_row));
      }
      per_row = std::exchange(in_row, 0);
      if (!take(";")) {
        close("]");
        return result;
      }
      result.number += 1;
    }
  }

  // The name as the paper's table has it: omega_1 for omega1, where omega_1 is no other name.
  template <class Map>
  [[nodiscard]] std::optional<std::string> known(const Map& map, std::string name) const {
    if (!names_.has(name)) {
      std::erase(name, '_');
    }
    return map.contains(name) ? std::optional(name) : std::nullopt;
  }

  // Whether "(" follows, after primes and an exponent; at once, if the name is also one of a quantity.
  [[nodiscard]] bool is_applied(bool at_once) const {
    std::size_t k = next_ + 1;
    const auto is_sign = [&](std::string_view sign) {
      return tokens_[k].kind == Kind::sign && tokens_[k].text == sign;
    };
    while (is_sign("'")) {
      ++k;
    }
    if (is_sign("^")) {
      ++k;
      k += is_sign("-") ? 1 : 0;
      k += tokens_[k].kind == Kind::number ? 1 : 0;
    }
    return is_sign("(") && !(at_once && tokens_[k].apart);
  }

  [[nodiscard]] Node named() {
    const Token token = here();
    if (token.text == "det") {
      return {Op::determinant, token.at, {}, 0, {bracketed()}};
    }
    if (const auto abbreviation = known(names_.abbreviations, token.text)) {
      return abbreviated(*abbreviation);
    }
    const auto quantity = known(names_.quantities, token.text);
    const auto function = known(names_.functions, token.text);
    if (function && is_applied(quantity.has_value())) {
      return application(*function);
    }
    if (quantity || token.text == "I") {
      ++next_;
      if (is("'")) {
        fail(here().at, fmt::format("a prime is the rate of a function of time, and {} is none", token.text));
      }
      return {Op::symbol, token.at, quantity.value_or("I"), 0, {}};
    }
    if (function) {
      fail(token.at, fmt::format("{0} is a function: write {0}(t)", token.text));
    }
    if (token.text == "abs" && is_applied(false)) {  // as |…|
      return {Op::function, token.at, "abs", 0, {bracketed()}};
    }
    const std::string own =
        names_.own_by.empty() ? ""
                              : fmt::format("; one of your own is named by {}{}", names_.own_by, token.text);
    fail(token.at, fmt::format("no symbol '{}'{}{}", token.text, names_like(token.text, names_), own));
  }

  // A name, then a term in brackets.
  [[nodiscard]] Node bracketed() {
    ++next_;
    close("(");
    Node inside = expression();
    close(")");
    return inside;
  }

  [[nodiscard]] Node abbreviated(const std::string& name) {
    const std::size_t at = here().at;
    const Abbreviation& abbreviation = names_.abbreviations.find(name)->second;
    const std::size_t count = abbreviation.parameters.size();
    ++next_;
    Node result{count == 0 ? Op::symbol : Op::function, at, name, 0, {}, &abbreviation};
    if (count == 0) {
      return result;
    }
    if (!take("(")) {
      fail(at, fmt::format("{} takes {} in brackets", name, count == 1 ? "an argument" : "arguments"));
    }
    do {
      result.parts.push_back(expression());
    } while (take(","));
    close(")");
    if (result.parts.size() != count) {
      fail(at, fmt::format("{} takes {} arguments, and here are {}", name, count, result.parts.size()));
    }
    return result;
  }

  [[nodiscard]] Node application(const std::string& name) {
    const std::size_t at = here().at;
    ++next_;
    int primes = 0;
    while (take("'")) {
      ++primes;
    }
    const std::optional<long> raised_to = exponent();
    close("(");
    const std::size_t argument_at = here().at;
    Node argument = expression();
    close(")");
    if (primes > 2) {
      fail(at, "at most two primes");
    }
    if (raised_to.value_or(0) < 0 && is_elementary(name)) {
      fail(at, fmt::format("{0}^-1 may mean two things: write 1/{0}(t)", name));
    }
    if (primes > 0 && !(argument.op == Op::symbol && argument.name == "t")) {
      fail(argument_at, fmt::format("a prime is a rate in t: write {}'(t), or d/dt[...]", name));
    }
    return raised(rate({Op::function, at, name, 0, {std::move(argument)}}, at, primes), raised_to);
  }

  std::string_view line_;
  const Names& names_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  int depth_ = 0;
};

}  // namespace

Relations relations_in(std::string_view line, const Names& names) {
  return Parser(line, names).relations();
}

Node expression_in(std::string_view line, const Names& names) {
  return Parser(line, names).whole_expression();
}

}  // namespace stickslip::proofs::symbols::parsing
