#include "numeric/families/symmetric.hpp"

#include <cmath>

#include "core/error.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

using model::Vector2;
using model::Vector4;

// C from the row whose left side is larger.
double amplitude(const model::SymmetricRows<double>& rows) {
  const int j = std::abs(rows.left(0)) > std::abs(rows.left(1)) ? 0 : 1;
  return rows.right(j) / rows.left(j);
}

// The residuals of the orbit in the paper's own terms, computed from the flows and not from the reduction.
void close_in_all_components(const ExactParameters& a, SymmetricOrbit& orbit) {
  const Equations16<Ball> sixteen = equations_16<Ball>(a, orbit.phase);
  const model::SymmetricData<Ball>& data = sixteen.data;
  const SymmetricState<Ball>& s = orbit.state;
  const Vector2<Ball> Q = sixteen.Q * data.sigma;
  const Vector4<Ball> Z0(s.z10, s.z20, s.zdot10, s.zdot20);
  const Vector4<Ball> EZ0(-s.z10, -s.z20, s.zdot10, s.zdot20);
  orbit.residual13 = model::slip_flow<Ball>(data.m, Q, data.omega, s.phi, Z0, s.tau) - EZ0;
  orbit.residual15 = Z0 - model::stick_flow<Ball>(data.chi, EZ0, s.T);
  orbit.residual16 = sixteen(Vector4<Ball>(s.tau, s.z10, s.z20, s.zdot10));
  for (const Vector4<Ball>& residual : {orbit.residual13, orbit.residual15, orbit.residual16}) {
    for (int i = 0; i < 4; ++i) {
      if (residual(i).is_nonzero()) {
        throw InternalError("a zero of the reduced equations of Section 4 does not close through the flows");
      }
    }
  }
}

}  // namespace

Motion motion_of(const ExactParameters& a, const SymmetricOrbit& orbit) {
  const WorkingPrecision scope(orbit.bits);
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
  const SymmetricState<Ball>& s = orbit.state;
  const Vector4<Ball> Z0(s.z10, s.z20, s.zdot10, s.zdot20);
  const Vector4<Ball> ZC(-s.z10, -s.z20, s.zdot10, s.zdot20);
  return {o,
          {{PhaseKind::slip, Ball(0), s.tau, s.phi, Z0},
           {PhaseKind::stick, s.tau, s.T, Ball(s.phi + o.data.omega * s.tau), ZC}}};
}

SymmetricOrbit describe_symmetric(const ExactParameters& a, LoadPhase phase, const Box<2>& tau_C) {
  SymmetricOrbit orbit;
  orbit.phase = phase;
  orbit.bits = WorkingPrecision::bits();
  orbit.state = symmetric_state<Ball>(a, phase, tau_C);
  close_in_all_components(a, orbit);
  return orbit;
}

std::vector<Vector2<double>> symmetric_guesses(const ExactParameters& a, LoadPhase phase) {
  const model::SymmetricData<double> data = symmetric_data<double>(a, phase);
  const SymmetricClosing<double> closing{data};
  const int steps = 32 + static_cast<int>(32 * data.Theta * (data.m.omega2 + data.omega));
  std::vector<Vector2<double>> guesses;
  double before = model::symmetric_eliminant(data, 0.0);
  for (int i = 1; i <= steps; ++i) {
    const double tau = data.Theta * i / steps;
    const double here = model::symmetric_eliminant(data, tau);
    if (before * here < 0) {
      const double middle = tau - data.Theta / steps * std::abs(here) / (std::abs(here) + std::abs(before));
      const double C = amplitude(model::symmetric_rows(data, middle));
      if (const auto zero = newton<double, 2>(closing, Vector2<double>(middle, C), 20)) {
        guesses.push_back(*zero);
      }
    }
    before = here;
  }
  return guesses;
}

SymmetricProof prove_symmetric(const ExactParameters& a, LoadPhase phase, const Vector2<double>& guess,
                               int digits) {
  require_stick_slip_domain(a);
  const auto recipe = [&] { return SymmetricClosing<Ball>{symmetric_data<Ball>(a, phase)}; };
  ZeroProof<2> zero;
  {
    const WorkingPrecision scope(128);
    zero = prove_zero_near<2>(recipe(), Box<2>(Ball(guess(0)), Ball(guess(1))));
  }
  if (zero.verdict.truth != Truth::proved) {
    return {zero.verdict, {}};
  }
  const WorkingPrecision scope(bits_for(digits) + 64);
  SymmetricProof proof{zero.verdict,
                       describe_symmetric(a, phase, refine<2>(recipe, zero.box, bits_for(digits)))};
  proof.orbit.tau_unique = zero.unique(0);
  proof.orbit.C_unique = zero.unique(1);
  return proof;
}

std::vector<SymmetricProof> solve_symmetric(const ExactParameters& a, int digits) {
  require_stick_slip_domain(a);
  std::vector<SymmetricProof> proofs;
  for (const LoadPhase phase : {LoadPhase::first, LoadPhase::second}) {
    for (const Vector2<double>& guess : symmetric_guesses(a, phase)) {
      proofs.push_back(prove_symmetric(a, phase, guess, digits));
    }
  }
  return proofs;
}

PrintedZero printed_zero_of_16(const ExactParameters& a, LoadPhase phase,
                               const std::array<Decimal, 4>& printed) {
  require_stick_slip_domain(a);
  const Equations16<Ball> f = equations_16<Ball>(a, phase);
  Box<4> point;
  Box<4> interval;
  for (int i = 0; i < 4; ++i) {
    const Decimal& decimal = printed[static_cast<std::size_t>(i)];
    point(i) = Ball(decimal.value);
    interval(i) = printed_interval(decimal);
  }
  return {f(point), f(interval), krawczyk_test<4>(f, interval).verdict};
}

}  // namespace stickslip::numeric::families
