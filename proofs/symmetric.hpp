// What Section 4 and Appendix 2 assume: a slip that ends in the state E Z_0, and a stick that leads back.
#pragma once

#include "proofs/claim.hpp"
#include "proofs/half_period.hpp"
#include "proofs/vocabulary.hpp"

namespace stickslip::proofs::symmetric {

using namespace vocabulary;
using half_period::closes;
using half_period::friction_at_rest;
using half_period::period;
using half_period::starts_with_belt;

inline const Assumption time_lag{"4.lag", equation(phi, (pi() - omega * tau) / 2)};
inline const Assumption slip_ends{"13", equation(Z(tau), E* Z0)};
inline const Assumption stick_ends{"15", equation(Gamma(T) * E * Z0, Z0)};
inline const Assumption stick_lasts{"4.T", equation(T, Theta - tau)};

}  // namespace stickslip::proofs::symmetric

namespace stickslip::proofs {

// The orbit of Fig. 2.
[[nodiscard]] std::vector<Claim> example_S();

}  // namespace stickslip::proofs
