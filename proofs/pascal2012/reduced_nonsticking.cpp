// (28) for any tau and V against the two reduced equations.
#include "model/nonsticking.hpp"
#include "proofs/pascal2012/reduction.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012::reduction {

using namespace methods;
using namespace symbols;

namespace {

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
  const model::Parameters<Symbolic> a{symbol("chi"), symbol("eta"), symbol("us"), V, omega, symbol("p")};
  const Vector2 rows = model::two_slips<Symbolic>(a, modes(), load()(1), c, half_turn(), delta, mu);
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
  const model::Parameters<Symbolic> a{symbol("chi"), symbol("eta"), symbol("us"),
                                      symbol("V"),   omega,         symbol("p")};
  const Vector2 c = model::modal_rest<Symbolic>(modes(), rest());
  const Vector2 rows = model::two_slips<Symbolic>(a, modes(), load()(1), c, pi, delta, mu);
  const Vector2 entire = model::two_slips_without_poles<Symbolic>(a, modes(), c, pi, delta, mu);
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

}  // namespace

Proofs of_nonsticking() {
  return {{"28.reduced", reduced(two_slips_close)},
          {"28.poles", reduced(without_poles)},
          {"28.unique", reduced(one_response)}};
}

}  // namespace stickslip::proofs::pascal2012::reduction
