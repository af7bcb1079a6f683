#include "proofs/derivations.hpp"

#include "symbolic/symbols.hpp"

namespace stickslip::proofs {
namespace {

using GiNaC::ex;
using symbolic::symbol;

// (39) with the chi and eta that Vieta's equations give.
symbolic::Matrix2 stiffness_in_frequencies() {
  const symbolic::Inverted solution = symbolic::solve_vieta(symbol("omega1"), symbol("omega2"));
  return model::matrix<ex>(1, -solution.chi, (-solution.chi * solution.eta).normal(),
                           (solution.chi * solution.eta).normal());
}

symbolic::Matrix column(const ex& first, const ex& second) {
  symbolic::Matrix result(2, 1);
  result << first, second;
  return result;
}

}  // namespace

symbolic::Matrix slip_exponential() {
  static const symbolic::Matrix result =
      symbolic::exponential(symbolic::first_order(stiffness_in_frequencies()),
                            {{symbol("omega1"), symbol("omega2")}, 0}, symbol("t"));
  return result;
}

symbolic::Matrix stick_exponential() {
  static const symbolic::Matrix result = symbolic::exponential(
      symbolic::first_order(model::matrix<ex>(1, -symbol("chi"), 0, 0)), {{ex(1)}, 2}, symbol("t"));
  return result;
}

symbolic::Matrix forced_amplitudes() {
  const symbolic::Matrix2 K = stiffness_in_frequencies();
  const ex square = symbol("omega") * symbol("omega");
  const GiNaC::symbol q1, q2;
  const ex solution = GiNaC::lsolve(GiNaC::lst{(K(0, 0) - square) * q1 + K(0, 1) * q2 == 0,
                                               K(1, 0) * q1 + (K(1, 1) - square) * q2 == symbol("p")},
                                    GiNaC::lst{q1, q2});
  return column(ex(q1).subs(solution), ex(q2).subs(solution));
}

symbolic::Matrix eigenvector_slopes() {
  const symbolic::Matrix2 K = stiffness_in_frequencies();
  return column(symbolic::eigenvector_slope(K, symbol("omega1")),
                symbolic::eigenvector_slope(K, symbol("omega2")));
}

symbolic::Matrix vieta_solution() {
  const symbolic::Inverted solution = symbolic::solve_vieta(symbol("omega1"), symbol("omega2"));
  return column(solution.chi, solution.eta);
}

}  // namespace stickslip::proofs
