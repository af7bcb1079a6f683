#include "numeric/words/complete_list.hpp"

#include "core/error.hpp"
#include "numeric/words/by_durations.hpp"
#include "numeric/words/without_stick.hpp"

namespace stickslip::numeric::words {

std::string why_no_motion(const Rational& V, const Word& word) {
  const auto lacks = [&](char c) { return word.letters().find(c) == std::string::npos; };
  if (V <= 0 && lacks('O')) {
    return "x2' <= V <= 0 all along, so x2 falls and does not return";
  }
  if (V >= 0 && lacks('S')) {
    return "x2' >= V >= 0 all along, so x2 rises and does not return";
  }
  return "";
}

bool has_complete_list(const WordQuestion& question, const Word& word, long periods) {
  return !why_no_motion(question.data.V, word).empty() || is_without_stick(question, word, periods) ||
         is_searched(word);
}

WordList all_orbits(const WordQuestion& question, const Word& word, long periods) {
  require_word_domain(question);
  if (!has_complete_list(question, word, periods)) {
    throw InternalError("no complete list is known of the word " + word.letters());
  }
  if (const std::string reason = why_no_motion(question.data.V, word); !reason.empty()) {
    return {{}, {}, 0, reason};
  }
  return is_searched(word) ? all_by_durations(question, word, periods)
                           : all_without_stick(question, word, periods);
}

}  // namespace stickslip::numeric::words
