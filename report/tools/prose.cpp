#include "report/tools/prose.hpp"

#include <fmt/format.h>

#include <cctype>
#include <functional>
#include <map>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "symbolic/typeset/names.hpp"

namespace stickslip::report::tools {

namespace {

constexpr CodePoint broken{0xFFFD, 1};

unsigned byte(std::string_view text, std::size_t position) {
  return static_cast<unsigned char>(text[position]);
}

std::size_t length_by_first_byte(unsigned first) {
  if (first < 0x80) {
    return 1;
  }
  if (first >= 0xC2 && first < 0xE0) {
    return 2;
  }
  if (first >= 0xE0 && first < 0xF0) {
    return 3;
  }
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

// What stands for a sign.
using Table = std::map<std::string, std::string, std::less<>>;

// Of pairs of words: a sign, and what stands for it.
Table table(const std::string& words) {
  std::istringstream all(words);
  Table made;
  for (std::string sign, text; all >> sign >> text;) {
    made.emplace(sign, text);
  }
  return made;
}

const Table html = table(R"(& &amp; < &lt; > &gt; " &quot; ' &#39;)");

const Table tex_of_words = [] {
  Table made =
      table(R"(\ \textbackslash{} { \{ } \} $ \$ & \& # \# % \% _ \_ ^ \textasciicircum{} < $<$ > $>$ | $|$
      ~ \textasciitilde{} " '' – -- — --- ‘ ` ’ ' “ `` ” '' … \ldots{} § \S{})");
  made.emplace("\u00A0", "~");
  return made;
}();

// What the project's own texts and a reader's input are likely to contain; commands of the LaTeX kernel only.
const Table tex_of_mathematics = table(
    R"(α \alpha β \beta γ \gamma δ \delta ε \varepsilon ζ \zeta η \eta θ \theta κ \kappa λ \lambda μ \mu ν \nu ξ \xi
    π \pi ρ \rho σ \sigma τ \tau φ \varphi χ \chi ψ \psi ω \omega Γ \Gamma Δ \Delta Θ \Theta Λ \Lambda Σ \Sigma
    Φ \Phi Ω \Omega ± \pm ∓ \mp × \times · \cdot − - ≠ \neq ≤ \leq ≥ \geq ≈ \approx ≡ \equiv ∈ \in ℝ \mathbf{R}
    ∞ \infty √ \surd → \to ⇒ \Rightarrow ⇔ \Leftrightarrow ′ ' ᵀ ^{T} ⁻ ^{-} ⁰ ^{0} ¹ ^{1} ² ^{2} ³ ^{3} ⁴ ^{4}
    ₀ _{0} ₁ _{1} ₂ _{2} ₃ _{3} ₄ _{4} ₅ _{5} ᵢ _{i} ⱼ _{j} ½ {\textstyle\frac12} ° ^{\circ})");

// Of one sign, of that code point; empty where there is nothing.
std::string tex_of(std::string_view sign, char32_t c) {
  if (const auto word = tex_of_words.find(sign); word != tex_of_words.end()) {
    return word->second;
  }
  if (c < 0x80) {
    const bool control = c != '\n' && (c < 0x20 || c == 0x7F);
    return {control ? ' ' : static_cast<char>(c)};
  }
  const auto mathematics = tex_of_mathematics.find(sign);
  return mathematics == tex_of_mathematics.end() ? "" : fmt::format("${}$", mathematics->second);
}

// Letters such as é, which LaTeX reads as they stand; × and ÷ are none.
bool is_latin_letter(char32_t c) {
  return c >= 0xC0 && c <= 0xFF && c != 0xD0 && c != 0xD7 && c != 0xDE && c != 0xF0 && c != 0xF7 && c != 0xFE;
}

}  // namespace

CodePoint code_point(std::string_view text, std::size_t position) {
  const unsigned first = byte(text, position);
  const std::size_t length = length_by_first_byte(first);
  if (length == 1) {
    return {first, 1};
  }
  if (length == 0 || position + length > text.size()) {
    return broken;
  }
  char32_t value = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned next = byte(text, position + i);
    if ((next & 0xC0U) != 0x80U) {
      return broken;
    }
    value = (value << 6U) | (next & 0x3FU);
  }
  return {value, length};
}

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point(text, i);
    const bool combining = c.value >= 0x300 && c.value < 0x370;
    count += combining ? 0 : 1;
    i += c.length;
  }
  return count;
}

std::string escape_html(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const auto reference = html.find(std::string_view(&c, 1));
    result += reference == html.end() ? std::string(1, c) : reference->second;
  }
  return result;
}

std::string escape_tex(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point(text, i);
    const std::string tex = tex_of(text.substr(i, c.length), c.value);
    if (!tex.empty()) {
      // Two hyphens are those of an option: LaTeX would join them to a dash, which no shell understands.
      result += c.value == '-' && result.ends_with('-') ? "{}-" : tex;
    } else if (is_latin_letter(c.value)) {
      result += text.substr(i, c.length);
    } else {
      result += fmt::format("[U+{:04X}]", static_cast<unsigned>(c.value));
    }
    i += c.length;
  }
  return result;
}

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
