// Closed forms that GiNaC derives from the equations of motion, with no formula of the model: the proofs of
// 39.derived, 6.H, 7 and 10.Gamma.
#include "proofs/methods/derivations.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols::vocabulary;

std::vector<Claim> derived_forms() {
  const auto derived = [](const char * id, const char * route, std::vector<Derived> (*derive)()) {
    return Claim{.id = id, .prove = by_derivation(route, derive)};
  };
  return {
      derived("39.derived",
              "Vieta's equations for $det(K - s^2 I)$ solved for $chi$ and $eta$, the eigenvectors by "
              "elimination",
              [] {
                return std::vector<Derived>{{eigenvector_slopes(), symbols::column({lambda1, lambda2})},
                                            {vieta_solution(), symbols::column({chi, eta})}};
              }),
      derived("6.H",
              "$H(t)$ equals the matrix exponential, found from the resolvent of the first-order system",
              [] {
                return std::vector<Derived>{{slip_exponential(), H(t)}};
              }),
      derived("7", "the linear system $(K - omega^2 I) Q = (0, p)$ solved by elimination",
              [] {
                return std::vector<Derived>{{forced_amplitudes(), Q}};
              }),
      derived("10.Gamma",
              "$Gamma(t)$ equals the matrix exponential, found from the resolvent of the first-order system",
              [] {
                return std::vector<Derived>{{stick_exponential(), Gamma(t)}};
              }),
  };
}

}  // namespace stickslip::proofs::pascal2012
