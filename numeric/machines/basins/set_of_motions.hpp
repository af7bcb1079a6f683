// Many motions of a machine at once: a set of starts followed in balls through the events that all of them
// have in one order.
//
// A member is u(e) = (t, (x, x')), |e| <= 1. Known are u(0), u'(0), and, over the whole set, in balls, u' and
// u''; so u(e) is in u(0) + u'(set) e, and u'(e) in u'(0) + u''(set) e, which is to second order as narrow as
// it is. (Products of balls alone are a thousand times as wide after the three phases of an orbit.)
//
// A phase is followed for all of them: the time of its end is enclosed by Newton's method in an interval,
// along the way from u(0) to u(e), and what else could end it is excluded by the conditions of judge.hpp.
// On a smooth law u'' is not known, and u' what products of balls give.
#pragma once

#include <optional>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/machines/orbits/machine_orbit.hpp"
#include "numeric/machines/phases/passage.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::machines {

// Axes for u, orthogonal where times, positions and velocities are counted in units of the machine: products
// of many ball matrices as they stand are useless (chain_proof.hpp).
struct Frame {
  Matrix axes, back;  // the columns; the inverse
};

// How a vector depends on e: its value, first derivatives as columns, and of each of these its derivatives.
struct Dependence {
  Vector value;
  Matrix first;
  // The derivative by e_k and e_l is the frame times column l of second[k]. Empty: unknown.
  std::vector<Matrix> second;
  Frame frame;
  Matrix along;  // but for the time, `first` is the frame times this, too; empty: not known

  [[nodiscard]] Matrix derivative_of_first(std::size_t k) const;
};

struct SetOfMotions {
  std::optional<Piece> before;  // where each motion is at the event between the two; nothing: at one time
  Piece piece;
  std::vector<Piece> passed;  // those after it so far; the last one is `piece`
  bool round = false;         // |e| is Euclid's norm; else the largest of |e_k|
  bool timeless = false;      // without a load: when each has its event does not matter, t is the middle's
  Dependence middle;          // of (t, (x, x')) at e = 0; without second derivatives
  Dependence all;             // over the set
  // u(0) = exact + frame offset, in a frame of its own, likewise.
  Vector exact, offset;
  Frame frame;

  // All values of row e.
  [[nodiscard]] Ball reach(const Vector& row) const;
  [[nodiscard]] const Ball& time() const { return middle.value(0); }
};

// At a time: the motions from middle + S e.
[[nodiscard]] SetOfMotions set_at(const Ball& time, const Piece& piece, const Vector& middle, const Matrix& S,
                                  bool round);

class SetFlow {
 public:
  // At the working precision. Throws as require_machine does.
  explicit SetFlow(const Machine& machine);

  [[nodiscard]] const LinearPhases& phases() const { return phases_; }
  // On which piece all these states are, by their relative velocity, and at rest on the belt, exactly, by r.
  [[nodiscard]] std::optional<Piece> piece_of(const Vector& states, const Ball& time) const;

  // Each follows all motions of the set: proved, and it is what they have become; or undecided, with the
  // reason, and the set is of no use any more.
  // To where this piece ends and the next begins, which the middle one does after about so long.
  [[nodiscard]] Verdict to_event(SetOfMotions& set, const Piece& after, double about) const;
  // To a time that lies on the same piece.
  [[nodiscard]] Verdict to_time(SetOfMotions& set, const Ball& time) const;
  // The events that the simulation of the middle one meets in so long a time.
  [[nodiscard]] std::vector<MachineGuess::Event> events(const SetOfMotions& set, double duration) const;
  // To a time, through these.
  [[nodiscard]] Verdict follow(SetOfMotions& set, const Ball& time) const;

 private:
  [[nodiscard]] Vector whole(const Vector& u) const;
  [[nodiscard]] Eigen::Index known_row(const SetOfMotions& set) const;
  [[nodiscard]] Verdict judge(const SetOfMotions& set, const Ball& duration,
                              const std::optional<Piece>& after, const SetOfMotions& end) const;

  Machine machine_;
  LinearPhases phases_;
  Vector units_;  // of u: in the time one goes as far as motions do, as fast as they do, and those of w
  model::FrictionOscillator<double> in_double_;
  mutable simulation::AnySimulation simulation_;
};

}  // namespace stickslip::numeric::machines
