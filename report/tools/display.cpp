#include "report/tools/display.hpp"

#include <algorithm>
#include <regex>
#include <vector>

namespace stickslip::report::tools {

namespace {

// The widest line, in letters.
constexpr double column = 34;

// What stands between the brace at `at` and its partner; `at` is then behind it.
std::string group(const std::string& latex, std::size_t& at) {
  const std::size_t from = at + 1;
  for (int depth = 0; at < latex.size(); ++at) {
    depth += latex[at] == '{' ? 1 : latex[at] == '}' ? -1 : 0;
    if (depth == 0) {
      break;
    }
  }
  return latex.substr(from, at++ - from);
}

// In letters: indices are smaller, signs have space about them, of a fraction the wider side counts.
double width(const std::string& latex) {
  static const std::regex name(R"(\\[a-z]+)");
  double result = 0;
  for (std::size_t at = 0; at < latex.size();) {
    std::smatch found;
    if (latex.compare(at, 5, "\\frac") == 0) {
      at += 5;
      const std::string above = group(latex, at), below = group(latex, at);
      result += std::max(width(above), width(below));
    } else if ((latex[at] == '_' || latex[at] == '^') && at + 1 < latex.size()) {
      ++at;
      const std::string index = latex[at] == '{' ? group(latex, at) : latex.substr(at++, 1);
      result += 0.7 * width(index);
    } else if (std::regex_search(latex.begin() + static_cast<long>(at), latex.end(), found, name,
                                 std::regex_constants::match_continuous)) {
      const std::string word = found.str();
      at += word.size();
      result += word == "\\left" || word == "\\right" || word == "\\dot" ? 0
                : word == "\\sin" || word == "\\cos" || word == "\\leq"  ? 3
                                                                         : 1.2;
    } else {
      const char c = latex[at++];
      result += c == ' ' || c == '{' || c == '}' ? 0 : c == '+' || c == '-' || c == '=' || c == '<' ? 2.5 : 1;
    }
  }
  return result;
}

// Cut in front of what matches and stands in no bracket, behind no sign.
std::vector<std::string> pieces(const std::string& latex, const std::regex& sign) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::sregex_iterator found(latex.begin(), latex.end(), sign), end; found != end; ++found) {
    const auto at = static_cast<std::size_t>(found->position());
    const std::string before = latex.substr(0, at);
    const auto count = [&](const std::string& what) {
      int times = 0;
      for (std::size_t k = 0; (k = before.find(what, k)) != std::string::npos; k += what.size()) {
        ++times;
      }
      return times;
    };
    const bool behind_sign = before.empty() || std::string("+-=<>").find(before.back()) != std::string::npos;
    if (!behind_sign && count("{") == count("}") && count("\\left") == count("\\right")) {
      result.push_back(latex.substr(begin, at - begin));
      begin = at;
    }
  }
  result.push_back(latex.substr(begin));
  return result;
}

// In front of signs and relations, and of brackets where that leaves what is too wide.
std::vector<std::string> pieces(const std::string& latex) {
  static const std::regex sign(R"( (\+|-|=|<|>|\\leq|\\geq|\\neq) )"), bracket(R"( \\left)");
  std::vector<std::string> result;
  for (const std::string& piece : pieces(latex, sign)) {
    if (width(piece) <= column) {
      result.push_back(piece);
      continue;
    }
    bool first = true;
    for (const std::string& factor : pieces(piece, bracket)) {
      result.push_back(first ? factor : " \\cdot" + factor);
      first = false;
    }
  }
  return result;
}

}  // namespace

std::string displayed(const std::string& latex) {
  std::vector<std::string> lines;
  for (const std::string& piece : pieces(latex)) {
    if (!lines.empty() && width(lines.back() + piece) <= column) {
      lines.back() += piece;
    } else {
      lines.push_back(piece);
    }
  }
  const std::string kind = lines.size() == 1 ? "gather*" : "multline*";
  std::string result = "\\begin{" + kind + "}\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    result += (i == 0 ? "" : " \\\\\n{}") + lines[i];
  }
  return result + "\n\\end{" + kind + "}";
}

}  // namespace stickslip::report::tools
