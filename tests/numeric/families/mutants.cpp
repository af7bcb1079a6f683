// Proofs that are wrong on purpose: a box off the root, phases in another order, a coefficient with the other
// sign. None may come out as proved at the orbit.
#include <doctest/doctest.h>

#include "numeric/families/through_phases/one_stick_closing.hpp"
#include "numeric/zeros/elimination.hpp"
#include "numeric/zeros/krawczyk.hpp"
#include "numeric/zeros/search.hpp"
#include "tests/numeric/families/composed.hpp"
#include "tests/numeric/families/equations_16.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

constexpr double radius = 1e-9;

// That Krawczyk's test on f proves the zero in a small box around it, and never in a box that was moved off
// it or shrunk away from it.
template <int N, class F>
void check_boxes(const F& f, const Box<N>& zero) {
  const Box<N> box = box_around<N>(zero, radius);
  REQUIRE(krawczyk_test<N>(f, box).verdict.truth == Truth::proved);
  for (int i = 0; i < box.size(); ++i) {
    CAPTURE(i);
    const Ball r = box(i).radius();
    for (const int side : {-1, 1}) {
      Box<N> moved = box;
      moved(i) += Ball(10 * side) * r;
      CHECK(krawczyk_test<N>(f, moved).verdict.truth != Truth::proved);
      Box<N> shrunk = box;  // the outer half of one side: its middle is 3/4 of the radius off the root
      shrunk(i) = box(i).midpoint() + Ball(side) * Ball::hull(r / Ball(2), r);
      CHECK(krawczyk_test<N>(f, shrunk).verdict.truth != Truth::proved);
    }
  }
}

// A mutant may have zeros of its own, but none here.
template <int N, class F>
void check_not_here(const F& mutant, const Box<N>& zero) {
  CHECK(krawczyk_test<N>(mutant, box_around<N>(zero, radius)).verdict.truth != Truth::proved);
  CHECK(krawczyk_test<N>(mutant, box_around<N>(zero, 1e-4)).verdict.truth != Truth::proved);
}

// One coefficient of the reduced rows of Section 4 with the other sign, C eliminated.
struct FlippedSymmetric {
  model::SymmetricData<Ball> data;
  int row;
  bool left;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 1, 1> operator()(const Eigen::Matrix<T, 1, 1>& u) const {
    const model::SymmetricData<T> d{model::lift<T>(data), T(data.sigma)};
    model::SymmetricRows<T> rows = model::symmetric_rows<T>(d, T(d.Theta * u(0)));
    T& coefficient = left ? rows.left(row) : rows.right(row);
    coefficient = -coefficient;
    return Eigen::Matrix<T, 1, 1>(T(rows.left(1) * rows.right(0) - rows.left(0) * rows.right(1)));
  }
};

// At an orbit's own data: boxes off the root.
void check_system(const Closing& f, const Given<Ball>& given, const Motion& motion) {
  check_boxes<Eigen::Dynamic>(AtParameters<Closing>{f, f.parameters(given)}, f.unknowns(motion));
}

// The same of Section 5, at the load's phase phi: the rows of (a, C, D, 1), of which one coefficient's sign
// may be flipped, eliminated as the search does.
struct OvershootingRows {
  model::ReducedData<Ball> data;
  Ball phi;
  Eigen::Matrix<Ball, 5, 5> combinations = Eigen::Matrix<Ball, 5, 5>::Identity();
  int row = -1, column = -1;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 5, 4> rows(const Eigen::Matrix<T, 2, 1>& sw) const {
    const auto d = model::lift<T>(data);
    const Eigen::Matrix<T, 2, 1> t = times<T, 2>(d.Theta, sw);
    const std::pair<T, T> psi = sin_cos(T(T(phi) + d.omega * T(t(0) + t(1)) / T(2)));
    const auto [odd1, odd2] = model::overshooting_odd<T>(d, t(0), t(1));
    const auto [even1, even2] = model::overshooting_even<T>(d, t(0), t(1));
    Eigen::Matrix<T, 5, 4> m;
    int i = 0;
    for (const auto& r : {odd1, odd2, even1, even2, model::overshooting_turn<T>(d, t(0), t(1))}) {
      m.row(i++) << r.a, r.C, r.D, T(r.one + r.cos_psi * psi.second + r.sin_psi * psi.first);
    }
    if (row >= 0) {
      m(row, column) = -m(row, column);
    }
    return m;
  }

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& sw) const {
    Eigen::Matrix<T, 5, 4> m = combined_rows<T, 5, 4>(combinations, rows<T>(sw));
    if (!eliminate<T, 5, 4>(m, 0, 3)) {
      const T nowhere = T(1) / T(0);
      return {nowhere, nowhere};
    }
    return {m(3, 3), m(4, 3)};
  }
};

// The flows of Section 5 with the overshoot before the slip.
struct SwappedPhases {
  Composed<Ball> f;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 5, 1> operator()(const Eigen::Matrix<T, 5, 1>& x) const {
    const model::Oscillator<Ball>& o = f.o;
    const model::Modes<T> m = model::lift<T>(o.modes);
    const model::Vector2<T> Q = model::lift<T>(o.Q);
    const T omega(o.data.omega);
    const T V(o.data.V);
    const model::Vector4<T> Z0(x(2), x(3), x(4), V);
    const model::Vector4<T> ZB =
        model::overshoot_flow<T>(m, Q, model::lift<T>(o.d0), omega, T(f.phi), Z0, x(0));
    const model::Vector4<T> ZC = model::slip_flow<T>(m, Q, omega, T(T(f.phi) + omega * x(0)), ZB, x(1));
    const model::Vector4<T> Z = model::stick_flow<T>(T(o.data.chi), ZC, T(T(f.Theta) - x(0) - x(1)));
    Eigen::Matrix<T, 5, 1> residual;
    residual << T(ZB(3) - V), T(ZC(3) - V), T(Z(0) - x(2)), T(Z(1) - x(3)), T(Z(2) - x(4));
    return residual;
  }
};

}  // namespace

TEST_CASE("Section 4: boxes off the root, and signs flipped in the reduced equations") {
  const Orbit orbit = listed(symmetric(), S(), 40).orbits.at(1);
  const SymmetricEliminant eliminant{symmetric_data(S(), LoadPhase::first)};
  const Box<1> zero(orbit.value("tau") / orbit.value("Theta"));
  check_boxes<1>(eliminant, zero);
  for (const int row : {0, 1}) {
    for (const bool left : {true, false}) {
      check_not_here<1>(FlippedSymmetric{eliminant.data, row, left}, zero);
    }
  }
  check_not_here<1>(SymmetricEliminant{symmetric_data(S(), LoadPhase::second)}, zero);
  const Closing first = SymmetricClosing{LoadPhase::first}, second = SymmetricClosing{LoadPhase::second};
  const Given<Ball> given{parameters_as<Ball>(S())};
  check_system(first, given, orbit.motion);
  check_not_here<Eigen::Dynamic>(AtParameters<Closing>{second, second.parameters(given)},
                                 first.unknowns(orbit.motion));
  const Equations16 sixteen = equations_16(S(), LoadPhase::first);
  const Box<4> state(orbit.value("tau"), orbit.value("z10"), orbit.value("z20"), orbit.value("zdot10"));
  check_boxes<4>(sixteen, state);
  Equations16 flipped = sixteen;
  flipped.Q = -flipped.Q;
  check_not_here<4>(flipped, state);
}

TEST_CASE("Section 5: boxes off the root, phases swapped, signs flipped in each coefficient") {
  const ComposedOrbit orbit = orbit_O();
  REQUIRE(orbit.proof.verdict.truth == Truth::proved);
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(O()));
  const Composed<Ball> f{o, Ball(0), Ball(2) * Ball::pi() / o.data.omega, true};
  check_boxes<5>(f, orbit.proof.box);
  check_not_here<5>(SwappedPhases{f}, orbit.proof.box);
  check_system(OvershootingClosing{true, false}, {parameters_as<Ball>(O()), Ball(0)}, orbit.motion);
  check_system(OvershootingClosing{false, true}, {parameters_as<Ball>(O()), {}, orbit.ur}, orbit.motion);

  const OneStick<2, Datum::phase> problem({overshooting_data<Ball>(O()), Ball(0)}, true);
  const Ball total = orbit.proof.box(0) + orbit.proof.box(1);
  const Box<2> sw(total / problem.exact.d.Theta, orbit.proof.box(1) / total);
  const auto reduced = LinearEliminant<OneStick<2, Datum::phase>>::near(problem, sw);
  REQUIRE(reduced.has_value());
  check_boxes<2>(*reduced, sw);
  OvershootingRows flipped{problem.exact.d, Ball(0), reduced->combinations};
  check_boxes<2>(flipped, sw);
  const auto rows = flipped.rows<Ball>(midpoint<2>(sw));
  for (flipped.row = 0; flipped.row < 5; ++flipped.row) {
    for (flipped.column = 0; flipped.column < 4; ++flipped.column) {
      CAPTURE(flipped.row);
      CAPTURE(flipped.column);
      if (!is_zero(rows(flipped.row, flipped.column))) {
        check_not_here<2>(flipped, sw);
      }
    }
  }
}

TEST_CASE("Section 6: boxes off the root, and the friction's sign flipped") {
  const Orbit orbit = listed(nonsticking(), P("0.1"), 40).orbits.at(1);
  const TwoSlips f = two_slips_of(parameters_as<Ball>(P("0.1")));
  const Ball delta = orbit.motion.oscillator.data.omega * orbit.value("tau") / Ball(2);
  const Box<2> zero(delta, orbit.value("phi") + delta);
  check_boxes<2>(f, zero);
  check_system(NonstickingClosing{}, {parameters_as<Ball>(P("0.1"))}, orbit.motion);
  TwoSlips flipped = f;
  flipped.c = -flipped.c;
  check_not_here<2>(flipped, zero);
  flipped = f;
  flipped.o.Q = -flipped.o.Q;
  check_not_here<2>(flipped, zero);
  flipped = f;
  flipped.o.data.V = -flipped.o.data.V;
  check_not_here<2>(flipped, zero);
}
