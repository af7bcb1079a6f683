#include "symbolic/typeset/names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace stickslip::symbolic::typeset {
namespace {

constexpr std::array greek_letters = {"alpha", "beta",  "gamma",   "delta",  "epsilon", "zeta",   "eta",
                                      "theta", "iota",  "kappa",   "lambda", "mu",      "nu",     "xi",
                                      "pi",    "rho",   "tau",     "sigma",  "upsilon", "phi",    "chi",
                                      "psi",   "omega", "Gamma",   "Delta",  "Theta",   "Lambda", "Xi",
                                      "Pi",    "Sigma", "Upsilon", "Phi",    "Psi",     "Omega"};

constexpr std::array accents = {"ddot", "dot", "bar", "tilde", "hat"};

constexpr std::array before_unknown = {"pi", "chi", "eta", "lambda"};
constexpr std::array after_unknown = {"u",     "p",   "V",   "d",     "q", "x", "z",
                                      "omega", "phi", "tau", "Theta", "T", "t", "s"};

struct Name {
  std::string letter;  // one letter, a Greek letter spelled out, or the whole name when it has no such form
  std::string accent;
  std::string subscript;
  bool plain = false;  // of the form that latex_name describes
};

template <std::size_t size>
bool contains(const std::array<const char *, size>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_letter(const std::string& word) {
  return (word.size() == 1 && std::isalpha(static_cast<unsigned char>(word[0])) != 0) ||
         contains(greek_letters, word);
}

std::optional<Name> accented_letter(const std::string& word) {
  if (is_letter(word)) {
    return Name{word, "", "", true};
  }
  for (const std::string accent : accents) {
    if (word.size() > accent.size() && word.ends_with(accent)) {
      const std::string letter = word.substr(0, word.size() - accent.size());
      if (is_letter(letter)) {
        return Name{letter, accent, "", true};
      }
    }
  }
  return std::nullopt;
}

bool is_alphanumeric(const std::string& word) {
  return std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

Name parse(const std::string& plain) {
  const auto with_subscript = [&plain](std::size_t end, const std::string& subscript) {
    std::optional<Name> name = accented_letter(plain.substr(0, end));
    if (name && is_alphanumeric(subscript)) {
      name->subscript = subscript;
      return name;
    }
    return std::optional<Name>();
  };
  const std::size_t underscore = plain.find('_');
  if (underscore != std::string::npos) {
    return with_subscript(underscore, plain.substr(underscore + 1)).value_or(Name{plain, "", "", false});
  }
  const std::size_t last = plain.find_last_not_of("0123456789");
  const std::size_t end = last == std::string::npos ? 0 : last + 1;
  if (const auto name = with_subscript(end, plain.substr(end))) {
    return *name;
  }
  if (end > 1) {
    if (const auto name = with_subscript(end - 1, plain.substr(end - 1))) {
      return *name;
    }
  }
  // z2C, zdot2B.
  const std::size_t digit = plain.find_first_of("0123456789");
  if (digit != std::string::npos) {
    if (const auto name = with_subscript(digit, plain.substr(digit))) {
      return *name;
    }
  }
  return {plain, "", "", false};
}

std::size_t rank(const Name& name) {
  const auto early = std::find(before_unknown.begin(), before_unknown.end(), name.letter);
  if (early != before_unknown.end()) {
    return static_cast<std::size_t>(early - before_unknown.begin());
  }
  const auto late = std::find(after_unknown.begin(), after_unknown.end(), name.letter);
  const std::size_t unknown = before_unknown.size();
  return late == after_unknown.end() ? unknown
                                     : unknown + 1 + static_cast<std::size_t>(late - after_unknown.begin());
}

std::string latex_letter(const std::string& letter) {
  if (letter == "phi" || letter == "epsilon") {
    return "\\var" + letter;
  }
  return letter.size() == 1 ? letter : "\\" + letter;
}

std::string upright(const std::string& word) {
  std::string escaped;
  for (const char c : word) {
    if (std::string_view("_%#&${}").find(c) != std::string_view::npos) {
      escaped += '\\';
    }
    escaped += c;
  }
  return "\\mathrm{" + escaped + "}";
}

}  // namespace

std::string latex_name(const std::string& plain) {
  const Name name = parse(plain);
  if (!name.plain) {
    return upright(plain);
  }
  std::string result = latex_letter(name.letter);
  if (!name.accent.empty()) {
    result = "\\" + name.accent + (result.size() == 1 ? " " : "") + result;
  }
  if (name.subscript.size() == 1) {
    result += "_" + name.subscript;
  } else if (!name.subscript.empty()) {
    result += "_{" + name.subscript + "}";
  }
  return result;
}

std::strong_ordering compare_names(const std::string& a, const std::string& b) {
  const Name left = parse(a);
  const Name right = parse(b);
  if (const auto order = rank(left) <=> rank(right); std::is_neq(order)) {
    return order;
  }
  if (const auto order = left.letter <=> right.letter; std::is_neq(order)) {
    return order;
  }
  if (const auto order = left.accent <=> right.accent; std::is_neq(order)) {
    return order;
  }
  if (const auto order = left.subscript.size() <=> right.subscript.size(); std::is_neq(order)) {
    return order;
  }
  return a <=> b;
}

bool names_frequency(const std::string& plain) {
  return parse(plain).letter == "omega";
}

bool exceeds_one(const std::string& plain) {
  return plain == "omega2";
}

}  // namespace stickslip::symbolic::typeset
