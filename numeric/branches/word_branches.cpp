#include "numeric/branches/word_branches.hpp"

#include <fmt/format.h>

#include "numeric/branches/shooting.hpp"

namespace stickslip::numeric::branches {

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
  const std::vector<motion::PhaseKind>& phases = word.family->phases;
  const motion::Closing equations = Shooting{phases, word.periods};
  const int phi = static_cast<int>(phases.size()) + 2;  // its place among the unknowns
  std::vector<families::Candidate> all;
  for (const motion::Motion& motion : word.motions) {
    all.push_back({equations, motion, {}, [](const motion::Motion&) { return true; }, 0, phi});
  }
  return all;
}

}  // namespace stickslip::numeric::branches
