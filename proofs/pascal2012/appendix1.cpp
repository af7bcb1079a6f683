// Appendix 1: the modes, H and Gamma, (38)-(42).
#include "proofs/methods/derivations.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/frequencies.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;
using namespace symbolic::algebra;

namespace {

using namespace symbols::vocabulary;

// What a flow G with blocks G1, G2, G3 must satisfy whatever it flows along; `id` is that of its definition.
std::vector<Claim> flow_properties(const std::string& id, const Function& G, const Function& G1,
                                   const Function& G2, const Function& G3, const Term& A) {
  return {
      {.id = id + ".init",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(G1(0), I2), equation(G2(0), zero(2, 2)), equation(G3(0), zero(2, 2)),
                   equation(G(0), I4)},
       .words = "initial values of the flow",
       .prove = by_normal_form()},
      {.id = id + ".ode",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(derivative(G(t)), A * G(t)), equation(derivative(G2(t)), G1(t)),
                   equation(derivative(G1(t)), G3(t))},
       .words = "differential equation of the flow and its blocks",
       .prove = by_normal_form()},
      {.id = id + ".group",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(G(t + s), G(t) * G(s))},
       .words = "group law",
       .prove = by_normal_form()},
      {.id = id + ".det",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(determinant(G(t)), 1)},
       .words = "the flow preserves volume",
       .prove = by_normal_form()},
      {.id = id + ".inverse",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(G(t) * G(-t), I4), equation(G(-t) * G(t), I4)},
       .words = "running backwards inverts the flow",
       .prove = by_rewriting({from(id + ".group").at("t", t).at("s", -t).solved_for(G(t) * G(-t)),
                              from(id + ".group").at("t", -t).at("s", t).solved_for(G(-t) * G(t)),
                              from(id + ".init").solved_for(G(0))})},
      {.id = id + ".commute",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(G1(t) * G2(s), G2(s) * G1(t)), equation(G1(t) * G3(s), G3(s) * G1(t)),
                   equation(G2(t) * G3(s), G3(s) * G2(t)), equation(G(t) * G(s), G(s) * G(t))},
       .words = "all blocks commute, at any two times",
       .prove = by_normal_form()},
      {.id = id + ".reversal",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(G(-t) * E, E * G(t))},
       .words = "time reversal: $E$ carries the flow into its inverse",
       .prove = by_normal_form()},
  };
}

std::vector<Claim> modes() {
  return {
      {.id = "38",
       .kind = Kind::definition,
       .printed = {equation(H1(t), Lambda * B1(t) * inverse(Lambda)),
                   equation(H2(t), Lambda * B2(t) * inverse(Lambda)),
                   equation(H3(t), Lambda * B3(t) * inverse(Lambda)),
                   equation(B2(t), block(2, {sin(omega1 * t) / omega1, 0, 0, sin(omega2 * t) / omega2})),
                   equation(B1(t), derivative(B2(t))), equation(B3(t), derivative(derivative(B2(t)))),
                   equation(Lambda, block(2, {1, 1, lambda1, lambda2}))},
       .words = "$H_i = Lambda B_i Lambda^{-1}$, defined wherever $lambda_1$ and $lambda_2$ differ",
       .prove = by_normal_form()},
      {.id = "39",
       .kind = Kind::definition,
       .printed = {equation(determinant(K - power(s, 2) * I2),
                            (power(s, 2) - power(omega1, 2)) * (power(s, 2) - power(omega2, 2))),
                   equation((K - power(omega1, 2) * I2) * psi1, zero(2, 1)),
                   equation((K - power(omega2, 2) * I2) * psi2, zero(2, 1))},
       .words =
           "$omega_1$, $omega_2$ are the roots of $det(K - I s^2)$, $psi_j = (1, lambda_j)$ the eigenvectors",
       .prove = by_normal_form()},
      {.id = "39.derived",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(lambda1, (1 - power(omega1, 2)) / chi),
                   equation(lambda2, (1 - power(omega2, 2)) / chi)},
       .words = "$chi$, $eta$ and the eigenvectors in terms of the frequencies",
       .prove = by_derivation("Vieta's equations for $det(K - s^2 I)$ solved for $chi$ and $eta$, the "
                              "eigenvectors by elimination",
                              [] {
                                return std::vector<Derived>{
                                    {eigenvector_slopes(), column({lambda1, lambda2})},
                                    {vieta_solution(), column({chi, eta})}};
                              })},
      {.id = "39.domain",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(power(1 + chi * eta, 2) - 4 * chi * eta * (1 - chi),
                            power(1 - chi * eta, 2) + 4 * power(chi, 2) * eta),
                   equation((1 - power(omega1, 2)) * (power(omega2, 2) - 1), power(chi, 2) * eta),
                   equation(power(omega1, 2) * power(omega2, 2), chi * eta * (1 - chi)),
                   equation(power(omega1, 2) + power(omega2, 2) - 1, chi * eta)},
       .words = "$0 < chi < 1$ and $eta > 0$ exactly if $0 < omega_1 < 1 < omega_2$: the discriminant is "
                "positive, 1 separates the roots, their product is positive; conversely $chi eta$, $1 - chi$ "
                "and $chi$ come out positive",
       .prove = by_normal_form()},
      {.id = "39.range",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {{chi, 0, Relation::greater}, {chi, 1, Relation::less}, {eta, 0, Relation::greater}},
       .words = "$0 < omega_1 < 1 < omega_2$ gives $0 < chi < 1$ and $eta > 0$",
       .prove = by_positive_combination(
           {{.positive = {{chi}}}, {.positive = {{1 - chi}}}, {.positive = {{eta}}}})},
      frequencies_exist(),
      said_of_data(),
  };
}

}  // namespace

std::vector<Claim> appendix1() {
  return joined({modes(),
                 flow_properties("38", H, H1, H2, H3, first_order(K)),
                 {{.id = "40",
                   .kind = Kind::identity,
                   .printed = {equation(power(H1(t), 2) - I2 - H2(t) * H3(t), 0)},
                   .words = "$H_1^2 - I - H_2 H_3 = 0$",
                   .prove = by_normal_form()},
                  {.id = "41",
                   .kind = Kind::definition,
                   .printed = {equation(Gamma1(t), Sigma * gamma1(t) * inverse(Sigma)),
                               equation(Gamma2(t), Sigma * gamma2(t) * inverse(Sigma)),
                               equation(Gamma3(t), Sigma * gamma3(t) * inverse(Sigma)),
                               equation(gamma2(t), block(2, {sin(t), 0, 0, t})),
                               equation(gamma1(t), derivative(gamma2(t))),
                               equation(gamma3(t), derivative(derivative(gamma2(t)))),
                               equation(Sigma, block(2, {1, chi, 0, 1}))},
                   .words = "$Gamma_i = Sigma gamma_i Sigma^{-1}$",
                   .prove = by_normal_form()}},
                 flow_properties("41", Gamma, Gamma1, Gamma2, Gamma3, first_order(stick_matrix)),
                 {{.id = "42",
                   .kind = Kind::identity,
                   .printed = {equation(power(Gamma1(t), 2) - I2 - Gamma2(t) * Gamma3(t), 0)},
                   .words = "$Gamma_1^2 - I - Gamma_2 Gamma_3 = 0$",
                   .prove = by_normal_form()}}});
}

}  // namespace stickslip::proofs::pascal2012
