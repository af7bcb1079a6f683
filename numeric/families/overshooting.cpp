#include "numeric/families/overshooting.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "model/symmetric.hpp"

namespace stickslip::numeric::families {

using namespace motion;

namespace {

// The motion from Z0 through the three phases.
struct Flight {
  model::Vector4<Ball> ZB, ZC, end;  // at tau, at tau + tau1, at tau + tau1 + T
};

Flight fly(const model::OvershootingData<Ball>& d, const Ball& phi, const Ball& tau, const Ball& tau1,
           const Ball& T, const model::Vector4<Ball>& Z0) {
  const model::Parameters<Ball> b{d.chi, d.eta, d.us, d.V, d.omega, d.p};
  const model::Vector2<Ball> Q = model::Q<Ball>(b, d.m);
  const model::Vector2<Ball> d0 = model::d0<Ball>(d.chi, d.us);
  Flight flight;
  flight.ZB = model::slip_flow<Ball>(d.m, Q, d.omega, phi, Z0, tau);
  const Ball phi_B = phi + d.omega * tau;
  flight.ZC = model::overshoot_flow<Ball>(d.m, Q, d0, d.omega, phi_B, flight.ZB, tau1);
  flight.end = model::stick_flow<Ball>(d.chi, flight.ZC, T);
  return flight;
}

}  // namespace

OvershootingOrbit describe_overshooting(const ExactParameters& a, const Ball& tau, const Ball& tau1,
                                        const StickAmplitudes& amplitude) {
  using model::Vector2;
  using model::Vector4;
  const model::OvershootingData<Ball> d = overshooting_data<Ball>(a);
  const Vector2<Ball> d0 = model::d0<Ball>(d.chi, d.us);
  const Ball& phi = amplitude.phi;
  const Ball T = d.Theta - tau - tau1;
  const Vector4<Ball> Z0 = model::overshooting_start<Ball>(d, T, amplitude.a, amplitude.C, amplitude.D);
  const Flight flight = fly(d, phi, tau, tau1, T, Z0);
  OvershootingOrbit orbit;
  orbit.state = {tau,
                 tau1,
                 T,
                 d.Theta,
                 phi,
                 Z0(0),
                 Z0(1),
                 Z0(2),
                 Z0(3),
                 Z0(0) + d0(0),
                 Z0(1) + d0(1),
                 model::friction_at_rest<Ball>(parameters_as<Ball>(a), Vector2<Ball>(Z0(0), Z0(1)), phi)};
  orbit.bits = WorkingPrecision::bits();
  orbit.residual20 = flight.end - Z0;
  orbit.residual18 = flight.ZB(3) - d.V;
  orbit.residual19 = flight.ZC(3) - d.V;
  for (const Ball& residual : {orbit.residual20(0), orbit.residual20(1), orbit.residual20(2),
                               orbit.residual20(3), orbit.residual18, orbit.residual19}) {
    if (residual.is_nonzero()) {
      throw InternalError("a zero of the reduced equations of Section 5 does not close through the flows");
    }
  }
  return orbit;
}

Motion motion_of(const ExactParameters& a, const OvershootingOrbit& orbit) {
  const WorkingPrecision scope(orbit.bits);
  const OvershootingState<Ball>& s = orbit.state;
  return compose(model::oscillator<Ball>(parameters_as<Ball>(a)), s.phi, {s.z10, s.z20, s.zdot10, s.zdot20},
                 {{PhaseKind::slip, s.tau}, {PhaseKind::overshoot, s.tau1}, {PhaseKind::stick, s.T}});
}

PrintedClosing printed_closing_overshooting(const ExactParameters& a, const Rational& phi,
                                            const std::array<Decimal, 5>& printed) {
  require_stick_slip_domain(a);
  const model::OvershootingData<Ball> d = overshooting_data<Ball>(a);
  const auto residuals = [&](const std::array<Ball, 5>& x) -> std::array<Ball, 5> {
    const model::Vector4<Ball> Z0(x[2], x[3], x[4], d.V);
    const Flight flight = fly(d, Ball(phi), x[0], x[1], d.Theta - x[0] - x[1], Z0);
    const model::Vector4<Ball> gap = flight.end - Z0;
    return {flight.ZB(3) - d.V, gap(0), gap(1), gap(2), gap(3)};
  };
  std::array<Ball, 5> point;
  std::array<Ball, 5> interval;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    point[i] = Ball(printed[i].value);
    interval[i] = printed_interval(printed[i]);
  }
  PrintedClosing result{residuals(point), residuals(interval),
                        Verdict::undecided("every closing condition may hold somewhere in the intervals")};
  const bool refuted = std::any_of(result.at_intervals.begin(), result.at_intervals.end(),
                                   [](const Ball& residual) { return residual.is_nonzero(); });
  if (refuted) {
    result.verdict = Verdict::refuted("a closing condition holds nowhere in the printed intervals");
  }
  return result;
}

}  // namespace stickslip::numeric::families
