// 10,000 random starts in each of some proved neighbourhoods: none leaves, all converge.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/numeric/families/random_data.hpp"
#include "tests/numeric/machines/neighbourhoods.hpp"
#include "tests/numeric/machines/one_mass.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;

namespace {

constexpr int starts = 10000;
// Of these the last ones end nearer than this, in parts of the set; what is lost to rounding in double.
constexpr double arrived = 1e-2, rounding = 1e-11;

// examples/machines/stribeck.toml.
Machine stribeck() {
  model::FrictionLaw<Rational> law{Rational(1), {}};
  for (const auto& [from, force] :
       {std::pair(0, 9000), std::pair(200, 7680), std::pair(400, 6797), std::pair(700, 5986),
        std::pair(1000, 5541), std::pair(1500, 5199), std::pair(2000, 5073), std::pair(3000, 5010)}) {
    law.sliding.push_back({Rational(from) / 1000, Rational(force) / 10000, Rational(0)});
  }
  for (std::size_t i = 0; i + 1 < law.sliding.size(); ++i) {
    auto &piece = law.sliding[i], &next = law.sliding[i + 1];
    piece.slope = (next.force - piece.force) / (next.from - piece.from);
  }
  return one_mass(Rational(13, 10), law);
}

// The next return to where the starts lie; nothing when there is none.
std::optional<Eigen::VectorXd> returned(const model::FrictionOscillator<double>& o, const MachineOrbit& orbit,
                                        const Neighbourhood& n, const Eigen::VectorXd& X,
                                        Simulation& simulation) {
  simulation.restart(o.omega * n.time, X);
  if (!n.before) {
    simulation.advance(simulation.period() * static_cast<double>(orbit.periods));
    return simulation.state();
  }
  std::vector<Simulation::Transition> log;
  simulation.advance(2 * n.period, &log);
  std::optional<Piece> before = n.piece;
  for (const MachineGuess::Event& event : events_of(o, log, 0)) {
    if (before == n.before && event.begins == n.piece) {
      return event.X;
    }
    before = event.begins;
  }
  return std::nullopt;
}

// An orbit with that many periods of the load, or without one any, from random starts.
MachineOrbit orbit_of(const Machine& machine, long periods, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int k = 0; k < 1000; ++k) {
    Eigen::VectorXd X(static_cast<Eigen::Index>(2 * machine.oscillator.size()));
    for (double& x : X) {
      x = uniform(engine);
    }
    const Settled end = settle(machine, X);
    if (end.kind == attractors::Kind::periodic && (periods == 0 || end.guess.periods == periods)) {
      return prove_machine_orbit(machine, end.guess);
    }
  }
  FAIL("no such orbit is met");
  return {};
}

void check_all_converge(const Machine& machine, long periods, int most_returns) {
  std::mt19937_64 engine(RandomData().seed());
  const MachineOrbit orbit = orbit_of(machine, periods, engine);
  const Neighbourhood n = neighbourhood_of(machine, orbit);
  CAPTURE(n.verdict.reason);
  REQUIRE(n.verdict.truth == Truth::proved);
  const auto o = oscillator_as<double>(machine);
  double narrowest = n.half_widths.maxCoeff();
  for (const double half : n.alone) {
    narrowest = half > 0 ? std::min(narrowest, half) : narrowest;
  }
  const double lost = rounding / narrowest;
  Simulation simulation(o, o.omega * n.time, zeros::in_double(n.centre));
  std::uniform_real_distribution<double> uniform(0, 1);
  long away = 0, late = 0, leaving = 0, slowest = 0;
  for (int k = 0; k < starts; ++k) {
    const double share = std::pow(uniform(engine), 1.0 / static_cast<double>(n.S.cols()));
    std::optional<Eigen::VectorXd> X = member(n, 0.9999 * share * n.radius, engine);
    double now = place(n, *X);
    int returns = 0;
    for (; X && returns < most_returns && now >= std::max(arrived, lost); ++returns) {
      X = returned(o, orbit, n, *X, simulation);
      const double before = std::exchange(now, X ? place(n, *X) : 2);
      away += now < before + lost ? 0 : 1;
      leaving += now < 1 ? 0 : 1;
    }
    late += now < std::max(arrived, lost) ? 0 : 1;
    slowest = std::max<long>(slowest, returns);
  }
  MESSAGE(starts, " starts, half widths ", n.half_widths.transpose(), ", all arrived after ", slowest,
          " returns");
  CHECK(away == 0);
  CHECK(leaving == 0);
  CHECK(late == 0);
}

}  // namespace

TEST_CASE("all of 10,000 starts in the neighbourhood of O, damped and not, converge") {
  check_all_converge(with_damping(O(), Rational("45899365993320057/100000000000000000")), 1, 200);
  check_all_converge(damped_O(), 1, 200);
}

TEST_CASE("all of 10,000 starts in the neighbourhood of P's orbit of period 3 converge") {
  check_all_converge(P_with_period_3(), 3, 100);
}

TEST_CASE("all of 10,000 starts in the neighbourhood of S's orbit of period 182 converge") {
  check_all_converge(with_damping(S(), parse_rational("0.16096526517987741")), 182, 100);
}

TEST_CASE("all of 10,000 starts in the neighbourhood of the Stribeck cycle converge") {
  check_all_converge(stribeck(), 0, 20);
}
