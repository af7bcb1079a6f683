// (13) and (15) against the reduced equations in (tau, C).
#include "model/symmetric_closing.hpp"
#include "proofs/pascal2012/reduction.hpp"

namespace stickslip::proofs::pascal2012::reduction {

using namespace methods;

namespace {

Vector4 reversed(const Vector4& Z) {
  return model::reversal<Symbolic>() * Z;
}

model::SymmetricData<Symbolic> symmetric_data(int sigma) {
  return {symbol("chi"), modes(), symbol("V"), symbol("omega"), symbol("p"), period(), Symbolic(sigma)};
}

// (13) at the state that (tau, C) stands for.
struct SymmetricSlip {
  Vector4 residual;  // Z(tau) - E Z0
  Vector2 reduced;
};

SymmetricSlip symmetric_slip(Flows& flows, int sigma) {
  const auto a = symmetric_data(sigma);
  const Symbolic tau = symbol("tau");
  const Symbolic C = symbol("C");
  const Vector4 Z0 = model::symmetric_start<Symbolic>(a, tau, C);
  const Symbolic phi = model::symmetric_phase<Symbolic>(a, half_turn(), tau);
  return {flows.slip(Z0, phi, tau) - reversed(Z0), model::symmetric_closing<Symbolic>(a, tau, C)};
}

// The residual that the rows make: mode j is (2 cos(alpha_j)/omega_j, -2 sin(alpha_j)) times row j over
// ±(lambda_2 - lambda_1).
Vector4 symmetric_residual_of(const Vector2& rows) {
  const Vector2 alpha = half_angles(symbol("tau"));
  Vector2 y, ydot;
  for (int j = 0; j < 2; ++j) {
    const Symbolic part = rows(j) / row_scale()(j);
    y(j) = 2 * cos(alpha(j)) / frequencies()(j) * part;
    ydot(j) = -2 * sin(alpha(j)) * part;
  }
  return from_modes(y, ydot);
}

Vector2 symmetric_rows_of(const Vector4& residual) {
  const Vector2 alpha = half_angles(symbol("tau"));
  const Vector2 y = to_modes(residual.head<2>());
  const Vector2 ydot = to_modes(residual.tail<2>());
  Vector2 rows;
  for (int j = 0; j < 2; ++j) {
    rows(j) = row_scale()(j) * (frequencies()(j) * cos(alpha(j)) * y(j) - sin(alpha(j)) * ydot(j)) / 2;
  }
  return rows;
}

std::vector<Equal> symmetric_sufficient(Flows& flows) {
  std::vector<Equal> result;
  for (const int sigma : {1, -1}) {
    const SymmetricSlip slip = symmetric_slip(flows, sigma);
    result.push_back(same(slip.residual, symmetric_residual_of(slip.reduced)));
  }
  return result;
}

std::vector<Equal> symmetric_necessary(Flows& flows) {
  flows.used.insert("16.reduced");
  const Vector2 rows{symbol("r1"), symbol("r2")};
  return {same(rows, symmetric_rows_of(symmetric_residual_of(rows)))};
}

std::vector<Equal> symmetric_stick(Flows& flows) {
  const auto a = symmetric_data(1);
  const Symbolic tau = symbol("tau");
  const Vector4 Z0 = model::symmetric_start<Symbolic>(a, tau, symbol("C"));
  return {same(flows.stick(reversed(Z0), a.Theta - tau), Z0)};
}

// Any state with z2' = V differs from that of its own C by a multiple of the residual of (15).
std::vector<Equal> symmetric_all_sticks(Flows& flows) {
  const auto a = symmetric_data(1);
  const Symbolic tau = symbol("tau");
  const Symbolic half = (a.Theta - tau) / 2;
  const Vector4 Z0{symbol("z10"), symbol("z20"), symbol("zdot10"), a.V};
  const Vector4 r = flows.stick(reversed(Z0), a.Theta - tau) - Z0;
  const Symbolic u = Z0(0) - a.chi * Z0(1);
  const Symbolic v = Z0(2) - a.chi * a.V;
  const Symbolic C = u * sin(half) + v * cos(half);
  const Symbolic b = (sin(half) * r(2) - cos(half) * (r(0) - a.chi * r(1))) / 2;
  const Symbolic second = -r(1) / 2;
  const Vector4 multiple{Symbolic(cos(half) * b + a.chi * second), second, Symbolic(-sin(half) * b),
                         Symbolic(0)};
  return {same(Z0 - model::symmetric_start<Symbolic>(a, tau, C), multiple)};
}

}  // namespace

Proofs of_symmetric() {
  return {{"16.reduced", reduced(symmetric_sufficient)},
          {"16.reduced.converse", reduced(symmetric_necessary)},
          {"15.reduced", reduced(symmetric_stick)},
          {"15.reduced.converse", reduced(symmetric_all_sticks)}};
}

}  // namespace stickslip::proofs::pascal2012::reduction
