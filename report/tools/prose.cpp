#include "report/tools/prose.hpp"

#include <fmt/format.h>

#include <cctype>
#include <regex>
#include <utility>
#include <vector>

#include "report/tools/escape.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::report::tools {
namespace {

std::string name(const std::string& text) {
  for (const char * function : {"sin", "cos", "tan", "exp", "det", "min", "max"}) {
    if (text == function) {
      return "\\" + text;
    }
  }
  if (text == "sign") {
    return "\\operatorname{sign}";
  }
  // As symbolic/typeset/names.hpp reads it: z2B is z with the index 2B.
  static const std::regex indexed("[a-z][0-9][A-Z]");
  return symbolic::typeset::latex_name(
      std::regex_match(text, indexed) ? text.substr(0, 1) + "_" + text.substr(1) : text);
}

std::string sign(const std::string& text) {
  return text == "<="    ? "\\le"
         : text == ">="  ? "\\ge"
         : text == "!="  ? "\\ne"
         : text == "±"   ? "\\pm"
         : text == "*"   ? "\\cdot"
         : text == "..." ? "\\dots"
         : text == " "   ? ""
                         : text;
}

std::string latex_of(const std::string& formula) {
  // A root is a group, whose end the bracket says.
  if (const std::size_t root = formula.find("sqrt("); root != std::string::npos) {
    const std::size_t inside = root + 5;
    std::size_t end = inside;
    for (int depth = 1; end < formula.size(); ++end) {
      depth += formula[end] == '(' ? 1 : formula[end] == ')' ? -1 : 0;
      if (depth == 0) {
        break;
      }
    }
    if (end < formula.size()) {
      return fmt::format("{} \\sqrt{{{}}} {}", latex_of(formula.substr(0, root)),
                         latex_of(formula.substr(inside, end - inside)), latex_of(formula.substr(end + 1)));
    }
  }
  // A name with primes, a number with an exponent, a sign.
  static const std::regex token(
      "([A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*)('*)|([0-9]+(?:\\.[0-9]+)?)(?:e(-?[0-9]+))?|<=|>=|!=|"
      "\\.\\.\\.|[^ -~]+|.");
  std::string latex;
  for (std::sregex_iterator found(formula.begin(), formula.end(), token), end; found != end; ++found) {
    const std::smatch& match = *found;
    const std::string one = match[1].matched ? name(match[1]) + match[2].str()
                            : match[4].matched
                                ? fmt::format("{} \\cdot 10^{{{}}}", match[3].str(), match[4].str())
                                : sign(match[0]);
    latex += (latex.empty() || one.empty() || one.front() == '^' ? "" : " ") + one;
  }
  return latex;
}

template <class Words, class Formula>
std::string written(const std::string& sentence, const Words& words, const Formula& formula) {
  // Between dollars; a number with a radius, with an exponent.
  static const std::regex marked(
      "\\$([^$]*)\\$|-?\\b[0-9][0-9.]*(?:e-?[0-9]+)? ± "
      "[0-9][0-9.]*(?:e-?[0-9]+)?|-?\\b[0-9][0-9.]*e-?[0-9]+");
  std::string text;
  auto rest = sentence.begin();
  for (std::sregex_iterator found(sentence.begin(), sentence.end(), marked), end; found != end; ++found) {
    const std::smatch& match = *found;
    text += words(std::string(rest, match[0].first)) + formula(match[match[1].matched ? 1 : 0].str());
    rest = match[0].second;
  }
  return text + words(std::string(rest, sentence.end()));
}

}  // namespace

std::string prose_html(std::string_view sentence) {
  return written(std::string(sentence), escape_html, [](const std::string& formula) {
    return "<tex>" + escape_html(latex_of(formula)) + "</tex>";
  });
}

std::string prose_tex(std::string_view sentence) {
  return written(std::string(sentence), escape_tex,
                 [](const std::string& formula) { return "$" + latex_of(formula) + "$"; });
}

std::string in_greek(std::string list) {
  static const std::vector<std::pair<std::regex, std::string>> names{
      {std::regex("\\bchi( ?=)"), "χ$1"},
      {std::regex("\\beta( ?=)"), "η$1"},
      {std::regex("\\bomega( ?=)"), "ω$1"},
      {std::regex("\\bphi( ?=)"), "φ$1"},
      {std::regex("\\bu([sr])( ?=)"), "u_$1$2"}};
  for (const auto& [name, letter] : names) {
    list = std::regex_replace(list, name, letter);
  }
  return list;
}

std::string capitalised(std::string words) {
  if (!words.empty()) {
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  }
  return words;
}

}  // namespace stickslip::report::tools
