// Closing conditions straight from the flows (5), (8), (10), as an existence proof that shares no reduced
// equation with the program.
#pragma once

#include "model/parameters.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/zeros/krawczyk.hpp"
#include "tests/numeric/examples.hpp"

namespace stickslip::examples {

using namespace numeric::motion;
using namespace numeric::zeros;

// x = (tau, tau1, z10, z20, zdot10) -> z2'(tau) - V, z2'(tau + tau1) - V, and z1, z2, z1' after the stick
// minus before the slip. Without overshoot (tau1 and its equation trivial) the orbit is symmetric or not.
template <class S>
struct Composed {
  model::Oscillator<S> o;
  S phi, Theta;
  bool overshoots;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 5, 1> operator()(const Eigen::Matrix<T, 5, 1>& x) const {
    const model::Modes<T> m = model::lift<T>(o.modes);
    const model::Vector2<T> Q = model::lift<T>(o.Q);
    const model::Vector2<T> d0 = model::lift<T>(o.d0);
    const T omega(o.data.omega);
    const T V(o.data.V);
    const model::Vector4<T> Z0(x(2), x(3), x(4), V);
    const model::Vector4<T> ZB = model::slip_flow<T>(m, Q, omega, T(phi), Z0, x(0));
    model::Vector4<T> ZC = ZB;
    if (overshoots) {
      ZC = model::overshoot_flow<T>(m, Q, d0, omega, T(T(phi) + omega * x(0)), ZB, x(1));
    }
    const model::Vector4<T> Z = model::stick_flow<T>(T(o.data.chi), ZC, T(T(Theta) - x(0) - x(1)));
    Eigen::Matrix<T, 5, 1> f;
    f << T(ZB(3) - V), overshoots ? T(ZC(3) - V) : x(1), T(Z(0) - x(2)), T(Z(1) - x(3)), T(Z(2) - x(4));
    return f;
  }
};

struct ComposedOrbit {
  ZeroProof<5> proof;
  Motion motion;
  Ball ur;  // by (12)
};

// The motion of a proved zero x of Composed, each phase starting where the flow of the one before leads.
[[nodiscard]] inline ComposedOrbit orbit_of(const Composed<Ball>& f, const ZeroProof<5>& proof) {
  const Box<5>& x = proof.box;
  const model::Vector4<Ball> Z0(x(2), x(3), x(4), f.o.data.V);
  std::vector<Leg> legs{{PhaseKind::slip, x(0)}};
  if (f.overshoots) {
    legs.push_back({PhaseKind::overshoot, x(1)});
  }
  legs.push_back({PhaseKind::stick, f.overshoots ? Ball(f.Theta - x(0) - x(1)) : Ball(f.Theta - x(0))});
  return {proof, compose(f.o, f.phi, Z0, legs), model::friction_at<Ball>(f.o.data, Z0, f.phi)};
}

[[nodiscard]] inline Box<5> point(double tau, double tau1, double z10, double z20, double zdot10) {
  Box<5> x;
  x << Ball(tau), Ball(tau1), Ball(z10), Ball(z20), Ball(zdot10);
  return x;
}

// An orbit with an overshoot for the data a and the load phase phi, near x.
[[nodiscard]] inline ComposedOrbit overshooting_near(const ExactParameters& a, const Ball& phi, Box<5> x) {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
  const Composed<Ball> f{o, phi, Ball(2) * Ball::pi() / o.data.omega, true};
  for (int k = 0; k < 8; ++k) {
    const auto better = newton<Ball, 5>(f, midpoint<5>(x), 1);
    x = better ? midpoint<5>(*better) : x;
  }
  return orbit_of(f, krawczyk_test<5>(f, box_around<5>(x, 1e-25)));
}

[[nodiscard]] inline ComposedOrbit orbit_O() {
  return overshooting_near(O(), Ball(0), point(4.909, 2.8275, 1.2809, 3.3861, -0.4117));
}

}  // namespace stickslip::examples
