#include "numeric/words/word_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/error.hpp"
#include "numeric/families/family.hpp"
#include "numeric/words/chain_proof.hpp"
#include "numeric/words/oscillator_chain.hpp"

namespace stickslip::numeric::words {

using namespace motion;

namespace {

// How often an undecided condition or stability is looked at with four times the bits.
constexpr int more_attempts = 3;

// Where the guess is to begin: at the first rotation of its word, of several the one whose first phase is the
// shortest. `turn` is the time of n periods.
std::size_t beginning(const Guess& guess, const Word& word, double turn) {
  const std::size_t count = guess.events.size();
  std::string letters;
  for (const Guess::Event& event : guess.events) {
    letters += letter(event.begins);
  }
  const auto duration = [&](std::size_t i) {
    return i + 1 < count ? guess.events[i + 1].t - guess.events[i].t
                         : guess.events.front().t + turn - guess.events[i].t;
  };
  const std::size_t first = first_rotation(letters);
  std::size_t best = first;
  for (std::size_t i = first; i < count; i += count / word.repetitions()) {
    best = duration(i) < duration(best) ? i : best;
  }
  return best;
}

Guess rotated(const Guess& guess, const Word& word, double Theta) {
  const double turn = static_cast<double>(guess.periods) * Theta;
  const std::size_t from = beginning(guess, word, turn);
  Guess result = guess;
  for (std::size_t i = 0; i < from; ++i) {
    result.events[i].t += turn;
  }
  std::rotate(result.events.begin(), result.events.begin() + static_cast<std::ptrdiff_t>(from),
              result.events.end());
  // So that the load's phase is at most pi in size when the motion begins.
  const double shift = Theta * std::round(result.events.front().t / Theta);
  for (Guess::Event& event : result.events) {
    event.t -= shift;
  }
  return result;
}

Nodes nodes_of(const Guess& guess, const ExactParameters& data) {
  const model::Vector2<Ball> d0 = model::d0<Ball>(Ball(data.chi), Ball(data.us));
  Nodes nodes;
  for (const Guess::Event& e : guess.events) {
    const Node u = node(Ball(e.t), Ball(e.x1) - d0(0), Ball(e.x2) - d0(1), Ball(e.xdot1));
    nodes.push_back(u.unaryExpr([](const Ball& x) { return x.midpoint(); }));
  }
  return nodes;
}

// What is known of "the orbit is a shorter one, taken d times".
Truth is_repetition(const ChainQuestion& q, const ChainProof& proof, long d) {
  const WorkingPrecision scope(proof.bits);
  const std::size_t count = q.phases.size();
  const std::size_t step = count / static_cast<std::size_t>(d);
  const Ball Theta = Ball(2) * Ball::pi() / Ball(q.data.omega);
  bool same = true;
  for (std::size_t i = 0; i < count; ++i) {
    const bool wraps = i + step >= count;
    Node later = proof.nodes[(i + step) % count];
    later(0) += Theta * Ball((wraps ? q.periods : 0) - q.periods / d);
    for (int j = 0; j < 4; ++j) {
      if (!later(j).overlaps(proof.nodes[i](j))) {
        return Truth::refuted;
      }
      same = same && later(j).is_interior_to(proof.unique[i](j));
    }
  }
  return same ? Truth::proved : Truth::undecided;
}

// How many times a shorter orbit the orbit is, or why that is not known.
std::pair<long, Verdict> repetition(const ChainQuestion& q, const ChainProof& proof, const Word& word) {
  const long most = std::gcd(static_cast<long>(word.repetitions()), q.periods);
  for (long d = most; d > 1; --d) {
    if (most % d != 0) {
      continue;
    }
    const Truth repeats = is_repetition(q, proof, d);
    if (repeats == Truth::proved) {
      return {d, Verdict::proved()};
    }
    if (repeats == Truth::undecided) {
      return {1, Verdict::undecided(fmt::format("the orbit may be a shorter one taken {} times", d))};
    }
  }
  return {1, Verdict::proved()};
}

bool all_decided(const families::Orbit& orbit) {
  return std::all_of(orbit.conditions.begin(), orbit.conditions.end(), [](const Condition& c) {
    return c.verdict.truth == Truth::proved || c.verdict.truth == Truth::refuted;
  });
}

bool is_open(const families::Orbit& orbit) {
  return !all_decided(orbit) || (orbit.stability && orbit.stability->kind == StabilityKind::undecided);
}

families::Orbit decided(const ChainQuestion& q, const ChainProof& proof, const Requirements& requirements) {
  const WorkingPrecision scope(proof.bits);
  const OscillatorChain chain(q);
  families::Orbit orbit;
  orbit.motion = chain.motion(proof.nodes);
  orbit.values = families::start_values(orbit.motion);
  orbit.values.push_back({"ur", chain.ur()});
  orbit.conditions =
      decide_all(q.phases, requirements, orbit.motion, all_waves(orbit.motion), std::optional(chain.ur()));
  orbit.admissible = admissible(orbit.conditions);
  if (orbit.admissible.truth == Truth::proved) {
    const bool sticks = std::find(q.phases.begin(), q.phases.end(), PhaseKind::stick) != q.phases.end();
    orbit.stability = stability_of(proof.return_map, sticks);
  }
  return orbit;
}

// The guess is rotated already. With more bits as long as something is open.
WordOrbit prove_rotated(const WordQuestion& question, const Guess& guess, const Word& word) {
  const ChainQuestion q{question.data, question.ur, word.phases(), guess.periods};
  const Requirements requirements = requirements_of(q.phases);
  Nodes nodes = nodes_of(guess, question.data);
  WordOrbit result{word, guess.periods, {}, {}, requirements};
  long bits = scalars::bits_for(question.digits) + 32;
  for (int attempt = 0; attempt <= more_attempts && bits <= question.most_bits; ++attempt) {
    const ChainProof proof = prove_chain(chain_at(q), nodes, bits, question.most_bits);
    if (proof.verdict.truth != Truth::proved) {
      if (attempt == 0) {
        result.existence = proof.verdict;
      }
      break;
    }
    const auto [times, verdict] = repetition(q, proof, word);
    if (verdict.truth == Truth::undecided) {
      result.existence = verdict;
      break;
    }
    if (times > 1) {
      Guess shorter{guess.events, q.periods / times};
      shorter.events.resize(guess.events.size() / static_cast<std::size_t>(times));
      return prove_word_orbit(question, shorter);
    }
    result.existence = Verdict::proved();
    result.orbit = decided(q, proof, requirements);
    if (!is_open(result.orbit)) {
      break;
    }
    nodes = midpoints(proof.nodes);
    bits = 4 * proof.bits;
  }
  return result;
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
  if (question.ur <= us) {
    throw DomainError("ur", stickslip::to_string(question.ur), "ur > us = " + stickslip::to_string(us));
  }
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
  if (question.data.p == 0) {
    throw DomainError("p", "0",
                      "p > 0: without load each shift in time of an orbit is an orbit, so none is alone");
  }
}

bool in_word_domain(const WordQuestion& question) {
  try {
    require_word_domain(question);
  } catch (const DomainError&) {
    return false;
  }
  return true;
}

WordOrbit prove_word_orbit(const WordQuestion& question, const Guess& guess) {
  require_word_domain(question);
  std::vector<PhaseKind> phases;
  for (const Guess::Event& event : guess.events) {
    phases.push_back(event.begins);
  }
  const Word word = Word::of(phases);
  const double Theta = 2 * std::numbers::pi / scalars::scalar<double>(question.data.omega);
  return prove_rotated(question, rotated(guess, word, Theta), word);
}

}  // namespace stickslip::numeric::words
