#include "proofs/methods/derivations.hpp"

#include "symbolic/algebra/symbols.hpp"

namespace stickslip::proofs::methods {

using namespace symbolic::algebra;

namespace {

using GiNaC::ex;
using symbolic::algebra::symbol;

// (39) with the chi and eta that Vieta's equations give.
symbolic::algebra::Matrix2 stiffness_in_frequencies() {
  const symbolic::algebra::Inverted solution =
      symbolic::algebra::solve_vieta(symbol("omega1"), symbol("omega2"));
  return model::matrix<ex>(1, -solution.chi, (-solution.chi * solution.eta).normal(),
                           (solution.chi * solution.eta).normal());
}

symbolic::algebra::Matrix column(const ex& first, const ex& second) {
  symbolic::algebra::Matrix result(2, 1);
  result << first, second;
  return result;
}

}  // namespace

symbolic::algebra::Matrix slip_exponential() {
  static const symbolic::algebra::Matrix result =
      symbolic::algebra::exponential(symbolic::algebra::first_order(stiffness_in_frequencies()),
                                     {{symbol("omega1"), symbol("omega2")}, 0}, symbol("t"));
  return result;
}

symbolic::algebra::Matrix stick_exponential() {
  static const symbolic::algebra::Matrix result = symbolic::algebra::exponential(
      symbolic::algebra::first_order(model::matrix<ex>(1, -symbol("chi"), 0, 0)), {{ex(1)}, 2}, symbol("t"));
  return result;
}

symbolic::algebra::Matrix forced_amplitudes() {
  const symbolic::algebra::Matrix2 K = stiffness_in_frequencies();
  const ex square = symbol("omega") * symbol("omega");
  const GiNaC::symbol q1, q2;
  const ex solution = GiNaC::lsolve(GiNaC::lst{(K(0, 0) - square) * q1 + K(0, 1) * q2 == 0,
                                               K(1, 0) * q1 + (K(1, 1) - square) * q2 == symbol("p")},
                                    GiNaC::lst{q1, q2});
  return column(ex(q1).subs(solution), ex(q2).subs(solution));
}

symbolic::algebra::Matrix eigenvector_slopes() {
  const symbolic::algebra::Matrix2 K = stiffness_in_frequencies();
  return column(symbolic::algebra::eigenvector_slope(K, symbol("omega1")),
                symbolic::algebra::eigenvector_slope(K, symbol("omega2")));
}

symbolic::algebra::Matrix vieta_solution() {
  const symbolic::algebra::Inverted solution =
      symbolic::algebra::solve_vieta(symbol("omega1"), symbol("omega2"));
  return column(solution.chi, solution.eta);
}

}  // namespace stickslip::proofs::methods
