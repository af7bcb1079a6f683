#include "proofs/pascal2012/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"

namespace stickslip::proofs::pascal2012 {

namespace {

using Use = SourceLine::Use;

const std::string opening = "⟨", closing = "⟩";

SourceLine read(const std::string& line) {
  static const std::map<char, Use> uses{{':', Use::printed},
                                        {'~', Use::otherwise},
                                        {'&', Use::beside},
                                        {'@', Use::numbers},
                                        {'"', Use::passage}};
  const std::size_t space = line.find(' ');
  const auto use = space + 1 < line.size() ? uses.find(line[space + 1]) : uses.end();
  if (use == uses.end()) {
    throw InternalError("no line of the source: " + line);
  }
  SourceLine result{line.substr(0, space), use->second, line.substr(std::min(line.size(), space + 3))};
  const std::size_t end = use->second == Use::printed ? result.text.find(" ; ") : std::string::npos;
  if (end != std::string::npos) {
    std::istringstream more(result.text.substr(end + 3));
    result.otherwise.assign(std::istream_iterator<std::string>(more), {});
    result.text.resize(end);
  }
  return result;
}

// The text with each mark ⟨A⟩ or ⟨A:B⟩ replaced by A, if the glyphs that are put back are kept, or else by B.
std::string with_marks_replaced(const std::string& marked, bool put_back) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t mark; (mark = marked.find(opening, at)) != std::string::npos;) {
    const std::size_t from = mark + opening.size(), end = marked.find(closing, from);
    if (end == std::string::npos) {
      throw InternalError("a mark without an end: " + marked);
    }
    const std::string inside = marked.substr(from, end - from);
    const std::size_t colon = inside.find(':');
    result += marked.substr(at, mark - at);
    result += put_back                     ? inside.substr(0, colon)
              : colon == std::string::npos ? std::string()
                                           : inside.substr(colon + 1);
    at = end + closing.size();
  }
  return result + marked.substr(at);
}

struct Glyph {
  const char * text;
  const char * one;
  const char * many;
};

// What can be lost, in the order in which it is told.
constexpr std::array<Glyph, 23> glyphs{{
    {"−", "minus sign", "minus signs"},
    {"′", "prime", "primes"},
    {"=", "equality sign", "equality signs"},
    {"≡", "identity sign", "identity signs"},
    {"≠", "sign of inequality", "signs of inequality"},
    {"|", "bar of an absolute value", "bars of absolute values"},
    {"()", "bracket", "brackets"},
    {"/", "fraction bar", "fraction bars"},
    {"√", "sign of the root", "signs of roots"},
    {"˜", "tilde", "tildes"},
    {"Q", "letter $Q$", "letters $Q$"},
    {"I", "letter $I$", "letters $I$"},
    {"p", "letter $p$", "letters $p$"},
    {"ω", "letter $omega$", "letters $omega$"},
    {"χ", "letter $chi$", "letters $chi$"},
    {"π", "letter $pi$", "letters $pi$"},
    {"τ", "letter $tau$", "letters $tau$"},
    {"λ", "letter $lambda$", "letters $lambda$"},
    {"ψ", "letter $psi$", "letters $psi$"},
    {"δ", "letter $delta$", "letters $delta$"},
    {"Γ", "letter $Gamma$", "letters $Gamma$"},
    {"Δ", "letter $Delta$", "letters $Delta$"},
    {"Θ", "letter $Theta$", "letters $Theta$"},
}};

int count(const std::string& text, const std::string& glyph) {
  if (glyph == "()") {
    return count(text, "(") + count(text, ")");
  }
  int result = 0;
  for (std::size_t at = 0; (at = text.find(glyph, at)) != std::string::npos; at += glyph.size()) {
    ++result;
  }
  return result;
}

}  // namespace

const std::vector<SourceLine>& source_lines() {
  static const std::vector<SourceLine> all = [] {
    std::vector<SourceLine> result;
    std::istringstream lines(source_text().front().second);
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty() && !line.starts_with("#")) {
        result.push_back(read(line));
      }
    }
    return result;
  }();
  return all;
}

std::string as_extracted(const std::string& marked) {
  return with_marks_replaced(marked, false);
}

std::string as_read(const std::string& marked) {
  return with_marks_replaced(marked, true);
}

std::string lost_in_source(const std::string& claim) {
  std::set<std::string> told;  // a formula with an index may stand for several statements
  std::string there, read;
  for (const SourceLine& line : source_lines()) {
    const bool again = std::ranges::find(line.otherwise, "again") != line.otherwise.end();
    if (line.of == claim && !again && told.insert(line.text).second) {
      there += as_extracted(line.text);
      read += as_read(line.text);
    }
  }
  std::string result;
  for (const Glyph& glyph : glyphs) {
    const int all = count(read, glyph.text), lost = all - count(there, glyph.text);
    if (lost > 0) {
      result += result.empty() ? "" : ", ";
      result += all == 1      ? fmt::format("the {}", glyph.one)
                : all == lost ? (all == 2 ? fmt::format("both {}", glyph.many)
                                          : fmt::format("all {} {}", all, glyph.many))
                              : fmt::format("{} of {} {}", lost, all, glyph.many);
    }
  }
  return result;
}

}  // namespace stickslip::proofs::pascal2012
