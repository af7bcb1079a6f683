// (18) and (20) against the rows odd, even and turn in (a, C, D, psi).
#include "model/overshooting_closing.hpp"
#include "proofs/pascal2012/reduction.hpp"

namespace stickslip::proofs::pascal2012::reduction {

using namespace methods;
using namespace symbols;

namespace {

model::OvershootingData<Symbolic> overshooting_data() {
  return {symbol("chi"), symbol("eta"),   modes(),     symbol("us"),
          symbol("V"),   symbol("omega"), symbol("p"), period()};
}

Symbolic row_value(const model::OvershootingRow<Symbolic>& r) {
  return r.a * symbol("a") + r.C * symbol("C") + r.D * symbol("D") + r.cos_psi * cos(symbol("psi")) +
         r.sin_psi * sin(symbol("psi")) + r.one;
}

struct Overshooting {
  model::OvershootingData<Symbolic> data = overshooting_data();
  Symbolic tau = symbol("tau");
  Symbolic tau1 = symbol("tau1");
  Symbolic T = period() - tau - tau1;
  Symbolic phi = symbol("psi") - data.omega * (tau + tau1) / 2;
  Vector4 Z0 = start(T);
  Vector4 ZC = start(-T);

  [[nodiscard]] Vector4 start(const Symbolic& duration) const {
    return model::overshooting_start<Symbolic>(data, duration, symbol("a"), symbol("C"), symbol("D"));
  }
  // What the slip and the overshoot make of Z0, less Z_C.
  [[nodiscard]] Vector4 residual(Flows& flows) const {
    const Vector4 ZB = flows.slip(Z0, phi, tau);
    return flows.overshoot(ZB, phi + data.omega * tau, tau1) - ZC;
  }
  [[nodiscard]] Vector2 odd() const {
    const auto rows = model::overshooting_odd<Symbolic>(data, tau, tau1);
    return {row_value(rows[0]), row_value(rows[1])};
  }
  [[nodiscard]] Vector2 even() const {
    const auto rows = model::overshooting_even<Symbolic>(data, tau, tau1);
    return {row_value(rows[0]), row_value(rows[1])};
  }
};

std::vector<Equal> overshooting_stick(Flows& flows) {
  const Overshooting o;
  const Symbolic half = o.T / 2;
  const Symbolic u = symbol("z10") - o.data.chi * symbol("z20");
  const Symbolic v = symbol("zdot10") - o.data.chi * o.data.V;
  const Vector4 any{symbol("z10"), symbol("z20"), symbol("zdot10"), o.data.V};
  const Vector4 amplitudes =
      model::overshooting_start<Symbolic>(o.data, -o.T, symbol("z20") + o.data.V * half,
                                          -u * sin(half) + v * cos(half), u * cos(half) + v * sin(half));
  return {same(flows.stick(o.ZC, o.T), o.Z0), same(amplitudes, any)};
}

// The residual that the rows odd_j and even_j make, mode by mode.
Vector4 overshooting_residual_of(const Vector2& odd, const Vector2& even) {
  const Vector2 alpha = half_angles(symbol("tau") + symbol("tau1"));
  Vector2 y, ydot;
  for (int j = 0; j < 2; ++j) {
    const Symbolic scale = row_scale()(j);
    y(j) = 2 * (cos(alpha(j)) * odd(j) - sin(alpha(j)) * even(j)) / (scale * frequencies()(j));
    ydot(j) = -2 * (cos(alpha(j)) * even(j) + sin(alpha(j)) * odd(j)) / scale;
  }
  return from_modes(y, ydot);
}

// (odd_1, odd_2, even_1, even_2).
Vector4 overshooting_rows_of(const Vector4& residual) {
  const Vector2 alpha = half_angles(symbol("tau") + symbol("tau1"));
  const Vector2 y = to_modes(residual.head<2>());
  const Vector2 ydot = to_modes(residual.tail<2>());
  Vector4 rows;
  for (int j = 0; j < 2; ++j) {
    const Symbolic scale = row_scale()(j) / 2;
    const Symbolic w = frequencies()(j);
    rows(j) = scale * (w * cos(alpha(j)) * y(j) - sin(alpha(j)) * ydot(j));
    rows(j + 2) = -scale * (w * sin(alpha(j)) * y(j) + cos(alpha(j)) * ydot(j));
  }
  return rows;
}

std::vector<Equal> overshooting_sufficient(Flows& flows) {
  const Overshooting o;
  return {same(o.residual(flows), overshooting_residual_of(o.odd(), o.even()))};
}

std::vector<Equal> overshooting_necessary(Flows& flows) {
  flows.used.insert("20.reduced");
  const Vector4 rows{symbol("r1"), symbol("r2"), symbol("r3"), symbol("r4")};
  return {same(rows, overshooting_rows_of(overshooting_residual_of(rows.head<2>(), rows.tail<2>())))};
}

// The slip seen from its beginning, the overshoot from its end.
std::vector<Equal> overshooting_turn(Flows& flows) {
  const Overshooting o;
  const Symbolic forward = flows.slip(o.Z0, o.phi, o.tau)(3);
  const Symbolic backward = flows.overshoot(o.ZC, o.phi + o.data.omega * (o.tau + o.tau1), -o.tau1)(3);
  const Symbolic turn = row_value(model::overshooting_turn<Symbolic>(o.data, o.tau, o.tau1));
  const Symbolic difference = (o.data.V - forward) / o.tau - (backward - o.data.V) / o.tau1;
  return {{turn.term, ((modes().lambda2 - modes().lambda1) * difference).term}};
}

}  // namespace

Proofs of_overshooting() {
  return {{"20.stick", reduced(overshooting_stick)},
          {"20.reduced", reduced(overshooting_sufficient)},
          {"20.reduced.converse", reduced(overshooting_necessary)},
          {"18.reduced", reduced(overshooting_turn)}};
}

}  // namespace stickslip::proofs::pascal2012::reduction
