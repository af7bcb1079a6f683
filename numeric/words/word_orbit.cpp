#include "numeric/words/word_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/domain.hpp"
#include "numeric/families/family.hpp"
#include "numeric/machines/orbits/machine_orbit.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using machines::ChainProof;
using machines::MachineGuess;
using machines::MachineQuestion;
using machines::Node;
using machines::Nodes;

namespace {

// How often an undecided condition or stability is looked at with four times the bits.
constexpr int more_attempts = 3;

// Where the guess is to begin: at the first rotation of its word, of several the one whose first phase is the
// shortest.
std::size_t beginning(const MachineGuess& guess, const Word& word) {
  std::string letters;
  for (const MachineGuess::Event& event : guess.events) {
    letters += letter(event.begins.kind);
  }
  std::size_t best = first_rotation(letters);
  for (std::size_t i = best; i < letters.size(); i += letters.size() / word.repetitions()) {
    best = guess.lasts(i) < guess.lasts(best) ? i : best;
  }
  return best;
}

// So that the load's phase, over whose period Theta is, is at most pi in size when the motion begins.
MachineGuess rotated(const MachineGuess& guess, const Word& word, double Theta) {
  MachineGuess result = guess.begun_at(beginning(guess, word));
  const double shift = Theta * std::round(result.events.front().t / Theta);
  for (MachineGuess::Event& event : result.events) {
    event.t -= shift;
  }
  return result;
}

// The motion that starts at node 0; phase i is that of node i.
Motion motion_of(const WordQuestion& question, const MachineQuestion& chain, const Nodes& nodes) {
  Motion motion{model::oscillator<Ball>(parameters_as<Ball>(question.data)), {}};
  const model::Oscillator<Ball>& o = motion.oscillator;
  const Ball turn = Ball(2 * chain.periods) * Ball::pi() / o.data.omega;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& u = nodes[i];
    const Ball until = i + 1 < nodes.size() ? nodes[i + 1](0) : Ball(nodes.front()(0) + turn);
    const Ball start = i == 0 ? Ball(0) : Ball(u(0) - nodes.front()(0));
    motion.phases.push_back({chain.pieces[i].kind, start, until - u(0), o.data.omega * u(0),
                             model::Vector4<Ball>(u(1) - o.d0(0), u(2) - o.d0(1), u(3), o.data.V)});
  }
  return motion;
}

bool is_open(const families::Orbit& orbit) {
  return !all_decided(orbit) || (orbit.stability && orbit.stability->kind == StabilityKind::undecided);
}

families::Orbit decided(const WordQuestion& question, const MachineQuestion& chain, const ChainProof& proof,
                        const std::vector<PhaseKind>& phases, const Requirements& requirements) {
  const WorkingPrecision scope(proof.bits);
  families::Orbit orbit;
  const Ball ur(question.ur);
  orbit.motion = motion_of(question, chain, proof.nodes);
  orbit.values = families::start_values(orbit.motion);
  orbit.values.push_back({"ur", ur});
  orbit.conditions =
      decide_all(phases, requirements, orbit.motion, all_waves(orbit.motion), std::optional(ur));
  orbit.admissible = admissible(orbit.conditions);
  if (is_admissible(orbit)) {
    const bool sticks = std::find(phases.begin(), phases.end(), PhaseKind::stick) != phases.end();
    orbit.stability = stability_of(proof.return_map, sticks);
  }
  return orbit;
}

}  // namespace

Requirements requirements_of(const std::vector<PhaseKind>& phases) {
  Requirements list = sound_data({});
  const std::size_t count = phases.size();
  for (std::size_t k = 0; k < count; ++k) {
    const PhaseKind before = phases[(k + count - 1) % count];
    const PhaseKind next = phases[(k + 1) % count];
    list.push_back({"duration", "each phase lasts", Quantity::duration, k});
    if (phases[k] == PhaseKind::stick) {
      list.push_back({"stick.upper",
                      "$r < ur$ while it sticks",
                      Quantity::below_ur,
                      k,
                      true,
                      {false, next == PhaseKind::slip}});
      list.push_back({"stick.lower",
                      "$r > -ur$ while it sticks",
                      Quantity::above_minus_ur,
                      k,
                      true,
                      {false, next == PhaseKind::overshoot}});
      continue;
    }
    const bool slip = phases[k] == PhaseKind::slip;
    if (before != PhaseKind::stick) {
      list.push_back({"crossing", "$|r| > ur$ where a slip and an overshoot meet",
                      slip ? Quantity::beyond_ur : Quantity::beyond_minus_ur, k});
    }
    list.push_back(slip ? slips(k, "$z2' < V$ while it slips")
                        : overshoots(k, "$z2' > V$ while it overshoots"));
  }
  return list;
}

namespace {

void require_friction(const WordQuestion& question) {
  const Rational& us = question.data.us;
  require(question.ur > us, "ur", question.ur, "ur > us = " + stickslip::to_string(us));
}

}  // namespace

void require_machine_domain(const WordQuestion& question) {
  require_response(question.data);
  require_friction(question);
}

void require_word_domain(const WordQuestion& question) {
  require_response(question.data);
  require_simulated_domain(question);
}

void require_simulated_domain(const WordQuestion& question) {
  require_model_domain(question.data);
  require_friction(question);
  require(question.data.p != 0, "p", "0",
          "p > 0: without load each shift in time of an orbit is an orbit, so none is alone");
}

bool in_word_domain(const WordQuestion& question) {
  try {
    require_word_domain(question);
  } catch (const DomainError&) {
    return false;
  }
  return true;
}

WordOrbit prove_word_orbit(const WordQuestion& question, const MachineGuess& seen) {
  require_word_domain(question);
  std::vector<PhaseKind> phases;
  for (const MachineGuess::Event& event : seen.events) {
    phases.push_back(event.begins.kind);
  }
  const Word word = Word::of(phases);
  const double Theta = 2 * std::numbers::pi / scalars::scalar<double>(question.data.omega);
  MachineGuess guess = seen;
  guess.duration = static_cast<double>(guess.periods) * Theta;
  guess = rotated(guess, word, Theta);
  const MachineQuestion q{
      {model::friction_oscillator<Rational>(question.data, question.ur)}, guess.pieces(), guess.periods};
  WordOrbit result{word, guess.periods, {}, {}, requirements_of(word.phases())};
  const auto [existence, times] = prove_while_open(
      q, guess, question.digits, question.most_bits, more_attempts, [&](const ChainProof& proof) {
        result.orbit = decided(question, q, proof, word.phases(), result.asked);
        return is_open(result.orbit);
      });
  if (times > 1) {
    return prove_word_orbit(question, guess.once_of(times, true));
  }
  result.existence = existence;
  return result;
}

}  // namespace stickslip::numeric::words
