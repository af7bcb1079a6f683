// A periodic motion of a machine through given pieces, proved near a guess, with everything decided about it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/machines/orbits/chain_proof.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::numeric::machines {

// A motion over n periods of the load, or round once where there is no load; nearly closed, in floating
// point.
struct MachineGuess {
  struct Event {
    double t;
    Eigen::VectorXd X;  // (x, x')
    Piece begins;
  };
  std::vector<Event> events;  // in their order, at least two
  long periods = 1;           // n
  double duration = 0;        // of all

  [[nodiscard]] std::vector<Piece> pieces() const;
  // Of the phase that begins at event i.
  [[nodiscard]] double lasts(std::size_t i) const;
  // Begun with event i.
  [[nodiscard]] MachineGuess begun_at(std::size_t i) const;
  // The first of so many times that it goes round a shorter motion.
  [[nodiscard]] MachineGuess once_of(long times, bool has_load) const;
};

// Of what a simulation meets: on a smooth law there is one piece to a side, where the simulation goes through
// many; and that the mass touches the belt's speed and leaves it again to the same side is no event.
template <class Transition>
[[nodiscard]] bool is_event(const model::FrictionOscillator<double>& o, const Transition& t) {
  const int side = Piece{t.after}.side();
  return side != 0 && o.law(side).smooth ? t.before != t.after : t.changes();
}
// Of what it met, counted from `begin`.
template <class Transition>
[[nodiscard]] std::vector<MachineGuess::Event> events_of(const model::FrictionOscillator<double>& o,
                                                         const std::vector<Transition>& log, double begin) {
  std::vector<MachineGuess::Event> events;
  for (const Transition& t : log) {
    if (is_event(o, t)) {
      const int side = Piece{t.after}.side();
      const bool smooth = side != 0 && o.law(side).smooth;
      events.push_back({t.time - begin, t.X, {t.after, smooth ? 0 : t.piece_after}});
    }
  }
  return events;
}

struct MachinePhase {
  Piece piece;
  Ball start, duration;  // counted from the first phase's beginning
  Vector state;          // (x, x') when it begins
};

struct Neighbourhood;

struct MachineOrbit {
  std::vector<Piece> pieces;
  long periods = 1;   // n
  Verdict existence;  // of "exactly one closed motion through these pieces lies near the guess"; else no more
                      // is known
  long bits = 0;      // that it was proved with
  Ball period;
  Ball load;  // theta when the first phase begins; 0 without a load
  std::vector<MachinePhase> phases;
  std::vector<motion::Condition> conditions;
  Verdict admissible;  // all of them hold: the motion obeys the friction law
  // Of the map from one passage of the first event to the next, period by period; nothing unless admissible.
  std::optional<motion::Stability> stability;
  // Where it was asked for (neighbourhood.hpp).
  std::shared_ptr<const Neighbourhood> neighbourhood = nullptr;
};

// Where, going round, a phase begins and not only another piece of the one before.
[[nodiscard]] std::vector<std::size_t> begins_of_phases(const std::vector<Piece>& pieces);
// Letters of the phases, as in words/word.hpp, in the first rotation; pieces of one phase are one letter, or,
// where `with_pieces` asks for it, S1, S2, … after each other.
[[nodiscard]] std::string word_of(const std::vector<Piece>& pieces, bool with_pieces = false);

// Proves the chain that Newton's method reaches from the guess, each value to that many significant digits,
// and hands it to `decide`; with four times the bits, so many times more at most, as long as that says that
// something is open. The verdict on its existence, and how many times it is a shorter one: then only that is
// known.
[[nodiscard]] std::pair<Verdict, long> prove_while_open(const MachineQuestion& question,
                                                        const MachineGuess& guess, int digits, long most_bits,
                                                        int more_attempts,
                                                        const std::function<bool(const ChainProof&)>& decide);

// Proves what Newton's method reaches from the guess, each value to that many significant digits, with more
// bits where a condition or the stability is open. When that is a shorter motion taken several times, the
// shorter one. Undecided when that fails, or is not known. Throws as require_machine does, and DomainError
// for a guess of fewer than two events.
[[nodiscard]] MachineOrbit prove_machine_orbit(const Machine& machine, const MachineGuess& guess,
                                               int digits = 20, long most_bits = 1L << 12);

// What holds of a proved chain: of the motion, or of the motions of all machines between two.
[[nodiscard]] MachineOrbit decided(const MachineQuestion& question, const ChainProof& proof);

// A guess as nodes.
[[nodiscard]] Nodes nodes_of(const MachineGuess& guess, const Machine& machine);

// A proved motion as a guess, the load's phase being 0 at t = 0.
[[nodiscard]] MachineGuess guess_of(const MachineOrbit& orbit, const Machine& machine);
// Likewise one of the paper's oscillator, of at least a phase, over so many periods of the load.
[[nodiscard]] MachineGuess guess_of(const motion::Motion& motion, long periods);

// Between two motions through the same phases: the largest difference of durations and states at events, in
// parts of the duration of the second and of its state there.
[[nodiscard]] double distance(const MachineGuess& a, const MachineGuess& b);
// What was proved is another motion than the one that was seen when they are farther apart than this.
inline constexpr double most_astray = 0.05;

}  // namespace stickslip::numeric::machines
