#include "report/tools/escape.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "report/tools/unicode.hpp"

namespace stickslip::report::tools {
namespace {

constexpr std::string_view html_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

using Entry = std::pair<char32_t, std::string_view>;

constexpr std::array tex_of_ascii = {
    Entry{'\\', "\\textbackslash{}"},
    Entry{'{', "\\{"},
    Entry{'}', "\\}"},
    Entry{'$', "\\$"},
    Entry{'&', "\\&"},
    Entry{'#', "\\#"},
    Entry{'%', "\\%"},
    Entry{'_', "\\_"},
    Entry{'^', "\\textasciicircum{}"},
    Entry{'<', "$<$"},
    Entry{'>', "$>$"},
    Entry{'|', "$|$"},
    Entry{'~', "\\textasciitilde{}"},
    Entry{'"', "''"},
};

// What the project's own texts and a reader's input are likely to contain; commands of the LaTeX kernel only.
constexpr std::array tex_of_mathematics = {
    Entry{U'α', "\\alpha"},
    Entry{U'β', "\\beta"},
    Entry{U'γ', "\\gamma"},
    Entry{U'δ', "\\delta"},
    Entry{U'ε', "\\varepsilon"},
    Entry{U'ζ', "\\zeta"},
    Entry{U'η', "\\eta"},
    Entry{U'θ', "\\theta"},
    Entry{U'κ', "\\kappa"},
    Entry{U'λ', "\\lambda"},
    Entry{U'μ', "\\mu"},
    Entry{U'ν', "\\nu"},
    Entry{U'ξ', "\\xi"},
    Entry{U'π', "\\pi"},
    Entry{U'ρ', "\\rho"},
    Entry{U'σ', "\\sigma"},
    Entry{U'τ', "\\tau"},
    Entry{U'φ', "\\varphi"},
    Entry{U'χ', "\\chi"},
    Entry{U'ψ', "\\psi"},
    Entry{U'ω', "\\omega"},
    Entry{U'Γ', "\\Gamma"},
    Entry{U'Δ', "\\Delta"},
    Entry{U'Θ', "\\Theta"},
    Entry{U'Λ', "\\Lambda"},
    Entry{U'Σ', "\\Sigma"},
    Entry{U'Φ', "\\Phi"},
    Entry{U'Ω', "\\Omega"},
    Entry{U'±', "\\pm"},
    Entry{U'∓', "\\mp"},
    Entry{U'×', "\\times"},
    Entry{U'·', "\\cdot"},
    Entry{U'−', "-"},
    Entry{U'≠', "\\neq"},
    Entry{U'≤', "\\leq"},
    Entry{U'≥', "\\geq"},
    Entry{U'≈', "\\approx"},
    Entry{U'≡', "\\equiv"},
    Entry{U'∈', "\\in"},
    Entry{U'ℝ', "\\mathbf{R}"},
    Entry{U'∞', "\\infty"},
    Entry{U'√', "\\surd"},
    Entry{U'→', "\\to"},
    Entry{U'⇒', "\\Rightarrow"},
    Entry{U'⇔', "\\Leftrightarrow"},
    Entry{U'′', "'"},
    Entry{U'ᵀ', "^{T}"},
    Entry{U'⁻', "^{-}"},
    Entry{U'⁰', "^{0}"},
    Entry{U'¹', "^{1}"},
    Entry{U'²', "^{2}"},
    Entry{U'³', "^{3}"},
    Entry{U'⁴', "^{4}"},
    Entry{U'₀', "_{0}"},
    Entry{U'₁', "_{1}"},
    Entry{U'₂', "_{2}"},
    Entry{U'₃', "_{3}"},
    Entry{U'₄', "_{4}"},
    Entry{U'₅', "_{5}"},
    Entry{U'ᵢ', "_{i}"},
    Entry{U'ⱼ', "_{j}"},
    Entry{U'½', "{\\textstyle\\frac12}"},
    Entry{U'°', "^{\\circ}"},
};

constexpr std::array tex_of_typography = {
    Entry{U'–', "--"},        Entry{U'—', "---"},    Entry{U'‘', "`"},
    Entry{U'’', "'"},         Entry{U'“', "``"},     Entry{U'”', "''"},
    Entry{U'…', "\\ldots{}"}, Entry{U'\u00A0', "~"}, Entry{U'§', "\\S{}"},
};

template <std::size_t n>
constexpr std::string_view look_up(const std::array<Entry, n>& table, char32_t c) {
  for (const Entry& entry : table) {
    if (entry.first == c) {
      return entry.second;
    }
  }
  return {};
}

std::string tex_of(char32_t c) {
  if (c < 0x80) {
    const std::string_view special = look_up(tex_of_ascii, c);
    if (!special.empty()) {
      return std::string(special);
    }
    const bool control = c != '\n' && (c < 0x20 || c == 0x7F);
    return {control ? ' ' : static_cast<char>(c)};
  }
  const std::string_view mathematics = look_up(tex_of_mathematics, c);
  if (!mathematics.empty()) {
    return fmt::format("${}$", mathematics);
  }
  return std::string(look_up(tex_of_typography, c));
}

// Letters such as é, which LaTeX reads as they stand; × and ÷ are none.
bool is_latin_letter(char32_t c) {
  return c >= 0xC0 && c <= 0xFF && c != 0xD0 && c != 0xD7 && c != 0xDE && c != 0xF0 && c != 0xF7 && c != 0xFE;
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const std::string_view reference = html_of(c);
    if (reference.empty()) {
      result += c;
    } else {
      result += reference;
    }
  }
  return result;
}

std::string escape_tex(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point(text, i);
    const std::string tex = tex_of(c.value);
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
