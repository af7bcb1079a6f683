// The equations that the proofs of orbits solve in place of the paper's, and that they say the same:
// "residual of the paper's closing condition = M · residual of the reduced equation" and back. Where a
// difference quotient such as sin(x)/x stands in a formula, x ≠ 0 appears among the hypotheses; both sides
// being continuous, the identity holds at x = 0 too.
#include "model/nonsticking.hpp"
#include "model/overshooting_closing.hpp"
#include "proofs/deciding.hpp"
#include "proofs/paper.hpp"
#include "proofs/prover.hpp"
#include "proofs/vocabulary.hpp"
#include "symbolic/symbols.hpp"

namespace stickslip::proofs {
namespace {

using GiNaC::cos;
using GiNaC::ex;
using GiNaC::sin;
using symbolic::symbol;
using Vector2 = model::Vector2<ex>;
using Vector4 = model::Vector4<ex>;

const std::string red = "red";

model::Modes<ex> modes() {
  return {symbol("omega1"), symbol("omega2"), symbol("lambda1"), symbol("lambda2")};
}
// Q and d0 by their modes: what (0, p) and (0, eta us) contribute to each.
Vector2 by_modes(const ex& force, const ex& shift) {
  const model::Modes<ex> m = modes();
  const ex share = force / (m.lambda2 - m.lambda1);
  const Vector2 y{ex(-share / (m.omega1 * m.omega1 - shift)), ex(share / (m.omega2 * m.omega2 - shift))};
  return model::Lambda<ex>(m) * y;
}
Vector2 load() {
  return by_modes(symbol("p"), symbol("omega") * symbol("omega"));
}
Vector2 rest() {
  return by_modes(symbol("eta") * symbol("us"), 0);
}
ex period() {
  return 2 * GiNaC::Pi / symbol("omega");
}
Vector4 reversed(const Vector4& Z) {
  return model::reversal<ex>() * Z;
}

// The flows (5), (8), (10); the claims behind those that were used.
struct Flows {
  std::set<std::string> used{"39.derived"};

  Vector4 slip(const Vector4& Z0, const ex& psi0, const ex& t) {
    used.merge(std::set<std::string>{"5", "7.modal"});
    return model::slip_flow<ex>(modes(), load(), symbol("omega"), psi0, Z0, t);
  }
  Vector4 overshoot(const Vector4& Z0, const ex& psi0, const ex& t) {
    used.merge(std::set<std::string>{"8", "7.modal"});
    return model::overshoot_flow<ex>(modes(), load(), rest(), symbol("omega"), psi0, Z0, t);
  }
  Vector4 stick(const Vector4& Z0, const ex& t) {
    used.insert("10");
    return model::stick_flow<ex>(symbol("chi"), Z0, t);
  }
};

struct Equal {
  symbolic::Matrix left, right;
};

// left = right, as: equal where all amplitudes and forces are zero, and equal derivatives with respect to
// each. Everything here is linear in them, which makes many small identities of a large one.
std::vector<Equal> split(const Equal& equal) {
  std::vector<ex> sources;
  for (const char* name : {"a", "C", "D", "V", "us", "p", "z10", "z20", "zdot10"}) {
    sources.push_back(symbol(name));
  }
  const auto both = [&](const auto& f) { return Equal{equal.left.unaryExpr(f), equal.right.unaryExpr(f)}; };
  GiNaC::exmap none;
  for (const ex& source : sources) {
    none[source] = 0;
  }
  std::vector<Equal> result{both([&](const ex& e) { return ex(e.subs(none)); })};
  for (const ex& source : sources) {
    result.push_back(both([&](const ex& e) { return ex(e.diff(GiNaC::ex_to<GiNaC::symbol>(source))); }));
  }
  return result;
}

// Every pair that `compare` builds from the model's own formulas is equal.
Proof by_comparison(std::vector<Equal> (*compare)(Flows&)) {
  return [compare](Prover&, const Claim& claim) {
    Outcome outcome;
    Flows flows;
    std::vector<Verdict> verdicts;
    for (const Equal& equal : compare(flows)) {
      for (const Equal& part : split(equal)) {
        decide(outcome, claim, part.left, part.right);
        verdicts.push_back(outcome.verdict);
      }
    }
    outcome.uses.merge(flows.used);
    outcome.verdict = all_of(verdicts);
    outcome.route = "the model's own formulas compared by normal form, for all values of the symbols";
    return outcome;
  };
}

// z = Lambda y, z' = Lambda y'.
Vector4 from_modes(const Vector2& y, const Vector2& ydot) {
  const model::Matrix2<ex> Lambda = model::Lambda<ex>(modes());
  return model::stack<ex>(Vector2(Lambda * y), Vector2(Lambda * ydot));
}
Vector2 to_modes(const Vector2& z) {
  return model::inverse<ex>(model::Lambda<ex>(modes())) * z;
}

// lambda_2 - lambda_1 with the sign that it has in row j of the reduced equations.
Vector2 row_scale() {
  const ex scale = modes().lambda2 - modes().lambda1;
  return {scale, -scale};
}

Vector2 half_angles(const ex& duration) {
  return {symbol("omega1") * duration / 2, symbol("omega2") * duration / 2};
}
Vector2 frequencies() {
  return {symbol("omega1"), symbol("omega2")};
}

std::vector<Equal> modal_forms(Flows& flows) {
  const model::Parameters<ex> a{symbol("chi"), symbol("eta"),   symbol("us"),
                                symbol("V"),   symbol("omega"), symbol("p")};
  flows.used.merge(std::set<std::string>{"6.d0", "7"});
  return {{model::Q<ex>(a, modes()), load()}, {model::d0<ex>(a.chi, a.us), rest()}};
}

// --- Section 4 ---

model::SymmetricData<ex> symmetric_data(int sigma) {
  return {symbol("chi"), modes(), symbol("V"), symbol("omega"), symbol("p"), period(), ex(sigma)};
}

// (13) at the state that (tau, C) stands for.
struct SymmetricSlip {
  Vector4 residual;  // Z(tau) - E Z0
  Vector2 reduced;
};

SymmetricSlip symmetric_slip(Flows& flows, int sigma) {
  const auto a = symmetric_data(sigma);
  const ex tau = symbol("tau");
  const ex C = symbol("C");
  const Vector4 Z0 = model::symmetric_start<ex>(a, tau, C);
  const ex phi = model::symmetric_phase<ex>(a, GiNaC::Pi, tau);
  return {flows.slip(Z0, phi, tau) - reversed(Z0), model::symmetric_closing<ex>(a, tau, C)};
}

// The residual that the rows make: mode j is (2 cos(alpha_j)/omega_j, -2 sin(alpha_j)) times row j over
// ±(lambda_2 - lambda_1).
Vector4 symmetric_residual_of(const Vector2& rows) {
  const Vector2 alpha = half_angles(symbol("tau"));
  Vector2 y, ydot;
  for (int j = 0; j < 2; ++j) {
    const ex part = rows(j) / row_scale()(j);
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
    result.push_back({slip.residual, symmetric_residual_of(slip.reduced)});
  }
  return result;
}

std::vector<Equal> symmetric_necessary(Flows& flows) {
  flows.used.insert("16.reduced");
  const Vector2 rows{symbol("r1"), symbol("r2")};
  return {{rows, symmetric_rows_of(symmetric_residual_of(rows))}};
}

std::vector<Equal> symmetric_stick(Flows& flows) {
  const auto a = symmetric_data(1);
  const ex tau = symbol("tau");
  const Vector4 Z0 = model::symmetric_start<ex>(a, tau, symbol("C"));
  return {{flows.stick(reversed(Z0), a.Theta - tau), Z0}};
}

// Any state with z2' = V differs from that of its own C by a multiple of the residual of (15).
std::vector<Equal> symmetric_all_sticks(Flows& flows) {
  const auto a = symmetric_data(1);
  const ex tau = symbol("tau");
  const ex half = (a.Theta - tau) / 2;
  const Vector4 Z0{symbol("z10"), symbol("z20"), symbol("zdot10"), a.V};
  const Vector4 r = flows.stick(reversed(Z0), a.Theta - tau) - Z0;
  const ex u = Z0(0) - a.chi * Z0(1);
  const ex v = Z0(2) - a.chi * a.V;
  const ex C = u * sin(half) + v * cos(half);
  const ex b = (sin(half) * r(2) - cos(half) * (r(0) - a.chi * r(1))) / 2;
  const ex second = -r(1) / 2;
  const Vector4 multiple{ex(cos(half) * b + a.chi * second), second, ex(-sin(half) * b), ex(0)};
  return {{Z0 - model::symmetric_start<ex>(a, tau, C), multiple}};
}

// --- Section 5 ---

model::OvershootingData<ex> overshooting_data() {
  return {symbol("chi"), symbol("eta"),   modes(),     symbol("us"),
          symbol("V"),   symbol("omega"), symbol("p"), period()};
}

ex row_value(const model::OvershootingRow<ex>& r) {
  return r.a * symbol("a") + r.C * symbol("C") + r.D * symbol("D") + r.cos_psi * cos(symbol("psi")) +
         r.sin_psi * sin(symbol("psi")) + r.one;
}

struct Overshooting {
  model::OvershootingData<ex> data = overshooting_data();
  ex tau = symbol("tau");
  ex tau1 = symbol("tau1");
  ex T = period() - tau - tau1;
  ex phi = symbol("psi") - data.omega * (tau + tau1) / 2;
  Vector4 Z0 = start(T);
  Vector4 ZC = start(-T);

  [[nodiscard]] Vector4 start(const ex& duration) const {
    return model::overshooting_start<ex>(data, duration, symbol("a"), symbol("C"), symbol("D"));
  }
  // What the slip and the overshoot make of Z0, less Z_C.
  [[nodiscard]] Vector4 residual(Flows& flows) const {
    const Vector4 ZB = flows.slip(Z0, phi, tau);
    return flows.overshoot(ZB, phi + data.omega * tau, tau1) - ZC;
  }
  [[nodiscard]] Vector2 odd() const {
    const auto rows = model::overshooting_odd<ex>(data, tau, tau1);
    return {row_value(rows[0]), row_value(rows[1])};
  }
  [[nodiscard]] Vector2 even() const {
    const auto rows = model::overshooting_even<ex>(data, tau, tau1);
    return {row_value(rows[0]), row_value(rows[1])};
  }
};

std::vector<Equal> overshooting_stick(Flows& flows) {
  const Overshooting o;
  const ex half = o.T / 2;
  const ex u = symbol("z10") - o.data.chi * symbol("z20");
  const ex v = symbol("zdot10") - o.data.chi * o.data.V;
  const Vector4 any{symbol("z10"), symbol("z20"), symbol("zdot10"), o.data.V};
  const Vector4 amplitudes =
      model::overshooting_start<ex>(o.data, -o.T, symbol("z20") + o.data.V * half,
                                    -u * sin(half) + v * cos(half), u * cos(half) + v * sin(half));
  return {{flows.stick(o.ZC, o.T), o.Z0}, {amplitudes, any}};
}

// The residual that the rows odd_j and even_j make, mode by mode.
Vector4 overshooting_residual_of(const Vector2& odd, const Vector2& even) {
  const Vector2 alpha = half_angles(symbol("tau") + symbol("tau1"));
  Vector2 y, ydot;
  for (int j = 0; j < 2; ++j) {
    const ex scale = row_scale()(j);
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
    const ex scale = row_scale()(j) / 2;
    const ex w = frequencies()(j);
    rows(j) = scale * (w * cos(alpha(j)) * y(j) - sin(alpha(j)) * ydot(j));
    rows(j + 2) = -scale * (w * sin(alpha(j)) * y(j) + cos(alpha(j)) * ydot(j));
  }
  return rows;
}

std::vector<Equal> overshooting_sufficient(Flows& flows) {
  const Overshooting o;
  return {{o.residual(flows), overshooting_residual_of(o.odd(), o.even())}};
}

std::vector<Equal> overshooting_necessary(Flows& flows) {
  flows.used.insert("20.reduced");
  const Vector4 rows{symbol("r1"), symbol("r2"), symbol("r3"), symbol("r4")};
  return {{rows, overshooting_rows_of(overshooting_residual_of(rows.head<2>(), rows.tail<2>()))}};
}

// The slip seen from its beginning, the overshoot from its end.
std::vector<Equal> overshooting_turn(Flows& flows) {
  const Overshooting o;
  const ex forward = flows.slip(o.Z0, o.phi, o.tau)(3);
  const ex backward = flows.overshoot(o.ZC, o.phi + o.data.omega * (o.tau + o.tau1), -o.tau1)(3);
  const ex turn = row_value(model::overshooting_turn<ex>(o.data, o.tau, o.tau1));
  const ex difference = (o.data.V - forward) / o.tau - (backward - o.data.V) / o.tau1;
  return {{symbolic::Matrix::Constant(1, 1, turn),
           symbolic::Matrix::Constant(1, 1, (modes().lambda2 - modes().lambda1) * difference)}};
}

// --- Section 6, any tau and V ---

std::vector<Equal> two_slips_close(Flows& flows) {
  const ex omega = symbol("omega");
  const ex delta = symbol("delta");
  const ex mu = symbol("mu");
  const ex V = symbol("V");
  const Vector2 c = model::modal_rest<ex>(modes(), rest());
  const model::Parameters<ex> a{symbol("chi"), symbol("eta"), symbol("us"), V, omega, symbol("p")};
  const Vector2 rows = model::two_slips<ex>(a, modes(), load()(1), c, GiNaC::Pi, delta, mu);
  const auto states = model::two_slips_states<ex>(V, modes(), load(), c, omega, GiNaC::Pi, delta, mu);
  // The response's own speeds z2' at 0 and tau, less V, are combinations of the rows.
  Vector4 Z0 = states.Z0;
  Vector4 ZB = states.ZB;
  Z0(3) += sin(delta) * rows(1) - rows(0);
  ZB(3) += -sin(delta) * rows(1) - rows(0);
  const ex tau = 2 * delta / omega;
  return {{flows.slip(Z0, mu - delta, tau), ZB}, {flows.overshoot(ZB, mu + delta, period() - tau), Z0}};
}

// det(H(Theta) - I) = (2 - 2 cos(omega_1 Theta))(2 - 2 cos(omega_2 Theta)).
std::vector<Equal> one_response(Flows&) {
  const ex Theta = period();
  const ex product = (2 - 2 * cos(symbol("omega1") * Theta)) * (2 - 2 * cos(symbol("omega2") * Theta));
  const Term stated = determinant(vocabulary::H(2 * pi() / vocabulary::omega) - vocabulary::I4);
  return {{evaluate<ex>(stated, symbolically()), symbolic::Matrix::Constant(1, 1, product)}};
}

namespace v = vocabulary;

Assumption nonzero(const std::string& id, const Term& term) {
  return {id, {term, 0, Relation::not_equal}};
}

// Where (7) has no Q.
std::vector<Assumption> off_load_resonance() {
  return {nonzero("resonance", v::omega - v::omega1), nonzero("resonance", v::omega - v::omega2)};
}

// Both sides are continuous where a duration is zero (the numeric code computes sin(x)/x there as 1): the
// identity extends to it.
std::vector<Assumption> durations(const std::vector<Term>& terms) {
  std::vector<Assumption> result = off_load_resonance();
  for (const Term& term : terms) {
    result.push_back(nonzero("duration", term));
  }
  return result;
}

std::vector<Assumption> two_slips_apart() {
  const Term delta = scalar("delta");
  std::vector<Assumption> result = durations({delta, delta - pi(), sin(delta)});
  for (const Term& omega_j : {v::omega1, v::omega2}) {
    result.push_back(nonzero("resonance", sin(pi() * omega_j / v::omega)));
  }
  return result;
}

Claim reduced(const std::string& id, const std::string& words, std::vector<Equal> (*compare)(Flows&),
              const std::vector<Assumption>& assumptions = {}) {
  return {.id = id,
          .place = red,
          .kind = Kind::step,
          .words = words,
          .assumptions = assumptions,
          .prove = by_comparison(compare)};
}

}  // namespace

std::vector<Claim> reduced() {
  return {
      reduced("7.modal", "Q and d_0 by their modes", modal_forms, off_load_resonance()),
      reduced("16.reduced",
              "the reduced equations in (tau, C) give all components of (13), for both load phases",
              symmetric_sufficient, durations({v::tau})),
      reduced("16.reduced.converse", "all components of (13) give the reduced equations",
              symmetric_necessary),
      reduced("15.reduced", "the states of the reduced equations fulfil all components of (15)",
              symmetric_stick),
      reduced("15.reduced.converse", "every state with z2' = V that fulfils (15) is one of them",
              symmetric_all_sticks),
      reduced("20.stick", "the states by amplitudes (a, C, D) are all states with z2' = V that a stick joins",
              overshooting_stick),
      reduced("20.reduced", "the four rows odd and even give Z(Theta) = Z_0 (20)", overshooting_sufficient,
              durations({v::tau + scalar("tau1")})),
      reduced("20.reduced.converse", "(20) gives the four rows", overshooting_necessary),
      reduced("18.reduced", "the row turn is the difference of the mean accelerations on both sides of tau",
              overshooting_turn, durations({v::tau, scalar("tau1")})),
      reduced("28.reduced",
              "where the two reduced equations hold the motion closes as in (28), with z2' = V at 0 and tau",
              two_slips_close, two_slips_apart()),
      reduced("28.unique", "off resonance there is one response of period Theta: det(H(Theta) - I) is not 0",
              one_response),
  };
}

}  // namespace stickslip::proofs
