// Claims of the paper proved: each identity with everything that its proof uses, but for the definitions,
// which are proved before; all symbolic claims and all claims from nothing. What is proved once is remembered
// for the life of the process, so each of these runs once; a figure is worth something when it is the only
// one of its process, as script/bench has it.
#include <benchmark/benchmark.h>

#include <set>
#include <string>
#include <vector>

#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace stickslip::bench {

using namespace proofs::methods;
using namespace proofs::symbols;

namespace {

using proofs::methods::Claim;
using Ids = std::set<std::string>;

void prove(benchmark::State& state, const std::vector<Claim>& claims, const Ids& ids) {
  for (auto _ : state) {
    for (const proofs::methods::Record& record : proofs::methods::audit(claims, ids).records) {
      if (!facts(record.status).decided) {
        state.SkipWithError(("not decided: " + record.claim.id).c_str());
      }
    }
  }
}

void identity(benchmark::State& state, const Ids& ids) {
  const std::vector<Claim> claims = proofs::pascal2012::paper().claims;
  proofs::methods::Prover prover(claims);
  for (const Claim& claim : claims) {
    if (claim.kind == proofs::methods::Kind::definition) {
      (void)prover.prove(claim.id);
    }
  }
  for (auto _ : state) {
    for (const std::string& id : ids) {
      if (!facts(prover.prove(id).status).decided) {
        state.SkipWithError(("not decided: " + id).c_str());
      }
    }
  }
}

void phase_of_35(benchmark::State& state) {
  prove(state, proofs::pascal2012::paper().claims, {"35"});
}

// Without the claims about the examples' numbers and about the families that rest on them.
void symbolic(benchmark::State& state) {
  const std::vector<Claim> claims = proofs::pascal2012::paper().claims;
  Ids ids;
  for (const Claim& claim : claims) {
    const bool of_example = std::string("SOP").find(claim.id.front()) != std::string::npos;
    if (!of_example && claim.place != "sec7") {
      ids.insert(claim.id);
    }
  }
  prove(state, claims, ids);
}

void everything(benchmark::State& state) {
  prove(state, proofs::pascal2012::paper().claims, {});
}

template <class Function>
void once(const std::string& name, const Function& function) {
  benchmark::RegisterBenchmark(name.c_str(), function)
      ->Iterations(1)
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  for (const char * id :
       {"40", "38.reversal", "38.group", "42", "41.reversal", "41.group", "59", "34.H", "70"}) {
    once(std::string("identity/") + id, [id](benchmark::State& state) { identity(state, {id}); });
  }
  once("identity/A3.d", [](benchmark::State& state) {
    identity(state, {"47.d", "48.d", "49.d", "50.d", "51.d"});
  });
  once("audit/35", phase_of_35);
  once("audit/symbolic", symbolic);
  once("audit/all", everything);
  return true;
}();

}  // namespace
}  // namespace stickslip::bench
