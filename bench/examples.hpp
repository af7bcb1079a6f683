// The paper's examples as starting points of the benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <stdexcept>
#include <string>

#include "numeric/families/family.hpp"
#include "numeric/orbits.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

namespace stickslip::bench {

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

// Registers "WHAT_S", "WHAT_O" and "WHAT_P", each of the example of that name.
template <class Run>
bool of_each_example(const std::string& what, const Run& run,
                     void (*set_up)(benchmark::internal::Benchmark *)) {
  for (const char * example : {"S", "O", "P"}) {
    benchmark::RegisterBenchmark((what + "_" + example).c_str(), [=](benchmark::State& state) {
      run(state, example);
    })->Apply(set_up);
  }
  return true;
}
inline void in_microseconds(benchmark::internal::Benchmark * b) {
  b->Unit(benchmark::kMicrosecond);
}
// Of all threads together.
inline void in_milliseconds(benchmark::internal::Benchmark * b) {
  b->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}
inline void in_seconds(benchmark::internal::Benchmark * b) {
  b->Unit(benchmark::kSecond)->MeasureProcessCPUTime();
}

[[nodiscard]] inline const numeric::motion::ExactParameters& data(const char * example) {
  return proofs::pascal2012::example_named(example).data;
}

// An example's closing conditions and its motion, to the accuracy of a double: what its proof starts from.
struct Problem {
  const numeric::Family& family;
  numeric::motion::Closing equations;
  numeric::motion::Given<Rational> given;
  numeric::motion::Motion guess;
};

[[nodiscard]] inline Problem problem(const char * name) {
  const proofs::methods::Example& example = proofs::pascal2012::example_named(name);
  const numeric::motion::Given<Rational> given{example.data, example.phi, {}};
  const auto printed = example.results.front();  // tau, or for P Theta, which all orbits have
  for (const numeric::families::Candidate& candidate : example.family->search(given).candidates) {
    const Ball& tau = candidate.where.front().value;
    if (printed.name != "tau" || (abs(tau - Ball(printed.value.value)) - Ball(0.1)).is_negative()) {
      Problem found{*example.family, candidate.equations, given, candidate.guess};
      for (numeric::motion::Phase& phase : found.guess.phases) {
        phase.duration = Ball(phase.duration.approximate());
        phase.load = Ball(phase.load.approximate());
        phase.Z = phase.Z.unaryExpr([](const Ball& x) { return Ball(x.approximate()); });
      }
      return found;
    }
  }
  throw std::logic_error(std::string("example ") + name + " is not in its list");
}

// The orbit, proved.
[[nodiscard]] inline numeric::motion::ClosedMotion proved(const Problem& s, int digits) {
  numeric::motion::ClosedMotion closed = numeric::motion::prove_closed(s.equations, s.given, s.guess, digits);
  require_proved(closed.existence);
  return closed;
}
// Those over a whole box of parameters.
[[nodiscard]] inline numeric::motion::ClosedMotion proved_over(const Problem& s,
                                                               const numeric::motion::Given<Ball>& box) {
  const numeric::motion::Closing& f = s.equations;
  const auto proof = numeric::zeros::prove_over_parameters(f, f.parameters(box), f.unknowns(s.guess));
  require_proved(proof.verdict);
  return numeric::motion::closed_over(proof, f.motion<numeric::zeros::ParameterJet>(proof.x, proof.p),
                                      f.motion<Ball>(proof.at_middle, proof.p0));
}

}  // namespace stickslip::bench
