// The cyclic word of a periodic motion: its phases in their order, as letters.
//
// S is a slip (x2' < V), O an overshoot (x2' > V), T a stick (x2' = V). A periodic motion may be cut
// anywhere, so all rotations of a word are one word; it is written in the one that comes first in the
// alphabet: OTS for slip, overshoot, stick.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::words {

class Word {
 public:
  // Any rotation of it. Throws UsageError, in one sentence, for what is no word: other letters, none, two
  // phases of one kind after each other (cyclically), and a single letter, whose motions have no event.
  [[nodiscard]] static Word parse(std::string_view text);
  // Of the phases of a motion; throws likewise.
  [[nodiscard]] static Word of(const std::vector<motion::PhaseKind>& phases);

  // The letters in the first rotation.
  [[nodiscard]] const std::string& letters() const { return letters_; }
  [[nodiscard]] std::vector<motion::PhaseKind> phases() const;
  [[nodiscard]] std::size_t size() const { return letters_.size(); }
  // How often the shortest word of which this is a repetition is repeated: 2 for STST.
  [[nodiscard]] std::size_t repetitions() const;

  friend bool operator==(const Word&, const Word&) = default;

 private:
  explicit Word(std::string letters) : letters_(std::move(letters)) {}
  std::string letters_;
};

[[nodiscard]] char letter(motion::PhaseKind kind);

// The phase of a text of one letter, S, O or T: of a motion that never leaves it, and so is no word.
[[nodiscard]] std::optional<motion::PhaseKind> kind_of(std::string_view text);

// Where the rotation of a text that comes first in the alphabet begins.
[[nodiscard]] std::size_t first_rotation(std::string_view text);
[[nodiscard]] std::string in_first_rotation(std::string text);

// Whether Word::parse takes the text.
[[nodiscard]] bool is_word(std::string_view text);

// Whether a text can only be meant as a word: it consists of the letters S, O, T.
[[nodiscard]] bool looks_like_word(std::string_view text);

}  // namespace stickslip::numeric::words
