// What is asked of the motions of a branch, and what of it holds on a part of one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/branches/branches.hpp"
#include "numeric/branches/curve.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/exits.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::numeric::branches {

// The friction law as a family or a word asks for it.
struct Law {
  // Those whose thresholds can be proved to be crossed. Several of one id stand for all of them together; the
  // second list is taken with ur = us: where ur is not given, some ur > us serves exactly if they hold then.
  motion::Requirements requirements;
  motion::Requirements at_us;
  // All conditions, which may be more; the ball contains the friction where it is given.
  std::function<std::vector<motion::Condition>(const motion::ClosedMotion&, const std::optional<Ball>& ur)>
      conditions;
  bool ur_is_result = false;   // r when the first phase begins
  std::optional<Rational> ur;  // where it is given and not the free parameter
  bool ur_is_free = false;
  std::optional<MachineAlong> machine = {};  // whose value the free parameter is: then its ur, if it is given
  bool phi_is_given = false;                 // of the load when the first phase begins
  bool is_symmetric = false;                 // all motions are orbits of Section 4
};

// A part of a cell, and what is known of it.
struct Part {
  std::size_t cell = 0;
  Rational first, last;  // of the cell's driver, in the direction of the branch
  Ball value;            // contains the parameter
  int rises = 0;         // the parameter along the branch: 1 rises, -1 falls, 0 not known
  State state = State::undecided;
  std::string reason;
  std::vector<motion::Condition> conditions;  // of an absent part, on durations only
  // For the reader: the motion in the middle, and its multipliers where it is admissible.
  motion::MotionOf<double> sample;
  double sample_value = 0;
  bool admissible = false;  // is proved, whatever the state
  bool in_units = false;    // other than the motion's own, as the sample is

  [[nodiscard]] bool decided() const { return state != State::undecided && rises != 0; }
  [[nodiscard]] bool refutes(const std::string& id) const;
};

// The proof over that part of a cell: of the cell's own motions, or undecided.
[[nodiscard]] zeros::ParametricProof proof_on(const Curve& curve, const Cell& cell, const Rational& first,
                                              const Rational& last);

[[nodiscard]] Part look(const Curve& curve, const Law& law, const std::vector<Cell>& cells, std::size_t cell,
                        const Rational& first, const Rational& last);

// The friction over the part in the motion's units, as jets by the driver; nothing where the law knows none.
[[nodiscard]] std::optional<zeros::ParameterJet> friction_jet(
    const Law& law, const motion::MotionOf<zeros::ParameterJet>& motion, const zeros::ParameterJet& value,
    const zeros::ParameterJet& unit);

// The whole branch in parts, each decided or so short that the parameter is enclosed to `shortest` (an
// upper bound of the interval's length); after too many divisions some are longer.
[[nodiscard]] std::vector<Part> parts_of(const Curve& curve, const Law& law, const std::vector<Cell>& cells,
                                         double shortest);

// That a threshold is crossed: on a short part of a branch a quantity rises or falls strictly wherever it is
// not above zero, so it has one zero there at most, and passes it with a speed that is not zero.

// How a quantity goes along the part.
enum class Trend {
  above,    // positive all the way
  rising,   // with a positive derivative wherever it is not positive
  falling,  // with a negative one
  unknown,
};

// Of the margin of a condition. Along a phase the margin is the infimum over time of g(t) or of g(t)/t next
// to an end that g touches, and it rises if g does at each time at which it is not positive: then the set of
// parameters where the condition holds has one end. Times count from the end of the phase that is nearer.
[[nodiscard]] Trend trend_of(const motion::Requirement& requirement,
                             const motion::MotionOf<zeros::ParameterJet>& motion,
                             const std::optional<zeros::ParameterJet>& ur);

// Of a quantity wherever it is: rising, falling or unknown.
[[nodiscard]] Trend by_slope(const zeros::ParameterJet& g);

// Of the lesser of two quantities.
[[nodiscard]] Trend joined(Trend a, Trend b);

}  // namespace stickslip::numeric::branches
