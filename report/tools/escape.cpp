#include "report/tools/escape.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <sstream>

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

}  // namespace stickslip::report::tools
