// The equations that the proofs of orbits solve in place of the paper's, and that they say the same:
// "residual of the paper's closing condition = M · residual of the reduced equation" and back. Where a
// difference quotient such as sin(x)/x stands in a formula, x ≠ 0 appears among the hypotheses; both sides
// being continuous, the identity holds at x = 0 too.
#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "model/appendix3.hpp"
#include "model/flows.hpp"
#include "model/nonsticking.hpp"
#include "model/overshooting_closing.hpp"
#include "model/symmetric.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace reduction {

using namespace symbols;

namespace {

using tactics::Symbolic;
using Vector2 = model::Vector2<Symbolic>;
using Vector4 = model::Vector4<Symbolic>;

// ---- The flows with the record of what they rest on, and formulas of the model compared with each other.

// The letter of a symbol, and pi.
Symbolic symbol(const std::string& name) {
  return kernel::Variable{name};
}
Symbolic half_turn() {
  return kernel::pi();
}

model::Modes<Symbolic> modes() {
  return {symbol("omega1"), symbol("omega2"), symbol("lambda1"), symbol("lambda2")};
}

model::Parameters<Symbolic> data() {
  return {symbol("chi"), symbol("eta"), symbol("us"), symbol("V"), symbol("omega"), symbol("p")};
}

// Q and d_0 by their modes: what (0, p) and (0, eta us) contribute to each.
Vector2 by_modes(const Symbolic& force, const Symbolic& shift) {
  const model::Modes<Symbolic> m = modes();
  const Symbolic share = force / (m.lambda2 - m.lambda1);
  const Vector2 y{Symbolic(-share / (m.omega1 * m.omega1 - shift)),
                  Symbolic(share / (m.omega2 * m.omega2 - shift))};
  return model::Lambda<Symbolic>(m) * y;
}
Vector2 load() {
  return by_modes(symbol("p"), symbol("omega") * symbol("omega"));
}
Vector2 rest() {
  return by_modes(symbol("eta") * symbol("us"), 0);
}

// Theta = 2 pi/omega.
Symbolic period() {
  return 2 * half_turn() / symbol("omega");
}

// The flows (5), (8), (10); the ids of the claims behind those that were used.
struct Flows {
  Derivation& derivation;
  std::set<std::string> used{"39.derived"};

  Vector4 slip(const Vector4& Z0, const Symbolic& psi0, const Symbolic& t) {
    used.merge(std::set<std::string>{"5", "7.modal"});
    return model::slip_flow<Symbolic>(modes(), load(), symbol("omega"), psi0, Z0, t);
  }
  Vector4 overshoot(const Vector4& Z0, const Symbolic& psi0, const Symbolic& t) {
    used.merge(std::set<std::string>{"8", "7.modal"});
    return model::overshoot_flow<Symbolic>(modes(), load(), rest(), symbol("omega"), psi0, Z0, t);
  }
  Vector4 stick(const Vector4& Z0, const Symbolic& t) {
    used.insert("10");
    return model::stick_flow<Symbolic>(symbol("chi"), Z0, t);
  }
};

// Two columns of the model's.
template <class Left, class Right>
Equal same(const Left& left, const Right& right) {
  return {tactics::as_term(left), tactics::as_term(right)};
}

// z = Lambda y, z' = Lambda y', and back.
Vector4 from_modes(const Vector2& y, const Vector2& ydot) {
  const model::Matrix2<Symbolic> Lambda = model::Lambda<Symbolic>(modes());
  return model::stack<Symbolic>(Vector2(Lambda * y), Vector2(Lambda * ydot));
}
Vector2 to_modes(const Vector2& z) {
  return model::inverse<Symbolic>(model::Lambda<Symbolic>(modes())) * z;
}

// lambda_2 - lambda_1 with the sign that it has in row j of the reduced equations.
Vector2 row_scale() {
  const Symbolic scale = modes().lambda2 - modes().lambda1;
  return {scale, -scale};
}

// omega_j, and omega_j duration/2.
Vector2 frequencies() {
  return {symbol("omega1"), symbol("omega2")};
}
Vector2 half_angles(const Symbolic& duration) {
  return {symbol("omega1") * duration / 2, symbol("omega2") * duration / 2};
}

// That every pair that `compare` builds from the model's own formulas is equal.
Proof compared_by(std::vector<Equal> (*compare)(Flows&)) {
  return [compare](Prover& prover, const Claim& claim) {
    std::set<std::string> used;
    Outcome outcome =
        compared("the model's own formulas compared in the kernel, for all values of the symbols", prover,
                 claim, [&](Derivation& derivation) {
                   Flows flows{derivation};
                   std::vector<Equal> pairs = compare(flows);
                   used = flows.used;
                   return pairs;
                 });
    outcome.uses.merge(used);
    return outcome;
  };
}

// (13) and (15) against the reduced equations in (tau, C).

Vector4 reversed(const Vector4& Z) {
  return model::reversal<Symbolic>() * Z;
}

model::ReducedData<Symbolic> reduced_data() {
  return {{symbol("chi"), symbol("eta"), symbol("us"), symbol("V"), symbol("omega"), symbol("p")},
          modes(),
          period()};
}
model::SymmetricData<Symbolic> symmetric_data(int sigma) {
  return {reduced_data(), Symbolic(sigma)};
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

// (28) for any tau and V against the two reduced equations.

// friction_speed divides by sinc(delta) + sinc(pi - delta), which is not 0 where sin(delta) = sin(pi - delta)
// is not.
kernel::Theorem sum_of_sincs_differs() {
  using kernel::Theorem;
  const kernel::Term delta = kernel::Variable{"delta"}, sine = sin(delta),
                     sum = delta * sin(kernel::pi() - delta) - delta * sine + kernel::pi() * sine;
  const kernel::Formula vanishes = kernel::equal(sum, 0);
  const Theorem sine_vanishes = tactics::nonzero(
      Theorem::combination(kernel::equal(sine, 0), {{Theorem::assume(vanishes), inverse(kernel::pi())}}), {});
  return Theorem::consequence(
      {Theorem::discharge(sine_vanishes, vanishes), Theorem::assume(kernel::differ(sine, 0))},
      kernel::differ(sum, 0));
}

std::vector<Equal> two_slips_close(Flows& flows) {
  flows.derivation.know(sum_of_sincs_differs());
  const Symbolic omega = symbol("omega");
  const Symbolic delta = symbol("delta");
  const Symbolic mu = symbol("mu");
  const Symbolic V = symbol("V");
  const Vector2 c = model::modal_rest<Symbolic>(modes(), rest());
  const Vector2 rows = model::two_slips<Symbolic>(data(), modes(), load()(1), c, half_turn(), delta, mu);
  const auto states = model::two_slips_states<Symbolic>(V, modes(), load(), c, omega, half_turn(), delta, mu);
  // The response's own speeds z2' at 0 and tau, less V, are combinations of the rows.
  Vector4 Z0 = states.Z0;
  Vector4 ZB = states.ZB;
  Z0(3) += sin(delta) * rows(1) - rows(0);
  ZB(3) += -sin(delta) * rows(1) - rows(0);
  const Symbolic tau = 2 * delta / omega;
  return {same(flows.slip(Z0, mu - delta, tau), ZB),
          same(flows.overshoot(ZB, mu + delta, period() - tau), Z0)};
}

// What is searched over a range of the load's frequency, resonances among it.
std::vector<Equal> without_poles(Flows& flows) {
  flows.derivation.know(sum_of_sincs_differs());
  const Symbolic omega = symbol("omega"), omega1 = symbol("omega1"), omega2 = symbol("omega2");
  const Symbolic delta = symbol("delta"), mu = symbol("mu"), pi = half_turn();
  const Vector2 c = model::modal_rest<Symbolic>(modes(), rest());
  const Vector2 rows = model::two_slips<Symbolic>(data(), modes(), load()(1), c, pi, delta, mu);
  const Vector2 entire = model::two_slips_without_poles<Symbolic>(data(), modes(), c, pi, delta, mu);
  const auto D = [&](const Symbolic& omega_j) { return omega * omega - omega_j * omega_j; };
  const auto sine = [&](const Symbolic& omega_j) { return sin(pi * omega_j / omega); };
  return {{entire(0).term, (rows(0) * (D(omega1) * D(omega2))).term},
          {entire(1).term, (rows(1) * (sine(omega1) * sine(omega2))).term}};
}

// det(H(Theta) - I) = (2 - 2 cos(omega_1 Theta))(2 - 2 cos(omega_2 Theta)).
std::vector<Equal> one_response(Flows& flows) {
  const Symbolic Theta = period();
  const Symbolic product = (2 - 2 * cos(symbol("omega1") * Theta)) * (2 - 2 * cos(symbol("omega2") * Theta));
  const Term stated = determinant(vocabulary::H(2 * pi() / vocabulary::omega) - vocabulary::I4);
  return {{flows.derivation.read(stated), product.term}};
}

// (18) and (20) against the rows odd, even and turn in (a, C, D, psi).

Symbolic row_value(const model::OvershootingRow<Symbolic>& r) {
  return r.a * symbol("a") + r.C * symbol("C") + r.D * symbol("D") + r.cos_psi * cos(symbol("psi")) +
         r.sin_psi * sin(symbol("psi")) + r.one;
}

struct Overshooting {
  model::ReducedData<Symbolic> data = reduced_data();
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

// (6) and (7) by modes.
std::vector<Equal> modal_forms(Flows& flows) {
  flows.used.merge(std::set<std::string>{"6.d0", "7"});
  return {same(model::Q<Symbolic>(data(), modes()), load()),
          same(model::d0<Symbolic>(symbol("chi"), symbol("us")), rest())};
}

// model/appendix3.hpp says the same as the twenty coefficients (47)-(51) that are printed.
std::vector<Equal> computed(Derivation& derivation) {
  const auto letters = model::appendix3_letters<Symbolic>(
      symbol("chi"), modes(), {symbol("q1"), symbol("q2")}, {symbol("d01"), symbol("d02")}, symbol("omega"),
      symbol("V"), symbol("phi"), symbol("tau"), symbol("tau1"), symbol("T"));
  const auto k = model::appendix3<Symbolic>(letters, model::Reading::printed);
  std::vector<Equal> result;
  model::each_coefficient(k, [&](char letter, int i, const Symbolic& one) {
    const Claim& claim = derivation.prover().claim(fmt::format("{}.{}", 46 + i, letter));
    result.push_back({one.term, derivation.read(claim.printed.front().right)});
  });
  return result;
}

}  // namespace
}  // namespace reduction

Proofs reduced() {
  using namespace reduction;
  return {{"7.modal", compared_by(modal_forms)},
          {"16.reduced", compared_by(symmetric_sufficient)},
          {"16.reduced.converse", compared_by(symmetric_necessary)},
          {"15.reduced", compared_by(symmetric_stick)},
          {"15.reduced.converse", compared_by(symmetric_all_sticks)},
          {"28.reduced", compared_by(two_slips_close)},
          {"28.poles", compared_by(without_poles)},
          {"28.unique", compared_by(one_response)},
          {"20.stick", compared_by(overshooting_stick)},
          {"20.reduced", compared_by(overshooting_sufficient)},
          {"20.reduced.converse", compared_by(overshooting_necessary)},
          {"18.reduced", compared_by(overshooting_turn)},
          {"51.formulas", [](Prover& prover, const Claim& claim) {
             return compared(
                 "the formulas that the program computes with and the printed ones have the same normal form",
                 prover, claim, computed);
           }}};
}

}  // namespace stickslip::proofs::pascal2012
