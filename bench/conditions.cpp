// All conditions along one proved orbit, for all times.
#include "numeric/motion/conditions.hpp"

#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace proofs::pascal2012;

namespace {

constexpr int digits = 30;

void decide_all(benchmark::State& state, const char * example) {
  const Problem s = problem(example);
  const ClosedMotion closed = proved(s, digits);
  const std::optional<Rational>& given = example_named(example).ur;
  const Ball ur = given ? Ball(*given) : friction_of(s.family, closed);
  for (auto _ : state) {
    const std::vector<Condition> all = families::conditions(s.family, closed, ur);
    require_proved(state, admissible(all));
  }
}

[[maybe_unused]] const bool registered = of_each_example("conditions", decide_all, in_microseconds);

}  // namespace
}  // namespace stickslip::bench
