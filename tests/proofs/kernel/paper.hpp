// The paper's functions as definitions of the kernel, from the model, for the tests.
#pragma once

#include "model/flows.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::kernel::paper {

using tactics::as_term;
using tactics::Symbolic;

inline const Variable t{"t"}, s{"s"}, omega1{"omega1"}, omega2{"omega2"}, lambda1{"lambda1"},
    lambda2{"lambda2"}, chi{"chi"}, omega{"omega"}, phi{"phi"}, tau{"tau"}, p{"p"}, us{"us"}, V{"V"};
inline const Variable Q{"Q", {Sort::real, 2, 1}};

inline model::Modes<Symbolic> modes() {
  return {omega1, omega2, lambda1, lambda2};
}
inline const std::vector<Variable> modal{t, omega1, omega2, lambda1, lambda2};

inline const Definition H_of("H", modal, as_term(model::H<Symbolic>(modes(), t)));
inline const Definition H1_of("H1", modal, as_term(model::H_blocks<Symbolic>(modes(), t).first));
inline const Definition H2_of("H2", modal, as_term(model::H_blocks<Symbolic>(modes(), t).second));
inline const Definition H3_of("H3", modal, as_term(model::H_blocks<Symbolic>(modes(), t).third));
inline const Definition Gamma_of("Gamma", {t, chi}, as_term(model::Gamma<Symbolic>(chi, t)));
inline const Definition F_of(
    "F", {t, Q, omega, phi},
    as_term(model::F<Symbolic>(model::Vector2<Symbolic>(Symbolic(entry(Q, 0)), Symbolic(entry(Q, 1))), omega,
                               Symbolic(omega) * Symbolic(t) + Symbolic(phi))));
inline Term H(const Term& time) {
  return H_of({time, omega1, omega2, lambda1, lambda2});
}
inline Term H1(const Term& time) {
  return H1_of({time, omega1, omega2, lambda1, lambda2});
}
inline Term H2(const Term& time) {
  return H2_of({time, omega1, omega2, lambda1, lambda2});
}
inline Term H3(const Term& time) {
  return H3_of({time, omega1, omega2, lambda1, lambda2});
}
inline Term F(const Term& time) {
  return F_of({time, Q, omega, phi});
}
inline const Term E = as_term(model::reversal<Symbolic>());

}  // namespace stickslip::proofs::kernel::paper
