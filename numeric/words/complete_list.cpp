#include "numeric/words/complete_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/through_phases/isolate.hpp"
#include "numeric/families/through_phases/through_phases.hpp"
#include "numeric/machines/orbits/machine_orbit.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using families::Concluded;
using families::FoundOf;
using families::Isolated;
using families::Remark;
using families::Unresolved;

namespace {

bool sticks(const Word& word) {
  return word.letters().find('T') != std::string::npos;
}

// Whether closed_through takes it.
bool is_searched(const Word& word) {
  return sticks(word) && word.size() <= 4;
}

// How often OS is repeated; 0 for other words.
long turns(const Word& word) {
  return sticks(word) ? 0 : static_cast<long>(word.size()) / 2;
}

// Whether the motion, taken so many times, is the zero, whichever phase it begins with.
bool is_zero(const Isolated& zero, Motion motion, long times) {
  const std::vector<Phase> once = motion.phases;
  for (long k = 1; k < times; ++k) {
    motion.phases.insert(motion.phases.end(), once.begin(), once.end());
  }
  const auto has_kinds = [&] {
    return std::ranges::equal(motion.phases, zero.guess.phases, {}, &Phase::kind, &Phase::kind);
  };
  for (std::size_t k = 0; k < once.size(); ++k) {
    Motion turned = motion;
    // The load's phase is at most pi in size when it begins.
    Ball& load = turned.phases.front().load;
    const Ball turn = Ball(2) * Ball::pi();
    load -= turn * Ball(std::round(Ball(load / turn).approximate()));
    if (has_kinds() && zero.is_same(turned)) {
      return true;
    }
    std::rotate(motion.phases.begin(), motion.phases.begin() + 1, motion.phases.end());
  }
  return false;
}

// The zero as an orbit, or left open; nothing if it is a shorter orbit taken several times.
Concluded<WordOrbit> conclude(const WordQuestion& q, long periods, const Isolated& zero) {
  const WorkingPrecision scope(families::guess_bits);
  WordOrbit orbit = prove_word_orbit(q, machines::guess_of(zero.guess, periods));
  if (orbit.existence.truth != Truth::proved) {
    return Unresolved{zero.where, orbit.existence.reason};
  }
  const long times = periods / orbit.periods;
  if (times * orbit.periods != periods || !is_zero(zero, orbit.orbit.motion, times)) {
    return Unresolved{zero.where, families::may_be_another};
  }
  return times == 1 ? Concluded<WordOrbit>(std::move(orbit)) : Concluded<WordOrbit>();
}

template <class Zero>
WordList concluded(const WordQuestion& q, long periods, FoundOf<Zero> found) {
  WordList list{{}, std::move(found.unresolved), found.cells, {}};
  families::conclude_all(
      found.candidates, [&](const Isolated& zero) { return conclude(q, periods, zero); }, list.orbits,
      list.unresolved);
  return list;
}

WordList all_with_stick(const WordQuestion& question, const Word& word, long periods) {
  std::vector<PhaseKind> phases = word.phases();
  const auto stick = std::find(phases.begin(), phases.end(), PhaseKind::stick);
  std::rotate(phases.begin(), stick + 1, phases.end());
  return concluded(question, periods,
                   families::closed_through({{question.data, {}, question.ur}, phases, periods, true}));
}

// OS and its repetitions; unresolved at the resonances below.
//
// Two motions that never stick, or one and the same with the load a period later, differ by w with
//   E = (w'ᵀ M w' + wᵀ M K w)/2,  E' = eta (x2' - y2') (u(x2') - u(y2')) <= 0
// (families/nonsticking.hpp). If they return after n periods so does E, so w is a free motion that does, and
// zero unless some n omega_j is a multiple of omega. So off these resonances there is at most one such
// motion, whatever the number of its phases, and it returns after one period already: where OS has an orbit
// that obeys the law, OSOS has none.
WordList all_without_stick(const WordQuestion& question, const Word& word, long periods) {
  ExactParameters slower = question.data;
  slower.omega /= periods;
  if (const Resonances found = resonances(slower); found.first != 0 || found.second != 0) {
    const Ball Theta = Ball(2) * Ball::pi() / Ball(question.data.omega);
    const std::string factor = periods == 1 ? "" : std::to_string(periods) + " ";
    return {{},
            {{{{"tau", Theta * Ball(periods) * Ball::hull(Ball(0), Ball(1))}},
              fmt::format("${}omega{} = {} omega$: motions that never stick need not be alone", factor,
                          found.first != 0 ? 1 : 2, found.first != 0 ? found.first : found.second)}},
            0,
            ""};
  }
  if (turns(word) % periods != 0) {
    return {{}, {}, 0, "a motion that never sticks returns after one period of the load already"};
  }
  if (turns(word) != periods) {
    return {{},
            {},
            0,
            "OS has an orbit that obeys the friction law, and no other motion that never sticks "
            "returns"};
  }
  const families::Found found = families::nonsticking().search({question.data, {}, {}});
  WordList list = concluded(question, 1, found);
  if (std::ranges::count(found.remarks, Remark::nothing_drives) > 0) {
    list.why_none = "the load does not act on x2, so nothing gives back what friction takes";
  }
  return list;
}

// Whether OS is proved to have an orbit that obeys the law.
bool has_orbit(const WordQuestion& question) {
  const WordList list = all_without_stick(question, Word::parse("OS"), 1);
  return std::ranges::any_of(list.orbits, families::is_admissible, &WordOrbit::orbit);
}

}  // namespace

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
  const long k = turns(word);
  return !why_no_motion(question.data.V, word).empty() || is_searched(word) ||
         (k > 0 && (k % periods != 0 || k == periods || has_orbit(question)));
}

WordList all_orbits(const WordQuestion& question, const Word& word, long periods) {
  require_word_domain(question);
  if (!has_complete_list(question, word, periods)) {
    throw InternalError("no complete list is known of the word " + word.letters());
  }
  if (const std::string reason = why_no_motion(question.data.V, word); !reason.empty()) {
    return {{}, {}, 0, reason};
  }
  return sticks(word) ? all_with_stick(question, word, periods) : all_without_stick(question, word, periods);
}

}  // namespace stickslip::numeric::words
