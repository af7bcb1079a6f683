#include "numeric/attractors/word_search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "numeric/attractors/settle.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"

namespace stickslip::numeric::attractors {

using words::Word;
using words::WordOrbit;

namespace {

constexpr long starts = 100;
constexpr long most_periods = 20000;  // as in attractors, which finds what nears an orbit slowly

// A word for readers, shortened.
std::string shown(const std::string& word) {
  constexpr std::size_t most = 24;
  return word.size() <= most ? word : fmt::format("{}... ({} phases)", word.substr(0, most), word.size());
}

// Whether the orbit is one of the word over n periods, taken as often as it needs.
bool is_of(const WordOrbit& orbit, const WordSearch& q) {
  if (q.periods % orbit.periods != 0) {
    return false;
  }
  std::string letters;
  for (long k = 0; k < q.periods / orbit.periods; ++k) {
    letters += orbit.word.letters();
  }
  return letters == q.word.letters();
}

WordOrbits from_start(const WordSearch& q) {
  WordOrbits result{q, {}, {}};
  const auto data = motion::parameters_as<double>(q.machine.data);
  Follower follower(data, scalars::scalar<double>(q.machine.ur), *q.near);
  const auto attempt = [&] {
    const Return next = follower.over_periods(q.periods);
    if (next.word != q.word.letters()) {
      return false;
    }
    const WordOrbit orbit = prove_word_orbit(q.machine, next.guess);
    const bool found = orbit.existence.truth == Truth::proved && is_of(orbit, q);
    if (found) {
      result.orbits.push_back(orbit);
    }
    return found;
  };
  if (attempt()) {
    return result;
  }
  follower.follow(most_periods, 1e-6);
  const std::optional<Return> settled = follower.returned();
  if (settled && q.periods % settled->guess.periods == 0 && attempt()) {
    return result;
  }
  result.interrupted = interrupted();
  result.seen = settled ? fmt::format("the motion from there settles on {} with the period {}",
                                      shown(settled->word), settled->guess.periods)
                        : fmt::format("the motion from there: {} after {} periods",
                                      to_string(follower.kind()), follower.periods());
  return result;
}

WordOrbits from_random_starts(const WordSearch& q) {
  WordOrbits result{q, {}, {}};
  const AttractorList list = find_attractors({q.machine, starts, 1, most_periods});
  std::string others;
  for (const Attractor& a : list.attractors) {
    if (a.orbit && a.orbit->existence.truth == Truth::proved && is_of(*a.orbit, q)) {
      result.orbits.push_back(*a.orbit);
    } else {
      others += others.empty() ? "" : ", ";
      others += a.kind == Kind::periodic ? fmt::format("{} with the period {}", shown(a.word), a.periods)
                                         : to_string(a.kind);
    }
  }
  result.interrupted = list.interrupted;
  if (result.orbits.empty()) {
    result.seen = fmt::format("{} random starts end on: {}", starts, others);
  }
  return result;
}

// Whether they may be one and the same, begun with the same phase or with another one.
bool may_be_same(const WordOrbit& a, const WordOrbit& b) {
  const std::vector<motion::Phase>&p = a.orbit.motion.phases, &q = b.orbit.motion.phases;
  const auto from = [&](std::size_t k) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const motion::Phase &one = p[i], &other = q[(i + k) % q.size()];
      if (one.kind != other.kind || !one.duration.overlaps(other.duration)) {
        return false;
      }
    }
    return true;
  };
  bool same = false;
  for (std::size_t k = 0; k < p.size() && p.size() == q.size(); ++k) {
    same = same || from(k);
  }
  return same;
}

bool is_long_search(const WordSearch& q) {
  constexpr std::size_t phases = 4;
  return q.word.size() >= phases && words::why_no_motion(q.machine.data.V, q.word).empty();
}

// What simulations find, and then all others.
WordOrbits all_of(const WordSearch& q) {
  const WordOrbits first = is_long_search(q) ? from_random_starts(q) : WordOrbits{q, {}, {}};
  const words::WordList list = words::all_orbits(q.machine, q.word, q.periods);
  WordOrbits result{q, list.orbits, list.why_none, interrupted(), true, list.unresolved};
  for (const WordOrbit& found : first.orbits) {
    const bool is_shorter = found.periods != q.periods;
    if (!is_shorter &&
        std::ranges::none_of(list.orbits, [&](const WordOrbit& one) { return may_be_same(one, found); })) {
      if (result.complete() && is_admissible(found.orbit)) {
        throw InternalError("a complete list lacks an orbit of " + q.word.letters());
      }
      result.orbits.push_back(found);
    }
  }
  return result;
}

}  // namespace

WordOrbits find_word_orbits(const WordSearch& question) {
  words::require_word_domain(question.machine);
  WordOrbits found = question.near ? from_start(question)
                     : words::has_complete_list(question.machine, question.word, question.periods) &&
                             (question.all || !is_long_search(question))
                         ? all_of(question)
                         : from_random_starts(question);
  for (WordOrbit& one : found.orbits) {
    if (question.neighbourhood) {
      machines::surround(one.orbit, question.machine, one.periods);
    }
  }
  return found;
}

}  // namespace stickslip::numeric::attractors
