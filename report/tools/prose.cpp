#include "report/tools/prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "report/tools/escape.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::report::tools {
namespace {

enum class Sort { symbol, function, number, sign, open, close, bar, comma, space, words };

struct Token {
  Sort sort;
  std::string_view text;
};

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_alphanumeric(char c) {
  return is_digit(c) || is_letter(c);
}

// Whether the character after a letter or digit goes on with a name, as in z_B, first-order, model's.
bool joins(char before, char c, char after) {
  return (c == '_' && is_alphanumeric(after)) ||
         ((c == '-' || c == '\'') && is_letter(before) && is_letter(after));
}

std::size_t length_of_name(std::string_view text) {
  std::size_t end = 1;
  while (end < text.size() && (is_alphanumeric(text[end]) ||
                               (end + 1 < text.size() && joins(text[end - 1], text[end], text[end + 1])))) {
    ++end;
  }
  return end;
}

std::size_t length_of_number(std::string_view text) {
  std::size_t end = 0;
  const auto digits = [&] {
    while (end < text.size() && is_digit(text[end])) {
      ++end;
    }
  };
  digits();
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) {
    ++end;
    digits();
  }
  if (end + 1 < text.size() && text[end] == '.' && is_letter(text[end + 1])) {
    return 0;  // 63.P is the number of a statement
  }
  const std::size_t sign = end + 1 < text.size() && text[end + 1] == '-' ? 2 : 1;
  if (end + sign < text.size() && text[end] == 'e' && is_digit(text[end + sign])) {
    end += sign;
    digits();
  }
  return end;
}

// As symbolic/typeset/names.hpp reads it: z2B is z with the index 2B.
std::string plain_name(std::string_view name) {
  const bool indexed = name.size() == 3 && is_digit(name[1]) && is_letter(name[2]);
  return indexed ? fmt::format("{}_{}", name.substr(0, 1), name.substr(1)) : std::string(name);
}

bool is_accent(std::string_view latex) {
  return latex.starts_with("\\hat") || latex.starts_with("\\bar") || latex.starts_with("\\dot") ||
         latex.starts_with("\\ddot") || latex.starts_with("\\tilde");
}

// Short names can be words; of those with two Latin letters only the two frictions are symbols.
bool is_symbol(std::string_view name) {
  const std::string latex = symbolic::typeset::latex_name(plain_name(name));
  if (name.size() == 1 || name == "us" || name == "ur") {
    return name != "a" && name != "A";
  }
  const bool indexed = name.find('_') != std::string_view::npos || std::ranges::any_of(name, is_digit);
  const bool greek = latex.front() == '\\' && !is_accent(latex);
  const bool capital_index = std::isupper(static_cast<unsigned char>(name.back())) != 0;
  return !latex.starts_with("\\mathrm") &&
         (indexed ? name.front() != 'A' : greek && (capital_index || latex.find('_') == std::string::npos));
}

constexpr std::array functions = {"sin", "cos", "det", "exp"};

using Sign = std::pair<std::string_view, std::string_view>;
constexpr std::array signs = {Sign{"<=", "\\le"}, Sign{">=", "\\ge"},  Sign{"!=", "\\ne"}, Sign{"±", "\\pm"},
                              Sign{"=", "="},     Sign{"<", "<"},      Sign{">", ">"},     Sign{"+", "+"},
                              Sign{"-", "-"},     Sign{"*", "\\cdot"}, Sign{"/", "/"},     Sign{"^", "^"}};

Token next_token(std::string_view text) {
  const char c = text.front();
  if (is_letter(c)) {
    const std::size_t end = length_of_name(text);
    const std::string_view name = text.substr(0, end);
    if (std::ranges::find(functions, name) != functions.end()) {
      return {Sort::function, name};
    }
    const bool listed = name == "a" && text.size() > 1 && (text[1] == ',' || text[1] == ')');
    if (!is_symbol(name) && !listed) {
      return {Sort::words, name};
    }
    const std::size_t after = std::min(text.find_first_not_of('\'', end), text.size());
    return {Sort::symbol, text.substr(0, after)};
  }
  if (is_digit(c)) {
    const std::size_t length = length_of_number(text);
    return length > 0 ? Token{Sort::number, text.substr(0, length)}
                      : Token{Sort::words, text.substr(0, text.find_first_of(" ,;:)"))};
  }
  for (const auto& [plain, latex] : signs) {
    if (text.starts_with(plain)) {
      return {Sort::sign, text.substr(0, plain.size())};
    }
  }
  const std::string_view one = text.substr(0, 1);
  switch (c) {
    case '(':
    case '[':
    case '{':
      return {Sort::open, one};
    case ')':
    case ']':
    case '}':
      return {Sort::close, one};
    case '|':
      return {Sort::bar, one};
    case ',':
      return {Sort::comma, one};
    case ' ':
      return {Sort::space, one};
    default:
      return {Sort::words, one};
  }
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  while (!text.empty()) {
    tokens.push_back(next_token(text));
    text.remove_prefix(tokens.back().text.size());
  }
  return tokens;
}

using Tokens = std::vector<Token>;

bool has(const Tokens& tokens, std::size_t begin, std::size_t end, Sort sort) {
  return std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                     tokens.begin() + static_cast<std::ptrdiff_t>(end),
                     [sort](const Token& token) { return token.sort == sort; });
}

// Beyond the bracket that closes the one at `open`, if nothing but a formula stands between them.
std::optional<std::size_t> end_of_group(const Tokens& tokens, std::size_t open) {
  std::size_t depth = 0;
  for (std::size_t i = open; i < tokens.size() && tokens[i].sort != Sort::words; ++i) {
    depth += tokens[i].sort == Sort::open ? 1 : 0;
    depth -= tokens[i].sort == Sort::close ? 1 : 0;
    if (depth == 0) {
      return i + 1;
    }
  }
  return std::nullopt;
}

// Beyond the formula that begins at `begin`; `begin` if none does.
std::size_t end_of_run(const Tokens& tokens, std::size_t begin) {
  std::size_t i = begin;
  std::size_t end = begin;  // beyond the last token that a formula can end with
  while (i < tokens.size()) {
    const Sort sort = tokens[i].sort;
    if (sort == Sort::open) {
      const std::optional<std::size_t> beyond = end_of_group(tokens, i);
      const bool argument = i > begin && tokens[i - 1].sort != Sort::space;
      const bool misplaced = tokens[i].text == "{" && !(i > begin && tokens[i - 1].text == "^");
      if (!beyond || misplaced || (!argument && !has(tokens, i, *beyond, Sort::symbol))) {
        break;
      }
      i = end = *beyond;
    } else if (sort == Sort::close || sort == Sort::comma || sort == Sort::words) {
      break;
    } else {
      ++i;
      if (sort == Sort::symbol || sort == Sort::number || sort == Sort::bar) {
        end = i;
      }
    }
  }
  return end;
}

bool is_formula(const Tokens& tokens, std::size_t begin, std::size_t end) {
  if (begin == end) {
    return false;
  }
  const std::size_t numbers = static_cast<std::size_t>(std::count_if(
      tokens.begin() + static_cast<std::ptrdiff_t>(begin), tokens.begin() + static_cast<std::ptrdiff_t>(end),
      [](const Token& token) { return token.sort == Sort::number; }));
  const bool lone = numbers == 1 && tokens[end - 1].text.find('e') != std::string_view::npos;
  return has(tokens, begin, end, Sort::symbol) || lone ||
         (numbers > 1 && has(tokens, begin, end, Sort::sign));
}

std::string latex_of(const Token& token) {
  const std::string text(token.text);
  switch (token.sort) {
    case Sort::symbol: {
      const std::size_t prime = text.find('\'');
      return symbolic::typeset::latex_name(plain_name(text.substr(0, prime))) +
             (prime == std::string::npos ? "" : text.substr(prime));
    }
    case Sort::function:
      return "\\" + text;
    case Sort::number: {
      const std::size_t e = text.find('e');
      return e == std::string::npos ? text : text.substr(0, e) + " \\cdot 10^{" + text.substr(e + 1) + "}";
    }
    case Sort::sign:
      return std::string(
          std::ranges::find(signs, token.text, &std::pair<std::string_view, std::string_view>::first)
              ->second);
    case Sort::space:
      return "";
    default:
      return text;
  }
}

std::string latex_of(const Tokens& tokens, std::size_t begin, std::size_t end) {
  std::string latex;
  for (std::size_t i = begin; i < end; ++i) {
    const std::string one = latex_of(tokens[i]);
    latex += (latex.empty() || one.empty() || one.front() == '^' ? "" : " ") + one;
  }
  return latex;
}

bool can_begin(const Token& token) {
  return token.sort == Sort::symbol || token.sort == Sort::function || token.sort == Sort::number ||
         token.sort == Sort::open || token.sort == Sort::bar || token.text == "-" || token.text == "+";
}

void append(std::vector<ProsePart>& parts, std::string_view words) {
  if (parts.empty() || parts.back().formula) {
    parts.push_back({false, ""});
  }
  parts.back().text += words;
}

template <class Escape>
std::string written(std::string_view sentence, Escape escape, std::string_view open, std::string_view close) {
  std::string text;
  for (const ProsePart& part : prose_parts(sentence)) {
    text += part.formula ? std::string(open) + escape(part.text, true) + std::string(close)
                         : escape(part.text, false);
  }
  return text;
}

}  // namespace

std::vector<ProsePart> prose_parts(std::string_view sentence) {
  const Tokens tokens = tokens_of(sentence);
  std::vector<ProsePart> parts;
  for (std::size_t i = 0; i < tokens.size();) {
    const bool after_word = i > 0 && tokens[i - 1].sort == Sort::words && tokens[i - 1].text != ":" &&
                            is_alphanumeric(tokens[i - 1].text.back());
    const std::size_t end = can_begin(tokens[i]) && !after_word ? end_of_run(tokens, i) : i;
    if (is_formula(tokens, i, end)) {
      parts.push_back({true, latex_of(tokens, i, end)});
      i = end;
    } else {
      append(parts, tokens[i].text);
      ++i;
    }
  }
  return parts;
}

std::string prose_html(std::string_view sentence) {
  return written(
      sentence, [](std::string_view text, bool) { return escape_html(text); }, "<tex>", "</tex>");
}

std::string prose_tex(std::string_view sentence) {
  return written(
      sentence,
      [](std::string_view text, bool formula) { return formula ? std::string(text) : escape_tex(text); }, "$",
      "$");
}

}  // namespace stickslip::report::tools
