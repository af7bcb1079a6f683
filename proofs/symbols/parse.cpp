#include "proofs/symbols/parse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/decimal.hpp"

namespace stickslip::proofs::symbols {
namespace {

// What nobody writes, and what would end in no time or no stack.
constexpr std::size_t longest_line = 20000, longest_number = 1000;
constexpr int deepest = 200, greatest_exponent = 200, greatest_exponent_of_matrix = 50;

// What may be typed for plain names and signs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 46> typed{{
    {"−", "-"},       {"·", "*"},     {"⋅", "*"},      {"×", "*"},      {"≤", "<="},    {"≥", ">="},
    {"≠", "!="},      {"²", "^2"},    {"³", "^3"},     {"′", "'"},      {"″", "''"},    {"₀", "0"},
    {"₁", "1"},       {"₂", "2"},     {"₃", "3"},      {"₄", "4"},      {"₅", "5"},     {"π", "pi"},
    {"χ", "chi"},     {"η", "eta"},   {"ω", "omega"},  {"τ", "tau"},    {"φ", "phi"},   {"ϕ", "phi"},
    {"ψ", "psi"},     {"ξ", "xi"},    {"λ", "lambda"}, {"ρ", "rho"},    {"δ", "delta"}, {"ε", "epsilon"},
    {"ϵ", "epsilon"}, {"γ", "gamma"}, {"α", "alpha"},  {"β", "beta"},   {"μ", "mu"},    {"θ", "theta"},
    {"Θ", "Theta"},   {"Γ", "Gamma"}, {"Λ", "Lambda"}, {"Σ", "Sigma"},  {"Δ", "Delta"}, {"Φ", "Phi"},
    {"Ψ", "Psi"},     {"Ω", "Omega"}, {"Ξ", "Xi"},     {"\u00a0", " "},
}};

enum class Kind { number, name, sign, end };

struct Token {
  Kind kind = Kind::end;
  std::string text = {};
  std::size_t at = 0;  // in the line
  bool apart = true;   // a blank or nothing stands before it
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// The line in plain characters, with the place in the line of each.
struct Plain {
  std::string text;
  std::vector<std::size_t> places;

  explicit Plain(std::string_view line) {
    if (line.size() > longest_line) {
      throw ParseError(line.substr(0, 60), 0, fmt::format("a line has at most {} characters", longest_line));
    }
    for (std::size_t i = 0; i < line.size();) {
      const auto other =
          std::ranges::find_if(typed, [&](const auto& one) { return line.substr(i).starts_with(one.first); });
      const std::string_view plain = other == typed.end() ? line.substr(i, 1) : other->second;
      text += plain;
      places.insert(places.end(), plain.size(), i);
      i += other == typed.end() ? 1 : other->first.size();
    }
    places.push_back(line.size());
  }
};

std::vector<Token> tokens_of(std::string_view line) {
  static constexpr std::array<std::string_view, 6> long_signs{"!=", "<=", ">=", "''", "d/dt[", "d^2/dt^2["};
  static constexpr std::string_view short_signs = "+-*/^()[]|,;=<>'";
  const Plain plain(line);
  std::vector<Token> tokens;
  std::size_t i = 0;
  bool apart = true;
  const auto take = [&](Kind kind, std::size_t length) {
    tokens.push_back({kind, plain.text.substr(i, length), plain.places[i], apart});
    i += length;
    apart = false;
  };
  while (i < plain.text.size()) {
    const std::string_view rest = std::string_view(plain.text).substr(i);
    const auto length = [&](auto belongs) {
      return static_cast<std::size_t>(std::ranges::find_if_not(rest, belongs) - rest.begin());
    };
    const auto sign = std::ranges::find_if(long_signs, [&](auto one) { return rest.starts_with(one); });
    if (is_blank(rest.front())) {
      apart = true;
      ++i;
    } else if (sign != long_signs.end() && *sign != "''") {
      take(Kind::sign, sign->size());
    } else if (is_digit(rest.front())) {
      const std::size_t whole = length(is_digit);
      const bool point = whole + 1 < rest.size() && rest[whole] == '.' && is_digit(rest[whole + 1]);
      const std::size_t digits =
          !point ? whole
                 : whole + 1 +
                       static_cast<std::size_t>(std::ranges::find_if_not(rest.substr(whole + 1), is_digit) -
                                                rest.substr(whole + 1).begin());
      if (digits > longest_number) {
        throw ParseError(line, plain.places[i],
                         fmt::format("a number has at most {} digits", longest_number));
      }
      take(Kind::number, digits);
    } else if (is_letter(rest.front())) {
      take(Kind::name, length([](char c) { return is_letter(c) || is_digit(c) || c == '_'; }));
    } else if (short_signs.find(rest.front()) != std::string_view::npos) {
      take(Kind::sign, 1);
    } else {
      throw ParseError(line, plain.places[i], "a character that is no part of a formula");
    }
  }
  tokens.push_back({Kind::end, {}, line.size(), true});
  return tokens;
}

// What is read before sizes are known.
struct Node {
  Op op = Op::number;
  std::size_t at = 0;
  std::string name = {};
  Rational number = 0;  // as that of a Term
  std::vector<Node> parts = {};
  const Abbreviation * abbreviation = nullptr;  // of a symbol or function
};

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

// Lines to trees whose sizes are not known yet.
class Parser {
 public:
  Parser(std::string_view line, const Names& names) : line_(line), names_(names), tokens_(tokens_of(line)) {}

  struct Relations {
    std::vector<Node> sides;
    std::vector<Relation> between;
    std::optional<std::pair<Node, Node>> times;
    bool almost = false;
  };

  [[nodiscard]] Relations relations() {
    Relations result{{expression()}, {}, {}, false};
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
    if (is(",")) {
      continuity();
    }
  }

  // What is differentiated is continuous, whether that is written or not.
  void continuity() {
    close(",");
    take_words("continuous on");
    close("[");
    (void)expression();
    close(",");
    (void)expression();
    close("]");
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
    Node result = product();
    Node& negative = result.op == Op::product ? result.parts.front() : result;
    negative = {Op::negate, at, {}, 0, {std::move(negative)}};
    return result;
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
    if (here().kind != Kind::number || !std::ranges::all_of(digits, is_digit)) {
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

  // The name as the paper's table has it: omega_1 for omega1.
  template <class Map>
  [[nodiscard]] static std::optional<std::string> known(const Map& map, std::string name) {
    if (!map.contains(name)) {
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
      ++next_;
      close("(");
      Node inside = expression();
      close(")");
      return {Op::determinant, token.at, {}, 0, {std::move(inside)}};
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
    fail(token.at, fmt::format("no symbol '{}'{}", token.text, names_like(token.text, names_)));
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

std::string sizes(const Shape& shape) {
  return shape.is_scalar()    ? "a number"
         : shape.columns == 1 ? fmt::format("a column of {}", shape.rows)
                              : fmt::format("a {} x {} matrix", shape.rows, shape.columns);
}

// A size that may not be known: 0 rows or columns are not.
struct Size {
  int rows = 0, columns = 0;
  [[nodiscard]] bool known() const { return rows > 0 && columns > 0; }
  [[nodiscard]] bool is_scalar() const { return rows == 1 && columns == 1; }
  void learn(const Size& other) {
    rows = rows > 0 ? rows : other.rows;
    columns = columns > 0 ? columns : other.columns;
  }
};

constexpr Size scalar_size{1, 1};

// Trees to terms: 0, I and what stands about them take the sizes that fit.
class Shaper {
 public:
  Shaper(std::string_view line, const Names& names) : line_(line), names_(names) {}

  [[nodiscard]] std::pair<Term, Term> sides(const Node& left, const Node& right) const {
    Size size = size_of(left);
    size.learn(size_of(right, size));
    size.learn(size_of(left, size));
    const Term a = made(left, size), b = made(right, size);
    require_same(right, b, a);
    return {a, b};
  }

  [[nodiscard]] Term scalar(const Node& node) const {
    Term term = made(node, scalar_size);
    if (!term.shape().is_scalar()) {
      fail(node.at, fmt::format("{}, where a number belongs", sizes(term.shape())));
    }
    return term;
  }

  // Of that size, where it leaves that open.
  [[nodiscard]] Term made(const Node& node, const Size& wanted) const {
    if (node.abbreviation != nullptr) {
      Replacements arguments;
      for (std::size_t k = 0; k < node.parts.size(); ++k) {
        arguments.emplace(node.abbreviation->parameters[k], scalar(node.parts[k]));
      }
      return substitute(node.abbreviation->means, arguments);
    }
    switch (node.op) {
      case Op::number:
        return Term(node.number);
      case Op::symbol:
        return symbol(node, wanted);
      case Op::function: {
        const Shape shape = node.name == "abs" ? Shape{} : names_.functions.find(node.name)->second;
        return Function{node.name, shape}(scalar(node.parts[0]));
      }
      case Op::sum:
        return sum_made(node, wanted);
      case Op::product:
        return product_made(node, wanted);
      case Op::quotient:
        return sized(node.parts[0], wanted) / scalar(node.parts[1]);
      case Op::power: {
        const Term base = sized(node.parts[0], wanted);
        require_square(node, base);
        if (!base.shape().is_scalar() && abs(node.number) > greatest_exponent_of_matrix) {
          fail(node.at, fmt::format("the exponent of a matrix is at most {}", greatest_exponent_of_matrix));
        }
        return power(base, static_cast<int>(node.number.get_num().get_si()));
      }
      case Op::negate:
        return -sized(node.parts[0], wanted);
      case Op::derivative:
        return derivative(sized(node.parts[0], wanted));
      case Op::block:
        return block_made(node, wanted);
      case Op::determinant: {
        const Term inside = made(node.parts[0], {});
        require_square(node, inside);
        return determinant(inside);
      }
    }
    fail(node.at, "a formula of unknown kind");
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& what) const { throw ParseError(line_, at, what); }

  // A part of a formula: a 0 has the size that is wanted there.
  [[nodiscard]] Term sized(const Node& part, const Size& wanted) const {
    const bool is_zero = part.op == Op::number && part.number == 0;
    return is_zero && wanted.known() ? zero(wanted.rows, wanted.columns) : made(part, wanted);
  }

  void require_same(const Node& node, const Term& term, const Term& other) const {
    if (term.shape() != other.shape() && !term.is_zero() && !other.is_zero()) {
      fail(node.at, fmt::format("this is {}, and what it stands with is {}", sizes(term.shape()),
                                sizes(other.shape())));
    }
  }
  void require_square(const Node& node, const Term& term) const {
    if (term.shape().rows != term.shape().columns) {
      fail(node.at, fmt::format("this is {}, and only square matrices have powers and determinants",
                                sizes(term.shape())));
    }
  }

  // As far as it is known: of it alone, or with what is known of its place.
  [[nodiscard]] Size size_of(const Node& node, Size wanted = {}) const {
    if (node.abbreviation != nullptr) {
      const Shape shape = node.abbreviation->means.shape();
      return {shape.rows, shape.columns};
    }
    switch (node.op) {
      case Op::number:
        return node.number == 0 ? wanted : scalar_size;
      case Op::symbol: {
        const auto found = names_.quantities.find(node.name);
        return found == names_.quantities.end() ? square(wanted)
                                                : Size{found->second.rows, found->second.columns};
      }
      case Op::function: {
        const auto found = names_.functions.find(node.name);
        return found == names_.functions.end() ? scalar_size
                                               : Size{found->second.rows, found->second.columns};
      }
      case Op::sum: {
        Size size;
        for (const Node& part : node.parts) {
          size.learn(size_of(part));
        }
        size.learn(wanted);
        return size;
      }
      case Op::product: {
        const std::vector<Size> factors = chain(node, wanted);
        Size size = scalar_size;
        bool first = true;
        for (const Size& factor : factors) {
          if (!factor.is_scalar()) {
            size = first ? factor : Size{size.rows, factor.columns};
            first = false;
          }
        }
        return size;
      }
      case Op::power:
        return square(size_of(node.parts[0], square(wanted)));
      case Op::quotient:
      case Op::negate:
      case Op::derivative:
        return size_of(node.parts[0], wanted);
      case Op::block: {
        const Grid grid = grid_of(node, wanted);
        const auto total = [](const std::vector<int>& all) {
          return std::ranges::find(all, 0) != all.end() ? 0 : std::accumulate(all.begin(), all.end(), 0);
        };
        return {total(grid.heights), total(grid.widths)};
      }
      case Op::determinant:
        return scalar_size;
    }
    return {};
  }

  [[nodiscard]] static Size square(Size size) {
    size.learn({size.columns, size.rows});
    return size;
  }

  // Of each factor, as far as the others and the place of the product say. A 0 that may be a number is one.
  [[nodiscard]] std::vector<Size> chain(const Node& node, const Size& wanted) const {
    std::vector<Size> sizes;
    std::vector<std::size_t> big;  // the factors that are no numbers
    for (const Node& part : node.parts) {
      sizes.push_back(size_of(part));
      if (!sizes.back().is_scalar()) {
        big.push_back(sizes.size() - 1);
      }
    }
    if (big.empty()) {
      return sizes;
    }
    sizes[big.front()].learn({wanted.rows, 0});
    sizes[big.back()].learn({0, wanted.columns});
    const auto look = [&](std::size_t k) { sizes[k] = size_of(node.parts[k], sizes[k]); };
    for (std::size_t k = 0; k < big.size(); ++k) {
      if (k > 0) {
        sizes[big[k]].learn({sizes[big[k - 1]].columns, 0});
      }
      look(big[k]);
    }
    for (std::size_t k = big.size(); k-- > 0;) {
      if (k + 1 < big.size()) {
        sizes[big[k]].learn({0, sizes[big[k + 1]].rows});
      }
      look(big[k]);
    }
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (node.parts[k].op == Op::number && !sizes[k].known()) {
        sizes[k] = scalar_size;
      }
    }
    return sizes;
  }

  struct Grid {
    std::size_t per_row = 1;
    std::vector<int> heights, widths;  // 0 for what is not known
  };

  [[nodiscard]] Grid grid_of(const Node& node, const Size& wanted) const {
    const auto rows = static_cast<std::size_t>(node.number.get_num().get_si());
    Grid grid{node.parts.size() / rows, std::vector<int>(rows, 0), {}};
    grid.widths.assign(grid.per_row, 0);
    const auto look = [&] {
      for (std::size_t again = 0; again < 2; ++again) {
        for (std::size_t k = 0; k < node.parts.size(); ++k) {
          int &height = grid.heights[k / grid.per_row], &width = grid.widths[k % grid.per_row];
          Size size{height, width};
          size.learn(size_of(node.parts[k], size));
          height = size.rows;
          width = size.columns;
        }
      }
    };
    look();
    share(grid.widths, wanted.columns);
    look();
    share(grid.heights, wanted.rows);
    look();
    return grid;
  }

  // What is left of the whole, if that is known, shared evenly among those not known.
  static void share(std::vector<int>& all, int whole) {
    const auto open = static_cast<int>(std::ranges::count(all, 0));
    const int left = whole - std::accumulate(all.begin(), all.end(), 0);
    if (open > 0 && left > 0 && left % open == 0) {
      std::ranges::replace(all, 0, left / open);
    }
  }

  [[nodiscard]] Term symbol(const Node& node, const Size& wanted) const {
    if (node.name != "I" || names_.quantities.contains("I")) {
      const Shape shape = names_.quantities.find(node.name)->second;
      return Term(Term::Node{Op::symbol, shape, node.name, 0, {}});
    }
    if (!wanted.known()) {
      fail(node.at, "nothing says how large this I is");
    }
    if (wanted.rows != wanted.columns || wanted.is_scalar()) {
      fail(node.at, fmt::format("I stands where {} belongs", sizes({wanted.rows, wanted.columns})));
    }
    return identity(wanted.rows);
  }

  [[nodiscard]] Term sum_made(const Node& node, const Size& wanted) const {
    Size size = size_of(node, wanted);
    for (const Node& part : node.parts) {  // what is known in part has made up its mind
      const Size known = size_of(part);
      if (!size.known() && (known.rows > 0 || known.columns > 0)) {
        const Shape shape = made(part, size).shape();
        size = {shape.rows, shape.columns};
      }
    }
    std::optional<Term> sum;
    for (const Node& part : node.parts) {
      const Term term = sized(part, size);
      if (sum) {
        require_same(part, term, *sum);
      }
      sum = sum ? *sum + term : term;
    }
    return *sum;
  }

  [[nodiscard]] Term product_made(const Node& node, const Size& wanted) const {
    const std::vector<Size> sizes_of_factors = chain(node, wanted);
    std::optional<Term> product;
    for (std::size_t k = 0; k < node.parts.size(); ++k) {
      const Size& size = sizes_of_factors[k];
      const Term factor = sized(node.parts[k], size);
      const Shape right = factor.shape(), left = product ? product->shape() : Shape{};
      if (!left.is_scalar() && !right.is_scalar() && left.columns != right.rows) {
        fail(node.parts[k].at,
             fmt::format("this is {}, and is multiplied by {} from the left", sizes(right), sizes(left)));
      }
      product = product ? *product * factor : factor;
    }
    return *product;
  }

  [[nodiscard]] Term block_made(const Node& node, const Size& wanted) const {
    Grid grid = grid_of(node, wanted);
    std::ranges::replace(grid.heights, 0, 1);
    std::ranges::replace(grid.widths, 0, 1);
    std::vector<Term> blocks;
    for (std::size_t k = 0; k < node.parts.size(); ++k) {
      const Size size{grid.heights[k / grid.per_row], grid.widths[k % grid.per_row]};
      Term one = sized(node.parts[k], size);
      if (one.shape() != Shape{size.rows, size.columns}) {
        fail(node.parts[k].at, fmt::format("this is {}, and its row and column of blocks ask for {}",
                                           sizes(one.shape()), sizes({size.rows, size.columns})));
      }
      blocks.push_back(std::move(one));
    }
    return block(static_cast<int>(grid.heights.size()), std::move(blocks));
  }

  std::string_view line_;
  const Names& names_;
};

}  // namespace

namespace {

// Characters before that place.
std::size_t characters(std::string_view line, std::size_t at) {
  return static_cast<std::size_t>(std::ranges::count_if(
      line.substr(0, at), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The line about that place, with a caret below it.
std::string pointing(std::string_view line, std::size_t at) {
  constexpr std::size_t before = 60, after = 20;
  const auto is_inside = [&](std::size_t k) {
    return k < line.size() && (static_cast<unsigned char>(line[k]) & 0xC0U) == 0x80U;
  };
  std::size_t begin = at > before ? at - before : 0, end = std::min(line.size(), at + after);
  while (is_inside(begin)) {
    ++begin;
  }
  while (is_inside(end)) {
    ++end;
  }
  const std::string cut = begin > 0 ? "…" : "";
  return fmt::format("  {}{}{}\n  {:>{}}", cut, line.substr(begin, end - begin), end < line.size() ? "…" : "",
                     "^", characters(line.substr(begin), at - begin) + 1 + (begin > 0 ? 1 : 0));
}

}  // namespace

ParseError::ParseError(std::string_view line, std::size_t at, const std::string& what)
    : UsageError(fmt::format("column {}: {}", characters(line, at) + 1, what)),
      excerpt_(pointing(line, at)) {}

ParseError ParseError::in(const std::string& place) const {
  return {fmt::format("{}: {}", place, what()), excerpt_};
}

bool Names::has(const std::string& name) const {
  return quantities.contains(name) || functions.contains(name) || abbreviations.contains(name);
}

Names names_of(const Symbols& table) {
  Names names;
  for (const Symbol& symbol : table) {
    if (symbol.name == "I" || symbol.name == "abs") {
      continue;
    }
    auto& map = symbol.of_time ? names.functions : names.quantities;
    if (!map.emplace(symbol.name, symbol.shape).second) {
      throw InternalError("two symbols are written " + symbol.name);
    }
  }
  return names;
}

std::vector<Statement> parse_statements(std::string_view line, const Names& names) {
  const Parser::Relations read = Parser(line, names).relations();
  const Shaper shaper(line, names);
  std::optional<Times> times;
  if (read.times) {
    times = Times{shaper.scalar(read.times->first), shaper.scalar(read.times->second), read.almost};
  }
  std::vector<Statement> statements;
  for (std::size_t i = 0; i < read.between.size(); ++i) {
    const auto [left, right] = shaper.sides(read.sides[i], read.sides[i + 1]);
    statements.push_back({left, right, read.between[i], times});
  }
  return statements;
}

Term parse_term(std::string_view line, const Names& names) {
  return Shaper(line, names).made(Parser(line, names).whole_expression(), {});
}

}  // namespace stickslip::proofs::symbols
