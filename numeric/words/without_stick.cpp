#include "numeric/words/without_stick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/families/nonsticking.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using families::Candidate;

namespace {

// How often OS is repeated; 0 for other words.
long turns(const Word& word) {
  return word.letters().find('T') == std::string::npos ? static_cast<long>(word.size()) / 2 : 0;
}

Guess guess_of(const Motion& motion) {
  const model::Oscillator<Ball>& o = motion.oscillator;
  const double begin = (motion.phases.front().load / o.data.omega).approximate();
  Guess guess{{}, 1};
  for (const Phase& phase : motion.phases) {
    guess.events.push_back({begin + phase.start.approximate(), Ball(phase.Z(0) + o.d0(0)).approximate(),
                            Ball(phase.Z(1) + o.d0(1)).approximate(), phase.Z(2).approximate(), phase.kind});
  }
  return guess;
}

// The motion from its slip on, the load's phase then at most pi in size.
Motion from_slip(Motion motion) {
  std::swap(motion.phases[0], motion.phases[1]);
  Phase& slip = motion.phases[0];
  const Ball turn = Ball(2) * Ball::pi();
  slip.load -= turn * Ball(std::round((slip.load / turn).approximate()));
  return motion;
}

void conclude(const WordQuestion& q, const Candidate& candidate, WordList& list) {
  WordOrbit orbit = prove_word_orbit(q, guess_of(candidate.guess));
  std::string reason = orbit.existence.reason;
  if (orbit.existence.truth == Truth::proved && !candidate.is_same(from_slip(orbit.orbit.motion))) {
    reason = "the motion that was proved near a zero may be another one";
  }
  if (reason.empty()) {
    list.orbits.push_back(std::move(orbit));
  } else {
    list.unresolved.push_back({candidate.where, reason});
  }
}

// Whether OS is proved to have an orbit that obeys the law.
bool has_orbit(const WordQuestion& question) {
  const WordList list = all_without_stick(question, Word::parse("OS"), 1);
  return std::any_of(list.orbits.begin(), list.orbits.end(),
                     [](const WordOrbit& o) { return o.orbit.admissible.truth == Truth::proved; });
}

}  // namespace

bool is_without_stick(const WordQuestion& question, const Word& word, long periods) {
  const long k = turns(word);
  return k > 0 && (k % periods != 0 || k == periods || has_orbit(question));
}

WordList all_without_stick(const WordQuestion& question, const Word& word, long periods) {
  WordList list;
  ExactParameters slower = question.data;
  slower.omega /= periods;
  if (const Resonances found = resonances(slower); found.first != 0 || found.second != 0) {
    const Ball Theta = Ball(2) * Ball::pi() / Ball(question.data.omega);
    const std::string factor = periods == 1 ? "" : std::to_string(periods) + " ";
    list.unresolved.push_back(
        {{{"tau", Theta * Ball(periods) * Ball::hull(Ball(0), Ball(1))}},
         fmt::format("${}omega{} = {} omega$: motions that never stick need not be alone", factor,
                     found.first != 0 ? 1 : 2, found.first != 0 ? found.first : found.second)});
    return list;
  }
  if (turns(word) % periods != 0) {
    list.why_none = "a motion that never sticks returns after one period of the load already";
    return list;
  }
  if (turns(word) != periods) {
    list.why_none =
        "OS has an orbit that obeys the friction law, and no other motion that never sticks returns";
    return list;
  }
  const families::Found found = families::nonsticking().search({question.data, {}, {}});
  list.unresolved = found.unresolved;
  list.cells = found.cells;
  const bool none_drives =
      std::count(found.remarks.begin(), found.remarks.end(), families::Remark::nothing_drives) > 0;
  if (none_drives) {
    list.why_none = "the load does not act on x2, so nothing gives back what friction takes";
  }
  for (const Candidate& candidate : found.candidates) {
    conclude(question, candidate, list);
  }
  return list;
}

}  // namespace stickslip::numeric::words
