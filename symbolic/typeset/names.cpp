#include "symbolic/typeset/names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <string_view>
#include <tuple>

namespace stickslip::symbolic::typeset {
namespace {

constexpr std::array before_unknown = {"pi", "chi", "eta", "lambda"};
constexpr std::array after_unknown = {"u",     "p",   "V",   "d",     "q", "x", "z",
                                      "omega", "phi", "tau", "Theta", "T", "t", "s"};

struct Name {
  std::string letter;  // one letter, a Greek letter spelled out, or the whole name when it has no such form
  std::string accent;
  std::string subscript;
  bool plain = false;  // of the form that latex_name describes
};

// A Greek letter spelled out or any one letter, an accent, and a subscript: after an underscore anything,
// else one letter, digits, or both.
const std::regex& grammar() {
  static const std::regex pattern(
      "(alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|upsilon|"
      "phi|"
      "chi|psi|omega|Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Upsilon|Phi|Psi|Omega|[A-Za-z])"
      "(ddot|dot|bar|tilde|hat)?(?:_([A-Za-z0-9]*)|([A-Za-z]?[0-9]*|[0-9][A-Za-z0-9]*))");
  return pattern;
}

const Name& parse(const std::string& plain) {
  thread_local std::map<std::string, Name> known;
  const auto [entry, fresh] = known.try_emplace(plain);
  std::smatch parts;
  if (fresh) {
    entry->second = std::regex_match(plain, parts, grammar())
                        ? Name{parts[1], parts[2], parts[3].str() + parts[4].str(), true}
                        : Name{plain, "", "", false};
  }
  return entry->second;
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
  const Name& name = parse(plain);
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
  const auto key = [](const std::string& plain) {
    const Name& name = parse(plain);
    return std::tuple(rank(name), std::string_view(name.letter), std::string_view(name.accent),
                      name.subscript.size(), std::string_view(plain));
  };
  return key(a) <=> key(b);
}

bool names_frequency(const std::string& plain) {
  return parse(plain).letter == "omega";
}

bool exceeds_one(const std::string& plain) {
  return plain == "omega2";
}

}  // namespace stickslip::symbolic::typeset
