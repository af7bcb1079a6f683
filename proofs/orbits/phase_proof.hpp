// What is true of one phase of an orbit in closed form. The theorems' hypotheses are that equations of Phases
// hold, and the ranges of the unknowns.
#pragma once

#include "proofs/orbits/along.hpp"
#include "proofs/orbits/phases.hpp"

namespace stickslip::proofs::orbits {

// The equation of this number, assumed.
[[nodiscard]] kernel::Theorem equation(const Phases& phases, std::size_t i);
// The theorem's inequality in another form of its sides.
[[nodiscard]] kernel::Theorem as(const kernel::Formula& inequality, const kernel::Theorem& theorem);
// That the wave is the bound at the end of a stick, the friction r or -r and ur: by the equation that says so
// where ur is given.
[[nodiscard]] std::vector<kernel::Multiple> ends_at_ur(const Phases& phases, std::size_t k, int sign);

class PhaseProof {
 public:
  // Refers to phases and ranges. ur is its value in the unknowns.
  PhaseProof(const Phases& phases, const Ranges& ranges, std::size_t k, const kernel::Term& ur)
      : phases_(phases), ranges_(ranges), k_(k), ur_(ur) {}

  // x2' = V at the beginning of a phase that slips.
  [[nodiscard]] kernel::Theorem meets_belt_at_start() const;
  // ⊢ the derivative at t, by (2) or (9).
  [[nodiscard]] kernel::Theorem obeys(const kernel::Variable& t, const kernel::Formula& rate) const;
  // x2' < V or V < x2' inside.
  [[nodiscard]] kernel::Theorem beside_belt(const kernel::Variable& t, const kernel::Formula& inside,
                                            const kernel::Formula& goal) const;
  // x2' = V, -ur < r, r < ur inside; which of these r reaches at the end.
  [[nodiscard]] kernel::Theorem held(const kernel::Variable& t, const kernel::Formula& inside,
                                     const kernel::Formula& goal, bool slips_next) const;

 private:
  [[nodiscard]] kernel::Theorem meets_belt_at_end() const;
  [[nodiscard]] kernel::Term speed(const kernel::Term& s) const;
  [[nodiscard]] kernel::Theorem at_time(const kernel::Variable& s, const kernel::Variable& t,
                                        const kernel::Theorem& theorem, const kernel::Formula& inside) const;

  const Phases& phases_;
  const Ranges& ranges_;
  std::size_t k_;
  kernel::Term ur_;
};

}  // namespace stickslip::proofs::orbits
