#include "proofs/symbols/parse_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "proofs/symbols/parse.hpp"

namespace stickslip::proofs::symbols::parsing {
namespace {

constexpr std::size_t longest_line = 20000, longest_number = 1000;

// What may be typed for plain names and signs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 47> typed{{
    {"−", "-"},       {"·", "*"},     {"⋅", "*"},      {"×", "*"},     {"≤", "<="},     {"≥", ">="},
    {"≠", "!="},      {"²", "^2"},    {"³", "^3"},     {"′", "'"},     {"″", "''"},     {"₀", "0"},
    {"₁", "1"},       {"₂", "2"},     {"₃", "3"},      {"₄", "4"},     {"₅", "5"},      {"π", "pi"},
    {"χ", "chi"},     {"η", "eta"},   {"ω", "omega"},  {"τ", "tau"},   {"φ", "phi"},    {"ϕ", "phi"},
    {"ψ", "psi"},     {"ξ", "xi"},    {"λ", "lambda"}, {"ρ", "rho"},   {"δ", "delta"},  {"ε", "epsilon"},
    {"ϵ", "epsilon"}, {"γ", "gamma"}, {"α", "alpha"},  {"β", "beta"},  {"μ", "mu"},     {"θ", "theta"},
    {"Θ", "Theta"},   {"Γ", "Gamma"}, {"Λ", "Lambda"}, {"Σ", "Sigma"}, {"Δ", "Delta"},  {"Φ", "Phi"},
    {"Ψ", "Psi"},     {"Ω", "Omega"}, {"Ξ", "Xi"},     {"√", "sqrt"},  {"\u00a0", " "},
}};

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
      const bool is_plain = (static_cast<unsigned char>(line[i]) & 0x80U) == 0;  // as none of those is
      const auto other = is_plain ? typed.end() : std::ranges::find_if(typed, [&](const auto& one) {
        return line.substr(i).starts_with(one.first);
      });
      const std::string_view plain = other == typed.end() ? line.substr(i, 1) : other->second;
      text += plain;
      places.insert(places.end(), plain.size(), i);
      i += other == typed.end() ? 1 : other->first.size();
    }
    places.push_back(line.size());
  }
};

}  // namespace

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
    const auto length = [&](auto belongs, std::size_t from = 0) {
      const std::string_view here = rest.substr(from);
      return static_cast<std::size_t>(std::ranges::find_if_not(here, belongs) - here.begin());
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
      const std::size_t digits = point ? whole + 1 + length(is_digit, whole + 1) : whole;
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

}  // namespace stickslip::proofs::symbols::parsing
