// Lists of words and proofs of long ones, and how many periods of a machine are followed in a second.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"
#include "numeric/attractors/attractors.hpp"
#include "numeric/machines/orbits/chain_proof.hpp"
#include "numeric/words/complete_list.hpp"

namespace stickslip::bench {

using namespace numeric;
using namespace numeric::words;

namespace {

WordQuestion question(const char * example, const char * ur) {
  return {data(example), parse_rational(ur), 20};
}
WordQuestion S() {
  return question("S", "0.16096526517987742");
}
WordQuestion O() {
  return question("O", "0.45899365993320057");
}
WordQuestion P() {
  return question("P", "0.2996");
}
WordQuestion driven() {
  return {motion::parse_parameters("0.4", "10", "0.2", "1", "0.7", "2"), parse_rational("0.5"), 20};
}

void list_word(benchmark::State& state, const WordQuestion& q, const char * word) {
  long cells = 0;
  for (auto _ : state) {
    const WordList list = all_orbits(q, Word::parse(word), 1);
    if (!list.unresolved.empty()) {
      state.SkipWithError("the list is not complete");
      break;
    }
    cells = list.cells;
  }
  state.counters["cells"] = static_cast<double>(cells);
}
BENCHMARK_CAPTURE(list_word, ST_S, S(), "ST")->Apply(in_milliseconds);
BENCHMARK_CAPTURE(list_word, SOT_S, S(), "SOT")->Apply(in_milliseconds);
BENCHMARK_CAPTURE(list_word, SOT_O, O(), "SOT")->Apply(in_milliseconds);
BENCHMARK_CAPTURE(list_word, SOT_P, P(), "SOT")->Apply(in_milliseconds);
BENCHMARK_CAPTURE(list_word, SOT_driven, driven(), "SOT")->Apply(in_milliseconds);
BENCHMARK_CAPTURE(list_word, STST_S, S(), "STST")->Apply(in_seconds)->Iterations(1);
BENCHMARK_CAPTURE(list_word, SOST_O, O(), "SOST")->Apply(in_seconds)->Iterations(1);

// The nodes of what the motion from there settles on, as near as doubles are.
struct Closed {
  machines::MachineQuestion question;
  machines::Nodes nodes;
};
Closed closed(const WordQuestion& q, const model::Vector4<double>& from, long periods) {
  const attractors::Attractor found = attractors::find_attractor(q, from);
  if (!found.orbit || found.periods != periods) {
    throw std::logic_error("the motion settles on something else");
  }
  require_proved(found.orbit->existence);
  Closed result{{{model::friction_oscillator<Rational>(q.data, q.ur)}, {}, periods}, {}};
  const motion::Motion& m = found.orbit->orbit.motion;
  const model::Vector2<Ball>& d0 = m.oscillator.d0;
  for (const motion::Phase& phase : m.phases) {
    const Ball t = m.phases.front().load / m.oscillator.data.omega + phase.start;
    machines::Node at(4);
    at << t, phase.Z(0) + d0(0), phase.Z(1) + d0(1), phase.Z(2);
    result.question.pieces.push_back({phase.kind});
    result.nodes.push_back(at.unaryExpr([](const Ball& x) { return Ball(x.approximate()); }));
  }
  return result;
}

void prove_existence(benchmark::State& state, const WordQuestion& q, const model::Vector4<double>& from,
                     long periods) {
  const Closed chain = closed(q, from, periods);
  for (auto _ : state) {
    require_proved(state, prove_chain(chain.question, chain.nodes, 64, 4096).verdict);
  }
  state.counters["phases"] = static_cast<double>(chain.nodes.size());
}

// With as many bits as that takes.
void prove_stability(benchmark::State& state, const WordQuestion& q, const model::Vector4<double>& from,
                     long periods) {
  const Closed chain = closed(q, from, periods);
  long bits = 0;
  for (auto _ : state) {
    auto kind = motion::StabilityKind::undecided;
    for (bits = 128; bits <= 16384 && kind == motion::StabilityKind::undecided; bits *= 4) {
      const machines::ChainProof proof = prove_chain(chain.question, chain.nodes, bits, bits);
      if (proof.verdict.truth == Truth::proved) {
        const WorkingPrecision scope(bits);
        kind = motion::stability_of(proof.return_map, true).kind;
      }
    }
    if (kind != motion::StabilityKind::stable) {
      state.SkipWithError("not proved to be stable");
    }
  }
  state.counters["bits"] = static_cast<double>(bits / 4);
}

const model::Vector4<double> to_3(1.453864542, 3.090387503, 0.4566110742, 1.16512107);
const model::Vector4<double> to_13(1.356516811, 2.998053712, 0.438424421, 0.8192487201);
const model::Vector4<double> to_182(0.5042730812, 0.8854186694, 0.4699546208, 0.6955831316);
BENCHMARK_CAPTURE(prove_existence, P_3, P(), to_3, 3)->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_existence, P_13, P(), to_13, 13)->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_existence, S_182, S(), to_182, 182)->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_stability, P_3, P(), to_3, 3)->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_stability, P_13, P(), to_13, 13)->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_stability, S_182, S(), to_182, 182)->Apply(in_milliseconds);

// 500 starts for 2,000 periods or until they have settled, everything proved; items are periods of the load.
void attractors_of(benchmark::State& state, const WordQuestion& q) {
  std::int64_t periods = 0;
  for (auto _ : state) {
    periods += attractors::find_attractors({q, 500, 1, 2000}).simulated;
  }
  state.SetItemsProcessed(periods);
}
BENCHMARK_CAPTURE(attractors_of, S, S())->Apply(in_seconds);
BENCHMARK_CAPTURE(attractors_of, O, O())->Apply(in_seconds);
BENCHMARK_CAPTURE(attractors_of, P, P())->Apply(in_seconds);

}  // namespace
}  // namespace stickslip::bench
