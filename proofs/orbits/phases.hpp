// The phases of an orbit in closed form, as terms of the kernel: x and the friction at rest as sums of
// harmonics whose amplitudes are unknown, and the equations that say that the phases fit together.
//
// Unknown are omega1, omega2 of (39), the amplitudes of each phase, the durations of all phases but the last,
// and the load's phase where it is not given. The last phase lasts until the period is over. The load's
// frequency is a letter, omega, too, of which only a value is known: as a number it would make cos(omega t)
// and cos(t) multiples of one phase.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/waves.hpp"
#include "numeric/orbits.hpp"
#include "proofs/kernel/term.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::orbits {

using numeric::motion::PhaseKind;

// What is known of an orbit: its data and its phases in their order, from the beginning of the first.
struct Question {
  model::Parameters<Rational> data;
  std::vector<PhaseKind> phases;
  std::vector<std::string> durations;  // their names
  int period = 1;                      // in periods of the load
  std::optional<Rational> phi = {};
  std::optional<Rational> ur = {};  // of orbits that stick, a result where it is not given
  // phi = (pi - omega tau)/2 and so many times pi more, tau the first duration.
  std::optional<int> lag = {};
};

// Of an orbit of a family at exact data: where neither phi nor ur may be given phi is the time lag, or that
// and pi, whichever is nearer.
[[nodiscard]] Question question_of(const numeric::OrbitQuestion& question,
                                   const numeric::motion::Motion& nearly);

// When phase k begins: the sum of the durations before it, by their names.
[[nodiscard]] kernel::Term start_of(const Question& question, std::size_t k);

// x1, x2 and the friction at rest r of (4) as functions of the time since a phase began.
struct Waves {
  model::Wave<tactics::Symbolic> x1, x2, r;
};

// A rational number near the ball's middle: a multiple of 2^-60.
[[nodiscard]] Rational near(const Ball& ball);

[[nodiscard]] kernel::Term value(const model::Wave<tactics::Symbolic>& wave, const kernel::Term& t);

class Phases {
 public:
  // Throws KernelError where omega is omega1 or omega2: then (7) has no Q; and where what is given is too
  // much or too little for these phases.
  explicit Phases(Question question);

  [[nodiscard]] const Question& question() const { return question_; }
  [[nodiscard]] std::size_t count() const { return question_.phases.size(); }
  [[nodiscard]] const std::vector<kernel::Variable>& unknowns() const { return unknowns_; }
  [[nodiscard]] const Waves& waves(std::size_t k) const { return waves_.at(k); }
  // When a phase begins, and how long it lasts.
  [[nodiscard]] kernel::Term start(std::size_t k) const { return start_of(question_, k); }
  [[nodiscard]] const kernel::Term& duration(std::size_t k) const { return durations_.at(k); }
  [[nodiscard]] const kernel::Term& phi() const { return *phi_; }
  [[nodiscard]] const kernel::Variable& omega() const { return omega_; }
  [[nodiscard]] const kernel::Term& period() const { return *period_; }
  // (x1, x2, x1', x2') at the time s after phase k began.
  [[nodiscard]] kernel::Term state(std::size_t k, const kernel::Term& s) const;
  // The mode j = 0, 1 of a phase that slips, at that time.
  [[nodiscard]] kernel::Term mode(std::size_t k, std::size_t j, const kernel::Term& s) const;
  // The load's part of x1, with amplitude 1, of any phase: cos(omega (start + s) + phi).
  [[nodiscard]] kernel::Term load(std::size_t k, const kernel::Term& s) const;
  // The amplitudes q1, q2 of (7).
  [[nodiscard]] const std::array<Rational, 2>& Q() const { return Q_; }
  // omega_j^4 - (1 + chi eta) omega_j^2 + chi eta (1 - chi), which (39) says is zero.
  [[nodiscard]] kernel::Term characteristic(std::size_t j) const;

  // All that is to vanish, as many terms as unknowns: the characteristic polynomial of omega1 and omega2; of
  // each phase in turn its end minus the beginning of the next, then x2' - V at the end of one that slips
  // where the next one does too; r - ur (or r + ur) at the end of a stick where ur is given and phi is not.
  [[nodiscard]] const std::vector<kernel::Term>& equations() const { return equations_; }
  // The first of the four rows at the end of phase k; and of x2' - V there.
  [[nodiscard]] std::size_t fitting(std::size_t k) const { return fitting_.at(k); }
  [[nodiscard]] std::optional<std::size_t> crossing(std::size_t k) const { return crossing_.at(k); }

  // Values of the unknowns, nearly, from a motion of these phases in balls.
  [[nodiscard]] std::vector<Rational> near(const numeric::motion::Motion& motion) const;

 private:
  kernel::Term unknown(const std::string& name);
  [[nodiscard]] kernel::Term time_lag(int turns) const;
  void add_phase(std::size_t k);
  void add_equations();

  Question question_;
  kernel::Variable omega_{"omega"};
  std::array<Rational, 2> Q_;
  std::vector<kernel::Variable> unknowns_;
  std::vector<kernel::Term> durations_;
  std::optional<kernel::Term> phi_, period_;
  std::vector<Waves> waves_;
  std::vector<kernel::Term> equations_;
  std::vector<std::size_t> fitting_;
  std::vector<std::optional<std::size_t>> crossing_;
};

}  // namespace stickslip::proofs::orbits
