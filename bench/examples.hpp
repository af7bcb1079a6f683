// The paper's examples as starting points of the benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric_list.hpp"
#include "proofs/pascal2012/examples.hpp"

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

[[nodiscard]] inline const numeric::motion::ExactParameters& data(const char * example) {
  return proofs::pascal2012::example_named(example).data;
}

// (tau, C) of Fig. 2, (tau, tau1) of Fig. 3, (delta, mu) of Fig. 4: to the accuracy of a double.
[[nodiscard]] inline Guess guess_S() {
  static const numeric::families::SymmetricState<Ball> s =
      numeric::families::list_symmetric(data("S"), 20).orbits.at(1).state;
  return {s.tau.approximate(), s.C.approximate()};
}
[[nodiscard]] inline Guess guess_O() {
  static const numeric::families::OvershootingList list =
      numeric::families::list_overshooting_at_phase(data("O"), 0, 20);
  for (const numeric::families::OvershootingOrbit& orbit : list.orbits) {
    if ((orbit.state.tau - Ball(4.9)).is_positive() && (orbit.state.tau - Ball(5)).is_negative()) {
      return {orbit.state.tau.approximate(), orbit.state.tau1.approximate()};
    }
  }
  throw std::logic_error("example O is not in its list");
}
[[nodiscard]] inline Guess guess_P() {
  static const numeric::families::NonstickingOrbit orbit =
      numeric::families::list_nonsticking(data("P"), 20).orbits.at(0);
  return {orbit.box(0).approximate(), orbit.box(1).approximate()};
}

// The three orbits, proved.
[[nodiscard]] inline numeric::families::SymmetricOrbit orbit_S(const Guess& guess, int digits) {
  const numeric::families::SymmetricProof proof =
      numeric::families::prove_symmetric(data("S"), numeric::families::LoadPhase::first, guess, digits);
  require_proved(proof.existence);
  return proof.orbit;
}
[[nodiscard]] inline numeric::families::OvershootingOrbit orbit_O(const Guess& guess, int digits) {
  const numeric::families::OvershootingProof proof =
      numeric::families::prove_overshooting_at_phase(data("O"), 0, guess, digits);
  require_proved(proof.existence);
  return proof.orbit;
}
[[nodiscard]] inline numeric::families::NonstickingOrbit orbit_P(const Guess& guess, int digits) {
  const numeric::families::NonstickingProof proof =
      numeric::families::prove_nonsticking(data("P"), guess, digits);
  require_proved(proof.existence);
  return proof.orbit;
}

}  // namespace stickslip::bench
