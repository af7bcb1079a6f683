#include "numeric/words/word.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace stickslip::numeric::words {

using motion::PhaseKind;

namespace {

constexpr std::string_view alphabet = "SOT";

PhaseKind kind_of(char c) {
  return c == 'S' ? PhaseKind::slip : c == 'O' ? PhaseKind::overshoot : PhaseKind::stick;
}

// A long word is not repeated in full.
std::string quoted(std::string_view text) {
  constexpr std::size_t shown = 40;
  return text.size() <= shown ? fmt::format("'{}'", text)
                              : fmt::format("'{}...' ({} letters)", text.substr(0, shown), text.size());
}

// Why a text is no word; empty when it is one.
std::string why_no_word(std::string_view text) {
  if (!looks_like_word(text)) {
    return fmt::format("{} is not a word of phases: its letters are S (slip), O (overshoot) and T (stick)",
                       quoted(text));
  }
  if (text.size() == 1) {
    return fmt::format(
        "the word {} has one phase: such a motion never leaves it and has no event that a word could order",
        quoted(text));
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == text[(i + 1) % text.size()]) {
      return fmt::format(
          "{} is not a word of phases: {} follows {}{}, and a phase ends only where another kind "
          "begins",
          quoted(text), text[i], text[i], i + 1 == text.size() ? " from its end to its start" : "");
    }
  }
  return {};
}

}  // namespace

char letter(PhaseKind kind) {
  return alphabet[static_cast<std::size_t>(kind)];
}

std::optional<PhaseKind> kind_of(std::string_view text) {
  return text.size() == 1 && looks_like_word(text) ? std::optional(kind_of(text.front())) : std::nullopt;
}

bool looks_like_word(std::string_view text) {
  return !text.empty() && text.find_first_not_of(alphabet) == std::string_view::npos;
}

bool is_word(std::string_view text) {
  return why_no_word(text).empty();
}

// Booth's algorithm in its form with two candidates.
std::size_t first_rotation(std::string_view text) {
  const std::size_t n = text.size();
  std::size_t i = 0;
  std::size_t j = 1;
  for (std::size_t same = 0; i < n && j < n && same < n;) {
    const char a = text[(i + same) % n];
    const char b = text[(j + same) % n];
    if (a == b) {
      ++same;
      continue;
    }
    (a > b ? i : j) += same + 1;
    j += i == j ? 1 : 0;
    same = 0;
  }
  return std::min(i, j);
}

std::string in_first_rotation(std::string text) {
  std::rotate(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(first_rotation(text)), text.end());
  return text;
}

Word Word::parse(std::string_view text) {
  if (const std::string why = why_no_word(text); !why.empty()) {
    throw UsageError(why);
  }
  return Word(in_first_rotation(std::string(text)));
}

Word Word::of(const std::vector<PhaseKind>& phases) {
  std::string text;
  for (const PhaseKind kind : phases) {
    text += letter(kind);
  }
  return parse(text);
}

std::vector<PhaseKind> Word::phases() const {
  std::vector<PhaseKind> kinds;
  for (const char c : letters_) {
    kinds.push_back(kind_of(c));
  }
  return kinds;
}

std::size_t Word::repetitions() const {
  const std::size_t length = (letters_ + letters_).find(letters_, 1);
  return letters_.size() / length;
}

}  // namespace stickslip::numeric::words
