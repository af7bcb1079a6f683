// Closed forms that GiNaC derives from the equations of motion, with no formula of the model, translated into
// terms and compared with what is printed: the proofs of 39.derived, 6.H, 7 and 10.Gamma.
#include <mutex>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "symbolic/algebra/derive.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols::vocabulary;

namespace {

namespace algebra = symbolic::algebra;
using algebra::symbol;
using GiNaC::ex;
using GiNaC::is_a;

// A rational function of symbols, their cosines and sines; of a symbol, the variable of its name.
kernel::Term term_of(const ex& scalar) {
  if (is_a<GiNaC::numeric>(scalar)) {
    return algebra::to_rational(GiNaC::ex_to<GiNaC::numeric>(scalar));
  }
  if (is_a<GiNaC::symbol>(scalar)) {
    return kernel::Variable{GiNaC::ex_to<GiNaC::symbol>(scalar).get_name()};
  }
  if (is_a<GiNaC::add>(scalar) || is_a<GiNaC::mul>(scalar)) {
    kernel::Term result = term_of(scalar.op(0));
    for (std::size_t i = 1; i < scalar.nops(); ++i) {
      const kernel::Term part = term_of(scalar.op(i));
      result = is_a<GiNaC::add>(scalar) ? result + part : result * part;
    }
    return result;
  }
  if (is_a<GiNaC::power>(scalar) && scalar.op(1).info(GiNaC::info_flags::integer)) {
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(scalar.op(1)).to_int();
    const kernel::Term base = term_of(scalar.op(0));
    return kernel::power(exponent < 0 ? kernel::inverse(base) : base, std::abs(exponent));
  }
  if (is_a<GiNaC::function>(scalar)) {
    const std::string name = GiNaC::ex_to<GiNaC::function>(scalar).get_name();
    if (name == "cos" || name == "sin") {
      const kernel::Term argument = term_of(scalar.op(0));
      return name == "cos" ? kernel::cos(argument) : kernel::sin(argument);
    }
  }
  throw kernel::KernelError("what was derived is no rational function");
}

template <class Derived>
kernel::Term term_of(const Eigen::MatrixBase<Derived>& matrix) {
  std::vector<kernel::Term> entries;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      entries.push_back(term_of(matrix(i, j)));
    }
  }
  return kernel::matrix(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), entries);
}

kernel::Term column_of(const ex& first, const ex& second) {
  return kernel::matrix(2, 1, {term_of(first), term_of(second)});
}

// chi and eta from Vieta's equations for det(K - s^2 I).
algebra::Inverted vieta() {
  return algebra::solve_vieta(symbol("omega1"), symbol("omega2"));
}

// (39) with these.
algebra::Matrix2 stiffness() {
  const algebra::Inverted solution = vieta();
  return model::matrix<ex>(1, -solution.chi, (-solution.chi * solution.eta).normal(),
                           (solution.chi * solution.eta).normal());
}

// exp(t [[0, I], [-K, 0]]).
kernel::Term slip_exponential() {
  return term_of(algebra::exponential(algebra::first_order(stiffness()),
                                      {{symbol("omega1"), symbol("omega2")}, 0}, symbol("t")));
}

// exp(t A) for the first-order form of (9).
kernel::Term stick_exponential() {
  return term_of(algebra::exponential(algebra::first_order(model::matrix<ex>(1, -symbol("chi"), 0, 0)),
                                      {{ex(1)}, 2}, symbol("t")));
}

// The solution (q1, q2) of (K - omega^2 I) Q = (0, p).
kernel::Term forced_amplitudes() {
  const algebra::Matrix2 K = stiffness();
  const ex square = symbol("omega") * symbol("omega");
  const GiNaC::symbol q1, q2;
  const ex solution = GiNaC::lsolve(GiNaC::lst{(K(0, 0) - square) * q1 + K(0, 1) * q2 == 0,
                                               K(1, 0) * q1 + (K(1, 1) - square) * q2 == symbol("p")},
                                    GiNaC::lst{q1, q2});
  return column_of(ex(q1).subs(solution), ex(q2).subs(solution));
}

// The second components of the eigenvectors (1, lambda_j) of K.
kernel::Term eigenvector_slopes() {
  const algebra::Matrix2 K = stiffness();
  return column_of(algebra::eigenvector_slope(K, symbol("omega1")),
                   algebra::eigenvector_slope(K, symbol("omega2")));
}

// GiNaC's objects are for one thread at a time.
Proof by_ginac(const std::string& route, const Compare& derive) {
  return by_derivation(route, [derive](Derivation& derivation) {
    static std::mutex ginac;
    const std::lock_guard alone(ginac);
    return derive(derivation);
  });
}

}  // namespace

Proofs derived_forms() {
  return {
      {"39.derived",
       by_ginac("Vieta's equations for $det(K - s^2 I)$ solved for $chi$ and $eta$, the eigenvectors by "
                "elimination",
                [](Derivation& derivation) -> std::vector<Equal> {
                  const algebra::Inverted solution = vieta();
                  return {
                      {eigenvector_slopes(), derivation.read(symbols::column({lambda1, lambda2}))},
                      {column_of(solution.chi, solution.eta), derivation.read(symbols::column({chi, eta}))}};
                })},
      {"6.H",
       by_ginac("$H(t)$ equals the matrix exponential, found from the resolvent of the first-order system",
                [](Derivation& derivation) -> std::vector<Equal> {
                  return {{slip_exponential(), derivation.read(H(t))}};
                })},
      {"7", by_ginac("the linear system $(K - omega^2 I) Q = (0, p)$ solved by elimination",
                     [](Derivation& derivation) -> std::vector<Equal> {
                       return {{forced_amplitudes(), derivation.read(Q)}};
                     })},
      {"10.Gamma",
       by_ginac(
           "$Gamma(t)$ equals the matrix exponential, found from the resolvent of the first-order system",
           [](Derivation& derivation) -> std::vector<Equal> {
             return {{stick_exponential(), derivation.read(Gamma(t))}};
           })},
  };
}

}  // namespace stickslip::proofs::pascal2012
