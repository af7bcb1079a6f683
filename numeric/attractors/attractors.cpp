#include "numeric/attractors/attractors.hpp"

#include <algorithm>

#include "numeric/attractors/settle.hpp"
#include "numeric/attractors/survey.hpp"
#include "numeric/families/family.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/simulation/agreement.hpp"
#include "numeric/words/pure.hpp"

namespace stickslip::numeric::attractors {

using namespace motion;
using families::NamedBall;
using model::Vector4;
using words::WordOrbit;

namespace {

// As survey.hpp asks for it. The proofs of words make use of (7), the response to the load.
struct WordProofs {
  using Attractor = attractors::Attractor;

  words::WordQuestion machine;
  bool resonant = is_resonant(machine.data);
  bool in_domain = words::in_word_domain(machine);

  [[nodiscard]] static double Omega() { return 1; }
  [[nodiscard]] bool provable() const { return in_domain; }
  [[nodiscard]] Return tidied(const Return& seen) const {
    return resonant ? shortest(seen, true, same_orbit, Omega()) : seen;
  }
  [[nodiscard]] std::optional<WordOrbit> prove(const Return& seen) const {
    if (in_domain) {
      return prove_word_orbit(machine, seen.guess);
    }
    return resonant ? std::optional(WordOrbit{
                          words::Word::parse(seen.word),
                          seen.guess.periods,
                          Verdict::undecided("$omega$ is a natural frequency, where (7) has a pole"),
                          {},
                          {}})
                    : std::nullopt;
  }
  [[nodiscard]] static const families::Orbit& judged(const WordOrbit& orbit) { return orbit.orbit; }
  [[nodiscard]] static const std::string& word(const WordOrbit& orbit) { return orbit.word.letters(); }
  [[nodiscard]] Vector4<double> begins_at(const WordOrbit& orbit) const {
    const families::Orbit& o = orbit.orbit;
    return {o.value("x10").approximate(), o.value("x20").approximate(), o.value("xdot10").approximate(),
            scalars::scalar<double>(machine.data.V)};
  }
  [[nodiscard]] static Vector4<double> at_phase_0(const WordOrbit& orbit) {
    return attractors::at_phase_0(simulation::start_of(orbit.orbit));
  }
  [[nodiscard]] static bool overlap(const WordOrbit& a, const WordOrbit& b) {
    return a.word == b.word && a.periods == b.periods &&
           std::ranges::all_of(a.orbit.values, [&](const NamedBall& value) {
             return value.value.overlaps(b.orbit.value(value.name));
           });
  }
  [[nodiscard]] static Attractor completed(Attractor a) {
    a.family = a.orbit ? family_of(*a.orbit) : "";
    return a;
  }
  // At resonance what slips goes on to grow until it meets the belt. Of a return no proof was tried.
  [[nodiscard]] Kind kind(Kind seen) const {
    return seen == Kind::periodic || (seen == Kind::slides && resonant) ? Kind::unsettled : seen;
  }
};

AttractorList survey(AttractorQuestion question, const std::vector<Vector4<double>>& starts) {
  question.starts = static_cast<long>(starts.size());
  question.machine.most_bits = std::max(most_bits_of_stable, 2 * scalars::bits_for(question.machine.digits));
  const auto data = parameters_as<double>(question.machine.data);
  const double ur = scalars::scalar<double>(question.machine.ur);
  std::vector<std::unique_ptr<AnyFollower>> followers;
  for (const Vector4<double>& X : starts) {
    followers.push_back(std::make_unique<Follower>(data, ur, X));
  }
  Survey<WordProofs> survey({question.machine}, question.most_periods, std::move(followers));
  return {survey.endings(), question};
}

// Every motion grows beyond all bounds: none is simulated. The state is where the first one starts.
AttractorList all_grow(const AttractorQuestion& question, const std::vector<Vector4<double>>& starts) {
  AttractorList list{{{Attractor{}}, 0, false, static_cast<long>(starts.size())}, question};
  list.question.starts = list.followed;
  Attractor& all = list.attractors.front();
  all.kind = Kind::grows;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    all.members.push_back(i);
  }
  all.count = list.followed;
  all.share = all.least = all.most = 1;
  all.state = starts.front();
  return list;
}

// Z(tau) = E Z(0), (13), as far as the balls tell.
bool may_be_symmetric(const Motion& m) {
  const model::Vector4<Ball>& Z = m.phases[0].Z;
  const model::Vector4<Ball>& later = m.phases[1].Z;
  return later(0).overlaps(-Z(0)) && later(1).overlaps(-Z(1)) && later(2).overlaps(Z(2));
}

}  // namespace

std::string family_of(const WordOrbit& orbit) {
  if (orbit.periods != 1 || orbit.existence.truth != Truth::proved) {
    return "";
  }
  for (const families::Family * family : families::all_families()) {
    if (orbit.word == words::Word::of(family->phases) &&
        (!family->is_symmetric || may_be_symmetric(orbit.orbit.motion))) {
      return family->name;
    }
  }
  return "";
}

AttractorList find_attractors_from(const AttractorQuestion& question,
                                   const std::vector<Vector4<double>>& starts) {
  motion::require_model_domain(question.machine.data);
  if (words::growth(question.machine.data, question.machine.ur).truth == Truth::proved) {
    return all_grow(question, starts);
  }
  words::require_simulated_domain(question.machine);
  return survey(question, starts);
}

AttractorList find_attractors(const AttractorQuestion& question) {
  AttractorList list = find_attractors_from(
      question, random_starts_in(start_box(parameters_as<double>(question.machine.data)),
                                 static_cast<std::size_t>(question.starts), question.seed));
  for (Attractor& a : list.attractors) {
    if (question.neighbourhood && a.orbit) {
      machines::surround(a.orbit->orbit, question.machine, a.orbit->periods);
    }
  }
  return list;
}

Attractor find_attractor(const words::WordQuestion& machine, const Vector4<double>& X, long most_periods) {
  const AttractorQuestion question{machine, 1, 0, most_periods};
  if (words::growth(machine.data, machine.ur).truth == Truth::proved) {
    return all_grow(question, {X}).attractors.front();
  }
  return survey(question, {X}).attractors.front();
}

}  // namespace stickslip::numeric::attractors
