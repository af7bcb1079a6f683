#include "report/orbits/listed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "numeric/families/family.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using attractors::WordOrbits;
using attractors::WordSearch;

namespace {

std::string searched_for(const WordOrbits& list) {
  if (list.searched) {
    return "all durations of the phases, every phase of the load";
  }
  return list.question.near ? "near " + state_of(*list.question.near) : "where random starts settle";
}

std::string result_of(const WordOrbits& list) {
  if (list.orbits.empty() && !list.searched) {
    return "no orbit found: " + list.seen + (list.interrupted ? "; interrupted" : "");
  }
  if (list.orbits.empty() && !list.seen.empty()) {
    return "complete: no orbit: " + list.seen;
  }
  const auto good = std::ranges::count(list.orbits, Truth::proved,
                                       [](const words::WordOrbit& o) { return o.orbit.admissible.truth; });
  const std::string count =
      fmt::format("{} {}, {} admissible", list.orbits.empty() ? "no" : std::to_string(list.orbits.size()),
                  list.orbits.size() == 1 ? "orbit" : "orbits", good);
  const std::string completeness = !list.searched ? "" : list.complete() ? "complete: " : "not complete: ";
  return completeness + count + (list.searched ? "" : "; others may exist") +
         (list.seen.empty() ? "" : ": " + list.seen) + (list.interrupted ? "; interrupted" : "");
}

}  // namespace

Listed::Listed(const OrbitList& found)
    : list(found),
      title(found.question.family->title),
      searched(orbits::searched(found.question)),
      result(result_of_search(found)),
      command(command_of(found.question)),
      durations(found.question.family->durations) {}

Listed::Listed(const WordOrbits& found)
    : searched(searched_for(found)),
      result(result_of(found)),
      command(command_of(found.question)),
      word(std::make_shared<const WordOrbits>(found)) {
  const WordSearch& q = found.question;
  const motion::ExactParameters& a = q.machine.data;
  const auto family = std::make_shared<Family>();
  family->name = q.word.letters();
  family->phases = q.word.phases();
  record = family;
  title = fmt::format("Orbits through {} in {} of the load", shortened(family->name),
                      q.periods == 1 ? "1 period" : fmt::format("{} periods", q.periods));
  for (const char letter : family->name) {
    durations.emplace_back(1, letter);
  }
  list.question = {record.get(),
                   {Range{a.chi}, Range{a.eta}, Range{a.us}, Range{a.V}, Range{a.omega}, Range{a.p}},
                   {},
                   Range{q.machine.ur},
                   q.machine.digits};
  list.unresolved = found.unresolved;
  for (const words::WordOrbit& one : found.orbits) {
    list.orbits.push_back(one.orbit);
    list.orbits.back().conditions = worst(one.orbit.conditions);
  }
}

}  // namespace stickslip::report::orbits
