// From a question about branches, of a family or of a word of phases, to the curves that are followed.
#pragma once

#include "core/error.hpp"
#include "numeric/branches/branches.hpp"
#include "numeric/branches/curve.hpp"
#include "numeric/branches/law.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/strip.hpp"
#include "numeric/motion/closing.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::branches {

// The closing conditions of a periodic motion through any given sequence of phases, ur given, by events and
// flows, in as few unknowns as there can be.
//
// Shooting: from a state at which a phase begins, through the flows (5), (8), (10) of all phases, back to
// that state one or more periods Theta = 2 pi/omega of the load later. Where a phase ends there is an event,
//   z2' = V          where a slip or an overshoot ends: (18), (19)
//   r = ur or -ur    where a stick ends, before a slip or an overshoot: (12)
// and the state has to return: (20), (28).

// For Closing.
//   x: the durations of all phases but the last; then z1, z2, z1' when the first phase begins, z2' = V, and
//   the
//      load's phase phi then.
// There are as many equations as unknowns: each phase ends with an event, and three components return.
struct Shooting {
  std::vector<motion::PhaseKind> phases;  // at least two
  int periods = 1;                        // of the load
  static constexpr bool takes_phi = false;
  static constexpr bool takes_ur = true;

  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    const model::Oscillator<T> o = motion::oscillator_of<T>(p);
    T last = T(2 * periods) * T(Ball::pi()) / o.data.omega;
    std::vector<motion::LegOf<T>> all;
    for (int i = 0; i < legs(); ++i) {
      all.push_back({phases[static_cast<std::size_t>(i)], x(i)});
      last -= x(i);
    }
    all.push_back({phases.back(), last});
    return motion::compose_motion<T>(o, x(legs() + 3), {x(legs()), x(legs() + 1), x(legs() + 2), o.data.V},
                                     all);
  }

  // The events in their order, then the return of z1, z2, z1'.
  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    const motion::MotionOf<T> m = motion<T>(x, p);
    const motion::PhaseOf<T>& last = m.phases.back();
    const model::Vector4<T>& Z0 = m.phases.front().Z;
    const model::Vector4<T> Z = motion::flow<T>(m.oscillator, last.kind, last.load, last.Z, last.duration);
    std::vector<T> f;
    for (std::size_t k = 0; k < m.phases.size(); ++k) {
      const std::size_t next = (k + 1) % m.phases.size();
      f.push_back(m.phases[k].kind == motion::PhaseKind::stick
                      ? T(motion::friction_ahead<T>(m, next) - p(p.size() - 1))
                      : T((&m.phases[k] == &last ? Z : m.phases[next].Z)(3) - m.oscillator.data.V));
    }
    f.insert(f.end(), {T(Z(0) - Z0(0)), T(Z(1) - Z0(1)), T(Z(2) - Z0(2))});
    return Eigen::Map<zeros::VectorOf<T>>(f.data(), static_cast<Eigen::Index>(f.size()));
  }

  // Throws InternalError when the motion has another number of phases.
  [[nodiscard]] zeros::Vector unknowns(const motion::Motion& motion) const {
    if (motion.phases.size() != phases.size()) {
      throw InternalError("a guess of " + std::to_string(motion.phases.size()) + " phases for " +
                          std::to_string(phases.size()));
    }
    const motion::Phase& first = motion.phases.front();
    zeros::Vector x(legs() + 4);
    for (int i = 0; i < legs(); ++i) {
      x(i) = motion.phases[static_cast<std::size_t>(i)].duration;
    }
    x.segment(legs(), 3) = first.Z.head<3>();
    x(legs() + 3) = first.load;
    return x;
  }

 private:
  [[nodiscard]] int legs() const { return static_cast<int>(phases.size()) - 1; }
};

// What a question about branches comes to: the orbits at one value, the friction law, the curves to follow.

// Throws as list_branches does.
void require_question(const BranchQuestion& question);

// The data with the free parameter at that value.
[[nodiscard]] motion::Given<Rational> data_at(const BranchQuestion& question, const Rational& value);

[[nodiscard]] families::StripQuestion strip_question(const BranchQuestion& question);

[[nodiscard]] Law law_of(const BranchQuestion& question);

[[nodiscard]] Curve curve_of(const BranchQuestion& question, const motion::Closing& equations);

// The integer multiple of the load's frequency that is nearest to a natural frequency, 1 (that of a stick)
// among them, in words, where it is next to it: why nothing more is known there. Else empty.
[[nodiscard]] std::string resonance_near(const Ball& value, const BranchQuestion& question);

// Branches of orbits through any phases: the question about them, as one about a family.

// Of the orbits of that word and over n periods that are among the known ones, at the machine's data and
// friction with the parameter at `at`. The durations are named t1, t2, … in the order of the word's letters.
[[nodiscard]] BranchQuestion word_question(const words::WordQuestion& machine, const words::Word& word,
                                           int periods, const std::vector<words::WordOrbit>& known);

// The closing conditions of its orbits, and of each a guess at `at`.
[[nodiscard]] std::vector<families::Candidate> word_candidates(const WordOrbits& word);

}  // namespace stickslip::numeric::branches
