// How an attack is told: a call that a rule must refuse with a sentence.
#pragma once

#include <doctest/doctest.h>

#include "proofs/tactics/tactics.hpp"
#include "tests/proofs/kernel/paper.hpp"

namespace stickslip::proofs::kernel {

// Whether making it throws KernelError, and says why.
template <class Attack>
[[nodiscard]] bool refuses(const Attack& attack) {
  try {
    attack();
  } catch (const KernelError& error) {
    return std::string(error.what()).find(' ') != std::string::npos;
  }
  return false;
}

// Γ ⊢ C gives Γ, Δ ⊢ C.
[[nodiscard]] inline Theorem weakened(const Theorem& theorem, const Formulas& more) {
  std::vector<Theorem> premises{theorem};
  for (const Formula& hypothesis : more) {
    premises.push_back(Theorem::assume(hypothesis));
  }
  return Theorem::consequence(premises, theorem.conclusion());
}

}  // namespace stickslip::proofs::kernel

#define REFUSES(...) CHECK(refuses([&] { static_cast<void>(__VA_ARGS__); }))
