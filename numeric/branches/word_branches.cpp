#include "numeric/branches/word_branches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "numeric/branches/setting.hpp"
#include "numeric/branches/shooting.hpp"
#include "numeric/families/overshooting.hpp"

namespace stickslip::numeric::branches {

namespace {

using motion::PhaseKind;

// A system whose motions begin with phase `first` of the word's.
template <class F>
struct Turned {
  F equations;
  std::size_t first;
  bool takes_phi = false;
  bool takes_ur = true;

  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return equations.template closing<T>(x, p);
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    motion::MotionOf<T> motion = equations.template motion<T>(x, p);
    turn(motion.phases, motion.phases.size() - first);
    T start(0);
    for (motion::PhaseOf<T>& phase : motion.phases) {
      phase.start = start;
      start += phase.duration;
    }
    return motion;
  }
  [[nodiscard]] zeros::Vector unknowns(motion::Motion motion) const {
    turn(motion.phases, first);
    return equations.unknowns(motion);
  }

  // So that phase `by` is the first.
  template <class Phases>
  static void turn(Phases& phases, std::size_t by) {
    std::rotate(phases.begin(), phases.begin() + static_cast<std::ptrdiff_t>(by % phases.size()),
                phases.end());
  }
};

// Where the phases are to be begun with, for these phases to come in that order; nothing where they do not.
std::optional<std::size_t> first_of(const std::vector<PhaseKind>& phases, const std::vector<PhaseKind>& as) {
  for (std::size_t k = 0; k < phases.size(); ++k) {
    std::vector<PhaseKind> turned = phases;
    Turned<Shooting>::turn(turned, k);
    if (turned == as) {
      return k;
    }
  }
  return std::nullopt;
}

struct Equations {
  motion::Closing closing;
  int phi;  // its place among the unknowns
  std::vector<families::Growth> growths;
};

// Of a slip, an overshoot and a stick in one period those of the family, reduced by hand: their cells are
// some twenty times as long. Else from the end of a stick on, if there is one: its duration, often the
// longest, is what the others leave.
Equations equations_of(std::vector<PhaseKind> phases, int periods) {
  const families::Family& family = families::overshooting();
  const auto whole = first_of(phases, family.phases);
  if (whole && periods == 1) {
    return {Turned<families::OvershootingClosing>{{false, true}, *whole}, 5, family.growths};
  }
  const auto stick = std::find(phases.rbegin(), phases.rend(), PhaseKind::stick).base() - phases.begin();
  const std::size_t first = static_cast<std::size_t>(stick) % phases.size();
  Turned<Shooting>::turn(phases, first);
  const int legs = static_cast<int>(phases.size()) - 1;
  return {Turned<Shooting>{{phases, periods}, first},
          legs + 3,
          {{{legs, legs + 1, legs + 2}, {}, {}}}};  // z1, z2, z1'
}

}  // namespace

BranchQuestion word_question(const words::WordQuestion& machine, const words::Word& word, int periods,
                             const std::vector<words::WordOrbit>& known) {
  families::Family record;
  record.name = word.letters();
  record.title = fmt::format("Orbits of the word {} over {} period{} of the load", word.letters(), periods,
                             periods == 1 ? "" : "s");
  record.phases = word.phases();
  for (std::size_t k = 0; k < word.size(); ++k) {
    record.durations.push_back(fmt::format("t{}", k + 1));
  }
  record.requirements = words::requirements_of(record.phases);
  record.growths = equations_of(record.phases, periods).growths;
  WordOrbits orbits{std::make_shared<const families::Family>(std::move(record)), {}, periods};
  for (const words::WordOrbit& one : known) {
    if (one.existence.truth == Truth::proved && one.word == word && one.periods == periods) {
      orbits.motions.push_back(one.orbit.motion);
    }
  }
  const motion::ExactParameters& a = machine.data;
  BranchQuestion question;
  question.orbits = {orbits.family.get(),
                     {Range{a.chi}, Range{a.eta}, Range{a.us}, Range{a.V}, Range{a.omega}, Range{a.p}},
                     {},
                     Range{machine.ur},
                     machine.digits};
  question.word = std::move(orbits);
  return question;
}

std::vector<families::Candidate> word_candidates(const WordOrbits& word) {
  const Equations equations = equations_of(word.family->phases, word.periods);
  std::vector<families::Candidate> all;
  for (const motion::Motion& motion : word.motions) {
    all.push_back(
        {{motion, {}, [](const motion::Motion&) { return true; }}, equations.closing, 0, equations.phi});
  }
  return all;
}

}  // namespace stickslip::numeric::branches
