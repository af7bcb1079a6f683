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

}  // namespace stickslip::proofs::kernel

#define REFUSES(...) CHECK(refuses([&] { static_cast<void>(__VA_ARGS__); }))
