// The paper's symbols as terms. Names are the paper's in ASCII; what else is known of them stands in the
// table (table.cpp).
#pragma once

#include <array>

#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::symbols {

// The entries of a 4x4 matrix by the letter of Appendix 3, h for H(tau_1) and Htilde for H(tau + tau_1):
// Entries{"Htilde"}(1, 3) is "Htilde13".
struct Entries {
  std::string letter;
  [[nodiscard]] Term operator()(int row, int column) const {
    return scalar(letter + std::to_string(row) + std::to_string(column));
  }
};

// The coefficients of equation i of (21): a_i, b_i, c_i, d_i.
[[nodiscard]] inline Term coefficient(char letter, int equation) {
  return scalar(std::string(1, letter) + "_" + std::to_string(equation));
}

// The determinant of (22) with these columns, of coefficients, in rows 1, 2, 3; `-d` for the negative column.
[[nodiscard]] inline Term determinant_of_columns(const std::array<std::string, 3>& columns) {
  std::vector<Term> entries;
  for (int row = 1; row <= 3; ++row) {
    for (const std::string& column : columns) {
      const Term entry = coefficient(column.back(), row);
      entries.push_back(column.front() == '-' ? -entry : entry);
    }
  }
  return determinant(block(3, std::move(entries)));
}

namespace vocabulary {

// Parameters and times.
inline const Term chi = scalar("chi"), eta = scalar("eta"), us = scalar("us"), ur = scalar("ur"),
                  V = scalar("V"), omega = scalar("omega"), p = scalar("p"), phi = scalar("phi");
inline const Term omega1 = scalar("omega1"), omega2 = scalar("omega2"), lambda1 = scalar("lambda1"),
                  lambda2 = scalar("lambda2");
inline const Term t = scalar("t"), s = scalar("s"), t1 = scalar("t1"), tau = scalar("tau"), T = scalar("T"),
                  Theta = scalar("Theta");

// Constant vectors and matrices.
inline const Term E = matrix("E", 4), I2 = identity(2), I4 = identity(4), K = matrix("K", 2),
                  Lambda = matrix("Lambda", 2), Sigma = matrix("Sigma", 2);
inline const Term d0 = vector("d0", 2), d01 = scalar("d01"), d02 = scalar("d02");
inline const Term Q = vector("Q", 2), q1 = scalar("q1"), q2 = scalar("q2");
inline const Term psi1 = vector("psi1", 2), psi2 = vector("psi2", 2);
inline const Term F0 = vector("F0", 4), Z0 = vector("Z0", 4);
inline const Term z10 = scalar("z10"), z20 = scalar("z20"), zdot10 = scalar("zdot10"),
                  zdot20 = scalar("zdot20");

// States at the end of the first slip (B), and those of x = z + d_0 and of z + 2 d_0.
inline const Term FB = vector("FB", 4), ZB = vector("ZB", 4);
inline const Term z0 = vector("z0", 2), zdot0 = vector("zdot0", 2), zB = vector("zB", 2),
                  zdotB = vector("zdotB", 2), zdot1B = scalar("zdot1B"), zdot2B = scalar("zdot2B"),
                  z1B = scalar("z1B"), z2B = scalar("z2B");
inline const Term x0 = vector("x0", 2), xB = vector("xB", 2), X0 = vector("X0", 4), XB = vector("XB", 4);
inline const Term zbar0 = vector("zbar0", 2), zbarB = vector("zbarB", 2), Zbar0 = vector("Zbar0", 4),
                  ZbarB = vector("ZbarB", 4);
inline const Term delta0 = vector("delta0", 4);

// (34), (35).
inline const Term phi1 = scalar("phi1"), phi2 = scalar("phi2"), d = scalar("d"), a1 = scalar("a1"),
                  a2 = scalar("a2"), b1 = scalar("b1"), b2 = scalar("b2");

// Appendix 5.
inline const Term tau1 = scalar("tau1"), rho1 = scalar("rho1"), rho2 = scalar("rho2");
inline const Term xi1 = vector("xi1", 4), xi2 = vector("xi2", 4), X1 = vector("X1", 2), Y1 = vector("Y1", 2),
                  X2 = vector("X2", 2), Y2 = vector("Y2", 2);
inline const Term P1 = matrix("P1", 2), P2 = matrix("P2", 2), P = matrix("P", 2),
                  Ptilde = matrix("Ptilde", 2);

// Section 5, beside its coefficients and entries.
inline const Term ZC = vector("ZC", 4), z1C = scalar("z1C"), z2C = scalar("z2C"), tau2 = scalar("tau2"),
                  Delta = scalar("Delta"), Delta1 = scalar("Delta1"), Delta2 = scalar("Delta2"),
                  Delta3 = scalar("Delta3");

// Functions of time.
inline const Function H{"H", {4, 4}}, H1{"H1", {2, 2}}, H2{"H2", {2, 2}}, H3{"H3", {2, 2}};
inline const Function B1{"B1", {2, 2}}, B2{"B2", {2, 2}}, B3{"B3", {2, 2}};
inline const Function Gamma{"Gamma", {4, 4}}, Gamma1{"Gamma1", {2, 2}}, Gamma2{"Gamma2", {2, 2}},
    Gamma3{"Gamma3", {2, 2}};
inline const Function gamma1{"gamma1", {2, 2}}, gamma2{"gamma2", {2, 2}}, gamma3{"gamma3", {2, 2}};
inline const Function F{"F", {4, 1}}, R{"R", {2, 1}}, L{"L", {4, 2}}, Z{"Z", {4, 1}}, X{"X", {4, 1}},
    Y{"Y", {4, 1}}, Zbar{"Zbar", {4, 1}};

// x1, x2, x1' or x2' of a state, counted from 0.
[[nodiscard]] inline Term component(std::size_t which, const Term& state) {
  std::vector<Term> row(4, Term(0));
  row.at(which) = 1;
  return block(1, std::move(row)) * state;
}

// The matrix of y'' + M y = 0 as a first-order system for (y, y').
[[nodiscard]] inline Term first_order(const Term& M) {
  return block(2, {zero(2, 2), I2, -M, zero(2, 2)});
}
// (9): x1'' + x1 - chi x2 = 0, x2'' = 0 has M = [[1, -chi], [0, 0]].
inline const Term stick_matrix = block(2, {1, -chi, 0, 0});

}  // namespace vocabulary
}  // namespace stickslip::proofs::symbols
