// The paper's examples as starting points of the benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "numeric/examples.hpp"
#include "numeric/nonsticking.hpp"
#include "numeric/overshooting.hpp"
#include "numeric/symmetric_list.hpp"

namespace stickslip::bench {

using Guess = model::Vector2<double>;

// What is not proved is not worth measuring.
inline void require_proved(const Verdict& verdict) {
  if (verdict.truth != Truth::proved) {
    throw std::logic_error("an orbit to start from is not proved: " + verdict.reason);
  }
}
// Ends the benchmark with the reason instead of a figure.
inline void require_proved(benchmark::State& state, const Verdict& verdict) {
  if (verdict.truth != Truth::proved) {
    state.SkipWithError(("not proved: " + verdict.reason).c_str());
  }
}

[[nodiscard]] inline const ExactParameters& data(const char* example) {
  return example_named(example).data;
}

// (tau, C) of Fig. 2, (tau, tau1) of Fig. 3, (delta, mu) of Fig. 4: to the accuracy of a double.
[[nodiscard]] inline Guess guess_S() {
  static const SymmetricState<Ball> s = list_symmetric(data("S"), 20).orbits.at(1).state;
  return {s.tau.approximate(), s.C.approximate()};
}
[[nodiscard]] inline Guess guess_O() {
  static const OvershootingList list = list_overshooting_at_phase(data("O"), 0, 20);
  for (const OvershootingOrbit& orbit : list.orbits) {
    if ((orbit.state.tau - Ball(4.9)).is_positive() && (orbit.state.tau - Ball(5)).is_negative()) {
      return {orbit.state.tau.approximate(), orbit.state.tau1.approximate()};
    }
  }
  throw std::logic_error("example O is not in its list");
}
[[nodiscard]] inline Guess guess_P() {
  static const NonstickingOrbit orbit = list_nonsticking(data("P"), 20).orbits.at(0);
  return {orbit.box(0).approximate(), orbit.box(1).approximate()};
}

// The three orbits, proved.
[[nodiscard]] inline SymmetricOrbit orbit_S(const Guess& guess, int digits) {
  const SymmetricProof proof = prove_symmetric(data("S"), LoadPhase::first, guess, digits);
  require_proved(proof.existence);
  return proof.orbit;
}
[[nodiscard]] inline OvershootingOrbit orbit_O(const Guess& guess, int digits) {
  const OvershootingProof proof = prove_overshooting_at_phase(data("O"), 0, guess, digits);
  require_proved(proof.existence);
  return proof.orbit;
}
[[nodiscard]] inline NonstickingOrbit orbit_P(const Guess& guess, int digits) {
  const NonstickingProof proof = prove_nonsticking(data("P"), guess, digits);
  require_proved(proof.existence);
  return proof.orbit;
}

}  // namespace stickslip::bench
