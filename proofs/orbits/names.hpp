// What an orbit theorem says of its phases, in the names that it declares: X1, X2, … for the motions, the
// names of the durations, phi and ur where they are results. The load's frequency is a letter, as in Phases.
#pragma once

#include "proofs/orbits/phases.hpp"

namespace stickslip::proofs::orbits {

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
  // The sum of the first durations: when a phase begins. When it ends: the last with the period.
  [[nodiscard]] kernel::Term start(std::size_t k) const;
  [[nodiscard]] kernel::Term end(std::size_t k) const;

  // That phase k is of its kind, and the definitions in that.
  [[nodiscard]] kernel::Formula phase(std::size_t k) const;
  [[nodiscard]] kernel::Definitions definitions(std::size_t k) const;

 private:
  const Question& q_;
  kernel::Variable omega_{"omega"};
};

}  // namespace stickslip::proofs::orbits
