// What theorems on orbits say of a phase: definitions of the kernel, in the data as parameters.
#pragma once

#include "numeric/motion/motion.hpp"
#include "proofs/kernel/term.hpp"
#include "proofs/orbits/phases.hpp"

namespace stickslip::proofs::orbits {

inline const kernel::Type state_type = kernel::real_matrix(4, 1);  // (x1, x2, x1', x2')
inline const kernel::Type motion_type = kernel::function_of_time(4, 1);

// (4): chi (x2 - x1) - (p/eta) cos(omega t + phi), of a state x and the time t.
[[nodiscard]] const kernel::Definition& friction();

// slips, overshoots: (2) during (a, b) with u = us or -us, and x2' < V or x2' > V there; sticks: (9), x2' = V
// and |r| < ur from a on until b. Each motion is continuous on [a, b].
[[nodiscard]] const kernel::Definition& phase_definition(numeric::motion::PhaseKind kind);

// ---- Stability: how a small deviation of the state is carried along an orbit.

// varies_slipping, varies_sticking: Y is continuous on [0, d], Y(0) = I, and Y' = A Y during (0, d) with the
// A of (2), of (9): what the deviation at the beginning of a phase is multiplied by.
[[nodiscard]] const kernel::Definition& variation(numeric::motion::PhaseKind kind);
inline const kernel::Type variation_type = kernel::function_of_time(4, 4);
// dr/dt of (4) while the mass sticks, of a state x and the time t.
[[nodiscard]] const kernel::Definition& friction_rate();
// What a deviation is multiplied by where one phase ends and the next begins (model/saltation.hpp): crossing
// of the accelerations x2'' before and after; break_away of chi, x2'' after and dr/dt; landing of nothing.
[[nodiscard]] const kernel::Definition& crossing();
[[nodiscard]] const kernel::Definition& break_away();
[[nodiscard]] const kernel::Definition& landing();
// The coefficients c0 … c4 of det(z I - M), of a matrix M of four rows; c0 + c1 z + … + c4 z^4, of such a
// column and a number z.
[[nodiscard]] const kernel::Definition& characteristic();
[[nodiscard]] const kernel::Definition& polynomial_at();

// What an orbit theorem says of its phases, in the names that it declares: X1, X2, … for the motions, the
// names of the durations, phi and ur where they are results. The load's frequency is a letter, as in Phases.

// Refers to the question, which has to outlive it.
class Names {
 public:
  explicit Names(const Question& question) : q_(question) {}

  [[nodiscard]] kernel::Term chi() const { return q_.data.chi; }
  [[nodiscard]] kernel::Term eta() const { return q_.data.eta; }
  [[nodiscard]] kernel::Term us() const { return q_.data.us; }
  [[nodiscard]] kernel::Term V() const { return q_.data.V; }
  [[nodiscard]] const kernel::Variable& omega() const { return omega_; }
  [[nodiscard]] kernel::Term phi() const;
  [[nodiscard]] kernel::Term ur() const;
  [[nodiscard]] static kernel::Variable motion(std::size_t k);
  // The state in phase k at the time t.
  [[nodiscard]] static kernel::Term state(std::size_t k, const kernel::Term& t);
  // The friction at rest there.
  [[nodiscard]] kernel::Term friction_at(std::size_t k, const kernel::Term& t) const;
  // When a phase begins. When it ends: the last with the period.
  [[nodiscard]] kernel::Term start(std::size_t k) const { return start_of(q_, k); }
  [[nodiscard]] kernel::Term end(std::size_t k) const;

  // That phase k is of its kind, and the definitions in that.
  [[nodiscard]] kernel::Formula phase(std::size_t k) const;
  [[nodiscard]] kernel::Definitions definitions(std::size_t k) const;

 private:
  const Question& q_;
  kernel::Variable omega_{"omega"};
};

}  // namespace stickslip::proofs::orbits
